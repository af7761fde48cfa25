#pragma once

#include <QTableView>

namespace berg {

/** Table view with the keys of a spreadsheet; letters remain shortcuts of the window. */
class IcebergTableView : public QTableView
{
    Q_OBJECT

public:
    explicit IcebergTableView(QWidget* parent = nullptr);

    /** Returns the visible columns, from left to right. */
    [[nodiscard]] std::vector<int> shownColumns() const;
    /** Returns the selected rows, from top to bottom. */
    [[nodiscard]] std::vector<int> selectedRows() const;

signals:
    void copyRequested();
    void pasteRequested();
    /** Emitted by Return or a double click on a row that cannot be edited. */
    void chosen(const QModelIndex& index);
    /** Emitted when the pointer moves to this row; the index is invalid when it leaves. */
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
