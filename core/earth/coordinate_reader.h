#pragma once

#include "core/earth/coordinates.h"

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace berg {

// Grammar of `parsePlace`: from a text to the two angles it consists of.

/** One angle as written. */
struct CoordinateAngle
{
    std::optional<char> sign;   ///< '+' or '-'
    std::optional<char> letter; ///< N, S, E or W
    /** One to three numbers with decimal points: degrees, minutes, seconds. */
    std::vector<std::string> numbers;
};

/** Two angles in the order written. */
using CoordinateAngles = std::pair<CoordinateAngle, CoordinateAngle>;

/**
 * Returns the text with every kind of mark as ASCII (* ' "), minus signs and spaces as ASCII,
 * single spaces with none at the start or end, and "ø" in lower case.
 */
[[nodiscard]] std::string plainCharacters(std::string_view text);

/**
 * Returns the text with N, S, E and W in place of the letters and words of directions in English,
 * Norwegian and French, and with marks (* ' ") in place of "deg", "d", "min" and "sec".
 */
[[nodiscard]] std::string plainDirections(const std::string& text);

/**
 * Returns the two angles of a text made by `plainDirections`, in the order written, or why they
 * cannot be read.
 */
[[nodiscard]] std::variant<CoordinateAngles, CoordinateFault> readAngles(const std::string& plain);

} // namespace berg
