#include "widgets/panels/study/study_tables.h"

#include <algorithm>
#include <numeric>

namespace berg {

StudyCase studyCase(const StudySpec& spec, std::size_t caseIndex)
{
    const auto runs = static_cast<std::size_t>(spec.runs);
    const std::size_t scenario = caseIndex / runs;
    StudyCase out{.run = static_cast<int>(caseIndex % runs)};
    if (scenario < spec.scenarios.size()) {
        out.scenario = QString::fromStdString(spec.scenarios[scenario].name);
        out.seed = seedOfRun(spec.scenarios[scenario].seed, out.run);
        return out;
    }
    const std::int64_t seed =
        spec.firstSeed + static_cast<std::int64_t>(scenario - spec.scenarios.size());
    out.scenario = StudyCasesModel::tr("Random %1", "scenario drawn from a seed").arg(seed);
    out.seed = seedOfRun(seed, out.run);
    return out;
}

StudyTableModel::StudyTableModel(const QLocale& locale, std::vector<ColumnHeader> headers,
                                 QObject* parent)
    : QAbstractTableModel(parent), m_locale(locale), m_headers(std::move(headers))
{
}

int StudyTableModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_order.size());
}

int StudyTableModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_headers.size());
}

QVariant StudyTableModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid() || index.row() >= rowCount())
        return {};
    switch (role) {
    case Qt::DisplayRole:
        return text(unsorted(index.row()), index.column());
    case Qt::ToolTipRole:
        return toolTip(unsorted(index.row()));
    case Qt::TextAlignmentRole:
        return headerData(index.column(), Qt::Horizontal, role);
    default:
        return {};
    }
}

QVariant StudyTableModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal)
        return {};
    const ColumnHeader& header = m_headers.at(static_cast<std::size_t>(section));
    switch (role) {
    case Qt::DisplayRole:
        return header.text;
    case Qt::ToolTipRole:
        return header.toolTip;
    case Qt::TextAlignmentRole:
        return QVariant((section == 0 ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
    default:
        return {};
    }
}

int StudyTableModel::rowOf(std::size_t row) const
{
    const auto found = std::find(m_order.begin(), m_order.end(), row);
    return found == m_order.end() ? -1 : static_cast<int>(found - m_order.begin());
}

std::vector<std::size_t> StudyTableModel::orderOf(std::size_t rows) const
{
    std::vector<std::size_t> order(rows);
    std::iota(order.begin(), order.end(), std::size_t{0});
    if (m_column < 0)
        return order;
    std::vector<SortKey> keys;
    keys.reserve(rows);
    for (std::size_t row = 0; row < rows; ++row)
        keys.push_back(sortKey(row, m_column));
    const auto isLess = [&keys](std::size_t a, std::size_t b) {
        return keys[a].number != keys[b].number ? keys[a].number < keys[b].number
                                                : keys[a].text.localeAwareCompare(keys[b].text) < 0;
    };
    if (m_direction == Qt::AscendingOrder)
        std::stable_sort(order.begin(), order.end(), isLess);
    else
        std::stable_sort(order.begin(), order.end(),
                         [&](std::size_t a, std::size_t b) { return isLess(b, a); });
    return order;
}

void StudyTableModel::setRows(std::size_t rows)
{
    std::vector<std::size_t> order = orderOf(rows);
    if (order == m_order) {
        if (rows > 0)
            emit dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1));
        return;
    }
    beginResetModel();
    m_order = std::move(order);
    endResetModel();
}

void StudyTableModel::sort(int column, Qt::SortOrder order)
{
    m_column = column;
    m_direction = order;
    setRows(m_order.size());
}

} // namespace berg
