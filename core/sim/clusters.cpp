#include "core/sim/clusters.h"

#include "core/base/angles.h"
#include "core/geometry/enclosing_circle.h"
#include "core/sim/simulation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace berg {

namespace {

/** Standard deviations of a member's position that the view must have to spare. */
constexpr double kDeviations = 2;
/**
 * Ratio of a flown turn to the tightest one, because the autopilot reaches its turn rate gradually.
 */
constexpr double kTurnMargin = 1.2;

/** Largest radius over ground of a turn in the wind. */
double widestTurn_m(const Motion& motion)
{
    return kTurnMargin * (motion.airspeed_mps + motion.wind_mps.norm()) / motion.limit_radps;
}

/** Returns false for places inside the circles of tightest turn, which the UAV must leave first. */
bool canTurnOnto(const DubinsState& uav, const Motion& motion, const Point& place_m)
{
    const double radius_m = widestTurn_m(motion);
    const Point left(-std::sin(uav.psi_rad), std::cos(uav.psi_rad));
    return std::ranges::all_of(std::array{left, Point(-left)}, [&](const Point& side) {
        return (place_m - uav.position_m - radius_m * side).norm() >= radius_m;
    });
}

/** Returns true if the UAV can stay inside the fence on any course over the place. */
bool isFlownOver(const Geofence& fence, const Point& place_m)
{
    constexpr int kCourses = 16;
    for (int i = 0; i < kCourses; ++i)
        if (fence.turnClearance_m({.position_m = place_m, .psi_rad = 2 * kPi * i / kCourses}) < 0)
            return false;
    return true;
}

/** Unites single icebergs into clusters. */
class Grouping
{
public:
    Grouping(std::span<const Track> tracks, std::span<const ClusterRules> uavs)
        : m_tracks(tracks), m_uavs(uavs), m_time_s(uavs.front().time_s)
    {
        for (const ClusterRules& rules : uavs)
            m_widest_m = std::max(m_widest_m, rules.cover_m);
        for (int i = 0; i < static_cast<int>(tracks.size()); ++i) {
            m_groups.push_back({i});
            m_places_m.push_back(track(i).estimate_m(m_time_s));
        }
        for (std::size_t a = 0; a < m_groups.size(); ++a)
            for (std::size_t b = a + 1; b < m_groups.size(); ++b)
                offer(a, b);
    }

    [[nodiscard]] std::vector<std::vector<int>> grown()
    {
        while (!m_unions.empty())
            unite(std::ranges::min(m_unions));
        std::erase_if(m_groups, [](const std::vector<int>& group) { return group.size() < 2; });
        for (std::vector<int>& group : m_groups)
            std::ranges::sort(group);
        std::ranges::sort(m_groups);
        return std::move(m_groups);
    }

private:
    /** Two groups whose union is permitted. */
    struct Union
    {
        double radius_m = 0;
        std::size_t a = 0; ///< the smaller index
        std::size_t b = 0;
        auto operator<=>(const Union&) const = default; // NOLINT(modernize-use-nullptr)
    };

    void offer(std::size_t a, std::size_t b)
    {
        if ((m_places_m[a] - m_places_m[b]).norm() > 2 * m_widest_m)
            return;
        std::vector<int> members = m_groups[a];
        members.insert(members.end(), m_groups[b].begin(), m_groups[b].end());
        if (const std::optional<double> radius_m = radiusOf(members))
            m_unions.push_back({.radius_m = *radius_m, .a = std::min(a, b), .b = std::max(a, b)});
    }

    void unite(const Union& chosen)
    {
        std::vector<int>& into = m_groups[chosen.a];
        std::vector<int>& from = m_groups[chosen.b];
        into.insert(into.end(), from.begin(), from.end());
        from.clear();
        std::erase_if(m_unions, [&](const Union& other) {
            return other.a == chosen.a || other.a == chosen.b || other.b == chosen.a ||
                   other.b == chosen.b;
        });
        for (std::size_t other = 0; other < m_groups.size(); ++other)
            if (other != chosen.a && !m_groups[other].empty())
                offer(other, chosen.a);
    }

    /**
     * Returns the radius of the circle around the members, the largest over the UAVs, or nullopt if
     * they may not be a cluster.
     */
    [[nodiscard]] std::optional<double> radiusOf(const std::vector<int>& members) const
    {
        const Circle now = circleAt(members, m_time_s);
        std::optional<double> largest_m;
        for (const ClusterRules& rules : m_uavs) {
            if (!mayVisit(rules, members))
                continue;
            const std::optional<double> radius_m = radiusFor(rules, members, now);
            if (!radius_m)
                return std::nullopt;
            largest_m = std::max(largest_m.value_or(0), *radius_m);
        }
        return largest_m;
    }

    /**
     * Returns the larger radius of now and at this UAV's arrival, or nullopt if a rule forbids the
     * cluster.
     */
    [[nodiscard]] std::optional<double>
    radiusFor(const ClusterRules& rules, const std::vector<int>& members, const Circle& now) const
    {
        const Motion& motion = rules.motion;
        if (now.radius_m > rules.cover_m || !canTurnOnto(rules.uav, motion, now.centre_m) ||
            (rules.fence && !isFlownOver(*rules.fence, now.centre_m)))
            return std::nullopt;
        const double wait_s =
            longestTurn_s(motion) +
            flightTime_s(now.centre_m - rules.uav.position_m, motion.airspeed_mps, motion.wind_mps);
        double sigma_m2 = 0;
        for (const int i : members)
            sigma_m2 = std::max(sigma_m2, track(i).sigmaAfter_m2(wait_s));
        const double radius_m =
            std::max(now.radius_m, circleAt(members, m_time_s + wait_s).radius_m);
        const double spare_m = kDeviations * std::sqrt(sigma_m2) + kFlownOver_m;
        return radius_m + spare_m <= rules.cover_m ? std::optional(radius_m) : std::nullopt;
    }

    [[nodiscard]] Circle circleAt(const std::vector<int>& members, double time_s) const
    {
        return circleRound(members, [&](int i) { return track(i).estimate_m(time_s); });
    }

    [[nodiscard]] const Track& track(int i) const { return m_tracks[static_cast<std::size_t>(i)]; }

    std::span<const Track> m_tracks;
    std::span<const ClusterRules> m_uavs;
    double m_time_s;
    double m_widest_m = 0;
    std::vector<Point> m_places_m; ///< by track, now
    /** Each at the index of its first member; empty once united with another. */
    std::vector<std::vector<int>> m_groups;
    std::vector<Union> m_unions;
};

} // namespace

double longestTurn_s(const Motion& motion)
{
    return kTurnMargin * 2 * kPi / motion.limit_radps;
}

std::optional<int> thisSortie(const Simulation& simulation, int uav,
                              std::span<const IcebergIndex> order,
                              std::span<const IcebergList> clusters)
{
    std::optional<int> visits =
        thisSortie(simulation.fleet().autopilot(uav), order, simulation.observer());
    while (visits && *visits > 0 && *visits < static_cast<int>(order.size())) {
        const auto next = static_cast<std::size_t>(*visits);
        const std::span<const IcebergIndex> members = clusterWith(clusters, order[next - 1]);
        if (std::ranges::find(members, order[next]) == members.end())
            break;
        --*visits;
    }
    return visits;
}

bool mayVisit(const ClusterRules& rules, std::span<const int> members)
{
    return rules.visitable.empty() || std::ranges::all_of(members, [&](int i) {
               return rules.visitable[static_cast<std::size_t>(i)];
           });
}

std::vector<std::vector<int>> clustersOf(std::span<const Track> tracks,
                                         std::span<const ClusterRules> uavs)
{
    return Grouping(tracks, uavs).grown();
}

std::span<const IcebergIndex> clusterWith(std::span<const IcebergList> clusters,
                                          IcebergIndex iceberg)
{
    const auto found = std::ranges::find_if(clusters, [iceberg](const IcebergList& members) {
        return std::ranges::find(members, iceberg) != members.end();
    });
    return found == clusters.end() ? std::span<const IcebergIndex>()
                                   : std::span<const IcebergIndex>(*found);
}

} // namespace berg
