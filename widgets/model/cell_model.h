#pragma once

#include <QAbstractTableModel>
#include <QStringList>

#include <functional>

namespace berg {

/** A table to look at: cells are asked for when they are shown. */
struct CellSheet
{
    QStringList titles;
    int rows = 0;
    std::function<QString(int row, int column)> text;
    std::function<QVariant(int row, int column)> sortKey; ///< null: the text
};

/** Shows a sheet; sorted by whatever proxy is put on it. */
class CellModel : public QAbstractTableModel
{
    Q_OBJECT

public:
    enum Role
    {
        SortRole = Qt::UserRole
    };

    using QAbstractTableModel::QAbstractTableModel;

    void setSheet(CellSheet sheet);

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation,
                                      int role) const override;

private:
    CellSheet m_sheet;
};

} // namespace berg
