#pragma once

#include "core/earth/geodesy.h"
#include "core/scenario/utc_time.h"

#include <optional>
#include <string>
#include <string_view>

namespace berg {

/** The EXIF data of a photograph; members that they do not contain are empty. */
struct PhotoData
{
    std::optional<LatLon> place; ///< of the camera; longitude in [-180, 180)
    std::optional<double> altitude_m;
    std::optional<UtcTime> time;         ///< by GPS, else the camera's clock if its offset is known
    std::optional<double> direction_deg; ///< of view, clockwise from true north, [0, 360)
};

/** Returns true if this build reads photographs: it has libexiv2. */
[[nodiscard]] bool readsPhotos();

/**
 * Reads the EXIF data of a JPEG file. Values that are missing, damaged or out of range are left
 * out. Throws `Error{InvalidInput}` if the file is damaged, and `Error{Unsupported}` in a build
 * without libexiv2.
 */
[[nodiscard]] PhotoData photoData(std::string_view bytes, const std::string& subject);

} // namespace berg
