#pragma once

#include "app/layout/window_part.h"
#include "widgets/flight/planned_sorties.h"
#include "widgets/panels/flight/run_time_line.h"

#include <QTimer>

#include <vector>

namespace berg {

class ChartPanel;
class Docks;

/** Returns the reason that no plan is possible, as a sentence; empty if planning is possible. */
[[nodiscard]] QString planFault(Workspace& workspace);

/** Charts, events and tables of the flight, none more often than the eye can follow. */
class FlightPanels : public WindowPart
{
    Q_OBJECT

public:
    FlightPanels(WindowContext& context, const Docks& docks);

    /** One after the other, and the tables after them. */
    void showSoon();
    void showCharts();
    void showPlan();

private:
    void connectTables();
    void showChart(ChartPanel& chart);
    void showNextChart();
    void showTables();
    void showEvents();
    void showSelection();
    void showSorties(std::vector<std::optional<PlannedSortie>> sorties, std::vector<Issue> issues);

    std::vector<TimeMark> m_marks;  ///< on the time line
    std::size_t m_markedEvents = 0; ///< of the history, turned into marks
    std::uint64_t m_markRewrites = 0;
    QTimer m_chartTimer; ///< each chart at most 25 times a second
    std::size_t m_nextChart = 0;
    std::size_t m_chartsDue = 0; ///< so many do not show the newest yet
    QTimer m_tableTimer; ///< tables of icebergs and, in flight, of the plan at most 10 times
};

} // namespace berg
