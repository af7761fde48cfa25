#pragma once

#include <QAbstractTableModel>

#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace berg {

/** Sort key of a cell: a number, then a text among equal numbers. */
struct CellKey
{
    // NOLINTBEGIN(google-explicit-constructor): columns return plain numbers and texts
    CellKey(double value, QString name = {}) : number(value), text(std::move(name)) {}
    /** A cell without a number comes last in both directions. */
    CellKey(std::optional<double> value) : number(value) {}
    CellKey(QString name) : text(std::move(name)) {}
    // NOLINTEND(google-explicit-constructor)

    std::optional<double> number = 0;
    QString text;
};

/** Column of a table. Its functions take a row of the sheet. */
struct CellColumn
{
    QString title;
    QString tip{}; ///< tool tip of the title
    std::function<QString(int row)> text;
    std::function<CellKey(int row)> key{}; ///< sort key; null sorts by `text`
    bool isNumber = false;                 ///< aligned to the right
    bool isMark = false;                   ///< centred
    /** Sets the cell and returns whether it did; null if the column cannot be edited. */
    std::function<bool(int row, const QVariant& value)> edit{};
    std::function<QVariant(int row)> value{}; ///< value in the editor; null for `text`
};

/** Content of a table. Cells are computed when they are shown; rows are numbered before sorting. */
struct CellSheet
{
    std::vector<CellColumn> columns;
    int rows = 0;
    std::function<QString(int row, int column)> toolTip{}; ///< null shows the text of the cell
    /** Returns the data of other roles, such as the icon. */
    std::function<QVariant(int row, int column, int role)> other{};
    std::function<bool(int row)> isShown{}; ///< filter; null shows all rows
    bool speaksTips =
        false; ///< whether screen readers read the tool tips of titles, not the titles
};

/** Shows a sheet and sorts it itself, so that large tables are sorted in milliseconds. */
class CellModel : public QAbstractTableModel
{
    Q_OBJECT

public:
    using QAbstractTableModel::QAbstractTableModel;

    /** Replaces the sheet. Resets the model only if the columns or the order of rows change. */
    void setSheet(CellSheet sheet);
    /**
     * Continues the sheet: rows keep their indices while they move, and without sorting others are
     * added and removed at the end. Reports the changed rows as one span: those for which `isSame`
     * returns false, or if it is null those with another text.
     */
    void updateSheet(CellSheet sheet, const std::function<bool(int row)>& isSame = {});
    /** Replaces the sheet and resets the model. */
    void resetSheet(CellSheet sheet);

    /** Returns the row of the sheet that is shown in `row`. */
    [[nodiscard]] int sourceRow(int row) const { return m_order.at(static_cast<std::size_t>(row)); }
    /** Returns the row in which a row of the sheet is shown; nullopt if it is not shown. */
    [[nodiscard]] std::optional<int> shownRow(int sourceRow) const;

    /** Sorts by a column; −1 restores the order of the sheet. The sort is stable. */
    void sort(int column, Qt::SortOrder order) override;
    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation,
                                      int role) const override;
    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;

protected:
    /** Returns whether a row has the texts of the same row in the other sheet. */
    [[nodiscard]] bool hasTextsOf(const CellSheet& sheet, int row) const;
    /** Reports that shown rows, from the first to the last, look different. */
    void reportRows(int first, int last, const QList<int>& roles = {});

private:
    [[nodiscard]] std::vector<int> orderOf(const CellSheet& sheet) const;
    void rearrange(std::vector<int> order);
    [[nodiscard]] const CellColumn& columnAt(int column) const;

    CellSheet m_sheet;
    std::vector<int> m_order;    ///< rows of the sheet in the order shown
    std::optional<int> m_column; ///< nullopt keeps the order of the sheet
    Qt::SortOrder m_direction = Qt::AscendingOrder;
};

/** Returns columns in which all but the first are aligned to the right. */
[[nodiscard]] std::vector<CellColumn> withNumbers(std::vector<CellColumn> columns);

} // namespace berg
