#pragma once

#include "app/interaction.h"
#include "app/system_appearance.h"
#include "widgets/map/map_tools.h"
#include "widgets/model/workspace.h"
#include "widgets/panels/flight/run_time_line.h"
#include "widgets/theme/icons.h"
#include "widgets/theme/theme.h"

#include <QMainWindow>
#include <QSettings>
#include <QTimer>

#include <array>
#include <functional>
#include <optional>

class QAction;
class QActionGroup;
class QLabel;
class QToolButton;
class QMenu;
class QUndoView;

namespace berg {

class CaptionLabel;
class ChartPanel;
class CheckPanel;
class ComparisonChart;
class ComparisonPanel;
class EventPanel;
class FlightBanner;
class GotoBar;
class IcebergTable;
class InspectorPanel;
class MapView;
class OverviewInset;
class ParetoChart;
class PlaceMark;
class PlanPanel;
class PlaybackBar;
class SolveTimePanel;
class StartPage;
class StudyPanel;
class Tour;
class TradeoffPanel;

/** Appearance by the user's choice. */
enum class Appearance
{
    System,
    Light,
    Dark
};

/**
 * The window: menus, tool bar, map in the middle, panels round it. Composition only; what it shows
 * is in the workspace, which outlives it.
 */
class MainWindow : public QMainWindow
{
    Q_OBJECT

public:
    MainWindow(Workspace& workspace, Interaction& interaction, QSettings& settings);
    ~MainWindow() override;

    /** Opens a scenario after the question about unsaved changes; false when it was not opened. */
    bool openFile(const QString& path);
    /** By its ending. Its results are shown beside the scenario, which stays. */
    [[nodiscard]] static bool isStudyFile(const QString& path);
    /** Over everything but the menus; opening anything closes it. */
    void showStartPage();
    [[nodiscard]] bool startPageIsShown() const { return m_startPage != nullptr; }
    /** Whether the user wants it when no file is named. */
    [[nodiscard]] static bool wantsStartPage(const QSettings& settings);
    /** Unsaved work of programs that ended unexpectedly; false, and no question: there is none. */
    bool offerRecoveries();
    /** The user logs out; false: not now. Without a question what is unsaved is left to recovery.
     * What was agreed holds until the window is closed by the end of the program, which follows,
     * or used again. */
    [[nodiscard]] bool mayEndSession(bool mayAsk);
    /** Carries on in place of another window of the same workspace: what that one awaits, and what
     * was last chosen in it. */
    void takeOver(MainWindow& other);
    void setAppearance(Appearance appearance);
    /** Applies a theme now; `setAppearance` decides it in daily use. */
    void applyTheme(const Theme& theme);
    [[nodiscard]] MapView& mapView() { return *m_map; }
    /** Waits until all the land last painted can be painted: for pictures. */
    void finishLand();

signals:
    /** Another language was chosen: the owner makes a new window. Empty: the system's. */
    void languageChosen(const QString& language);
    /** Other units were chosen, and are in the settings: as another language. */
    void unitsChosen();

protected:
    void closeEvent(QCloseEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;
    void changeEvent(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;
    bool focusNextPrevChild(bool next) override;

private:
    // Settings
    static constexpr const char* kKeepOldKey = "files/keepOld"; ///< on unless told otherwise
    static constexpr const char* kRecentFilesKey = "files/recent";
    static constexpr const char* kShowAtStartKey = "start/show"; ///< on unless told otherwise
    static constexpr const char* kStudyWorthKey =
        "study/worthSaving_s"; ///< asked about from then on
    static constexpr const char* kTourSeenKey = "start/tourSeen";

    static constexpr int kLayoutVersion = 3; ///< of the docks' saved places

    struct ActionSpec
    {
        const char* name; ///< object name, for tests and settings
        QString text;
        QKeySequence shortcut;
        std::optional<IconName> icon;
    };

    // main_window.cpp
    void buildPanels();
    void buildDocks();
    void connectPanels();
    void connectWorkspace();
    void connectPlanner();
    void connectFlight();
    void connectCharts();
    void connectTables();
    void connectMap();
    void showFlight();
    void showPlan();
    void showCharts();
    void showChart(ChartPanel& chart);
    void showChartsSoon();
    void showNextChart();
    void showTables();
    void showEvents();
    void showCurve();
    void showSelection();
    void showComparison();
    void showPlanner();
    void showTitle();
    void showOverview();
    void showCursor(const Point& position_m);
    void setInFlight(bool inFlight);
    void showGivenUp();
    void followSystem();
    void togglePlay();
    void askWind();
    void openInspector();

    // main_window_checks.cpp
    void connectChecks();
    void showChecks();
    void openChecks();
    void showCulprit(const Issue& issue);
    [[nodiscard]] QString planFault() const;
    void generateIcebergs();

    // main_window_menu.cpp
    void showContextMenu(const QPoint& globalPos, const Point& position_m, const std::string& id);
    void showPlanMenu(const QPoint& globalPos, const std::string& id);
    void addHandOverActions(QMenu& menu, const std::string& id);
    void addObjectActions(QMenu& menu, const std::string& id);
    void addWaterActions(QMenu& menu, const Point& position_m);

    // main_window_actions.cpp
    template <class Slot>
    QAction* addAction(QMenu& menu, const ActionSpec& spec, const Slot& slot);
    void buildActions();
    void buildFileMenu();
    void buildEditMenu();
    void buildViewMenu();
    void buildFlightMenu();
    void buildHelpMenu();
    void buildToolBar();
    void addTool(MapToolKind kind, const ActionSpec& spec);
    void addChoice(QMenu& menu, const QString& text, const QString& key, const QString& value);
    void refreshIcons();
    void updateActions();
    void showShortcuts();
    void showAbout();

    // main_window_files.cpp
    void finishTyping();
    [[nodiscard]] bool mayLeaveScene(Interaction::FlightEnd why);
    [[nodiscard]] bool mayEndFlight(Interaction::FlightEnd why);
    [[nodiscard]] bool mayAnswer(bool wasInFlight);
    [[nodiscard]] bool openUnlessInUse(const QString& path);
    [[nodiscard]] Interaction::Overwrite mayOverwrite(const QString& path);
    void newScenario();
    void openScenario();
    bool saveScenario();
    bool saveScenarioAs();
    bool saveTo(const QString& path);
    void saveRun();
    void exportPlan();
    [[nodiscard]] bool isStillOf(std::uint64_t generation);
    void writeExport(const std::vector<ExportFile>& files);
    void writeRun(const QString& path, const RunFile& run);
    void exportChart(const ChartPanel& chart);
    void openRunToCompare();
    void rememberFile(const QString& path);
    void fillRecentMenu();

    // main_window_import.cpp
    [[nodiscard]] bool mayImport();
    void chooseSightings();
    void importSightings(const QString& path);
    void takeImport(const ImportChoice& choice, const QString& fileName);
    void openDropped(const QString& path);

    // main_window_places.cpp
    void buildPlaces();
    void buildUnitMenu(QMenu& menu);
    void openGoto();
    void showPlace(const LatLon& place, const QString& name);
    void moveScenario(const LatLon& suggested);

    // main_window_start.cpp
    void connectStartPage(StartPage& page);
    [[nodiscard]] QString fileToContinue() const;
    void closeStartPage();
    void openExample(const QString& path);
    void startTour();

    // main_window_safety.cpp
    void connectSafety();
    void restore(FoundRecovery found);
    void showDamaged(const QString& path);
    void lookAtFile();
    void followEnd(const QEvent& event);

    // main_window_study.cpp
    void connectStudy();
    [[nodiscard]] QString studyPath(const QString& extension, const QString& filter);
    void saveStudyPicture();
    [[nodiscard]] Interaction::Unsaved askAboutStudy();
    bool saveStudy();
    bool saveStudyNow();
    /** To be done once a study is in its file, by the window that there is then. */
    using AfterStudy = std::function<void(MainWindow&)>;
    [[nodiscard]] bool maySettleStudy(AfterStudy then);
    void replaceStudy(const AfterStudy& replace);
    [[nodiscard]] bool isWorthSaving(double unsaved_s) const;
    bool saveSolveTimes();
    [[nodiscard]] bool maySettleSolveTimes();
    void openStudyDock(const QString& name, const QSize& best_px);
    void showStudy();
    [[nodiscard]] bool flyOnMap(const Scenario& scenario, const QString& text);
    void compareFlights(const Scenario& scenario, const PlannerSettings& best,
                        const PlannerSettings& tsp);
    void finishComparison();

    /** Two flights to be set beside each other when both have ended. */
    struct ComparedPair
    {
        Scenario world;
        PlannerSettings reference;
        PlannerSettings other;
    };

    /** Goes to the window made in place of this one. */
    struct CarriedOver
    {
        std::optional<ComparedPair> compared; ///< awaited
        AfterStudy afterStudySaved;           ///< awaited; none: nothing
        ExportOptions exportOptions;          ///< last chosen
        QDateTime reloadRefused;              ///< of this change of the file
    };

    Workspace& m_workspace;
    Interaction& m_interaction;
    QSettings& m_settings;
    Theme m_theme;
    SystemAppearance m_system;
    Appearance m_appearance = Appearance::System;

    MapView* m_map = nullptr;
    TradeoffPanel* m_tradeoff = nullptr;
    PlanPanel* m_plan = nullptr;
    InspectorPanel* m_inspector = nullptr;
    PlaybackBar* m_playback = nullptr;
    std::array<ChartPanel*, 2> m_charts{};
    ComparisonPanel* m_comparison = nullptr;
    ComparisonChart* m_comparisonChart = nullptr;
    ParetoChart* m_pareto = nullptr;
    SolveTimePanel* m_solveTime = nullptr;
    StudyPanel* m_study = nullptr;
    FlightBanner* m_banner = nullptr;
    OverviewInset* m_overview = nullptr;
    GotoBar* m_goto = nullptr;
    PlaceMark* m_placeMark = nullptr;
    IcebergTable* m_icebergs = nullptr;
    EventPanel* m_events = nullptr;
    CheckPanel* m_checks = nullptr;
    std::vector<QDockWidget*> m_docks;
    QByteArray m_defaultLayout;

    std::vector<std::pair<QAction*, IconName>> m_icons;
    std::vector<QAction*> m_editActions; ///< locked in flight
    QActionGroup* m_tools = nullptr;
    QMenu* m_recentMenu = nullptr;
    QAction* m_followAction = nullptr;
    QAction* m_sweptAction = nullptr; ///< whether the water seen so far is shown
    QAction* m_truthAction = nullptr; ///< whether true positions are
    QAction* m_playAction = nullptr;
    QLabel* m_hintLabel = nullptr; ///< what the tool expects
    QLabel* m_cursorLabel = nullptr;
    QLabel* m_stateLabel = nullptr;
    QToolButton* m_checksButton = nullptr; ///< counts errors and warnings, where there are any
    CaptionLabel* m_autosaveLabel = nullptr;
    QUndoView* m_history = nullptr;
    StartPage* m_startPage = nullptr; ///< while it is shown
    Tour* m_tour = nullptr;           ///< while it goes on

    CarriedOver m_carried;
    bool m_endAgreed = false;  ///< the user logs out, and has not come back since
    bool m_ends = false;       ///< all windows are being closed for that
    bool m_asksReload = false; ///< the question is on screen

    std::vector<TimeMark> m_marks;  ///< on the time line
    std::size_t m_markedEvents = 0; ///< of the history, turned into marks
    std::uint64_t m_markRewrites = 0;
    QTimer m_chartTimer; ///< each chart at most 25 times a second
    std::size_t m_nextChart = 0;
    std::size_t m_chartsDue = 0; ///< so many do not show the newest yet
    QTimer m_givenUpTimer;       ///< until the banner says no more of a flight that was given up
    QTimer m_tableTimer; ///< tables of icebergs and, in flight, of the plan at most 10 times
};

} // namespace berg
