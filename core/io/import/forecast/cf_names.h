#pragma once

#include "core/io/import/forecast/grid_layers.h"

#include <optional>
#include <string>
#include <string_view>

namespace berg {

/** Returns the number that a standard name of the CF conventions stands for, or nullopt. */
[[nodiscard]] std::optional<GridNumber> numberOfStandardName(std::string_view name);
/**
 * Returns the number that a variable's own name stands for in files of ROMS, NEMO, ECMWF and MET
 * Norway, whatever the case of its letters, or nullopt.
 */
[[nodiscard]] std::optional<GridNumber> numberOfVariableName(std::string_view name);

/** Conversion of a unit to that of `ForecastEntry`: value * scale + offset. */
struct UnitScale
{
    double scale = 1;
    double offset = 0;
};
/**
 * Returns the conversion of a number's unit; without a text the unit is that of the CF conventions
 * (K, m s-1, m, 1, rad). Returns nullopt for a unit of another kind.
 */
[[nodiscard]] std::optional<UnitScale> unitScale(GridNumber number, std::string_view unit);
/** Returns the units that `unitScale` understands for a number, for messages. */
[[nodiscard]] std::string unitNames(GridNumber number);

/** Height in metres above the sea at which a number is wanted; depths count as 0. */
[[nodiscard]] double wantedLevel_m(GridNumber number);

} // namespace berg
