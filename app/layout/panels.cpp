#include "app/layout/panels.h"

#include "widgets/charts/comparison_chart.h"
#include "widgets/charts/pareto_chart.h"
#include "widgets/map/paint/overview_inset.h"
#include "widgets/map/view/map_view.h"
#include "widgets/map/view/place_mark.h"
#include "widgets/panels/aircraft/aircraft_panel.h"
#include "widgets/panels/flight/alarm_strip.h"
#include "widgets/panels/flight/chart_panel.h"
#include "widgets/panels/flight/event_panel.h"
#include "widgets/panels/flight/message_list.h"
#include "widgets/panels/flight/playback_bar.h"
#include "widgets/panels/icebergs/iceberg_table.h"
#include "widgets/panels/inspector/check_panel.h"
#include "widgets/panels/inspector/inspector_panel.h"
#include "widgets/panels/map/find_box.h"
#include "widgets/panels/map/layers_panel.h"
#include "widgets/panels/plan/plan_panel.h"
#include "widgets/panels/plan/tradeoff_panel.h"
#include "widgets/panels/study/comparison_panel.h"
#include "widgets/panels/study/solve_time_panel.h"
#include "widgets/panels/study/start_panel.h"
#include "widgets/panels/study/study_panel.h"
#include "widgets/theme/announcer.h"
#include "widgets/theme/icons.h"
#include "widgets/workspace/workspace.h"

#include <QCoreApplication>
#include <QResizeEvent>
#include <QUndoView>
#include <QVBoxLayout>

#include <algorithm>

namespace berg {

namespace {

struct PanelText
{
    Q_DECLARE_TR_FUNCTIONS(PanelText)
};

/**
 * Alarms, map and playback below each other. The first line of the alarms has room of its own;
 * more lines lie over the map, which stays where it is.
 */
class Centre final : public QWidget
{
public:
    Centre(AlarmStrip& alarms, MapView& map, QWidget& playback)
        : m_alarms(alarms), m_map(map), m_column(new QVBoxLayout(this))
    {
        alarms.setParent(this);
        m_column->setSpacing(0);
        m_column->addWidget(&map, 1);
        m_column->addWidget(&playback);
        alarms.installEventFilter(this);
        place();
    }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override
    {
        if (event->type() == QEvent::LayoutRequest)
            place();
        return QWidget::eventFilter(watched, event);
    }
    void resizeEvent(QResizeEvent* event) override
    {
        QWidget::resizeEvent(event);
        place();
    }

private:
    void place()
    {
        const int height_px = m_alarms.sizeHint().height();
        m_column->setContentsMargins(0, m_alarms.lineHeight(), 0, 0);
        m_alarms.setGeometry(0, 0, width(), height_px);
        m_alarms.raise();
        m_map.panels().setCover(std::max(0, height_px - m_alarms.lineHeight()));
    }

    AlarmStrip& m_alarms;
    MapView& m_map;
    QVBoxLayout* m_column;
};

} // namespace

Panels::Panels(Workspace& workspace, const Theme& theme)
    : map(new MapView(workspace.document(), workspace.selection()))
    , playback(new PlaybackBar)
    , tradeoff(new TradeoffPanel)
    , plan(new PlanPanel)
    , inspector(new InspectorPanel(workspace.document(), workspace.selection()))
    , charts{new ChartPanel(ChartKind::Zeta, theme), new ChartPanel(ChartKind::Sigma, theme)}
    , pareto(new ParetoChart(theme))
    , solveTime(new SolveTimePanel(workspace.benchmark()))
    , starts(new StartPanel(workspace.starts(), workspace.document()))
    , study(new StudyPanel(workspace.study()))
    , alarms(new AlarmStrip)
    , overview(new OverviewInset(map))
    , history(new QUndoView(workspace.document().undoStack()))
    , events(new EventPanel)
    , checks(new CheckPanel(workspace.document()))
    , icebergs(new IcebergTable(workspace.document(), workspace.selection()))
    , comparison(new ComparisonPanel(workspace.runs()))
    , comparisonChart(new ComparisonChart(theme))
    , placeMark(new PlaceMark(*map))
    , findBox(new FindBox(map))
    , layers(new LayersPanel)
    , messages(new MessageList)
    , announcer(new Announcer)
    , aircraft(new AircraftPanel)
{
    ChartPanel::linkTimes(*charts.front(), *charts.back());
    overview->hide();
    pareto->setTitleShown(false);
    comparisonChart->setTitleShown(false);
    history->setAccessibleName(PanelText::tr("History of edits"));
    history->setEmptyLabel(PanelText::tr("As opened"));
    history->setToolTip(
        PanelText::tr("Click a line to go to that state; the disk marks the saved one."));
}

void Panels::setTheme(const Theme& theme) const
{
    const auto paint = [&theme](auto*... panels) { (panels->setTheme(theme), ...); };
    paint(alarms, overview, findBox, placeMark, map, tradeoff, plan, inspector, playback,
          charts.front(), charts.back(), comparison, comparisonChart, pareto, solveTime, starts,
          study, events, checks, icebergs, messages, aircraft);
    history->setCleanIcon(icon(IconName::Save, theme));
}

void Panels::finishTyping() const
{
    inspector->finishTyping();
    icebergs->finishTyping();
    tradeoff->finishTyping();
}

QWidget* Panels::makeCentre() const
{
    return new Centre(*alarms, *map, *playback);
}

} // namespace berg
