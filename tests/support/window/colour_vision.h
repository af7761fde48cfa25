#pragma once

#include "widgets/theme/theme.h"

#include <algorithm>
#include <array>
#include <cmath>

// Simulation of colour blindness, and differences between colours.

namespace berg::test {

enum class Vision
{
    Normal,
    Protanopia,
    Deuteranopia,
    Tritanopia
};
inline constexpr std::array kVisions = {Vision::Normal, Vision::Protanopia, Vision::Deuteranopia,
                                        Vision::Tritanopia};

/** Linear sRGB, 0 to 1. */
using LinearRgb = std::array<double, 3>;

/**
 * Full dichromacy (severity 1) by Machado, Oliveira and Fernandes, "A Physiologically-based Model
 * for Simulation of Color Vision Deficiency", IEEE TVCG 15 (2009), Table 1, on linear RGB.
 */
inline LinearRgb seen(const QColor& colour, Vision vision)
{
    using Matrix = std::array<std::array<double, 3>, 3>;
    static constexpr std::array<Matrix, 4> kMatrices = {Matrix{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
                                                        Matrix{{{0.152286, 1.052583, -0.204868},
                                                                {0.114503, 0.786281, 0.099216},
                                                                {-0.003882, -0.048116, 1.051998}}},
                                                        Matrix{{{0.367322, 0.860646, -0.227968},
                                                                {0.280085, 0.672501, 0.047413},
                                                                {-0.011820, 0.042940, 0.968881}}},
                                                        Matrix{{{1.255528, -0.076749, -0.178779},
                                                                {-0.078411, 0.930809, 0.147602},
                                                                {0.004733, 0.691367, 0.303900}}}};
    const auto linear = [](float given) {
        const auto channel = static_cast<double>(given);
        return channel <= 0.04045 ? channel / 12.92 : std::pow((channel + 0.055) / 1.055, 2.4);
    };
    const LinearRgb own = {linear(colour.redF()), linear(colour.greenF()), linear(colour.blueF())};
    LinearRgb result{};
    for (std::size_t row = 0; row < 3; ++row) {
        const std::array<double, 3>& weights = kMatrices[static_cast<std::size_t>(vision)][row];
        result[row] =
            std::clamp(weights[0] * own[0] + weights[1] * own[1] + weights[2] * own[2], 0.0, 1.0);
    }
    return result;
}

struct Lab
{
    double L = 0;
    double a = 0;
    double b = 0;
};

/** CIE L*a*b* of linear sRGB at D65. */
inline Lab labOf(const LinearRgb& rgb)
{
    const auto f = [](double t) {
        return t > 216.0 / 24389 ? std::cbrt(t) : (24389.0 / 27 * t + 16) / 116;
    };
    const double x = f((0.4124564 * rgb[0] + 0.3575761 * rgb[1] + 0.1804375 * rgb[2]) / 0.95047);
    const double y = f(0.2126729 * rgb[0] + 0.7151522 * rgb[1] + 0.0721750 * rgb[2]);
    const double z = f((0.0193339 * rgb[0] + 0.1191920 * rgb[1] + 0.9503041 * rgb[2]) / 1.08883);
    return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

/**
 * Returns the CIEDE2000 difference after Sharma, Wu and Dalal, Color Research and Application 30
 * (2005). About 1 is just noticeable for large areas side by side.
 */
inline double colourDifference(const Lab& p, const Lab& q)
{
    constexpr double kPi = 3.14159265358979323846;
    constexpr double k25To7 = 6103515625.0;
    const auto rad = [](double degrees) { return degrees * kPi / 180; };
    const auto share = [](double chroma) {
        const double to7 = std::pow(chroma, 7);
        return std::sqrt(to7 / (to7 + k25To7));
    };
    const double stretch = 1.5 - 0.5 * share((std::hypot(p.a, p.b) + std::hypot(q.a, q.b)) / 2);
    const double c1 = std::hypot(stretch * p.a, p.b);
    const double c2 = std::hypot(stretch * q.a, q.b);
    const auto hue = [&](const Lab& lab) {
        const double angle = std::atan2(lab.b, stretch * lab.a) * 180 / kPi;
        return angle < 0 ? angle + 360 : angle;
    };
    const double h1 = hue(p);
    const double h2 = hue(q);
    const bool isGrey = c1 * c2 == 0;
    double turn = isGrey ? 0 : h2 - h1;
    if (turn > 180)
        turn -= 360;
    else if (turn < -180)
        turn += 360;
    double middle = h1 + h2;
    if (!isGrey) {
        if (std::abs(h1 - h2) > 180)
            middle += middle < 360 ? 360 : -360;
        middle /= 2;
    }
    const double lightness = (p.L + q.L) / 2 - 50;
    const double chroma = (c1 + c2) / 2;
    const double t = 1 - 0.17 * std::cos(rad(middle - 30)) + 0.24 * std::cos(rad(2 * middle)) +
                     0.32 * std::cos(rad(3 * middle + 6)) - 0.2 * std::cos(rad(4 * middle - 63));
    const double dL =
        (q.L - p.L) / (1 + 0.015 * lightness * lightness / std::sqrt(20 + lightness * lightness));
    const double dC = (c2 - c1) / (1 + 0.045 * chroma);
    const double dH = 2 * std::sqrt(c1 * c2) * std::sin(rad(turn / 2)) / (1 + 0.015 * chroma * t);
    const double cross =
        -std::sin(rad(60 * std::exp(-std::pow((middle - 275) / 25, 2)))) * 2 * share(chroma);
    return std::sqrt(dL * dL + dC * dC + dH * dH + cross * dC * dH);
}

inline double colourDifference(const QColor& a, const QColor& b, Vision vision)
{
    return colourDifference(labOf(seen(a, vision)), labOf(seen(b, vision)));
}

} // namespace berg::test
