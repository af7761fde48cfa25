#pragma once

#include "app/dialogs/interaction.h"
#include "widgets/model/import_runner.h"
#include "widgets/model/scenario_document.h"
#include "widgets/model/selection.h"
#include "widgets/panels/dialogs/import_cells.h"

#include <QDialog>

class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QStackedWidget;
class QTabWidget;
class QTableView;

namespace berg {

class CaptionLabel;
class ImportColumnsView;
class ImportOptionsView;
class MapView;

/**
 * Shows what an import would do while it is being set up: map, counts, icebergs, rejected rows. All
 * reading is the runner's. Changes nothing itself.
 */
class ImportDialog : public QDialog
{
    Q_OBJECT

public:
    /** The runner is borrowed; the dialog leaves it without work. */
    ImportDialog(ImportRunner& runner, const ImportOffer& offer, QWidget* parent = nullptr);
    ~ImportDialog() override;

    /** Of the preview shown; none: there is nothing to import, or it is not known yet. */
    [[nodiscard]] std::optional<ImportChoice> choice() const;

private:
    [[nodiscard]] QWidget* makeSettings();
    [[nodiscard]] QWidget* makeResults();
    [[nodiscard]] QLayout* makeFoot();
    void fillFormats();
    void request(bool atOnce);
    void changeFormat();
    void take(const PreviewPointer& preview);
    void showOutcome();
    void showTables();
    void showState();
    void selectRow();
    void selectOnMap();

    ImportRunner& m_runner;
    ImportOffer m_offer;
    std::shared_ptr<const Scenario> m_new; ///< what a new scenario begins as
    PreviewPointer m_preview;              ///< newest, also when it is of an earlier request
    std::optional<LatLon> m_shownOrigin;   ///< of the map

    ScenarioDocument m_document; ///< empty: the map shows pictures
    Selection m_selection;
    CellModel m_icebergs;
    CellModel m_rejected;

    QComboBox* m_format = nullptr;
    ImportOptionsView* m_options = nullptr;
    ImportColumnsView* m_columns = nullptr;
    QStackedWidget* m_outcome = nullptr; ///< the map, or why there is none
    MapView* m_map = nullptr;
    QLabel* m_error = nullptr;
    QLabel* m_summary = nullptr;
    CaptionLabel* m_scene = nullptr; ///< what becomes of the file's UAVs, area and asset
    CaptionLabel* m_legend = nullptr;
    QTabWidget* m_tabs = nullptr;
    QTableView* m_icebergTable = nullptr;
    QTableView* m_rejectedTable = nullptr;
    QProgressBar* m_progress = nullptr;
    QPushButton* m_import = nullptr;
    QPushButton* m_intoNew = nullptr;
};

} // namespace berg
