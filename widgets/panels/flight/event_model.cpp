#include "widgets/panels/flight/event_model.h"

#include "widgets/model/mission_snapshot.h"
#include "widgets/words/event_text.h"
#include "widgets/words/plan_text.h"

#include <algorithm>
#include <iterator>
#include <utility>

using namespace Qt::StringLiterals;

namespace berg {
EventModel::EventModel(const QLocale& locale, QObject* parent)
    : QAbstractTableModel(parent), m_locale(locale)
{
}

void EventModel::clear()
{
    beginResetModel();
    m_rows.clear();
    m_events = m_plans = 0;
    m_next.clear();
    endResetModel();
}

void EventModel::setHistory(const MissionHistory& history, const std::vector<Iceberg>& icebergs,
                            const std::vector<Uav>& uavs)
{
    if (history.rewrites != m_rewrites || history.events.size() < m_events)
        clear();
    m_rewrites = history.rewrites;
    std::vector<EventRow> news;
    for (; m_events < history.events.size(); ++m_events) {
        const MissionEvent& event = history.events[m_events];
        const PlanEvent* plan = nullptr;
        if (event.kind == EventKind::Planned) {
            while (m_plans < history.plans.size() && history.plans[m_plans].interim)
                ++m_plans; // interim plans are not listed
            if (m_plans < history.plans.size())
                plan = &history.plans[m_plans++];
        }
        if (!addsInformation(event, plan))
            continue;
        news.push_back(rowOf(event, plan, icebergs, uavs));
        news.back().number = m_events;
    }
    if (news.empty())
        return;
    const int first = rowCount();
    beginInsertRows({}, first, first + static_cast<int>(news.size()) - 1);
    std::ranges::move(news, std::back_inserter(m_rows));
    endInsertRows();
}

bool EventModel::addsInformation(const MissionEvent& event, const PlanEvent* plan)
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

EventModel::EventRow EventModel::rowOf(const MissionEvent& event, const PlanEvent* plan,
                                       const std::vector<Iceberg>& icebergs,
                                       const std::vector<Uav>& uavs) const
{
    EventRow row{
        .number = 0, .event = event, .what = eventSentence(event, icebergs, uavs, m_locale)};
    if (plan != nullptr) {
        const PlanState state = planState({.plan = *plan}, m_locale);
        row.details = planReasonText(plan->reason);
        if (!state.text.isEmpty() && !plan->sameSolve) // otherwise the row above states it
            row.details += u" · "_s + state.text;
        if (plan->warmStarted && !plan->sameSolve)
            row.details += u" · "_s + tr("warm start");
        if (plan->fellBack)
            row.details += u" · "_s + tr("previous plan kept");
        row.toolTip = planOrderText(*plan, icebergs);
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
    if (!m_rows.empty())
        emit dataChanged(index(0, Time), index(rowCount() - 1, Time));
}

void EventModel::setShown(std::size_t shown)
{
    if (shown == m_shown)
        return;
    const int before = shownRows();
    m_shown = shown;
    const int now = shownRows();
    if (before != now)
        emit dataChanged(index(std::min(before, now), 0),
                         index(std::max(before, now) - 1, ColumnCount - 1), {AheadRole});
}

int EventModel::shownRows() const
{
    const auto ahead = std::ranges::lower_bound(m_rows, m_shown, {}, &EventRow::number);
    return static_cast<int>(ahead - m_rows.begin());
}

double EventModel::time_s(int row) const
{
    return m_rows.at(static_cast<std::size_t>(row)).event.time_s;
}

int EventModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_rows.size());
}

int EventModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : ColumnCount;
}

QVariant EventModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid())
        return {};
    const auto i = static_cast<std::size_t>(index.row());
    const EventRow& row = m_rows.at(i);
    if (role == Qt::DisplayRole)
        switch (index.column()) {
        case Time:
            return m_clock.text(row.event.time_s);
        case What:
            return row.what;
        case Details:
            return row.details;
        default:
            return {};
        }
    if (role == Qt::ToolTipRole && index.column() == Time && m_clock.start)
        return m_clock.details(row.event.time_s);
    if (role == Qt::ToolTipRole)
        return row.toolTip.isEmpty() ? row.what : row.toolTip;
    if (role == AheadRole)
        return row.number >= m_shown;
    return {};
}

QVariant EventModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal)
        return {};
    if (role == Qt::TextAlignmentRole)
        return int(Qt::AlignLeft | Qt::AlignVCenter);
    if (role != Qt::DisplayRole)
        return {};
    switch (section) {
    case Time:
        return tr("Time");
    case What:
        return tr("Event");
    case Details:
        return tr("How it was planned");
    default:
        return {};
    }
}

} // namespace berg
