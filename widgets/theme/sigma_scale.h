#pragma once

#include <QColor>

#include <cstdint>

namespace berg {

/**
 * Colour of the uncertainty sigma: a stretch of viridis (van der Walt and Smith 2015, CC0), which
 * is perceptually even and safe for colour-blind eyes. The stretch is the one whose every colour
 * keeps 3 : 1 against the background, and urgent stands out: dark on light, bright on dark. By
 * night it runs from a dark to a light red, in even steps of lightness too.
 */
class SigmaScale
{
public:
    /** What the colours are seen on. */
    enum class Ground : std::uint8_t
    {
        Light,
        Dark,
        Night
    };
    explicit SigmaScale(Ground ground) : m_ground(ground) {}

    /** Colour at `fraction` of the scale, clamped to [0, 1]; 1 is the most uncertain. */
    [[nodiscard]] QColor at(double fraction) const;

    /** Colour of `sigma_m2` on a scale that ends at `full_m2`; the lowest colour when that is 0. */
    [[nodiscard]] QColor colour(double sigma_m2, double full_m2) const;

private:
    Ground m_ground;
};

} // namespace berg
