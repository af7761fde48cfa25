#include "widgets/panels/flight/event_model.h"

#include "widgets/model/mission_snapshot.h"
#include "widgets/theme/quantity_text.h"
#include "widgets/words/event_text.h"
#include "widgets/words/plan_text.h"

#include <algorithm>

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
    m_plans = 0;
    endResetModel();
}

void EventModel::setHistory(const MissionHistory& history, const std::vector<Iceberg>& icebergs,
                            const std::vector<Uav>& uavs)
{
    if (history.rewrites != m_rewrites || history.events.size() < m_rows.size())
        clear();
    m_rewrites = history.rewrites;
    const std::size_t kept = m_rows.size();
    if (kept == history.events.size())
        return;
    beginInsertRows({}, static_cast<int>(kept), static_cast<int>(history.events.size()) - 1);
    for (std::size_t i = kept; i < history.events.size(); ++i) {
        const MissionEvent& event = history.events[i];
        const PlanEvent* plan = nullptr;
        if (event.kind == EventKind::Planned) {
            while (m_plans < history.plans.size() && history.plans[m_plans].interim)
                ++m_plans; // nothing is told of those
            if (m_plans < history.plans.size())
                plan = &history.plans[m_plans++];
        }
        m_rows.push_back(rowOf(event, plan, icebergs, uavs));
    }
    endInsertRows();
}

EventModel::Row EventModel::rowOf(const MissionEvent& event, const PlanEvent* plan,
                                  const std::vector<Iceberg>& icebergs,
                                  const std::vector<Uav>& uavs) const
{
    Row row{.event = event,
            .what = eventSentence(event, icebergs, uavs, m_locale),
            .details = {},
            .toolTip = {}};
    if (plan != nullptr) {
        const PlanState state = planState({.plan = *plan}, m_locale);
        row.details = planReasonText(plan->reason);
        if (!state.text.isEmpty() && !plan->sameSolve) // else it is in the row above
            row.details += u" · "_s + state.text;
        if (plan->warmStarted && !plan->sameSolve)
            row.details += u" · "_s + tr("warm start");
        if (plan->fellBack)
            row.details += u" · "_s + tr("last plan kept");
        row.toolTip = planOrderText(*plan, icebergs);
        if (!state.details.isEmpty())
            row.toolTip += u'\n' + state.details;
    }
    return row;
}

void EventModel::setShown(std::size_t shown)
{
    if (shown == m_shown)
        return;
    const std::size_t from = std::min({shown, m_shown, m_rows.size()});
    const std::size_t to = std::min(std::max(shown, m_shown), m_rows.size());
    m_shown = shown;
    if (from < to)
        emit dataChanged(index(static_cast<int>(from), 0),
                         index(static_cast<int>(to) - 1, ColumnCount - 1), {AheadRole});
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
    const Row& row = m_rows.at(i);
    if (role == Qt::DisplayRole)
        switch (index.column()) {
        case Time:
            return clockText(row.event.time_s);
        case What:
            return row.what;
        case Details:
            return row.details;
        default:
            return {};
        }
    if (role == Qt::ToolTipRole)
        return row.toolTip.isEmpty() ? row.what : row.toolTip;
    if (role == AheadRole)
        return i >= m_shown;
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
