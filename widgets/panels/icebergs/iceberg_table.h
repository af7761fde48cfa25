#pragma once

#include "widgets/model/flight_record.h"
#include "widgets/model/scenario_document.h"
#include "widgets/model/selection.h"
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
 * The icebergs as a table: before take-off a spreadsheet to edit them in, in flight how each of
 * them stands at the instant shown. Its rows are selected with those of map and charts. Updated in
 * place: scroll position, selection and sorting stay.
 */
class IcebergTable : public QWidget
{
    Q_OBJECT

public:
    /** Both are borrowed and must outlive the panel. */
    IcebergTable(ScenarioDocument& document, Selection& selection, QWidget* parent = nullptr);
    ~IcebergTable() override;

    void setTheme(const Theme& theme);
    /** sigma at the end of the colour scale, the same as on the map. */
    void setSigmaFull(double full_m2);
    /** The document before take-off, in flight the instant shown. */
    void showRecord(const FlightRecord& record);
    /** Marks this iceberg's row, e.g. while the pointer is on it on the map; empty: none. */
    void setHighlight(const std::string& id);
    /** Takes what is being typed as if Return had been pressed. */
    void finishTyping();

    /** Keys of columns not to be shown. */
    void setHiddenColumns(const QStringList& keys);
    [[nodiscard]] const QStringList& hiddenColumns() const { return m_hiddenColumns; }

signals:
    /** The pointer is on this iceberg's row; empty: on none any more. */
    void hovered(const std::string& id);
    /** Double-clicked in flight, or Return pressed: to be shown on the map. */
    void chosen(const std::string& id);
    /** There are icebergs cut or copied on the map on the clipboard, not cells. */
    void mapPasteRequested();
    /** By the user. */
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
    QLabel* m_fault; ///< why something was not pasted
    QLabel* m_empty;
    QStringList m_hiddenColumns;
    double m_sigmaFull_m2 = 0;
    std::string m_hovered;
    std::string m_current;      ///< id of the current row, found again when the rows are begun anew
    bool m_isSelecting = false; ///< the selection is going from here to there, or back
};

} // namespace berg
