#pragma once

#include "widgets/model/flight_record.h"

#include <QLocale>

#include <string>
#include <vector>

namespace berg {

/** How much a notice matters, the worst first. */
enum class NoticeRank
{
    Alarm, ///< something may be hit or lost: act now
    Warning,
    Note
};

enum class NoticeKind
{
    UavsClose,
    LateHome,
    RingEntry,
    PlannerFailed,
    WindLimit,
    LostIceberg,
    Mode
};

[[nodiscard]] NoticeRank rankOf(NoticeKind kind);

/** What the user is told above the map for as long as it holds. */
struct FlightNotice
{
    NoticeKind kind = NoticeKind::Mode;
    std::vector<std::string> about{}; ///< icebergs, UAVs, the asset: where it is on the map
    QString text;
    QString toolTip{}; ///< the same in full; empty: the text says it all
    bool operator==(const FlightNotice&) const = default;
};

/**
 * Of the instant shown, warnings first: that the planner has failed and no later plan has come,
 * UAVs of one altitude layer that are close to each other, that home cannot be reached in time,
 * icebergs on their way into the inner ring of the asset, lost icebergs, and what else the UAVs do
 * than visit icebergs. Cost: linear in icebergs and the last events.
 */
[[nodiscard]] std::vector<FlightNotice> flightNotices(const FlightRecord& record,
                                                      const QLocale& locale);

} // namespace berg
