#pragma once

#include <QAbstractTableModel>
#include <QStringList>

#include <functional>
#include <optional>
#include <vector>

namespace berg {

/** Sort key of a cell: a number, before all numbers none, then a text among equal numbers. */
struct CellKey
{
    std::optional<double> number{};
    QString text{};
};

/** Read-only table. Cells are computed when they are shown; rows are numbered as before sorting. */
struct CellSheet
{
    QStringList titles;
    int rows = 0;
    std::function<QString(int row, int column)> text;
    std::function<CellKey(int row, int column)> key{}; ///< sort key; null sorts by `text`
    QStringList titleTips{};                           ///< tool tip of each column title
    /** Tool tip of a row; null shows the text of the cell. */
    std::function<QString(int row)> toolTip{};
    std::function<QVariant(int row)> icon{}; ///< icon before the first column
    bool hasNumbers = false;                 ///< aligns all columns but the first to the right
};

/** Shows a sheet and sorts it itself, so that large tables are sorted in milliseconds. */
class CellModel : public QAbstractTableModel
{
    Q_OBJECT

public:
    using QAbstractTableModel::QAbstractTableModel;

    /** Replaces the sheet. Resets the model only if the columns or the order of rows change. */
    void setSheet(CellSheet sheet);
    /** Returns the row of the sheet that is shown in `row`. */
    [[nodiscard]] int sourceRow(int row) const { return m_order[static_cast<std::size_t>(row)]; }
    /** Returns the row in which a row of the sheet is shown; nullopt if there is no such row. */
    [[nodiscard]] std::optional<int> shownRow(int sourceRow) const;

    /** Sorts by a column; −1 restores the order of the sheet. The sort is stable. */
    void sort(int column, Qt::SortOrder order) override;
    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation,
                                      int role) const override;

private:
    [[nodiscard]] std::vector<int> orderOf(const CellSheet& sheet) const;

    CellSheet m_sheet;
    std::vector<int> m_order; ///< rows of the sheet in the order shown
    int m_column = -1;
    Qt::SortOrder m_direction = Qt::AscendingOrder;
};

} // namespace berg
