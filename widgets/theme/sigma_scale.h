#pragma once

#include <QColor>

#include <cstdint>

namespace berg {

/**
 * Colour scale of the uncertainty sigma: a section of viridis (van der Walt and Smith 2015, CC0),
 * which is perceptually uniform and safe for colour-blind eyes. Every colour of the section keeps
 * 3 : 1 against the background, and high values stand out: dark on light, bright on dark. The night
 * scale runs from a dark to a light red, uniform in lightness.
 */
class SigmaScale
{
public:
    /** Background of the colours. */
    enum class Ground : std::uint8_t
    {
        Light,
        Dark,
        Night
    };
    explicit SigmaScale(Ground ground) : m_ground(ground) {}

    /** Colour at `fraction` of the scale, clamped to [0, 1]; one is the most uncertain. */
    [[nodiscard]] QColor at(double fraction) const;

    /** Colour of `sigma_m2` on a scale that ends at `full_m2`; the lowest one if that is zero. */
    [[nodiscard]] QColor colour(double sigma_m2, double full_m2) const;

private:
    Ground m_ground;
};

} // namespace berg
