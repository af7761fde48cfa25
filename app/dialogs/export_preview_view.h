#pragma once

#include "app/dialogs/import_cells.h"
#include "widgets/document/scenario_document.h"
#include "widgets/document/selection.h"
#include "widgets/flight/export_preview.h"

#include <QTabWidget>

class QPlainTextEdit;
class QScrollArea;

namespace berg {

class MapView;
struct Theme;

using ExportPreviewPointer = std::shared_ptr<const ExportPreview>;

class PageView;

/** Preview of an export: the page, or the paths on a map, the waypoints and the beginning of the
 * file. */
class ExportPreviewView : public QTabWidget
{
    Q_OBJECT

public:
    explicit ExportPreviewView(const Theme& theme, QWidget* parent = nullptr);
    ~ExportPreviewView() override;

    /** Shows a preview without an error. */
    void showPreview(const ExportPreviewPointer& preview);

private:
    ScenarioDocument m_document; ///< stays empty; the map shows pictures
    Selection m_selection;
    CellModel m_cells;
    QScrollArea* m_scroll = nullptr;
    PageView* m_page;
    MapView* m_map = nullptr;
    QTableView* m_waypoints = nullptr;
    QPlainTextEdit* m_text;
    bool m_isFitted = false;
};

} // namespace berg
