#pragma once

#include <QTableView>

namespace berg {

/** A table view with the keys of a spreadsheet; letters stay the shortcuts of the window. */
class IcebergTableView : public QTableView
{
    Q_OBJECT

public:
    explicit IcebergTableView(QWidget* parent = nullptr);

    /** Columns that are not hidden, from left to right. */
    [[nodiscard]] std::vector<int> shownColumns() const;
    /** Rows selected, from top to bottom. */
    [[nodiscard]] std::vector<int> selectedRows() const;

signals:
    void copyRequested();
    void pasteRequested();
    /** Return or a double click on a row that cannot be edited. */
    void chosen(const QModelIndex& index);
    /** The pointer is on this row; invalid: on none any more. */
    void pointedAt(const QModelIndex& index);

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void leaveEvent(QEvent* event) override;
    bool edit(const QModelIndex& index, EditTrigger trigger, QEvent* event) override;
    using QTableView::edit;

private:
    [[nodiscard]] bool isMine(const QKeyEvent& key) const;
    [[nodiscard]] bool startsNumber(const QKeyEvent& key) const;
};

} // namespace berg
