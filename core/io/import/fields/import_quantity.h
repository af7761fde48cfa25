#pragma once

// Private to core/io: optional values of tables, with their units or in words.

#include "core/base/unit_names.h"

#include <functional>
#include <optional>
#include <string_view>

namespace berg {

/** A value read from a table. */
struct ReadQuantity
{
    double value = 0;     ///< in SI units if `hasUnit`; angles in degrees
    bool hasUnit = false; ///< whether the text has a unit; if not, the column's unit applies
    bool isExact = true;  ///< false for a range, a limit or an estimate
};

/** Reads one number. Returns nullopt if the text is not a number or an ambiguous one. */
using NumberReader = std::function<std::optional<double>(std::string_view)>;

/**
 * Returns the value of a UTF-8 text: "0.9 km/h", "400 ft", "157.5 ° True", "SSE", "120-200 m",
 * "<60", "ca. 120"; for lengths, "120 x 80 m" gives the longer one. Returns nullopt for any other
 * text, also if the unit measures something else.
 */
[[nodiscard]] std::optional<ReadQuantity> quantityOf(std::string_view text, Dimension dimension,
                                                     const NumberReader& number);

/** Returns true for a number that programs write for a missing value: -999, 1e35 and the like. */
[[nodiscard]] bool standsForNone(double value);

} // namespace berg
