#pragma once

#include "app/dialogs/import_cells.h"

#include <QWidget>

class QTableView;

namespace berg {

/** A page of the import dialog: one list of rows of the file with line, reason and text. */
class ImportRowsView : public QWidget
{
    Q_OBJECT

public:
    enum class List
    {
        Rejected,
        Noted,  ///< imported in part, or changed
        Outside ///< outside the chosen area or time
    };

    explicit ImportRowsView(List list, QWidget* parent = nullptr);

    void showPreview(const PreviewPointer& preview);
    /** Returns the name of the list with its number of rows. */
    [[nodiscard]] QString title() const;
    [[nodiscard]] bool isEmpty() const { return m_count == 0; }

private:
    List m_list;
    std::size_t m_count = 0;
    std::size_t m_listed = 0; ///< number of rows that can be shown
    CellModel m_rows;
    QTableView* m_table = nullptr;
};

} // namespace berg
