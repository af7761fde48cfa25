#pragma once

#include "app/dialogs/import_cells.h"
#include "app/dialogs/interaction.h"
#include "widgets/document/scenario_document.h"
#include "widgets/document/selection.h"
#include "widgets/sightings/import_runner.h"

#include <QDialog>

#include <array>

class QCheckBox;
class QComboBox;
class QLabel;
class QProgressBar;
class QSettings;
class QPushButton;
class QStackedWidget;
class QTabWidget;
class QTableView;

namespace berg {

class CaptionLabel;
class ImportColumnsView;
class ImportIdentityView;
class ImportOptionsView;
class ImportRowsView;
class MapView;

/**
 * Dialog that sets up an import and previews its effect: map, counts, icebergs, rejected rows. The
 * runner reads the file. The dialog changes nothing.
 */
class ImportDialog : public QDialog
{
    Q_OBJECT

public:
    /** The runner must outlive the dialog, which stops its work at the end. `settings` store the
     * chosen columns; null stores nothing. */
    ImportDialog(ImportRunner& runner, const ImportOffer& offer, QWidget* parent = nullptr,
                 QSettings* settings = nullptr);
    ~ImportDialog() override;

    /** Returns the choice of the preview shown; nullopt if there is nothing to import or no preview
     * yet. */
    [[nodiscard]] std::optional<ImportChoice> choice() const;

private:
    [[nodiscard]] QWidget* makeInputs();
    [[nodiscard]] QWidget* makeResults();
    [[nodiscard]] QLayout* makeFoot();
    void fillFormats();
    void request(bool atOnce);
    void changeFormat();
    void take(const PreviewPointer& preview);
    /** Requests a preview with the columns of the last file with this header, if there was one. */
    void recallColumns();
    void keepColumns();
    void forget(const QString& fingerprint);
    void showMemory();
    void showOutcome();
    void showTables();
    void showState();
    void showRemarks(bool usable);
    [[nodiscard]] bool isAgreed() const;
    void selectRow();
    void selectOnMap();

    ImportRunner& m_runner;
    ImportOffer m_offer;
    QSettings* m_settings;                 ///< may be null
    QString m_recalledFor;                 ///< header for which columns were looked up
    bool m_isRecalled = false;             ///< the columns are those of an earlier import
    std::shared_ptr<const Scenario> m_new; ///< initial content of a new scenario
    PreviewPointer m_preview;              ///< newest, possibly of an earlier request
    std::optional<LatLon> m_shownOrigin;   ///< of the map

    ScenarioDocument m_document; ///< stays empty; the map shows pictures
    Selection m_selection;
    CellModel m_icebergs;

    QComboBox* m_format = nullptr;
    ImportOptionsView* m_options = nullptr;
    ImportColumnsView* m_columns = nullptr;
    ImportIdentityView* m_identity = nullptr;
    QStackedWidget* m_outcome = nullptr; ///< the map, or the reason that there is none
    MapView* m_map = nullptr;
    QLabel* m_error = nullptr;
    QLabel* m_summary = nullptr;
    CaptionLabel* m_scene = nullptr; ///< treatment of the file's UAVs, area and asset
    CaptionLabel* m_legend = nullptr;
    QTabWidget* m_tabs = nullptr;
    QTableView* m_icebergTable = nullptr;
    std::array<ImportRowsView*, 3> m_rowLists{}; ///< by `ImportRowsView::List`
    QProgressBar* m_progress = nullptr;
    QCheckBox* m_consent = nullptr; ///< to icebergs that are too fast or on land
    QPushButton* m_import = nullptr;
    QPushButton* m_intoNew = nullptr;
};

} // namespace berg
