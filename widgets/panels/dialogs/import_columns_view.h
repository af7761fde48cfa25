#pragma once

#include "widgets/panels/dialogs/import_cells.h"

#include <QWidget>

#include <vector>

class QComboBox;
class QFormLayout;
class QLabel;
class QTableView;

namespace berg {

/**
 * Which column of a table serves as what, beside the first rows of the file. A field that is left
 * to itself takes the column whose name says so.
 */
class ImportColumnsView : public QWidget
{
    Q_OBJECT

public:
    explicit ImportColumnsView(QWidget* parent = nullptr);

    void showPreview(const PreviewPointer& preview);
    /** What the user has chosen; the rest is guessed. */
    [[nodiscard]] ColumnMapping mapping() const;
    /** Everything guessed again, e.g. for another format. */
    void clear();

signals:
    void edited();

private:
    void fill(QComboBox& combo, const QStringList& columns, const QString& guess);

    QLabel* m_words = nullptr;
    QWidget* m_fields = nullptr;
    std::vector<QComboBox*> m_combos; ///< by field
    CellModel m_rows;
    QTableView* m_table = nullptr;
};

} // namespace berg
