#pragma once

#include "widgets/flight/flight_record.h"
#include "widgets/sightings/import_preview.h"

#include <vector>

namespace berg {

/**
 * Returns the scenario that sightings are imported into in flight: its t = 0 is the newest instant,
 * and icebergs have their present estimates and uncertainties. Icebergs that have not appeared or
 * are no longer monitored are omitted.
 */
[[nodiscard]] Scenario scenarioNow(const FlightRecord& record);

/** Restricts import options in flight: t = 0, origin and observer stay as they are. */
[[nodiscard]] ImportOptions optionsInFlight(ImportOptions options, const Scenario& now);

/**
 * Returns the interventions of an import into `scenarioNow`: known icebergs are reported seen with
 * the age of their last sighting, new ones appear. Icebergs left out change nothing.
 */
[[nodiscard]] std::vector<Intervention> reportsOf(const ImportPreview& preview);

} // namespace berg
