#include "widgets/panels/flight/event_model.h"

#include "widgets/flight/mission_snapshot.h"
#include "widgets/words/event_text.h"
#include "widgets/words/plan_text.h"

#include <algorithm>
#include <utility>

using namespace Qt::StringLiterals;

namespace berg {
EventModel::EventModel(const QLocale& locale, QObject* parent) : CellModel(parent), m_locale(locale)
{
    clear();
}

void EventModel::clear()
{
    m_rows.clear();
    m_events = m_plans = 0;
    m_next.clear();
    resetSheet(sheet());
}

void EventModel::setHistory(const MissionHistory& history, const std::vector<Iceberg>& icebergs,
                            const std::vector<Uav>& uavs)
{
    if (history.rewrites != m_rewrites || history.events.size() < m_events)
        clear();
    m_rewrites = history.rewrites;
    for (; m_events < history.events.size(); ++m_events) {
        const MissionEvent& event = history.events[m_events];
        PlanPointer plan;
        if (event.kind == EventKind::Planned) {
            while (m_plans < history.plans.size() && history.plans[m_plans]->interim)
                ++m_plans; // interim plans are not listed
            if (m_plans < history.plans.size())
                plan = history.plans[m_plans];
            if (plan && event.uav == plan->uavs.back().uav)
                ++m_plans; // a plan has an event for each of its UAVs
        }
        const UavPlan* own = plan ? plan->of(*event.uav) : nullptr;
        if (!addsInformation(event, own))
            continue;
        m_rows.push_back(rowOf(event, plan.get(), icebergs, uavs));
        m_rows.back().number = m_events;
    }
    if (m_rows.size() > static_cast<std::size_t>(rowCount()))
        updateSheet(sheet(), [](int /*row*/) { return true; });
}

bool EventModel::addsInformation(const MissionEvent& event, const UavPlan* plan)
{
    if (event.kind != EventKind::Planned)
        return true;
    const auto [next, isFirst] = m_next.try_emplace(event.uav, event.iceberg);
    const bool isSame = !isFirst && std::exchange(next->second, event.iceberg) == event.iceberg;
    if (!isSame || plan == nullptr)
        return true;
    // While circling or searching with nothing to visit, the UAV replans without result at every
    // step.
    const bool isInVain = !event.iceberg && plan->reason == PlanReason::OutOfView;
    return plan->reason != PlanReason::HoldFlown && !isInVain;
}

EventModel::EventRow EventModel::rowOf(const MissionEvent& event, const Plan* plan,
                                       const std::vector<Iceberg>& icebergs,
                                       const std::vector<Uav>& uavs) const
{
    EventRow row{
        .number = 0, .event = event, .what = eventSentence(event, icebergs, uavs, m_locale)};
    if (plan != nullptr) {
        const UavPlan& own = *plan->of(*event.uav);
        const bool isFirst =
            &own == &plan->uavs.front(); // otherwise the row above states the solve
        Plan alone = *plan;
        alone.uavs = {own};
        const PlanState state =
            planState({.plan = std::make_shared<const Plan>(std::move(alone))}, m_locale);
        row.details = planReasonText(own.reason);
        if (!state.text.isEmpty() && isFirst)
            row.details += u" · "_s + state.text;
        if (plan->outcome.hintUsed && isFirst)
            row.details += u" · "_s + tr("warm start");
        if (plan->fellBack)
            row.details += u" · "_s + tr("previous plan kept");
        row.toolTip = planOrderText(own, icebergs);
        if (!state.details.isEmpty())
            row.toolTip += u'\n' + state.details;
    }
    return row;
}

void EventModel::setClock(const MissionClock& clock)
{
    if (clock == m_clock)
        return;
    m_clock = clock;
    reportRows(0, rowCount() - 1);
}

void EventModel::setShown(std::size_t shown)
{
    if (shown == m_shown)
        return;
    const int before = shownRows();
    m_shown = shown;
    const int now = shownRows();
    reportRows(std::min(before, now), std::max(before, now) - 1, {AheadRole});
}

int EventModel::shownRows() const
{
    const auto ahead = std::ranges::lower_bound(m_rows, m_shown, {}, &EventRow::number);
    return static_cast<int>(ahead - m_rows.begin());
}

CellSheet EventModel::sheet() const
{
    return {.columns = {{.title = tr("Time"),
                         .text = [this](int row) { return m_clock.text(time_s(row)); }},
                        {.title = tr("Event"), .text = [this](int row) { return rowAt(row).what; }},
                        {.title = tr("How it was planned"),
                         .text = [this](int row) { return rowAt(row).details; }}},
            .rows = static_cast<int>(m_rows.size()),
            .toolTip =
                [this](int row, int column) {
                    const EventRow& event = rowAt(row);
                    if (column == Time && m_clock.start)
                        return m_clock.details(event.event.time_s);
                    return event.toolTip.isEmpty() ? event.what : event.toolTip;
                },
            .other = [this](int row, int /*column*/, int role) -> QVariant {
                return role == AheadRole ? QVariant(rowAt(row).number >= m_shown) : QVariant();
            }};
}

} // namespace berg
