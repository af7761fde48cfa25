#include "core/base/unit_names.h"

#include "core/base/angles.h"

#include <algorithm>
#include <array>
#include <string>

namespace berg {

namespace {

constexpr double kNauticalMile_m = 1852;
constexpr double kFoot_m = 0.3048;
constexpr double kMinute_s = 60;
constexpr double kHour_s = 3600;
constexpr double kDay_s = 24 * kHour_s;

} // namespace

std::span<const NamedUnit> namedUnits()
{
    using enum Dimension;
    static const std::array kUnits = {
        NamedUnit{Length, 1, {"m", "metres", "meters", "metre", "meter"}},
        NamedUnit{Length, 1000, {"km", "kilometres", "kilometers"}},
        NamedUnit{Length, kNauticalMile_m, {"nmi", "nm", "sm", "nauticalmiles"}},
        NamedUnit{Length, kFoot_m, {"ft", "feet", "foot", "'", "′"}},
        NamedUnit{Length, 0.9144, {"yd", "yards"}},
        NamedUnit{Length, 0.01, {"cm"}},
        NamedUnit{Area, 1, {"m²", "m2", "m^2", "sqm"}},
        NamedUnit{Area, 1e6, {"km²", "km2", "km^2", "sqkm"}},
        NamedUnit{Area, 1e4, {"ha", "hectares"}},
        NamedUnit{Area, kNauticalMile_m * kNauticalMile_m, {"nmi²", "nm²", "nmi2", "nm2", "sqnm"}},
        NamedUnit{Speed, 1, {"m/s", "mps", "ms", "ms-1", "m.s-1", "ms⁻¹"}},
        NamedUnit{Speed,
                  1000 / kHour_s,
                  {"km/h", "kmh", "kph", "kmph", "km/t", "km/hr", "kmh-1", "kmh⁻¹"}},
        NamedUnit{Speed,
                  kNauticalMile_m / kHour_s,
                  {"kn", "kt", "kts", "knots", "knot", "kns", "nd", "knop", "nm/h", "nmi/h"}},
        NamedUnit{Speed, 0.01, {"cm/s", "cms", "cmps", "cms-1", "cm.s-1", "cms⁻¹"}},
        NamedUnit{Speed, 1000 / kDay_s, {"km/d", "km/day", "kmd-1"}},
        NamedUnit{Speed, kNauticalMile_m / kDay_s, {"nm/d", "nm/day", "nmi/d", "nmi/day"}},
        NamedUnit{Speed, 1609.344 / kHour_s, {"mph", "mi/h"}},
        NamedUnit{Speed, kFoot_m, {"ft/s", "fps"}},
        NamedUnit{Time, 1, {"s", "sec", "seconds", "sek"}},
        NamedUnit{Time, kMinute_s, {"min", "m", "mins", "minutes", "′"}},
        NamedUnit{Time, kHour_s, {"h", "hr", "hrs", "hours", "t"}},
        NamedUnit{Time, kDay_s, {"d", "days"}},
        NamedUnit{Angle,
                  1,
                  {"°", "deg", "degrees", "degree", "°t", "°true", "true", "t", "degt", "degtrue",
                   "degreestrue", "degrees_true", "degree_true"}},
        NamedUnit{Share, 1, {"%", "percent"}},
        NamedUnit{Temperature, 1, {"°c", "c", "°"}},
        NamedUnit{Angle, 180 / kPi, {"rad", "radians"}},
        NamedUnit{Growth, 1, {"m²/s", "m2/s", "m2ps", "m^2/s"}},
    };
    return kUnits;
}

std::optional<double> unitInSi(Dimension dimension, std::string_view name)
{
    std::string plain;
    for (const char c : name)
        if (c != ' ')
            plain += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    for (const NamedUnit& unit : namedUnits())
        if (unit.dimension == dimension && std::ranges::find(unit.names, plain) != unit.names.end())
            return unit.inSi;
    return std::nullopt;
}

} // namespace berg
