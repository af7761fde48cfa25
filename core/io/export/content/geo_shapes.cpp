#include "core/io/export/content/geo_shapes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

namespace berg {

namespace {

/** Largest distance between a leg and its image. */
constexpr double kTolerance_m = 1;
/** Legs with a smaller change in longitude stay within 0.3 m of their image: R dlon^2 / 16. */
constexpr double kShortLeg_deg = 0.05;

struct Vertex
{
    Point position_m;
    TimedPlace at;
};

Vertex vertexOf(const LocalFrame& frame, const TimedPoint& point)
{
    return {.position_m = point.position_m,
            .at = {.place = frame.toGeographic(point.position_m), .time_s = point.time_s}};
}

/** Longitude of `b` in the shorter direction from `a`; it may be outside [-180, 180]. */
double nextLongitude_deg(const LatLon& a, const LatLon& b)
{
    return a.longitude_deg + std::remainder(b.longitude_deg - a.longitude_deg, 360.0);
}

/** Passes the vertices after `a` up to `b` to `take`. */
void addLeg(const LocalFrame& frame, const Vertex& a, const Vertex& b,
            const std::function<void(const TimedPlace&)>& take)
{
    const double longitude_deg = nextLongitude_deg(a.at.place, b.at.place);
    const double change_deg = std::abs(longitude_deg - a.at.place.longitude_deg);
    if (change_deg > kShortLeg_deg && (b.position_m - a.position_m).norm() > kTolerance_m) {
        const TimedPoint middle{.position_m = (a.position_m + b.position_m) / 2,
                                .time_s = (a.at.time_s + b.at.time_s) / 2};
        const LatLon image{.latitude_deg = (a.at.place.latitude_deg + b.at.place.latitude_deg) / 2,
                           .longitude_deg = (a.at.place.longitude_deg + longitude_deg) / 2};
        if ((frame.toPlane(image) - middle.position_m).norm() > kTolerance_m) {
            const Vertex split = vertexOf(frame, middle);
            addLeg(frame, a, split, take);
            addLeg(frame, split, b, take);
            return;
        }
    }
    take(b.at);
}

/**
 * Returns the point at which the line from `a` to `b` crosses the antimeridian, on the side of `a`,
 * or nullopt if it does not cross.
 */
std::optional<TimedPlace> crossing(const TimedPlace& a, const TimedPlace& b)
{
    const double change_deg = b.place.longitude_deg - a.place.longitude_deg;
    if (std::abs(change_deg) <= 180)
        return std::nullopt;
    const double border_deg = change_deg < 0 ? 180 : -180; // eastwards, westwards
    const double step_deg = nextLongitude_deg(a.place, b.place) - a.place.longitude_deg;
    const double part = step_deg == 0 ? 0 : (border_deg - a.place.longitude_deg) / step_deg;
    return TimedPlace{
        .place = {.latitude_deg = std::lerp(a.place.latitude_deg, b.place.latitude_deg, part),
                  .longitude_deg = border_deg},
        .time_s = std::lerp(a.time_s, b.time_s, part)};
}

/**
 * Adds vertices to a line and cuts it at the antimeridian. It passes on each vertex and whether a
 * part begins with it; a part may be a single vertex.
 */
class LineCutter
{
public:
    LineCutter(const LocalFrame& frame, PlaceSink take) : m_frame(frame), m_take(std::move(take)) {}

    void add(const TimedPoint& point)
    {
        const Vertex vertex = vertexOf(m_frame, point);
        if (m_last)
            addLeg(m_frame, *m_last, vertex, [this](const TimedPlace& place) { addPlace(place); });
        else
            put(vertex.at, true);
        m_last = vertex;
    }

private:
    void addPlace(const TimedPlace& place)
    {
        std::optional<TimedPlace> border = crossing(m_lastPlace, place);
        if (!border)
            return put(place, false);
        if (!(m_lastPlace.place == border->place))
            put(*border, false);
        border->place.longitude_deg *= -1;
        put(*border, true);
        if (!(place.place == border->place))
            put(place, false);
        m_lastPlace = place;
    }

    void put(const TimedPlace& place, bool isFirst)
    {
        m_take(place, isFirst);
        m_lastPlace = place;
    }

    const LocalFrame& m_frame;
    PlaceSink m_take;
    std::optional<Vertex> m_last;
    TimedPlace m_lastPlace;
};

/** Returns the parts of a ring; the first and last may be single points. */
std::vector<std::vector<TimedPlace>> partsOf(const LocalFrame& frame,
                                             std::span<const TimedPoint> points)
{
    std::vector<std::vector<TimedPlace>> parts;
    LineCutter cutter(frame, [&parts](const TimedPlace& place, bool isFirst) {
        if (isFirst)
            parts.emplace_back();
        parts.back().push_back(place);
    });
    for (const TimedPoint& point : points)
        cutter.add(point);
    return parts;
}

bool onBorder(const TimedPlace& vertex)
{
    return std::abs(vertex.place.longitude_deg) == 180;
}

using Ring = std::vector<LatLon>;

/**
 * Joins the parts of a counter-clockwise ring to rings along the border of the map. The inside is
 * on the left, so a part that ends on the east border continues northwards to the next part that
 * starts on it, and one that ends on the west border continues southwards. If there is no such
 * part, the pole is inside, and the border is followed over it to the other side.
 */
class RingAssembler
{
public:
    explicit RingAssembler(std::vector<Ring> parts)
        : m_parts(std::move(parts)), m_used(m_parts.size(), false)
    {
    }

    std::vector<Ring> rings()
    {
        std::vector<Ring> rings;
        for (std::size_t first = 0; first < m_parts.size(); ++first) {
            if (m_used[first])
                continue;
            m_used[first] = true;
            Ring ring = m_parts[first];
            for (std::size_t next = nextPart(ring, first); next != first;
                 next = nextPart(ring, first)) {
                m_used[next] = true;
                ring.insert(ring.end(), m_parts[next].begin(), m_parts[next].end());
            }
            ring.push_back(ring.front());
            rings.push_back(std::move(ring));
        }
        return rings;
    }

private:
    /**
     * Returns the part that continues from the end of `ring`; adds the corners at a pole to the
     * ring.
     */
    std::size_t nextPart(Ring& ring, std::size_t first) const
    {
        LatLon at = ring.back();
        for (int side = 0; side < 2; ++side) {
            if (const std::optional<std::size_t> next = startOnBorder(at, first))
                return *next;
            const double pole_deg = at.longitude_deg > 0 ? 90 : -90;
            ring.push_back({.latitude_deg = pole_deg, .longitude_deg = at.longitude_deg});
            at = {.latitude_deg = pole_deg, .longitude_deg = -at.longitude_deg};
            ring.push_back(at);
        }
        return first; // the ring's own start is on one of the two borders
    }

    /**
     * Returns the first start of an unused part (or of `first`) on the border of `at`, beyond `at`.
     */
    [[nodiscard]] std::optional<std::size_t> startOnBorder(const LatLon& at,
                                                           std::size_t first) const
    {
        const double sense = at.longitude_deg > 0 ? 1 : -1;
        std::optional<std::size_t> best;
        double bestAhead_deg = 0;
        for (std::size_t i = 0; i < m_parts.size(); ++i) {
            const LatLon& start = m_parts[i].front();
            const double ahead_deg = (start.latitude_deg - at.latitude_deg) * sense;
            if ((m_used[i] && i != first) || start.longitude_deg != at.longitude_deg ||
                ahead_deg < 0)
                continue;
            if (!best || ahead_deg < bestAhead_deg) {
                best = i;
                bestAhead_deg = ahead_deg;
            }
        }
        return best;
    }

    std::vector<Ring> m_parts;
    std::vector<bool> m_used;
};

Ring placesOf(const std::vector<TimedPlace>& line)
{
    Ring ring;
    for (const TimedPlace& vertex : line)
        ring.push_back(vertex.place);
    return ring;
}

} // namespace

void eachPlace(const LocalFrame& frame, const std::function<void(const PointSink&)>& eachPoint,
               const PlaceSink& take)
{
    std::optional<TimedPlace> waiting; // first vertex of a part, in case a second follows
    LineCutter cutter(frame, [&](const TimedPlace& place, bool isFirst) {
        if (waiting && !isFirst)
            take(*waiting, true);
        waiting.reset();
        if (isFirst)
            waiting = place;
        else
            take(place, false);
    });
    eachPoint([&cutter](const TimedPoint& point) { cutter.add(point); });
}

std::vector<std::vector<LatLon>> geographicPolygon(const LocalFrame& frame,
                                                   std::span<const Point> corners_m)
{
    std::vector<TimedPoint> outline;
    for (const Point& corner_m : corners_m)
        outline.push_back({.position_m = corner_m});
    if (signedArea(corners_m) < 0)
        std::reverse(outline.begin(), outline.end());
    outline.push_back(outline.front());

    std::vector<std::vector<TimedPlace>> parts = partsOf(frame, outline);
    if (parts.size() == 1)
        return {placesOf(parts.front())};
    // The outline starts and ends at the same corner, in the middle of a part.
    const std::vector<TimedPlace> head = std::move(parts.front());
    parts.erase(parts.begin());
    parts.back().insert(parts.back().end(), head.begin() + 1, head.end());

    std::vector<Ring> rings;
    for (const std::vector<TimedPlace>& part : parts)
        if (!std::all_of(part.begin(), part.end(), onBorder)) // skips a part along the border
            rings.push_back(placesOf(part));
    return RingAssembler(std::move(rings)).rings();
}

} // namespace berg
