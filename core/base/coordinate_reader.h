#pragma once

#include "core/base/coordinates.h"

#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace berg {

// The grammar of `parsePlace`: a text to the two angles it is made of.

/** One angle as written. */
struct CoordinateAngle
{
    char sign = 0;                    ///< '+', '-' or none
    char letter = 0;                  ///< N, S, E, W or none
    std::vector<std::string> numbers; ///< one to three: degrees, minutes, seconds; decimal points
};

using CoordinateAngles = std::pair<CoordinateAngle, CoordinateAngle>;

/**
 * ASCII for all kinds of marks (* ' "), minus signs and spaces in UTF-8; single spaces, none at the
 * end; "ø" for both cases of it.
 */
[[nodiscard]] std::string plainCharacters(std::string_view text);

/** N, S, E and W in upper case for letters and words of directions in either language. */
[[nodiscard]] std::string plainDirections(const std::string& text);

/** The two angles of a text of `plainDirections`, in the order written. */
[[nodiscard]] std::variant<CoordinateAngles, CoordinateFault> readAngles(const std::string& plain);

} // namespace berg
