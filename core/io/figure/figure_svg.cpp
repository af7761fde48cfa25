#include "core/io/figure/figure_svg.h"

#include "core/base/number_text.h"
#include "core/io/figure/figure_layout.h"
#include "core/io/figure/mark_outline.h"
#include "core/io/text/html_text.h"
#include "core/plan/policy/policy.h"

namespace berg {
namespace {

constexpr double kLetter_px = 6.6; // average width of a letter at 12 px
constexpr double kBaseline_px = 4; // below the middle of a line of text

std::string px(double value)
{
    return fixedText(value, 1);
}

std::string inkClass(const Ink& ink)
{
    switch (ink.of) {
    case InkOf::Text:
        return "text";
    case InkOf::Muted:
        return "muted";
    case InkOf::Axis:
        return "axis";
    case InkOf::Grid:
        return "grid";
    case InkOf::Policy:
        return "p-" + nameOf(kPolicyNames, static_cast<PolicyKind>(static_cast<int>(ink.value)));
    case InkOf::Caution:
        return "caution";
    case InkOf::Danger:
        return "danger";
    case InkOf::Uav:
    case InkOf::Plan:
    case InkOf::Accumulated:
    case InkOf::Momentary:
    case InkOf::Comparison:
    case InkOf::Solver:
    case InkOf::Sigma:
        break;
    }
    return "plan";
}

std::string attribute(const char* name, const std::string& value)
{
    return std::string(" ") + name + "=\"" + value + '"';
}

std::string pointsAttribute(const std::vector<Pixel>& points)
{
    std::string text;
    for (const Pixel& point : points)
        text += (text.empty() ? "" : " ") + px(point.x) + ',' + px(point.y);
    return attribute("points", text);
}

/** SVG element, with a tooltip if `tip` is not empty. */
std::string element(const std::string& name, const std::string& attributes, const std::string& tip)
{
    const std::string opened = '<' + name + attributes;
    return tip.empty() ? opened + "/>\n"
                       : opened + "><title>" + htmlText(tip) + "</title></" + name + ">\n";
}

std::string lineSvg(const DrawnLine& line)
{
    std::string attributes =
        attribute("class",
                  line.key.empty() ? inkClass(line.ink) : line.key + ' ' + inkClass(line.ink)) +
        pointsAttribute(line.points);
    if (line.width_px != 1)
        attributes += attribute("stroke-width", px(line.width_px));
    if (line.ink.strength < 1)
        attributes += attribute("stroke-opacity", fixedText(line.ink.strength, 2));
    std::string dashes;
    for (const double dash : line.dash_px)
        dashes += (dashes.empty() ? "" : " ") + fixedText(dash, 0);
    return element("polyline",
                   attributes + (dashes.empty() ? "" : attribute("stroke-dasharray", dashes)), {});
}

std::string areaSvg(const DrawnArea& area)
{
    std::string attributes =
        attribute("class", (area.of.key.empty() ? "" : area.of.key + ' ') + inkClass(area.of.ink)) +
        pointsAttribute(area.outline);
    if (area.of.opacity < 1)
        attributes += attribute("fill-opacity", fixedText(area.of.opacity, 2));
    return element("polygon", attributes, area.of.tip);
}

std::string markSvg(const DrawnMark& mark)
{
    const std::vector<Pixel> outline = markOutline(mark.of, mark.at);
    const bool isRing = mark.of.shape == MarkShape::Ring;
    const std::string style =
        attribute("class", (mark.of.isHollow || isRing ? "hollow " : "") + inkClass(mark.of.ink)) +
        (isRing ? attribute("style", "fill: none") : "");
    if (!outline.empty())
        return element("polygon", style + pointsAttribute(outline), mark.of.tip);
    return element("circle",
                   style + attribute("cx", px(mark.at.x)) + attribute("cy", px(mark.at.y)) +
                       attribute("r", px(mark.of.radius_px)),
                   mark.of.tip);
}

std::string textSvg(const DrawnText& text)
{
    if (text.text.empty())
        return {};
    const bool isCentred = text.align == TextAlign::Centre;
    const double x = isCentred                        ? (text.rect.left + text.rect.right) / 2
                     : text.align == TextAlign::Right ? text.rect.right
                                                      : text.rect.left;
    const std::string anchor = isCentred ? "middle" : text.align == TextAlign::Right ? "end" : "";
    return "<text" + attribute("class", inkClass(text.ink)) + attribute("x", px(x)) +
           attribute("y", px((text.rect.top + text.rect.bottom) / 2 + kBaseline_px)) +
           (anchor.empty() ? "" : attribute("text-anchor", anchor)) + '>' + htmlText(text.text) +
           "</text>\n";
}

/** Number of characters, which may be less than the number of bytes. */
double lengthOf(const std::string& text)
{
    double length = 0;
    for (const char c : text)
        length += (static_cast<unsigned char>(c) & 0xC0U) == 0x80U ? 0 : 1;
    return length;
}

} // namespace

std::string figureSvg(const Figure& figure, double width_px, double height_px)
{
    const FigureFonts fonts{
        .width_px = [](const std::string& text,
                       FigureFont /*font*/) { return kLetter_px * lengthOf(text); },
        .elided = [](const std::string& text, FigureFont /*font*/,
                     double /*room_px*/) { return text; }};
    const Drawing drawing = layOut(figure, {width_px, height_px}, fonts);
    std::string svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " +
                      fixedText(width_px, 0) + ' ' + fixedText(height_px, 0) +
                      "\" role=\"img\">\n<title>" + htmlText(figure.name) + "</title>\n";
    for (const DrawnLine& line : drawing.grid)
        svg += lineSvg(line);
    for (const DrawnArea& area : drawing.areas)
        svg += areaSvg(area);
    for (const DrawnLine& line : drawing.lines)
        svg += lineSvg(line);
    for (const DrawnMark& mark : drawing.marks)
        svg += markSvg(mark);
    for (const DrawnLine& line : drawing.over)
        svg += lineSvg(line);
    for (const DrawnText& text : drawing.texts)
        svg += textSvg(text);
    return svg + "</svg>\n";
}

std::string figureSvgFile(const Figure& figure, double width_px, double height_px)
{
    constexpr std::string_view kStyle = R"css(<style>
svg { --text: #16222b; --muted: #4c5e6a; --page: #ffffff; --grid: #e3eaee; --axis: #84949e;
  --plan: #1769aa; --caution: #b86e00; --danger: #b3263a; background: var(--page); }
@media (prefers-color-scheme: dark) { svg { --text: #e8eff3; --muted: #9cb0bc; --page: #111e28;
  --grid: #223441; --axis: #6b7f8c; --plan: #5fb3f2; --caution: #f2b04d; --danger: #ff7a8a; } }
.text { --ink: var(--text); } .muted { --ink: var(--muted); } .axis { --ink: var(--axis); }
.grid { --ink: var(--grid); } .plan { --ink: var(--plan); } .caution { --ink: var(--caution); }
.danger { --ink: var(--danger); }
text { font: 12px system-ui, "Segoe UI", "Noto Sans", sans-serif; fill: var(--ink); }
polyline { fill: none; stroke: var(--ink); stroke-linejoin: round; }
polygon, circle { fill: var(--ink); }
.hollow { fill: var(--page); stroke: var(--ink); stroke-width: 1.5; }
.no-go { fill: url(#hatch); fill-opacity: 1; stroke: var(--ink); }
.stripe { stroke: var(--danger); stroke-width: 2.4; }
</style>
<defs><pattern id="hatch" patternUnits="userSpaceOnUse" width="6" height="6"
  patternTransform="rotate(45)"><line class="stripe" x1="0" y1="0" x2="0" y2="6"/></pattern></defs>
)css";
    std::string svg = figureSvg(figure, width_px, height_px);
    const std::string sizes =
        " width=\"" + fixedText(width_px, 0) + "\" height=\"" + fixedText(height_px, 0) + '"';
    svg.insert(svg.find('>') + 1, '\n' + std::string(kStyle));
    svg.insert(svg.find(" viewBox"), sizes);
    return svg;
}

} // namespace berg
