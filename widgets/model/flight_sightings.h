#pragma once

#include "widgets/model/flight_record.h"
#include "widgets/model/import_preview.h"

#include <vector>

namespace berg {

/**
 * What sightings are imported into while the flight is under way: the scenario with the newest
 * instant as its t = 0. Icebergs are where and as surely as they are estimated to be; those that
 * have not appeared or are monitored no more are left out.
 */
[[nodiscard]] Scenario scenarioNow(const FlightRecord& record);

/** The options as they can be in flight: t = 0 stays, origin and observer too. */
[[nodiscard]] ImportOptions optionsInFlight(ImportOptions options, const Scenario& now);

/**
 * What an import into `scenarioNow` is to the flight: icebergs that it has are reported seen, as
 * long ago as their last sighting; new ones appear. Those left out change nothing.
 */
[[nodiscard]] std::vector<Intervention> reportsOf(const ImportPreview& preview);

} // namespace berg
