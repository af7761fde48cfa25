#pragma once

// Private to core/io: parts of the scenario file that the run file holds too.

#include "core/io/files/scenario_json.h"
#include "core/io/text/json_reader.h"
#include "core/io/text/json_writer.h"
#include "core/scenario/scenario.h"

namespace berg {

/**
 * Scenario of an object whose format and version are checked already. Notes what has the wrong
 * type, is missing or is wrong for this use; the value returned is whole only without faults.
 */
[[nodiscard]] Scenario readScenario(ObjectReader& object, ScenarioUse use = ScenarioUse::Flying);

/** One entry of `uavs`; its id is empty when the file gives none. */
[[nodiscard]] Uav readUav(const Json& value, const std::string& path, Faults& faults);

/** One entry of `icebergs`; its id is empty when the file gives none. */
[[nodiscard]] Iceberg readIceberg(const Json& value, const std::string& path, Faults& faults);

/** The member `asset`. */
[[nodiscard]] Asset readAsset(const Json& value, const std::string& path, Faults& faults);

/** One entry of `no_fly`. */
[[nodiscard]] NoFlyArea readNoFlyArea(const Json& value, const std::string& path, Faults& faults);

/** The member `ground_station`. */
[[nodiscard]] GroundStation readGroundStation(const Json& value, const std::string& path,
                                              Faults& faults);

/** The member `operation`. */
[[nodiscard]] Operation readOperation(const Json& value, const std::string& path, Faults& faults);

/** One entry of `airspace`. */
[[nodiscard]] AirspaceArea readAirspaceArea(const Json& value, const std::string& path,
                                            Faults& faults);

/** The member `weather`. */
[[nodiscard]] Weather readWeather(const Json& value, const std::string& path, Faults& faults);

/** Corners of a polygon in the member of this name; empty when it is missing or unreadable. */
[[nodiscard]] std::vector<Point> readCorners(ObjectReader& object, const char* member);

/** The scenario as an object whose braces stand at `indent`. */
[[nodiscard]] std::string scenarioText(const Scenario& scenario, int indent);
[[nodiscard]] std::string uavText(const Uav& uav);
[[nodiscard]] std::string icebergText(const Iceberg& iceberg);
[[nodiscard]] std::string assetText(const Asset& asset);
[[nodiscard]] std::string noFlyAreaText(const NoFlyArea& area);
[[nodiscard]] std::string groundStationText(const GroundStation& station);
[[nodiscard]] std::string operationText(const Operation& operation);
[[nodiscard]] std::string airspaceAreaText(const AirspaceArea& area);
[[nodiscard]] std::string weatherText(const Weather& weather);

} // namespace berg
