#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace berg {

/** A colour of 8 bits per channel. */
struct Rgb
{
    std::uint8_t red = 0;
    std::uint8_t green = 0;
    std::uint8_t blue = 0;
};

/**
 * Returns the colour of UAV `row` in files: the palette of Okabe and Ito, distinguishable with
 * colour blindness, used cyclically.
 */
[[nodiscard]] constexpr Rgb uavColour(std::size_t row)
{
    constexpr std::array<Rgb, 6> kColours{{{0, 114, 178},
                                           {213, 94, 0},
                                           {0, 158, 115},
                                           {204, 121, 167},
                                           {230, 159, 0},
                                           {86, 180, 233}}};
    return kColours[row % kColours.size()];
}

} // namespace berg
