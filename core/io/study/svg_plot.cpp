#include "core/io/study/svg_plot.h"

#include "core/io/text/html_text.h"
#include "core/io/text/number_text.h"

namespace berg {

namespace {

/** Below the middle of a line of 12 px: where its letters stand. */
constexpr double kBaseline_px = 4;
constexpr double kTick_px = 5;

std::string px(double value)
{
    return fixedText(value, 1);
}

std::string classAttribute(std::string_view style)
{
    return " class=\"" + std::string(style) + '"';
}

/** End of an element that may tell something under the mouse. */
std::string withTip(std::string_view element, std::string_view tip)
{
    if (tip.empty())
        return "/>\n";
    return "><title>" + htmlText(tip) + "</title></" + std::string(element) + ">\n";
}

std::string pointsAttribute(std::span<const SvgPoint> points)
{
    std::string text = " points=\"";
    for (const SvgPoint& point : points) {
        if (text.back() != '"')
            text += ' ';
        text += px(point.x) + ',' + px(point.y);
    }
    return text + '"';
}

std::string_view anchorAttribute(TextAnchor anchor)
{
    switch (anchor) {
    case TextAnchor::Start:
        return "";
    case TextAnchor::Middle:
        return " text-anchor=\"middle\"";
    case TextAnchor::End:
        return " text-anchor=\"end\"";
    }
    return "";
}

} // namespace

SvgDrawing::SvgDrawing(SvgPoint size, std::string_view title)
    : m_body("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " + fixedText(size.x, 0) +
             ' ' + fixedText(size.y, 0) + "\" role=\"img\">\n<title>" + htmlText(title) +
             "</title>\n")
{
}

void SvgDrawing::line(SvgPoint from, SvgPoint to, std::string_view style)
{
    m_body += "<line" + classAttribute(style) + " x1=\"" + px(from.x) + "\" y1=\"" + px(from.y) +
              "\" x2=\"" + px(to.x) + "\" y2=\"" + px(to.y) + "\"/>\n";
}

void SvgDrawing::polyline(std::span<const SvgPoint> points, std::string_view style)
{
    m_body += "<polyline" + classAttribute(style) + pointsAttribute(points) + "/>\n";
}

void SvgDrawing::polygon(std::span<const SvgPoint> points, std::string_view style)
{
    m_body += "<polygon" + classAttribute(style) + pointsAttribute(points) + "/>\n";
}

void SvgDrawing::rect(SvgPoint corner, SvgPoint size, std::string_view style, std::string_view tip)
{
    m_body += "<rect" + classAttribute(style) + " x=\"" + px(corner.x) + "\" y=\"" + px(corner.y) +
              "\" width=\"" + px(size.x) + "\" height=\"" + px(size.y) + '"' + withTip("rect", tip);
}

void SvgDrawing::circle(SvgPoint centre, double radius, std::string_view style,
                        std::string_view tip)
{
    m_body += "<circle" + classAttribute(style) + " cx=\"" + px(centre.x) + "\" cy=\"" +
              px(centre.y) + "\" r=\"" + px(radius) + '"' + withTip("circle", tip);
}

void SvgDrawing::text(SvgPoint at, std::string_view text, std::string_view style, TextAnchor anchor)
{
    m_body += "<text" + (style.empty() ? std::string() : classAttribute(style)) + " x=\"" +
              px(at.x) + "\" y=\"" + px(at.y + kBaseline_px) + '"' +
              std::string(anchorAttribute(anchor)) + '>' + htmlText(text) + "</text>\n";
}

std::string SvgDrawing::svg() const
{
    return m_body + "</svg>\n";
}

PlotScale::PlotScale(NiceRange range, double first_px, double last_px)
    : m_range(range), m_first_px(first_px), m_last_px(last_px)
{
}

double PlotScale::at(double value) const
{
    return m_first_px + m_range.share(value) * (m_last_px - m_first_px);
}

std::string PlotScale::label(int tick) const
{
    return printedNumber(m_range.at(tick), m_range.decimals());
}

void drawXAxis(SvgDrawing& drawing, const PlotFrame& frame, const PlotScale& x,
               std::string_view title, bool grid)
{
    for (int tick = 0; tick <= x.range().count; ++tick) {
        const double at = x.at(x.range().at(tick));
        if (grid)
            drawing.line({at, frame.top}, {at, frame.bottom}, "grid");
        drawing.line({at, frame.bottom}, {at, frame.bottom + kTick_px}, "axis");
        drawing.text({at, frame.bottom + 15}, x.label(tick), "number", TextAnchor::Middle);
    }
    drawing.line({frame.left, frame.bottom}, {frame.right, frame.bottom}, "axis");
    drawing.text({(frame.left + frame.right) / 2, frame.bottom + 34}, title, "muted",
                 TextAnchor::Middle);
}

void drawYAxis(SvgDrawing& drawing, const PlotFrame& frame, const PlotScale& y,
               std::string_view title)
{
    for (int tick = 0; tick <= y.range().count; ++tick) {
        const double at = y.at(y.range().at(tick));
        drawing.line({frame.left, at}, {frame.right, at}, "grid");
        drawing.text({frame.left - 8, at}, y.label(tick), "number", TextAnchor::End);
    }
    drawing.text({8, frame.top - 20}, title, "muted");
}

} // namespace berg
