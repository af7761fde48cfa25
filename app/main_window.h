#pragma once

#include "app/interaction.h"
#include "app/system_appearance.h"
#include "widgets/map/map_tools.h"
#include "widgets/model/workspace.h"
#include "widgets/panels/run_time_line.h"
#include "widgets/theme/icons.h"
#include "widgets/theme/theme.h"

#include <QMainWindow>
#include <QSettings>
#include <QTimer>

#include <array>
#include <optional>

class QAction;
class QActionGroup;
class QLabel;
class QMenu;

namespace berg {

class ChartPanel;
class ComparisonChart;
class ComparisonPanel;
class EventPanel;
class FlightBanner;
class InspectorPanel;
class MapView;
class ParetoChart;
class PlanPanel;
class PlaybackBar;
class SolveTimePanel;
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
    void setAppearance(Appearance appearance);
    /** Applies a theme now; `setAppearance` decides it in daily use. */
    void applyTheme(const Theme& theme);
    [[nodiscard]] MapView& mapView() { return *m_map; }

signals:
    /** Another language was chosen: the owner makes a new window. Empty: the system's. */
    void languageChosen(const QString& language);

protected:
    void closeEvent(QCloseEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;
    void changeEvent(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    static constexpr int kLayoutVersion = 2; ///< of the docks' saved places

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
    void showFlight();
    void showCharts();
    void showEvents();
    void showCurve();
    void showSelection();
    void showComparison();
    void showPlanner();
    void showTitle();
    void showCursor(const Point& position_m);
    void setInFlight(bool inFlight);
    void followSystem();
    void togglePlay();
    void showContextMenu(const QPoint& globalPos);

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
    [[nodiscard]] bool maySettleChanges();
    void newScenario();
    void openScenario();
    bool saveScenario();
    bool saveScenarioAs();
    bool saveTo(const QString& path);
    void saveRun();
    void exportPlan();
    void writeExport(const QString& path, const std::string& content);
    void writeRun(const QString& path, const RunFile& run);
    void saveTable(const std::string& csv);
    void exportChart(const ChartPanel& chart);
    void openRunToCompare();
    void rememberFile(const QString& path);
    void fillRecentMenu();

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
    FlightBanner* m_banner = nullptr;
    EventPanel* m_events = nullptr;
    std::vector<QDockWidget*> m_docks;
    QByteArray m_defaultLayout;

    std::vector<std::pair<QAction*, IconName>> m_icons;
    std::vector<QAction*> m_editActions; ///< locked in flight
    QActionGroup* m_tools = nullptr;
    QMenu* m_recentMenu = nullptr;
    QAction* m_followAction = nullptr;
    QAction* m_playAction = nullptr;
    QLabel* m_hintLabel = nullptr; ///< what the tool expects
    QLabel* m_cursorLabel = nullptr;
    QLabel* m_stateLabel = nullptr;

    std::vector<TimeMark> m_marks;  ///< on the time line
    std::size_t m_markedEvents = 0; ///< of the history, turned into marks
    std::uint64_t m_markRewrites = 0;
    QTimer m_chartTimer; ///< charts at most 25 times a second
};

} // namespace berg
