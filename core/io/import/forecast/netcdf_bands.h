#pragma once

#include "core/io/import/forecast/grid_layers.h"
#include "core/io/import/forecast/netcdf_file.h"

#include <optional>
#include <string>

namespace berg {

/** A message of a GRIB file that gdal_translate has made a variable of its own ("Band1", ...). */
struct GribBand
{
    GridNumber number = GridNumber::WindEast;
    double levelOffset_m = 0; ///< distance from the level at which the number is wanted
    ForecastTime time;        ///< for which the band is valid
    std::optional<ForecastTime> issued;
    std::string unit;
};

/** Returns true if the variable is a band of gdal_translate, which names no quantity by itself. */
[[nodiscard]] bool isBand(const NetcdfFile& file, const NetcdfVariable& variable);

/**
 * Returns the contents of a band, or nullopt if it holds a quantity or level that no forecast
 * needs. Throws `Error{InvalidInput}` if the attributes GRIB_ELEMENT, GRIB_SHORT_NAME and
 * GRIB_VALID_TIME do not give quantity, level and time.
 */
[[nodiscard]] std::optional<GribBand> gribBandOf(const NetcdfFile& file,
                                                 const NetcdfVariable& variable);

} // namespace berg
