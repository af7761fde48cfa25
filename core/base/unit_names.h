#pragma once

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <span>
#include <string_view>

namespace berg {

/** Physical quantity of a unit. */
enum class Dimension : std::uint8_t
{
    Length,
    Area,
    Speed,
    Time,
    Angle, ///< in degrees
    Share,
    Temperature,
    Growth ///< growth of a variance
};

/** A unit with the names in use: UTF-8 in lower case without blanks. */
struct NamedUnit
{
    Dimension dimension = Dimension::Length;
    double inSi = 1; ///< value of one such unit in SI units; for angles in degrees
    /** The first is the name that Bergwatch writes. */
    std::initializer_list<std::string_view> names;
};

/** Returns all known units. */
[[nodiscard]] std::span<const NamedUnit> namedUnits();

/**
 * Returns the value in SI units of the unit with this name, in any case and with any blanks, or
 * nullopt if there is none.
 */
[[nodiscard]] std::optional<double> unitInSi(Dimension dimension, std::string_view name);

} // namespace berg
