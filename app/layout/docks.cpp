#include "app/layout/docks.h"

#include "app/layout/panels.h"
#include "app/layout/tab_order.h"
#include "widgets/charts/comparison_chart.h"
#include "widgets/charts/pareto_chart.h"
#include "widgets/map/view/map_view.h"
#include "widgets/panels/aircraft/aircraft_panel.h"
#include "widgets/panels/flight/chart_panel.h"
#include "widgets/panels/flight/event_panel.h"
#include "widgets/panels/flight/message_list.h"
#include "widgets/panels/icebergs/iceberg_table.h"
#include "widgets/panels/inspector/check_panel.h"
#include "widgets/panels/inspector/inspector_panel.h"
#include "widgets/panels/map/layers_panel.h"
#include "widgets/panels/plan/plan_panel.h"
#include "widgets/panels/plan/tradeoff_panel.h"
#include "widgets/panels/study/comparison_panel.h"
#include "widgets/panels/study/solve_time_panel.h"
#include "widgets/panels/study/start_panel.h"
#include "widgets/panels/study/study_panel.h"
#include "widgets/workspace/workspace.h"

#include <QAction>
#include <QDockWidget>
#include <QMainWindow>
#include <QScreen>
#include <QScrollArea>
#include <QSettings>
#include <QUndoView>

#include <algorithm>

namespace berg {

namespace {

constexpr int kLayoutVersion = 3;       ///< of the docks' saved places
constexpr QSize kStudyFrame_px(24, 48); ///< title and edges of the window of a study

constexpr const char* kLayoutKey = "window/layout";
constexpr const char* kFoldedKey = "inspector/folded";
constexpr const char* kWasBehind = "wasBehind"; ///< property of a dock: as it was toggled

/** Returns the settings key of the saved layout. */
QString keyOf(Layout layout)
{
    return QStringLiteral("window/layout-%1").arg(static_cast<int>(layout));
}

/** Does not ask for the room it is best in. */
QWidget* scrolling(QWidget* content)
{
    auto* scroll = new QScrollArea;
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setFocusPolicy(Qt::NoFocus);
    scroll->setWidget(content);
    return scroll;
}

} // namespace

Docks::Docks(WindowContext& context) : WindowPart(context)
{
    window().setDockOptions(QMainWindow::AnimatedDocks | QMainWindow::AllowNestedDocks |
                            QMainWindow::AllowTabbedDocks);
    window().setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
    addRight();
    addBottom();
    addStudies();
    const auto resize = [this](const std::vector<Dock>& which, const QList<int>& sizes_px,
                               Qt::Orientation along) {
        QList<QDockWidget*> docks;
        for (const Dock one : which)
            docks.push_back(dock(one));
        window().resizeDocks(docks, sizes_px, along);
    };
    resize({Dock::Tradeoff}, {330}, Qt::Horizontal); // lists of the inspector show their words
    resize({Dock::Zeta}, {230}, Qt::Vertical);
    resize({Dock::Zeta, Dock::Sigma}, {470, 490}, Qt::Horizontal);
    shareRight();
}

/** Between the trade-off, which needs so much, and the plan, which has use for all there is. */
void Docks::shareRight() const
{
    window().resizeDocks({dock(Dock::Tradeoff), dock(Dock::Plan)}, {300, 400}, Qt::Vertical);
}

QDockWidget* Docks::add(const char* name, const QString& title, QWidget* content,
                        Qt::DockWidgetArea area)
{
    auto* widget = new QDockWidget(title, &window());
    widget->setObjectName(QLatin1String(name));
    widget->setWidget(content);
    window().addDockWidget(area, widget);
    connect(widget, &QDockWidget::visibilityChanged, this, [this](bool visible) {
        if (visible)
            emit shown();
    });
    connect(
        widget, &QDockWidget::visibilityChanged, this,
        [this] { // what is typed is to be seen
            if (const QWidget* focused = window().focusWidget();
                focused != nullptr && isBehindATab(*focused))
                panels().map->setFocus();
        },
        Qt::QueuedConnection);
    widget->toggleViewAction()->setObjectName(QStringLiteral("%1Action").arg(QLatin1String(name)));
    // Behind another tab it is not seen: then its command shows it, and closes it only in front.
    connect(widget->toggleViewAction(), &QAction::toggled, widget, [widget](bool isShown) {
        widget->setProperty(kWasBehind, !isShown && isBehindATab(*widget));
    });
    connect(widget->toggleViewAction(), &QAction::triggered, widget, [this, widget](bool isShown) {
        if (!isShown && !widget->property(kWasBehind).toBool())
            return;
        widget->show();
        widget->raise(); // among its tabs
        if (widget->widget()->focusProxy() != nullptr && !workspace().inFlight())
            widget->widget()->setFocus(); // its first field: one goes on by typing
    });
    m_docks.push_back(widget);
    return widget;
}

void Docks::addRight()
{
    constexpr auto kArea = Qt::RightDockWidgetArea;
    add("tradeoffDock", tr("Trade-off"), panels().tradeoff, kArea)
        ->toggleViewAction()
        ->setStatusTip(tr("Trade-off τ, policy, solver and route"));
    // The height counts only above other docks; beside them all have the same height.
    const auto limitHeight = [this, tradeoff = panels().tradeoff, dock = dock(Dock::Tradeoff)] {
        const Qt::DockWidgetArea area = window().dockWidgetArea(dock);
        const bool isBeside =
            area == Qt::BottomDockWidgetArea || area == Qt::TopDockWidgetArea || dock->isFloating();
        tradeoff->setHeightLimited(!isBeside);
    };
    connect(dock(Dock::Tradeoff), &QDockWidget::dockLocationChanged, this, limitHeight);
    connect(dock(Dock::Tradeoff), &QDockWidget::topLevelChanged, this, limitHeight);
    limitHeight();
    QDockWidget* plan = add("planDock", tr("Plan"), panels().plan, kArea);
    if (settings().contains(kFoldedKey))
        panels().inspector->foldGroups(settings().value(kFoldedKey).toStringList());
    connect(panels().inspector, &InspectorPanel::folded, this,
            [this] { settings().setValue(kFoldedKey, panels().inspector->foldedGroups()); });
    connect(panels().inspector, &InspectorPanel::left, panels().map,
            qOverload<>(&QWidget::setFocus));
    QDockWidget* inspector = add("inspectorDock", tr("Inspector"), panels().inspector, kArea);
    QDockWidget* pareto = add("paretoDock", tr("Pareto curve"), panels().pareto, kArea);
    window().tabifyDockWidget(plan, inspector);
    window().tabifyDockWidget(inspector, pareto);
    QDockWidget* history = add("historyDock", tr("History"), panels().history, kArea);
    window().tabifyDockWidget(pareto, history);
    history->hide(); // for whoever wants it
    plan->raise();
}

void Docks::addBottom()
{
    constexpr auto kArea = Qt::BottomDockWidgetArea;
    QDockWidget* zeta = add("zetaDock", tr("First chart"), panels().charts.front(), kArea);
    QDockWidget* sigma = add("sigmaDock", tr("Second chart"), panels().charts.back(), kArea);
    add("eventsDock", tr("Events"), panels().events, kArea);
    window().splitDockWidget(zeta, sigma, Qt::Horizontal);
    QDockWidget* comparisonChart =
        add("comparisonChartDock", tr("Comparison chart"), panels().comparisonChart, kArea);
    QDockWidget* checks = add("checksDock", tr("Checks"), panels().checks, kArea);
    window().tabifyDockWidget(zeta, comparisonChart);
    window().tabifyDockWidget(comparisonChart, checks);
    zeta->raise();
}

void Docks::addStudies()
{
    constexpr auto kArea = Qt::BottomDockWidgetArea;
    QDockWidget* solveTime =
        add("solveTimeDock", tr("Solve time"), scrolling(panels().solveTime), kArea);
    QDockWidget* study = add("studyDock", tr("Study"), scrolling(panels().study), kArea);
    // Studies, not part of watching a flight; hidden before their tabs ask for room.
    solveTime->hide();
    study->hide();
    // It asks for more room when there are runs, which would move the map.
    QDockWidget* comparison =
        add("comparisonDock", tr("Comparison"), scrolling(panels().comparison), kArea);
    QDockWidget* icebergs = add("icebergsDock", tr("Icebergs"), panels().icebergs, kArea);
    window().tabifyDockWidget(dock(Dock::Sigma), icebergs);
    window().tabifyDockWidget(icebergs, dock(Dock::Events));
    window().tabifyDockWidget(dock(Dock::Events), comparison);
    window().tabifyDockWidget(comparison, solveTime);
    window().tabifyDockWidget(solveTime, study);
    QDockWidget* layers =
        add("layersDock", tr("Map layers"), scrolling(panels().layers), Qt::RightDockWidgetArea);
    window().tabifyDockWidget(dock(Dock::Inspector), layers);
    layers->hide(); // for whoever wants it
    QDockWidget* messages = add("messagesDock", tr("Messages"), panels().messages, kArea);
    window().tabifyDockWidget(dock(Dock::Events), messages);
    messages->hide();
    QDockWidget* aircraft =
        add("aircraftDock", tr("Aircraft"), scrolling(panels().aircraft), Qt::RightDockWidgetArea);
    window().tabifyDockWidget(layers, aircraft);
    aircraft->hide();
    QDockWidget* starts = add("startsDock", tr("Start times"), scrolling(panels().starts), kArea);
    window().tabifyDockWidget(study, starts);
    starts->hide();
    dock(Dock::Sigma)->raise();
    dock(Dock::Plan)->raise();
}

QDockWidget* Docks::dock(Dock which) const
{
    return m_docks[static_cast<std::size_t>(which)];
}

void Docks::raise(Dock which) const
{
    dock(which)->show();
    dock(which)->raise();
}

bool Docks::isInFront(Dock which) const
{
    return dock(which)->isVisible() && !isBehindATab(*dock(which));
}

void Docks::openFloating(Dock which, const QSize& best_px) const
{
    QDockWidget& opened = *dock(which);
    if (!opened.isVisible()) {
        opened.setFloating(true);
        opened.setWindowFlags(Qt::Window); // of its own: it can be below others, large, an icon
        opened.resize((best_px + kStudyFrame_px).boundedTo(window().screen()->availableSize()));
        opened.move(window().geometry().center() - opened.rect().center());
    }
    raise(which);
}

void Docks::openInspector() const
{
    raise(Dock::Inspector);
    panels().inspector->setFocus();
}

void Docks::noteDefault()
{
    m_defaultLayout = window().saveState(kLayoutVersion);
}

void Docks::reset()
{
    arrange(m_layout);
    fitScreen();
}

/** By itself. */
void Docks::arrange(Layout layout) const
{
    window().restoreState(m_defaultLayout, kLayoutVersion);
    if (layout == Layout::Analyse)
        return;
    for (const Dock bottom : {Dock::Zeta, Dock::Sigma, Dock::Events, Dock::ComparisonChart,
                              Dock::Checks, Dock::Comparison, Dock::Icebergs})
        dock(bottom)->hide(); // the map is as wide as it is in all layouts, and higher
    shareRight();
    if (layout == Layout::Plan)
        return;
    dock(Dock::Tradeoff)->hide();
    for (const Dock moved : {Dock::Zeta, Dock::Events}) {
        window().addDockWidget(Qt::RightDockWidgetArea, dock(moved), Qt::Vertical);
        dock(moved)->show();
    }
    window().tabifyDockWidget(dock(Dock::Zeta), dock(Dock::Events));
    dock(Dock::Zeta)->raise();
    dock(Dock::Plan)->raise();
}

/** Puts the right-hand panels into tabs if they are together higher than the screen. */
void Docks::fitScreen() const
{
    if (window().minimumSizeHint().height() <= window().screen()->availableSize().height())
        return;
    for (const Dock other :
         {Dock::Plan, Dock::Inspector, Dock::Pareto, Dock::History, Dock::Layers, Dock::Aircraft})
        window().tabifyDockWidget(dock(Dock::Tradeoff), dock(other));
    dock(Dock::Tradeoff)->raise();
}

void Docks::begin(Layout layout)
{
    arrange(layout);
    fitScreen();
    setLayout(layout);
}

void Docks::showLayout(Layout layout)
{
    settings().setValue(keyOf(m_layout), window().saveState(kLayoutVersion));
    if (!window().restoreState(settings().value(keyOf(layout)).toByteArray(), kLayoutVersion))
        arrange(layout);
    fitScreen();
    setLayout(layout);
}

void Docks::setLayout(Layout layout)
{
    m_layout = layout;
    settings().setValue(kLayoutKey, static_cast<int>(layout));
    emit layoutChanged(layout);
}

void Docks::save() const
{
    settings().setValue("window/geometry", window().saveGeometry());
    settings().setValue("window/state", window().saveState(kLayoutVersion));
}

void Docks::restore()
{
    const int saved = settings().value(kLayoutKey, static_cast<int>(Layout::Analyse)).toInt();
    m_layout = static_cast<Layout>(
        std::clamp(saved, static_cast<int>(Layout::Plan), static_cast<int>(Layout::Analyse)));
    emit layoutChanged(m_layout);
    window().restoreGeometry(settings().value("window/geometry").toByteArray());
    window().restoreState(settings().value("window/state").toByteArray(), kLayoutVersion);
    fitScreen();
}

} // namespace berg
