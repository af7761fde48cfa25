#include "widgets/charts/weather_marks.h"

#include "core/io/figure/wind_barb.h"
#include "widgets/charts/weather_chart.h"
#include "widgets/theme/quantity_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace berg {
namespace {

constexpr double kShaft_px = 17;
constexpr double kBarbRow_px = 30;  // height of the row of barbs
constexpr double kMarkStep_px = 34; // least distance of marks
constexpr double kMarkEdge_px = 12; // distance from the ends of the plot
constexpr double kArrow_px = 15;
constexpr double kLeastHeight_px = 130; // of a chart with barbs
constexpr std::array<double, 13> kMarkSteps_s{60,   120,   300,   600,   900,   1800,  3600,
                                              7200, 10800, 21600, 43200, 86400, 172800};

/** Times of marks in the window, at round times of the chart's clock. */
std::vector<double> markTimes_s(const TimeFigure& time, const TimeChartContent& content,
                                double width_px)
{
    const double length_s = time.window.length_s();
    const double sPerPx = length_s / std::max(1, chartColumns(width_px));
    const auto step = std::ranges::find_if(
        kMarkSteps_s, [sPerPx](double step_s) { return step_s >= kMarkStep_px * sPerPx; });
    const double step_s = step == kMarkSteps_s.end() ? kMarkSteps_s.back() : *step;
    const double from_s = time.window.from_s + kMarkEdge_px * sPerPx;
    const double to_s = time.window.to_s - kMarkEdge_px * sPerPx;
    const double midnight_s = content.clock.isUtc() ? content.clock.midnight_s() : 0;
    std::vector<double> times_s;
    for (double time_s = midnight_s + std::ceil((from_s - midnight_s) / step_s) * step_s;
         time_s <= to_s && times_s.size() < 200; time_s += step_s)
        times_s.push_back(time_s);
    if (times_s.empty())
        times_s.push_back((from_s + to_s) / 2);
    return times_s;
}

void addStroke(Figure& figure, const PlotPoint& at, const std::vector<Pixel>& path, const Ink& ink,
               bool onRightAxis)
{
    PlotLine line{
        .points = {}, .ink = ink, .width_px = 1.3, .onRightAxis = onRightAxis, .isOver = true};
    for (const Pixel& pixel : path)
        line.points.push_back({at.x, at.y, at.dx_px + pixel.x, at.dy_px + pixel.y});
    figure.lines.push_back(std::move(line));
}

/** A circle as a polygon, because figures draw lines. */
std::vector<Pixel> circleOf(double radius_px)
{
    constexpr int kCorners = 12;
    std::vector<Pixel> circle;
    for (int i = 0; i <= kCorners; ++i) {
        const double angle_rad = 2 * std::numbers::pi * i / kCorners;
        circle.push_back({radius_px * std::cos(angle_rad), radius_px * std::sin(angle_rad)});
    }
    return circle;
}

/** Lines that fill a triangle. */
std::vector<Pixel> filled(const std::vector<Pixel>& triangle)
{
    constexpr int kStrokes = 5;
    std::vector<Pixel> path = triangle;
    path.push_back(triangle.front());
    for (int i = 1; i <= kStrokes; ++i) {
        const double share = static_cast<double>(i) / kStrokes;
        path.push_back(triangle[1]);
        path.push_back({triangle[0].x + share * (triangle[2].x - triangle[0].x),
                        triangle[0].y + share * (triangle[2].y - triangle[0].y)});
    }
    return path;
}

void addBarb(Figure& figure, double time_s, const Point& wind_mps, bool isSouthern)
{
    const WindBarb barb = windBarb(wind_mps, kShaft_px, isSouthern);
    const Ink ink{.of = InkOf::Text};
    PlotPoint at{time_s, kPlotEdge, 0, kBarbRow_px / 2};
    if (barb.calm_px)
        return addStroke(figure, at, circleOf(*barb.calm_px), ink, false);
    const Pixel& tip = barb.lines.front().back();
    at.dx_px -= tip.x / 2; // the middle of the shaft is at the time
    at.dy_px -= tip.y / 2;
    for (const std::vector<Pixel>& line : barb.lines)
        addStroke(figure, at, line, ink, false);
    for (const std::vector<Pixel>& pennant : barb.pennants)
        addStroke(figure, at, filled(pennant), ink, false);
}

bool isLineShown(const TimeChartContent& content, LineRole role)
{
    return std::ranges::any_of(content.lines, [role](const TimeLine& line) {
        return line.role == role && line.isShown();
    });
}

} // namespace

void addWeatherMarks(TimeFigure& time, const TimeChartContent& content, const QSizeF& size_px)
{
    const TimeDirections& directions = content.directions;
    Figure& figure = time.figure;
    const std::vector<double> times_s = markTimes_s(time, content, size_px.width());
    if (isLineShown(content, LineRole::Wind) && size_px.height() >= kLeastHeight_px) {
        figure.y.reserve_px = kBarbRow_px;
        if (figure.right)
            figure.right->reserve_px = kBarbRow_px;
        for (const double time_s : times_s)
            if (const auto wind_mps = velocityAt_mps(directions.wind, time_s))
                addBarb(figure, time_s, *wind_mps, directions.isSouthern);
    }
    if (!isLineShown(content, LineRole::Current))
        return;
    for (const double time_s : times_s) {
        const auto current_mps = velocityAt_mps(directions.current, time_s);
        if (!current_mps || current_mps->isZero(0))
            continue;
        const PlotPoint at{time_s, speedUnit().fromSi(current_mps->norm())};
        for (const std::vector<Pixel>& path : velocityArrow(*current_mps, kArrow_px))
            addStroke(figure, at, path, {.of = InkOf::Plan}, true);
    }
}

} // namespace berg
