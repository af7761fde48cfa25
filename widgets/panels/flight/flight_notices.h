#pragma once

#include "widgets/flight/flight_record.h"

#include <QLocale>

#include <string>
#include <vector>

namespace berg {

/** Importance of a notice, worst first. */
enum class NoticeRank
{
    Alarm, ///< risk of collision or loss: act now
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
    Mode,
    ContactLost,   ///< with a real aircraft
    Battery,       ///< of a real aircraft: it ends before the way home does
    PilotTookOver, ///< a real aircraft that was steered
    OnBoard        ///< the mission on board of a real aircraft is not the plan
};

[[nodiscard]] NoticeRank rankOf(NoticeKind kind);

/** A notice above the map, shown as long as its condition holds. */
struct FlightNotice
{
    NoticeKind kind = NoticeKind::Mode;
    std::vector<std::string> about{}; ///< icebergs, UAVs or the asset, as shown on the map
    QString text;
    QString toolTip{};     ///< full text; empty if `text` is complete
    std::string subject{}; ///< distinguishes notices of a kind; empty if `about` does
    bool operator==(const FlightNotice&) const = default;
};

/**
 * Returns the notices of the instant shown, alarms first: UAVs of one altitude layer that are too
 * close, home out of reach, icebergs on their way into the inner ring of the asset, a failed
 * planner without a later plan, wind above a limit, lost icebergs, and UAVs that do not visit
 * icebergs. Cost: linear in icebergs and the last events.
 */
[[nodiscard]] std::vector<FlightNotice> flightNotices(const FlightRecord& record,
                                                      const QLocale& locale);

} // namespace berg
