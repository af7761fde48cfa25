#pragma once

#include "core/link/traffic.h"
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

/**
 * Returns the interventions that report ice that a radar tracks or AIS marks, `age_s` after that
 * was received. The nearest monitored iceberg whose 95 % position circle and that of the radar
 * overlap is reported seen; without one, a new iceberg appears, named as the target. Empty if the
 * place is outside the plane.
 */
[[nodiscard]] std::vector<Intervention> reportsOfIce(const FlightRecord& record,
                                                     const TrafficTarget& ice, double age_s);

} // namespace berg
