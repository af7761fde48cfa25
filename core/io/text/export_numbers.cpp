#include "core/io/text/export_numbers.h"

#include <array>
#include <charconv>
#include <cmath>

namespace berg {

void appendNumber(std::string& text, double value)
{
    // Fixed notation where it is short: the plain shortest form writes 100000 as 1e+05, which
    // reads back but puzzles people and some spreadsheets.
    std::array<char, 40> buffer{};
    char* const last = buffer.data() + buffer.size();
    const double size = std::abs(value);
    const bool fixed = value == 0 || (size >= 1e-6 && size < 1e15);
    const std::to_chars_result end =
        fixed ? std::to_chars(buffer.data(), last, value, std::chars_format::fixed)
              : std::to_chars(buffer.data(), last, value);
    text.append(buffer.data(), end.ptr);
}

std::string decimalText(double value)
{
    std::array<char, 400> buffer{}; // the largest double has 309 digits, the smallest 324 decimals
    const std::to_chars_result end = std::to_chars(buffer.data(), buffer.data() + buffer.size(),
                                                   value, std::chars_format::fixed);
    return {buffer.data(), end.ptr};
}

double roundedDegrees(double angle_deg)
{
    return std::round(angle_deg * 1e9) / 1e9 + 0.0; // + 0.0 turns -0 into 0
}

LatLon roundedPlace(LatLon place)
{
    LatLon rounded{.latitude_deg = roundedDegrees(place.latitude_deg),
                   .longitude_deg = roundedDegrees(place.longitude_deg)};
    if (rounded.longitude_deg >= 180)
        rounded.longitude_deg -= 360;
    return rounded;
}

double roundedSeconds(double time_s)
{
    return std::round(time_s * 1e3) / 1e3 + 0.0;
}

} // namespace berg
