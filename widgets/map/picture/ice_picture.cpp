#include "widgets/map/picture/ice_picture.h"

#include "core/geometry/geometry.h"

#include <algorithm>
#include <mutex>

namespace berg {

namespace {

constexpr std::uint32_t kFillAlpha = 0xB0;
constexpr std::uint32_t kEdgeAlpha = 0xFF;

/** Darkens a colour, so that areas of one class differ. */
std::uint32_t edgeOf(std::uint32_t rgb)
{
    const auto part = [rgb](unsigned shift) { return ((rgb >> shift & 0xFFU) * 2 / 3) << shift; };
    return kEdgeAlpha << 24U | part(16) | part(8) | part(0);
}

std::vector<MapShape> shapesOf(const IceChart& chart, const LatLon& origin)
{
    const LocalFrame frame(origin);
    std::vector<MapShape> shapes;
    for (const IceArea& area : chart.areas) {
        MapShape shape{.kind = MapShape::Kind::Polygon,
                       .parts = {},
                       .name = {},
                       .fill = iceFill(classOf(area)),
                       .line = edgeOf(wmoColour(classOf(area)))};
        for (const std::vector<Point>& outline_m : area.outlines_m) {
            std::vector<LatLon>& part = shape.parts.emplace_back();
            for (const Point& corner_m : outline_m)
                part.push_back(frame.toGeographic(corner_m));
        }
        shapes.push_back(std::move(shape));
    }
    return shapes;
}

bool isOld(const IceChart& chart, const std::string& startUtc)
{
    return ageOf_s(chart, startUtc) > kOldIceChart_s;
}

} // namespace

std::uint32_t iceFill(IceClass iceClass)
{
    return kFillAlpha << 24U | wmoColour(iceClass);
}

IceChartPointer iceChartOf(const Scenario& scenario)
{
    // Every picture of a flight has the same chart, and projecting it takes milliseconds.
    static std::mutex guard;
    static IceChartPointer last;
    if (!scenario.iceChart)
        return nullptr;
    const std::lock_guard lock(guard);
    const bool old = isOld(*scenario.iceChart, scenario.startUtc);
    if (last == nullptr || last->isOld != old || last->origin != scenario.origin ||
        last->chart != *scenario.iceChart)
        last = std::make_shared<const MapIceChart>(
            MapIceChart{.chart = *scenario.iceChart,
                        .origin = scenario.origin,
                        .isOld = old,
                        .shapes = std::make_shared<const std::vector<MapShape>>(
                            shapesOf(*scenario.iceChart, scenario.origin))});
    return last;
}

const IceArea* iceAreaAt(const MapIceChart& chart, const Point& place_m)
{
    const std::vector<IceArea>& areas = chart.chart.areas;
    const auto found = std::find_if(areas.rbegin(), areas.rend(), [&](const IceArea& area) {
        return std::ranges::count_if(area.outlines_m,
                                     [&](const std::vector<Point>& outline_m) {
                                         return insidePolygon(outline_m, place_m);
                                     }) %
                   2 ==
               1;
    });
    return found == areas.rend() ? nullptr : &*found;
}

} // namespace berg
