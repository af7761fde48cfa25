#pragma once

#include "widgets/model/flight_record.h"
#include "widgets/theme/icons.h"

#include <QLocale>

#include <vector>

namespace berg {

/** What the user is told on the map for as long as it holds. */
struct FlightNotice
{
    IconName icon = IconName::Hint;
    QString text;
    QString toolTip; ///< the same in full; empty: the text says it all
    bool operator==(const FlightNotice&) const = default;
};

/**
 * Of the instant shown, warnings first: that the planner has failed and no later plan has come,
 * UAVs of one altitude layer that are close to each other, that home cannot be reached in time,
 * icebergs on their way into the inner ring of the asset, and what else the UAVs do than visit
 * icebergs. Cost: linear in icebergs and the last events.
 */
[[nodiscard]] std::vector<FlightNotice> flightNotices(const FlightRecord& record,
                                                      const QLocale& locale);

} // namespace berg
