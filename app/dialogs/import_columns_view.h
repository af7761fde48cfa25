#pragma once

#include "app/dialogs/import_cells.h"
#include "widgets/sightings/column_memory.h"

#include <QWidget>

#include <vector>

class QComboBox;
class QFormLayout;
class QLabel;
class QMenu;
class QPushButton;
class QSpinBox;
class QTableView;

namespace berg {

/**
 * Assigns the columns of a table to fields, beside the first rows of the file. A field set to
 * Automatic uses the column whose name matches.
 */
class ImportColumnsView : public QWidget
{
    Q_OBJECT

public:
    explicit ImportColumnsView(QWidget* parent = nullptr);

    void showPreview(const PreviewPointer& preview);
    /** Returns the user's choices; other fields are guessed. */
    [[nodiscard]] ColumnMapping mapping() const;
    /** Returns the line of the header, or nullopt if it is detected. */
    [[nodiscard]] std::optional<std::size_t> headerLine() const;
    /** Resets all fields to Automatic, e.g. for another format. */
    void clear();
    /**
     * Chooses the columns of `mapping` that the file has, without emitting `edited`. Returns
     * whether it has any.
     */
    bool choose(const ColumnMapping& mapping);
    /**
     * Lists remembered headers. `isInUse` is true if the present choice comes from an earlier
     * import.
     */
    void showMemory(const std::vector<RememberedColumns>& all, bool isInUse);

signals:
    void edited();
    /** Requests to forget this header, or all headers if `fingerprint` is empty. */
    void forgetRequested(const QString& fingerprint);

private:
    [[nodiscard]] QWidget* makeHeaderLine();
    [[nodiscard]] QWidget* makeMemory();
    void fill(QComboBox& combo, const QStringList& columns, const QString& guess);

    QLabel* m_words = nullptr;
    QSpinBox* m_headerLine = nullptr;
    QWidget* m_headerRow = nullptr;
    QLabel* m_inUse = nullptr;
    QPushButton* m_memory = nullptr;
    QMenu* m_memoryMenu = nullptr;
    QWidget* m_fields = nullptr;
    std::vector<QComboBox*> m_combos; ///< by field
    CellModel m_rows;
    QTableView* m_table = nullptr;
};

} // namespace berg
