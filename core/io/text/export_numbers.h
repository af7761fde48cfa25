#pragma once

#include "core/base/geodesy.h"

#include <string>

namespace berg {

// Numbers as exported files hold them. All of it is independent of the locale.

/** `numberText` (core/io/results/result_csv.h) without a string of its own, for tables of many
 * rows. */
void appendNumber(std::string& text, double value);

/** Shortest text that reads back as the same double, never with an exponent: for XML decimals. */
[[nodiscard]] std::string decimalText(double value);

/** To nine decimals, 0.1 mm on the ground; never -0. */
[[nodiscard]] double roundedDegrees(double angle_deg);

/** `roundedDegrees` of both; the longitude stays in [-180, 180). */
[[nodiscard]] LatLon roundedPlace(LatLon place);

/** To milliseconds, which hides the rounding of step x dt; never -0. */
[[nodiscard]] double roundedSeconds(double time_s);

} // namespace berg
