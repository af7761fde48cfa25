#include "widgets/model/cell_model.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace berg {

void CellModel::setSheet(CellSheet sheet)
{
    std::vector<int> order = orderOf(sheet);
    if (order == m_order && sheet.titles.size() == m_sheet.titles.size()) {
        m_sheet = std::move(sheet);
        emit headerDataChanged(Qt::Horizontal, 0, columnCount() - 1);
        if (rowCount() > 0)
            emit dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1));
        return;
    }
    beginResetModel();
    m_sheet = std::move(sheet);
    m_order = std::move(order);
    endResetModel();
}

std::vector<int> CellModel::orderOf(const CellSheet& sheet) const
{
    std::vector<int> order(static_cast<std::size_t>(sheet.rows));
    std::iota(order.begin(), order.end(), 0);
    if (m_column < 0 || m_column >= sheet.titles.size())
        return order;
    std::vector<CellKey> keys;
    keys.reserve(order.size());
    for (const int row : order)
        keys.push_back(sheet.key ? sheet.key(row, m_column)
                                 : CellKey{.text = sheet.text(row, m_column)});
    const auto isLess = [&keys](int a, int b) {
        const CellKey& one = keys[static_cast<std::size_t>(a)];
        const CellKey& other = keys[static_cast<std::size_t>(b)];
        return one.number != other.number ? one.number < other.number
                                          : one.text.localeAwareCompare(other.text) < 0;
    };
    std::ranges::stable_sort(order, [&](int a, int b) {
        return m_direction == Qt::AscendingOrder ? isLess(a, b) : isLess(b, a);
    });
    return order;
}

std::optional<int> CellModel::shownRow(int sourceRow) const
{
    const auto found = std::ranges::find(m_order, sourceRow);
    if (found == m_order.end())
        return std::nullopt;
    return static_cast<int>(found - m_order.begin());
}

void CellModel::sort(int column, Qt::SortOrder order)
{
    m_column = column;
    m_direction = order;
    emit layoutAboutToBeChanged({}, VerticalSortHint);
    const QModelIndexList before = persistentIndexList();
    const std::vector<int> rows = std::exchange(m_order, orderOf(m_sheet));
    QModelIndexList after;
    for (const QModelIndex& at : before)
        after << index(shownRow(rows[static_cast<std::size_t>(at.row())]).value(), at.column());
    changePersistentIndexList(before, after);
    emit layoutChanged({}, VerticalSortHint);
}

int CellModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_order.size());
}

int CellModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_sheet.titles.size());
}

QVariant CellModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid())
        return {};
    const int row = sourceRow(index.row());
    if (role == Qt::ToolTipRole && m_sheet.toolTip)
        return m_sheet.toolTip(row);
    if (role == Qt::DisplayRole || role == Qt::ToolTipRole)
        return m_sheet.text(row, index.column());
    if (role == Qt::TextAlignmentRole)
        return headerData(index.column(), Qt::Horizontal, role);
    return role == Qt::DecorationRole && index.column() == 0 && m_sheet.icon ? m_sheet.icon(row)
                                                                             : QVariant();
}

QVariant CellModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal)
        return {};
    if (role == Qt::TextAlignmentRole)
        return QVariant((m_sheet.hasNumbers && section > 0 ? Qt::AlignRight : Qt::AlignLeft) |
                        Qt::AlignVCenter);
    if (role == Qt::ToolTipRole)
        return m_sheet.titleTips.value(section);
    return role == Qt::DisplayRole ? m_sheet.titles.value(section) : QVariant();
}

} // namespace berg
