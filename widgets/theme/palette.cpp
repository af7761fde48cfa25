#include "widgets/theme/palette.h"

#include <QApplication>

#include <array>

namespace berg {

namespace {

/** Sets the colour of check marks and the like, which has its own role from Qt 6.6 on. */
template <class Palette>
void setAccent(Palette& palette, const QColor& colour)
{
    if constexpr (requires { Palette::Accent; })
        palette.setColor(Palette::Accent, colour);
}

} // namespace

QPalette paletteOf(const Theme& theme)
{
    const QColor base = theme.chart;
    const QColor window = mixed(base, theme.text, theme.isDark ? 0.06 : 0.03);
    QPalette palette;
    palette.setColor(QPalette::Window, window);
    palette.setColor(QPalette::WindowText, theme.text);
    palette.setColor(QPalette::Base, base);
    palette.setColor(QPalette::AlternateBase, mixed(base, theme.text, 0.04));
    palette.setColor(QPalette::Text, theme.text);
    palette.setColor(QPalette::PlaceholderText, theme.mutedText);
    palette.setColor(QPalette::Button, mixed(base, theme.text, theme.isDark ? 0.12 : 0.05));
    palette.setColor(QPalette::ButtonText, theme.text);
    palette.setColor(QPalette::ToolTipBase, theme.panel);
    palette.setColor(QPalette::ToolTipText, theme.text);
    palette.setColor(QPalette::BrightText, theme.uav);
    palette.setColor(QPalette::Link, theme.plan);
    palette.setColor(QPalette::Highlight, theme.plan);
    palette.setColor(QPalette::HighlightedText, theme.planText);
    setAccent(palette, theme.plan);
    palette.setColor(QPalette::Light,
                     mixed(window, theme.toned(Qt::white), theme.isDark ? 0.1 : 0.6));
    palette.setColor(QPalette::Midlight, mixed(window, theme.text, 0.08));
    palette.setColor(QPalette::Mid, mixed(window, theme.text, 0.25));
    palette.setColor(QPalette::Dark, mixed(window, theme.text, 0.35));
    palette.setColor(QPalette::Shadow, mixed(window, Qt::black, 0.6));
    // Fading red on black loses more contrast, and values locked in flight must remain readable.
    const QColor disabled = mixed(window, theme.text, theme.isNight ? 0.7 : 0.45);
    for (const QPalette::ColorRole role :
         {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
        palette.setColor(QPalette::Disabled, role, disabled);
    palette.setColor(QPalette::Disabled, QPalette::Highlight, mixed(window, theme.text, 0.3));
    return palette;
}

QColor uavColour(const Theme& theme, int index)
{
    // Vermillion is the first; bluish green, reddish purple, blue, sky blue, yellow follow. Orange
    // is left out: a shade dark enough for a light sea looks like vermillion to most colour-blind.
    constexpr std::array<QRgb, kUavColours - 1> kOnLight = {0x00795b, 0xab4f87, 0x004a80, 0x2983ba,
                                                            0x524c00};
    constexpr std::array<QRgb, kUavColours - 1> kOnDark = {0x12b886, 0xe7a8d0, 0x3d8fdd, 0x9ad6f7,
                                                           0xf0e442};
    constexpr std::array<QRgb, kUavColours - 1> kByNight = {0xec0000, 0xffad71, 0xed840e, 0xc0172b,
                                                            0xb43972};
    const auto place = static_cast<std::size_t>(index % kUavColours);
    if (place == 0)
        return theme.uav;
    return {(theme.isNight ? kByNight : theme.isDark ? kOnDark : kOnLight)[place - 1]};
}

bool systemPaletteIsDark()
{
    // Qt reports the desktop's palette only while no other one is set.
    const QPalette own = QApplication::palette();
    QApplication::setPalette(QPalette());
    const double luminance = relativeLuminance(QApplication::palette().color(QPalette::Window));
    QApplication::setPalette(own);
    return luminance < 0.2;
}

} // namespace berg
