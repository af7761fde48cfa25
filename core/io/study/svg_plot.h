#pragma once

#include "core/base/nice_ticks.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace berg {

// Drawings for documents: SVG whose colours and fonts come from the classes of the page's style
// sheet (`kReportStyle`), so that light, dark and print are the same drawing.

/** Pixels, y down. */
struct SvgPoint
{
    double x = 0;
    double y = 0;
};

enum class TextAnchor
{
    Start,
    Middle,
    End
};

/** One drawing; later things lie over earlier ones. Texts are escaped, classes are not. */
class SvgDrawing
{
public:
    /** `title`: what somebody who cannot see the drawing is told. */
    SvgDrawing(SvgPoint size, std::string_view title);

    void line(SvgPoint from, SvgPoint to, std::string_view style);
    void polyline(std::span<const SvgPoint> points, std::string_view style);
    void polygon(std::span<const SvgPoint> points, std::string_view style);
    void rect(SvgPoint corner, SvgPoint size, std::string_view style, std::string_view tip);
    void circle(SvgPoint centre, double radius, std::string_view style, std::string_view tip);
    /** `at.y` is the middle of the line. */
    void text(SvgPoint at, std::string_view text, std::string_view style,
              TextAnchor anchor = TextAnchor::Start);

    [[nodiscard]] std::string svg() const;

private:
    std::string m_body;
};

/** Pixels of the plot within its drawing. */
struct PlotFrame
{
    double left = 0;
    double top = 0;
    double right = 0;
    double bottom = 0;
};

/** Range and ticks of one axis and the pixels of its ends. */
class PlotScale
{
public:
    PlotScale(NiceRange range, double first_px, double last_px);

    [[nodiscard]] double at(double value) const;
    [[nodiscard]] const NiceRange& range() const { return m_range; }
    /** "18 000", with the decimals that the ticks need. */
    [[nodiscard]] std::string label(int tick) const;

private:
    NiceRange m_range;
    double m_first_px;
    double m_last_px;
};

/** Ticks, numbers and the title below the plot; grid lines upwards when wanted. */
void drawXAxis(SvgDrawing& drawing, const PlotFrame& frame, const PlotScale& x,
               std::string_view title, bool grid);
/** Grid lines and numbers; the title lies above the plot. */
void drawYAxis(SvgDrawing& drawing, const PlotFrame& frame, const PlotScale& y,
               std::string_view title);

} // namespace berg
