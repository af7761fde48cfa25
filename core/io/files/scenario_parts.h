#pragma once

// Private to core/io: parts of the scenario file that the run file contains too.

#include "core/io/files/scenario_json.h"
#include "core/io/text/json_reader.h"
#include "core/io/text/json_writer.h"
#include "core/scenario/scenario.h"

#include <string>

namespace berg {

/**
 * Reads the scenario of an object. Adds a fault for a wrong format or version (both may be missing)
 * and for every member that is missing, of the wrong type or wrong for this use; the result is
 * complete only without faults. UAVs and icebergs without an id get one.
 */
[[nodiscard]] Scenario readScenario(ObjectReader& object, ScenarioUse use = ScenarioUse::Flying);

/**
 * Reads an object of a scenario file: Uav, Iceberg (with empty ids if the file gives none), Asset,
 * NoFlyArea, AirspaceArea, IceChart, IceArea, GroundStation, Operation, Weather or ForecastField.
 */
template <class T>
[[nodiscard]] T readObject(const Json& value, const std::string& path, Faults& faults);
/** Returns the JSON text of an object that `readObject` reads, on one line. */
template <class T>
[[nodiscard]] std::string objectText(const T& object);
template <>
[[nodiscard]] ForecastField readObject(const Json& value, const std::string& path, Faults& faults);
template <>
[[nodiscard]] std::string objectText(const ForecastField& object);

/** Returns the JSON text of the scenario as an object with its braces at `indent`. */
[[nodiscard]] std::string scenarioText(const Scenario& scenario, int indent);

} // namespace berg
