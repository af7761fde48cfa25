#include "widgets/theme/theme.h"

#include <algorithm>
#include <cmath>

namespace berg {
namespace {

QFont sized(QFont font, int size_px, QFont::Weight weight = QFont::Normal)
{
    font.setPixelSize(size_px);
    font.setWeight(weight);
    return font;
}

double linear(float given)
{
    const auto channel = static_cast<double>(given);
    return channel <= 0.04045 ? channel / 12.92 : std::pow((channel + 0.055) / 1.055, 2.4);
}

/** Both usual appearances, with their colours side by side. */
Theme usual(bool isDark)
{
    const auto of = [isDark](const QColor& light, const QColor& dark) {
        return isDark ? dark : light;
    };
    Theme theme;
    theme.isDark = isDark;
    theme.sea = of(0xe6eff4, 0x0e1a23);
    theme.land = of(0xe7e1d3, 0x27313a);
    theme.coast = of(0x74827c, 0x71828e);
    theme.graticule = of(0x6c7e88, QColor(0x96, 0xbe, 0xd7, 158)); // visible on sea and land
    theme.graticuleText = of(0x4c626f, 0x8aa0ae);
    theme.ice = of(0xffffff, 0xf2f7fa);
    theme.ink = of(0x22313b, 0xc3d0d8);
    theme.uav = of(0xd9541e, 0xff8a4c);
    theme.plan = of(0x1769aa, 0x5fb3f2);
    theme.planText = of(0xffffff, 0x0b1720);
    theme.formerPlan = of(0x667c94, 0x5f7d96);
    theme.track = of(0x43535f, 0x9fb1bd);
    theme.swept = of(QColor(0x2a, 0x8f, 0x86, 24), QColor(0x4f, 0xd0, 0xc0, 30));
    theme.comparison = of(0xb3263a, 0xfa5876);
    theme.alarm = of(0xa40810, 0xff5c52);
    theme.warning = of(0x9c6400, 0xf2b632);
    theme.text = of(0x16222b, 0xe8eff3);
    theme.mutedText = of(0x4c5e6a, 0x9cb0bc);
    theme.panel = of(0xfafcfd, 0x152530);
    theme.panelLine = of(0xcbd8e0, 0x2c4150);
    theme.chart = of(0xffffff, 0x111e28);
    theme.chartGrid = of(0xe3eaee, 0x223441);
    theme.chartAxis = of(0x84949e, 0x6b7f8c);
    theme.accumulated = of(0x16222b, 0xe8eff3);
    theme.momentary = of(0x1769aa, 0x5fb3f2);
    theme.sigma = SigmaScale(isDark ? SigmaScale::Ground::Dark : SigmaScale::Ground::Light);
    return theme;
}

} // namespace

Theme Theme::light()
{
    return usual(false);
}

Theme Theme::dark()
{
    return usual(true);
}

Theme Theme::highContrast(bool isDark)
{
    Theme theme = usual(isDark);
    const QColor ground = isDark ? QColor(Qt::black) : QColor(Qt::white);
    const QColor ink = isDark ? QColor(Qt::white) : QColor(Qt::black);
    theme.sea = ground;
    theme.panel = ground;
    theme.chart = ground;
    theme.text = ink;
    theme.ink = ink;
    theme.panelLine = ink;
    theme.chartAxis = ink;
    theme.accumulated = ink;
    theme.coast = ink;
    theme.land = mixed(ground, ink, isDark ? 0.16 : 0.12);
    theme.mutedText = mixed(ground, ink, isDark ? 0.8 : 0.75);
    theme.track = theme.mutedText;
    theme.chartGrid = mixed(ground, ink, 0.3);
    theme.graticule = mixed(ground, ink, 0.55);
    theme.graticuleText = theme.mutedText;
    theme.formerPlan = mixed(ground, ink, isDark ? 0.5 : 0.55);
    theme.uav = isDark ? QColor(0xffa05c) : QColor(0xb05400);
    theme.plan = isDark ? QColor(0x7cc8ff) : QColor(0x004f94);
    theme.planText = ground;
    theme.momentary = theme.plan;
    theme.comparison = isDark ? QColor(0xf85c9c) : QColor(0x901820);
    theme.alarm = isDark ? QColor(0xff7a72) : QColor(0x780008);
    theme.warning = isDark ? QColor(0xffc83c) : QColor(0x946c00);
    return theme;
}

Theme Theme::night()
{
    Theme theme = usual(true);
    theme.isNight = true;
    theme.sea = 0x060000;
    theme.land = 0x220504;
    theme.coast = 0xc82016;
    theme.graticule = 0xcd0e08;
    theme.graticuleText = 0xf22a20;
    theme.ice = 0xffaa8c;
    theme.ink = 0xf05a46;
    theme.uav = 0xff465f;
    theme.plan = 0xf67e2f;
    theme.planText = Qt::black;
    theme.formerPlan = 0xfe000a;
    theme.track = 0xc4021a;
    theme.swept = QColor(0xe1, 0x22, 0x1a, 31);
    theme.comparison = 0xba6800;
    theme.alarm = 0xff000f;
    theme.warning = 0xc40010;
    theme.text = 0xff5440;
    theme.mutedText = 0xf23a2c;
    theme.panel = 0x0e0101;
    theme.panelLine = 0x540e0a;
    theme.chart = Qt::black;
    theme.chartGrid = 0x3a0806;
    theme.chartAxis = 0xc81810;
    theme.accumulated = 0xf84759;
    theme.momentary = theme.plan;
    theme.sigma = SigmaScale(SigmaScale::Ground::Night);
    return theme;
}

QColor Theme::toned(const QColor& colour) const
{
    if (!isNight)
        return colour;
    // CIE lightness L*, 0 to 100; the scale of sigma covers the upper part.
    constexpr double kDarkest = 41;
    constexpr double kLightest = 77;
    const double luminance = relativeLuminance(colour);
    const double lightness = 116 * std::cbrt(luminance) - 16;
    QColor red = lightness < kDarkest
                     ? mixed(chart, sigma.at(0), std::max(0.0, lightness) / kDarkest)
                     : sigma.at((lightness - kDarkest) / (kLightest - kDarkest));
    red.setAlphaF(colour.alphaF());
    return red;
}

QFont Theme::body() const
{
    return sized(font, 13);
}

QFont Theme::small() const
{
    return sized(font, 11);
}

QFont Theme::strong() const
{
    return sized(font, 13, QFont::Bold);
}

QFont Theme::figure() const
{
    return sized(font, 22);
}

double relativeLuminance(const QColor& colour)
{
    return 0.2126 * linear(colour.redF()) + 0.7152 * linear(colour.greenF()) +
           0.0722 * linear(colour.blueF());
}

double contrastRatio(const QColor& a, const QColor& b)
{
    const auto [low, high] = std::minmax({relativeLuminance(a), relativeLuminance(b)});
    return (high + 0.05) / (low + 0.05);
}

QColor mixed(const QColor& from, const QColor& to, double fraction)
{
    const auto t = static_cast<float>(std::clamp(fraction, 0.0, 1.0));
    const auto mix = [t](float a, float b) { return a + t * (b - a); };
    return QColor::fromRgbF(mix(from.redF(), to.redF()), mix(from.greenF(), to.greenF()),
                            mix(from.blueF(), to.blueF()), mix(from.alphaF(), to.alphaF()));
}

} // namespace berg
