#include "core/geometry/covering_outline.h"

#include "core/base/angles.h"
#include "core/geometry/outline.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

namespace berg {

namespace {

constexpr double kLeastArea_m2 = 1;
constexpr double kClose_m = 0.01;           ///< nearer places count as one
constexpr double kPassage_m = 0.2;          ///< distance by which corners move to join parts
constexpr std::size_t kMostCrossing = 4000; ///< corners; more would make too many pairs of edges
constexpr std::size_t kMostPlaces = 20'000; ///< places at which lines begin, end or cross

/** Returns the corners of a closed line, each once. */
std::vector<Point> tidied(std::span<const Point> ring_m)
{
    std::vector<Point> corners_m;
    for (const Point& place_m : ring_m)
        if (corners_m.empty() || corners_m.back() != place_m)
            corners_m.push_back(place_m);
    while (corners_m.size() > 1 && corners_m.back() == corners_m.front())
        corners_m.pop_back();
    return corners_m;
}

/** Effect of removing one corner on a polygon that runs counter-clockwise. */
struct Removal
{
    double added_m2 = std::numeric_limits<double>::infinity();
    Point replacement_m = Point::Zero(); ///< replaces the corner and the next if both go
    bool ofTwo = false;
};

/** Removes corners one by one, always the one that adds the least area. */
class Thinning
{
public:
    explicit Thinning(std::vector<Point> corners_m)
        : m_corners_m(std::move(corners_m))
        , m_links(m_corners_m.size())
        , m_removals(m_corners_m.size())
    {
        const std::size_t count = m_corners_m.size();
        for (std::size_t i = 0; i < count; ++i)
            m_links[i] = {.before = (i + count - 1) % count, .next = (i + 1) % count};
        for (std::size_t i = 0; i < count; ++i)
            enter(i);
    }

    /** Returns the polygon with `limit` corners, or more if no further one can go. */
    std::vector<Point> take(std::size_t limit)
    {
        while (m_order.size() > limit && std::isfinite(m_order.begin()->first))
            removeLeast();
        std::vector<Point> kept_m;
        std::size_t at = m_order.begin()->second;
        for (std::size_t n = 0; n < m_order.size(); ++n, at = m_links[at].next)
            kept_m.push_back(m_corners_m[at]);
        return kept_m;
    }

private:
    struct Link
    {
        std::size_t before = 0;
        std::size_t next = 0;
    };

    /**
     * Returns the removal of a corner: one that bends inwards is dropped, and an edge is replaced
     * by the point where its neighbours meet outside.
     */
    [[nodiscard]] Removal removalAt(std::size_t i) const
    {
        const std::size_t after = m_links[i].next;
        const Point& corner_m = m_corners_m[i];
        const Point& next_m = m_corners_m[after];
        const Point in = corner_m - m_corners_m[m_links[i].before];
        const double bend = cross(in, next_m - corner_m);
        if (bend <= 0)
            return {.added_m2 = -bend / 2};
        const Point out = m_corners_m[m_links[after].next] - next_m;
        const double turn = cross(in, out);
        if (cross(next_m - corner_m, out) <= 0 || turn <= 0)
            return {};
        const Point meeting_m = corner_m + cross(next_m - corner_m, out) / turn * in;
        return {.added_m2 = std::abs(cross(meeting_m - corner_m, next_m - corner_m)) / 2,
                .replacement_m = meeting_m,
                .ofTwo = true};
    }

    void enter(std::size_t i)
    {
        m_removals[i] = removalAt(i);
        m_order.emplace(m_removals[i].added_m2, i);
    }

    void removeLeast()
    {
        const std::size_t least = m_order.begin()->second;
        const std::size_t gone = m_removals[least].ofTwo ? m_links[least].next : least;
        if (m_removals[least].ofTwo)
            m_corners_m[least] = m_removals[least].replacement_m;
        m_order.erase({m_removals[gone].added_m2, gone});
        const Link link = m_links[gone];
        m_links[link.before].next = link.next;
        m_links[link.next].before = link.before;
        std::size_t changed = m_links[m_links[link.before].before].before;
        for (int step = 0; step < 5; ++step, changed = m_links[changed].next) {
            m_order.erase({m_removals[changed].added_m2, changed});
            enter(changed);
        }
    }

    std::vector<Point> m_corners_m;
    std::vector<Link> m_links;
    std::vector<Removal> m_removals; ///< by corner
    std::set<std::pair<double, std::size_t>> m_order;
};

/** Lines of an outline cut where they meet: places, and the neighbours of each. */
class LineNet
{
public:
    explicit LineNet(std::span<const Point> ring_m)
    {
        for (std::size_t i = 0; i < ring_m.size() && !isTangled(); ++i)
            addEdge(ring_m, i);
    }

    /** Returns true if the lines cross so often that some were left out. */
    [[nodiscard]] bool isTangled() const { return m_places_m.size() > kMostPlaces; }
    [[nodiscard]] const std::vector<Point>& places_m() const { return m_places_m; }

    /** Walks counter-clockwise round the outside; lines with nothing beside them appear twice. */
    [[nodiscard]] std::vector<std::size_t> outerWalk() const
    {
        const auto first = std::ranges::min_element(m_places_m, [](const Point& a, const Point& b) {
            return a.y() < b.y() || (a.y() == b.y() && a.x() < b.x());
        });
        const auto start = static_cast<std::size_t>(first - m_places_m.begin());
        std::vector<std::size_t> walk;
        std::size_t at = start;
        const std::size_t begin = nextOf(start, Point(0, -1));
        std::size_t to = begin;
        const std::size_t most = 4 * m_edges + 4;
        do {
            walk.push_back(at);
            const std::size_t after = nextOf(to, m_places_m[at] - m_places_m[to]);
            at = to;
            to = after;
        } while ((at != start || to != begin) && walk.size() < most);
        return walk.size() < most ? walk : std::vector<std::size_t>();
    }

private:
    /** Returns the number of a place; places within a centimetre share it. */
    std::size_t numberOf(const Point& place_m)
    {
        const std::pair key(std::llround(place_m.x() / kClose_m),
                            std::llround(place_m.y() / kClose_m));
        const auto [it, isNew] = m_numbers.emplace(key, m_places_m.size());
        if (isNew) {
            m_places_m.emplace_back(static_cast<double>(key.first) * kClose_m,
                                    static_cast<double>(key.second) * kClose_m);
            m_neighbours.emplace_back();
        }
        return it->second;
    }

    void addEdge(std::span<const Point> ring_m, std::size_t i)
    {
        const Point& from_m = ring_m[i];
        const Point along_m = ring_m[(i + 1) % ring_m.size()] - from_m;
        std::vector<double> cuts{0, 1};
        for (std::size_t other = 0; other < ring_m.size(); ++other)
            if (other != i)
                addCuts(cuts, from_m, along_m,
                        {ring_m[other], ring_m[(other + 1) % ring_m.size()]});
        std::ranges::sort(cuts);
        std::size_t before = numberOf(from_m);
        for (const double cut : cuts) {
            const std::size_t place = numberOf(from_m + cut * along_m);
            if (place == before)
                continue;
            link(before, place);
            link(place, before);
            before = place;
        }
    }

    /** Adds the positions, as shares of this line, at which another line meets it. */
    static void addCuts(std::vector<double>& cuts, const Point& from_m, const Point& along_m,
                        const std::pair<Point, Point>& other)
    {
        const Point& a = other.first;
        const Point& b = other.second;
        const Point to_m = from_m + along_m;
        if (std::max(a.x(), b.x()) < std::min(from_m.x(), to_m.x()) - kClose_m ||
            std::min(a.x(), b.x()) > std::max(from_m.x(), to_m.x()) + kClose_m ||
            std::max(a.y(), b.y()) < std::min(from_m.y(), to_m.y()) - kClose_m ||
            std::min(a.y(), b.y()) > std::max(from_m.y(), to_m.y()) + kClose_m)
            return;
        for (const Point& end_m : {a, b})
            if (distanceToSegment(from_m, to_m, end_m) < kClose_m)
                cuts.push_back(
                    std::clamp((end_m - from_m).dot(along_m) / along_m.squaredNorm(), 0.0, 1.0));
        const double turn = cross(along_m, b - a);
        if (turn == 0)
            return;
        const double here = cross(a - from_m, b - a) / turn;
        const double there = cross(a - from_m, along_m) / turn;
        if (here > 0 && here < 1 && there > 0 && there < 1)
            cuts.push_back(here);
    }

    void link(std::size_t from, std::size_t to)
    {
        std::vector<std::size_t>& known = m_neighbours[from];
        if (std::ranges::find(known, to) != known.end())
            return;
        known.push_back(to);
        ++m_edges;
    }

    /** Returns the neighbour first met when turning counter-clockwise from `back`. */
    [[nodiscard]] std::size_t nextOf(std::size_t place, const Point& back) const
    {
        std::size_t best = place;
        double least_rad = std::numeric_limits<double>::infinity();
        for (const std::size_t neighbour : m_neighbours[place]) {
            const Point out = m_places_m[neighbour] - m_places_m[place];
            double turn_rad = std::atan2(cross(back, out), back.dot(out));
            if (turn_rad <= 1e-12) // going back is the last choice
                turn_rad += 2 * kPi;
            if (turn_rad < least_rad) {
                least_rad = turn_rad;
                best = neighbour;
            }
        }
        return best;
    }

    std::map<std::pair<long long, long long>, std::size_t> m_numbers;
    std::vector<Point> m_places_m;
    std::vector<std::vector<std::size_t>> m_neighbours;
    std::size_t m_edges = 0;
};

/** Removes lines that are walked there and back. */
std::vector<std::size_t> withoutSpikes(const std::vector<std::size_t>& walk)
{
    std::vector<std::size_t> kept;
    for (const std::size_t place : walk) {
        if (kept.size() > 1 && kept[kept.size() - 2] == place)
            kept.pop_back();
        else
            kept.push_back(place);
    }
    std::size_t begin = 0;
    while (kept.size() - begin > 2 && kept[begin + 1] == kept.back()) {
        ++begin;
        kept.pop_back();
    }
    kept.erase(kept.begin(), kept.begin() + static_cast<std::ptrdiff_t>(begin));
    return kept;
}

/** Separates places that the walk passes more than once by moving them outwards. */
std::vector<Point> withPassages(const std::vector<std::size_t>& walk,
                                const std::vector<Point>& places_m)
{
    std::map<std::size_t, int> visits;
    for (const std::size_t place : walk)
        ++visits[place];
    std::vector<Point> outline_m;
    const std::size_t count = walk.size();
    for (std::size_t i = 0; i < count; ++i) {
        const Point& here_m = places_m[walk[i]];
        if (visits[walk[i]] == 1) {
            outline_m.push_back(here_m);
            continue;
        }
        const Point in = (here_m - places_m[walk[(i + count - 1) % count]]).normalized();
        const Point out = (places_m[walk[(i + 1) % count]] - here_m).normalized();
        if (cross(in, out) < 0) {
            outline_m.emplace_back(here_m + kPassage_m * (out - in).normalized());
            continue;
        }
        outline_m.emplace_back(here_m + kPassage_m * Point(in.y(), -in.x()));
        if (cross(in, out) > 0)
            outline_m.emplace_back(here_m + kPassage_m * Point(out.y(), -out.x()));
    }
    return outline_m;
}

bool covers(std::span<const Point> outline_m, std::span<const Point> ring_m)
{
    const auto isIn = [&](const Point& place_m) {
        return insidePolygon(outline_m, place_m) ||
               distanceToEdges(outline_m, place_m) <= 2 * kClose_m;
    };
    for (std::size_t i = 0; i < ring_m.size(); ++i)
        for (const double part : {0.0, 0.25, 0.5, 0.75})
            if (!isIn(ring_m[i] + part * (ring_m[(i + 1) % ring_m.size()] - ring_m[i])))
                return false;
    return true;
}

/** Returns an outline round a line that touches or crosses itself. */
std::vector<Point> repaired(const std::vector<Point>& ring_m)
{
    if (ring_m.size() > kMostCrossing)
        return convexHull(ring_m);
    const LineNet net(ring_m);
    const std::vector<std::size_t> walk =
        net.isTangled() ? std::vector<std::size_t>() : withoutSpikes(net.outerWalk());
    if (walk.size() < 3)
        return convexHull(ring_m);
    std::vector<Point> bare_m;
    for (const std::size_t place : walk)
        bare_m.push_back(net.places_m()[place]);
    std::vector<Point> outline_m = withPassages(walk, net.places_m());
    if (isSimplePolygon(bare_m) && signedArea(bare_m) > 0)
        return bare_m;
    if (isSimplePolygon(outline_m) && signedArea(outline_m) > 0 && covers(outline_m, bare_m))
        return outline_m;
    return convexHull(ring_m);
}

} // namespace

std::optional<CoveringOutline> coveringOutline(std::span<const Point> ring_m, std::size_t limit)
{
    CoveringOutline result{.corners_m = tidied(ring_m)};
    std::vector<Point>& corners_m = result.corners_m;
    if (corners_m.size() < 3 || std::abs(signedArea(convexHull(corners_m))) < kLeastArea_m2)
        return std::nullopt;
    if (signedArea(corners_m) < 0)
        std::ranges::reverse(corners_m);
    if (!isSimplePolygon(corners_m)) {
        result.wasCrossing = true;
        corners_m = repaired(corners_m);
    }
    if (corners_m.size() > limit) {
        result.wasThinned = true;
        const std::vector<Point> all_m = corners_m;
        corners_m = Thinning(std::move(corners_m)).take(limit);
        // Removals only add area, so a simple result covers everything.
        if (corners_m.size() > limit || !isSimplePolygon(corners_m))
            corners_m = convexHull(all_m);
    }
    if (corners_m.size() > limit) // no corner of a hull bends inwards
        corners_m = Thinning(std::move(corners_m)).take(limit);
    if (corners_m.size() < 3 || signedArea(corners_m) < kLeastArea_m2)
        return std::nullopt;
    return result;
}

} // namespace berg
