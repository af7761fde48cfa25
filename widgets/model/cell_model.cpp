#include "widgets/model/cell_model.h"

#include <utility>

namespace berg {

void CellModel::setSheet(CellSheet sheet)
{
    beginResetModel();
    m_sheet = std::move(sheet);
    endResetModel();
}

int CellModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : m_sheet.rows;
}

int CellModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_sheet.titles.size());
}

QVariant CellModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid())
        return {};
    if (role == Qt::DisplayRole || role == Qt::ToolTipRole)
        return m_sheet.text(index.row(), index.column());
    if (role == SortRole)
        return m_sheet.sortKey ? m_sheet.sortKey(index.row(), index.column())
                               : m_sheet.text(index.row(), index.column());
    return {};
}

QVariant CellModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal)
        return {};
    if (role == Qt::TextAlignmentRole)
        return int(Qt::AlignLeft | Qt::AlignVCenter);
    return role == Qt::DisplayRole ? m_sheet.titles.value(section) : QVariant();
}

} // namespace berg
