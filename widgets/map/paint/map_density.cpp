#include "widgets/map/paint/map_density.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <unordered_map>

namespace berg {
namespace {

constexpr std::size_t kFewest = 40;      // fewest icebergs in sight of a crowded field
constexpr std::size_t kFewestAfter = 35; // hysteresis of `kFewest`
constexpr double kCrowded_px = 34;       // symbols lose their rings below this spacing
constexpr double kUncrowded_px = 38;     // and regain them above this one
constexpr double kDense_px = 20;         // symbols become dots below this spacing
constexpr double kOpen_px = 23;          // and dots become symbols above this one
constexpr double kVeryDense_px = 7;      // dots overlap everywhere
constexpr double kCover_px = 8;          // nearer dots are counted together
constexpr double kCoverFar_px = 20;      // in a very dense field
constexpr int kLeastCount = 3;

/** Grid of the screen that finds near points. */
class PixelGrid
{
public:
    explicit PixelGrid(double cell_px) : m_cell_px(cell_px) {}

    void add(const QPointF& at, std::size_t number)
    {
        m_cells[keyOf(columnOf(at.x()), columnOf(at.y()))].push_back({at, number});
    }
    /** Number of a point other than `self` nearer than a cell; nullopt if there is none. */
    [[nodiscard]] std::optional<std::size_t> near(const QPointF& at,
                                                  std::optional<std::size_t> self = {}) const
    {
        for (int x = columnOf(at.x()) - 1; x <= columnOf(at.x()) + 1; ++x)
            for (int y = columnOf(at.y()) - 1; y <= columnOf(at.y()) + 1; ++y) {
                const auto cell = m_cells.find(keyOf(x, y));
                if (cell == m_cells.end())
                    continue;
                for (const GridPoint& entry : cell->second) {
                    const QPointF d = entry.at - at;
                    if (entry.number != self && QPointF::dotProduct(d, d) < m_cell_px * m_cell_px)
                        return entry.number;
                }
            }
        return std::nullopt;
    }

private:
    struct GridPoint
    {
        QPointF at;
        std::size_t number;
    };
    [[nodiscard]] int columnOf(double at_px) const
    {
        return static_cast<int>(std::floor(at_px / m_cell_px));
    }
    [[nodiscard]] static std::int64_t keyOf(int x, int y)
    {
        return std::int64_t{x} * (std::int64_t{1} << 32) + y;
    }

    double m_cell_px;
    std::unordered_map<std::int64_t, std::vector<GridPoint>> m_cells;
};

/** Returns whether most places have a neighbour within `spacing_px`. */
bool areCloserThan(double spacing_px, const std::vector<QPointF>& places)
{
    PixelGrid grid(spacing_px);
    for (std::size_t i = 0; i < places.size(); ++i)
        grid.add(places[i], i);
    std::ptrdiff_t crowded = 0;
    for (std::size_t i = 0; i < places.size(); ++i)
        crowded += grid.near(places[i], i) ? 1 : 0;
    return 2 * crowded > std::ssize(places);
}

bool keepsSymbol(const MapIceberg& iceberg, const MapStop& stop)
{
    return isNext(stop) || iceberg.status != TrackStatus::Tracked || iceberg.ringEntry_s;
}

/** Groups dots (each joins the first group that covers it) and counts groups of three or more. */
void count(MapDensity& density, const MapPicture& picture, const std::vector<std::size_t>& dots,
           const std::vector<QPointF>& places, double cover_px)
{
    PixelGrid firsts(cover_px);
    std::vector<std::vector<std::size_t>> groups;
    for (std::size_t k = 0; k < dots.size(); ++k) {
        const std::optional<std::size_t> group = firsts.near(places[k]);
        if (group) {
            groups[*group].push_back(k);
            continue;
        }
        firsts.add(places[k], groups.size());
        groups.push_back({k});
    }
    for (const std::vector<std::size_t>& group : groups) {
        if (static_cast<int>(group.size()) < kLeastCount)
            continue;
        MapCount& one = density.counts.emplace_back();
        one.icebergs = static_cast<int>(group.size());
        for (const std::size_t k : group) {
            one.centre_px += places[k] / static_cast<double>(group.size());
            one.sigma_m2 = std::max(one.sigma_m2, picture.icebergs[dots[k]].sigma_m2);
            density.marks[dots[k]] = IcebergMark::Counted;
        }
    }
}

} // namespace

std::vector<MapStop> stopsOf(const MapPicture& picture)
{
    std::vector<MapStop> stops(picture.icebergs.size());
    for (std::size_t uav = 0; uav < picture.routes.size(); ++uav) {
        int order = 0;
        for (const MapPlace iceberg : picture.routes[uav].plan) {
            MapStop& stop = stops[toIndex(iceberg)];
            ++order;
            if (!stop.order || order < *stop.order)
                stop = {.order = order, .uav = uav};
            else if (stop.uav == uav)
                stop.later.push_back(order);
        }
    }
    return stops;
}

MapDensity densityOf(const MapPicture& picture, const MapViewTransform& view, const QRectF& shown,
                     const std::vector<MapStop>& stops, const MapCrowding& before)
{
    MapDensity density;
    density.marks.assign(picture.icebergs.size(), IcebergMark::Symbol);
    std::vector<QPointF> places;
    for (const MapIceberg& iceberg : picture.icebergs)
        if (const QPointF at = view.toPixel(iceberg.position_m); shown.contains(at))
            places.push_back(at);
    density.isCrowded = std::size(places) >= (before.isCrowded ? kFewestAfter : kFewest) &&
                        areCloserThan(before.isCrowded ? kUncrowded_px : kCrowded_px, places);
    density.isDense =
        density.isCrowded && areCloserThan(before.isDense ? kOpen_px : kDense_px, places);
    if (!density.isDense)
        return density;
    const bool isVeryDense = areCloserThan(kVeryDense_px, places);
    std::vector<std::size_t> dots;
    places.clear();
    for (std::size_t i = 0; i < picture.icebergs.size(); ++i) {
        if (keepsSymbol(picture.icebergs[i], stops[i]))
            continue;
        density.marks[i] = IcebergMark::Dot;
        const QPointF at = view.toPixel(picture.icebergs[i].position_m);
        if (!shown.contains(at))
            continue;
        dots.push_back(i);
        places.push_back(at);
    }
    count(density, picture, dots, places, isVeryDense ? kCoverFar_px : kCover_px);
    return density;
}

} // namespace berg
