#include "widgets/tables/cell_model.h"

#include <algorithm>
#include <numeric>

namespace berg {
namespace {

/** Returns the row in which each of `count` rows of a sheet is shown, if it is shown. */
std::vector<std::optional<int>> shownRows(const std::vector<int>& order, int count)
{
    std::vector<std::optional<int>> shown(static_cast<std::size_t>(count));
    for (std::size_t row = 0; row < order.size(); ++row)
        shown[static_cast<std::size_t>(order[row])] = static_cast<int>(row);
    return shown;
}

/** Returns whether one list begins with all of the other. */
bool continues(const std::vector<int>& one, const std::vector<int>& other)
{
    const auto [end, otherEnd] = std::ranges::mismatch(one, other);
    return end == one.end() || otherEnd == other.end();
}

} // namespace

void CellModel::setSheet(CellSheet sheet)
{
    if (orderOf(sheet) != m_order || sheet.columns.size() != m_sheet.columns.size())
        resetSheet(std::move(sheet));
    else
        updateSheet(std::move(sheet), [](int /*row*/) { return false; });
}

void CellModel::resetSheet(CellSheet sheet)
{
    beginResetModel();
    m_order = orderOf(sheet);
    m_sheet = std::move(sheet);
    endResetModel();
}

void CellModel::updateSheet(CellSheet sheet, const std::function<bool(int row)>& isSame)
{
    std::vector<int> order = orderOf(sheet);
    const auto before = static_cast<int>(m_order.size());
    const auto after = static_cast<int>(order.size());
    if (sheet.columns.size() != m_sheet.columns.size() ||
        (after != before && !continues(order, m_order)))
        return resetSheet(std::move(sheet));

    const auto differs = [&](int row) {
        return isSame ? !isSame(row) : row >= m_sheet.rows || !hasTextsOf(sheet, row);
    };
    const auto end = order.begin() + std::min(before, after);
    const auto first = std::find_if(order.begin(), end, differs);
    const auto last =
        std::find_if(std::reverse_iterator(end), std::reverse_iterator(first), differs);
    const auto firstRow = static_cast<int>(first - order.begin());
    const auto lastRow = static_cast<int>(last.base() - order.begin()) - 1;
    const bool hasOtherTitles = !std::ranges::equal(sheet.columns, m_sheet.columns, {},
                                                    &CellColumn::title, &CellColumn::title);
    if (after < before) {
        beginRemoveRows({}, after, before - 1);
        m_order.resize(order.size());
        endRemoveRows();
    } else if (after > before) {
        beginInsertRows({}, before, after - 1);
    }
    m_sheet = std::move(sheet);
    if (after > before) {
        m_order = std::move(order);
        endInsertRows();
    } else {
        rearrange(std::move(order));
    }
    if (hasOtherTitles)
        emit headerDataChanged(Qt::Horizontal, 0, columnCount() - 1);
    reportRows(firstRow, lastRow);
}

bool CellModel::hasTextsOf(const CellSheet& sheet, int row) const
{
    return std::ranges::equal(sheet.columns, m_sheet.columns,
                              [row](const CellColumn& one, const CellColumn& other) {
                                  return one.text(row) == other.text(row);
                              });
}

void CellModel::reportRows(int first, int last, const QList<int>& roles)
{
    if (first <= last)
        emit dataChanged(index(first, 0), index(last, columnCount() - 1), roles);
}

std::vector<int> CellModel::orderOf(const CellSheet& sheet) const
{
    std::vector<int> order(static_cast<std::size_t>(sheet.rows));
    std::iota(order.begin(), order.end(), 0);
    if (sheet.isShown)
        std::erase_if(order, [&](int row) { return !sheet.isShown(row); });
    if (!m_column || static_cast<std::size_t>(*m_column) >= sheet.columns.size())
        return order;
    const CellColumn& column = sheet.columns[static_cast<std::size_t>(*m_column)];
    std::vector<CellKey> keys;
    keys.reserve(static_cast<std::size_t>(sheet.rows));
    for (int row = 0; row < sheet.rows; ++row)
        keys.push_back(column.key ? column.key(row) : CellKey(column.text(row)));
    std::ranges::stable_sort(order, [&](int a, int b) {
        const CellKey& one = keys[static_cast<std::size_t>(a)];
        const CellKey& other = keys[static_cast<std::size_t>(b)];
        if (!one.number || !other.number)
            return one.number && !other.number;
        const bool isUp = m_direction == Qt::AscendingOrder;
        const CellKey& low = isUp ? one : other;
        const CellKey& high = isUp ? other : one;
        return low.number != high.number ? *low.number < *high.number
                                         : low.text.localeAwareCompare(high.text) < 0;
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
    m_column = column < 0 ? std::nullopt : std::optional(column);
    m_direction = order;
    rearrange(orderOf(m_sheet));
}

/** Shows the same number of rows in another order; indices follow their rows. */
void CellModel::rearrange(std::vector<int> order)
{
    if (order == m_order)
        return;
    emit layoutAboutToBeChanged({}, VerticalSortHint);
    const std::vector<std::optional<int>> shown = shownRows(order, m_sheet.rows);
    const QModelIndexList before = persistentIndexList();
    QModelIndexList after;
    after.reserve(before.size());
    for (const QModelIndex& at : before)
        if (const auto row = shown[static_cast<std::size_t>(sourceRow(at.row()))])
            after << index(*row, at.column());
        else
            after << QModelIndex();
    m_order = std::move(order);
    changePersistentIndexList(before, after);
    emit layoutChanged({}, VerticalSortHint);
}

int CellModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_order.size());
}

int CellModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_sheet.columns.size());
}

const CellColumn& CellModel::columnAt(int column) const
{
    return m_sheet.columns.at(static_cast<std::size_t>(column));
}

QVariant CellModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid())
        return {};
    const int row = sourceRow(index.row());
    const CellColumn& column = columnAt(index.column());
    if (role == Qt::ToolTipRole && m_sheet.toolTip)
        return m_sheet.toolTip(row, index.column());
    if (role == Qt::EditRole && column.value)
        return column.value(row);
    if (role == Qt::DisplayRole || role == Qt::ToolTipRole || (role == Qt::EditRole && column.edit))
        return column.text(row);
    if (role == Qt::TextAlignmentRole)
        return headerData(index.column(), Qt::Horizontal, role);
    return m_sheet.other ? m_sheet.other(row, index.column(), role) : QVariant();
}

QVariant CellModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || section < 0 || section >= columnCount())
        return {};
    const CellColumn& column = columnAt(section);
    if (role == Qt::TextAlignmentRole)
        return QVariant(Qt::AlignVCenter | (column.isMark     ? Qt::AlignHCenter
                                            : column.isNumber ? Qt::AlignRight
                                                              : Qt::AlignLeft));
    if (role == Qt::ToolTipRole || (role == Qt::AccessibleTextRole && m_sheet.speaksTips))
        return column.tip;
    return role == Qt::DisplayRole ? column.title : QVariant();
}

Qt::ItemFlags CellModel::flags(const QModelIndex& index) const
{
    Qt::ItemFlags flags = QAbstractTableModel::flags(index);
    flags.setFlag(Qt::ItemIsEditable, index.isValid() && columnAt(index.column()).edit);
    return flags;
}

bool CellModel::setData(const QModelIndex& index, const QVariant& value, int role)
{
    const auto edit = columnAt(index.column()).edit; // a copy, as the edit may replace the sheet
    return role == Qt::EditRole && edit && edit(sourceRow(index.row()), value);
}

std::vector<CellColumn> withNumbers(std::vector<CellColumn> columns)
{
    for (std::size_t i = 1; i < columns.size(); ++i)
        columns[i].isNumber = true;
    return columns;
}

} // namespace berg
