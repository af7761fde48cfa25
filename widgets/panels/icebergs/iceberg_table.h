#pragma once

#include "widgets/document/scenario_document.h"
#include "widgets/document/selection.h"
#include "widgets/flight/flight_record.h"
#include "widgets/theme/theme.h"

#include <QStringList>
#include <QWidget>

class QLabel;
class QLineEdit;

namespace berg {

class IcebergTableDelegate;
class IcebergTableModel;
class IcebergTableView;
enum class IcebergColumn;

/**
 * Table of icebergs: before take-off an editable spreadsheet, in flight the state at the instant
 * shown. Its selection is shared with map and charts. Updates keep scroll position, selection and
 * sorting.
 */
class IcebergTable : public QWidget
{
    Q_OBJECT

public:
    /** Borrows both, which must outlive the panel. */
    IcebergTable(ScenarioDocument& document, Selection& selection, QWidget* parent = nullptr);
    ~IcebergTable() override;

    void setTheme(const Theme& theme);
    /** Sets sigma at the end of the colour scale, as on the map. */
    void setSigmaFull(double full_m2);
    /** Shows the document before take-off, or the instant shown in flight. */
    void showRecord(const FlightRecord& record);
    /**
     * Highlights the row of this iceberg, e.g. while the pointer is on it on the map; an empty id
     * clears it.
     */
    void setHighlight(const std::string& id);
    /** Accepts typed text as if Return had been pressed. */
    void finishTyping();

    /** Sets the keys of hidden columns. */
    void setHiddenColumns(const QStringList& keys);
    [[nodiscard]] const QStringList& hiddenColumns() const { return m_hiddenColumns; }

signals:
    /**
     * Emitted when the pointer moves to the row of this iceberg, or with an empty id when it
     * leaves.
     */
    void hovered(const std::string& id);
    /** Requests to show an iceberg on the map: double click in flight, or Return. */
    void chosen(const std::string& id);
    /** Requests to paste icebergs of the map, not cells, from the clipboard. */
    void mapPasteRequested();
    /** Emitted when the user hides or shows columns. */
    void hiddenColumnsChanged(const QStringList& keys);

protected:
    void showEvent(QShowEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void setUpTable();
    void connectTable();
    void showDocument();
    void refresh();
    void showColumns();
    [[nodiscard]] int markWidth(IcebergColumn column) const;
    void setColumnWidths();
    void showFilter();
    void showEmpty();
    void showSelection();
    void scrollToSelection();
    void acceptSelection();
    void setHovered(const std::string& id);
    void editAll(const QModelIndex& index, const QVariant& value);
    void copy();
    void paste();
    void say(const QString& fault);
    void showColumnMenu(const QPoint& at);
    void showCellMenu(const QPoint& at);

    ScenarioDocument& m_document;
    Selection& m_selection;
    IcebergTableModel* m_model;
    IcebergTableDelegate* m_delegate;
    IcebergTableView* m_table;
    QLineEdit* m_filter;
    QLabel* m_fault; ///< reason for a rejected paste
    QLabel* m_empty;
    QStringList m_hiddenColumns;
    double m_sigmaFull_m2 = 0;
    std::string m_hovered;
    std::string m_current; ///< Id of the current row, by which it is found again after a reset.
    bool m_isSelecting = false; ///< whether a selection is being copied between table and map
};

} // namespace berg
