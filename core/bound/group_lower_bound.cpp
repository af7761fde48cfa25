#include "core/bound/group_lower_bound.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>

namespace berg {

namespace {

/** This exceeds the rounding of positions in a run. */
constexpr double kSlack_m = 1e-3;
/**
 * Above this share of the airspeed the wind's direction is not used: its speed alone bounds the
 * ground speed.
 */
constexpr double kStrongWind = 0.95;
/**
 * Multipliers for each second since the start, relative to the growth of all icebergs. They raise
 * the bound in the first minutes only, so they are used with coarse cells only.
 */
constexpr std::array kStartMultipliers{0.25, 0.5, 1.0, 2.0};
constexpr int kMostCellsPriced = 32;

std::span<const double> startMultipliers(int perRegion)
{
    return std::span(kStartMultipliers)
        .first(perRegion <= kMostCellsPriced ? kStartMultipliers.size() : 0);
}

/** Returns the work of the legs between all cells, in units of `chainCosts`. */
std::int64_t legWork(int icebergs, int perRegion)
{
    constexpr std::int64_t kOneLeg = 60;
    const std::int64_t cells = std::int64_t{icebergs} * perRegion;
    return kOneLeg * cells * cells;
}

/**
 * With several UAVs a window is cut into this number of parts, each with one call of `sharedOut`.
 */
constexpr int kPartsOfWindow = 20;

/** Returns the work of sharing out all sets of icebergs between UAVs once. */
std::int64_t shareWork(std::size_t icebergs, std::size_t uavs)
{
    constexpr std::int64_t kOneShare = 3;
    std::int64_t shares = kOneShare * static_cast<std::int64_t>(uavs - 1);
    for (std::size_t i = 0; i < icebergs; ++i)
        shares *= 3; // Each iceberg belongs to one UAV, to the others or to no set.
    return shares;
}

/**
 * Returns, for each set, the least sum of costs over all partitions of the set between two UAVs.
 */
std::vector<double> sharedOut(const std::vector<double>& a, const std::vector<double>& b)
{
    std::vector<double> least(a.size());
    for (std::size_t set = 0; set < a.size(); ++set) {
        double best = a[set] + b[0];
        for (std::size_t part = set; part != 0;) {
            part = (part - 1) & set;
            best = std::min(best, a[part] + b[set ^ part]);
        }
        least[set] = best;
    }
    return least;
}

/** Returns whether both UAVs have the same edges and legs. */
bool isAlike(const Uav& a, const Uav& b)
{
    return a.spec.airspeed_mps == b.spec.airspeed_mps && a.fov_m == b.fov_m;
}

/** Returns the number of UAVs that differ from the one before, the first one included. */
std::int64_t kindsOf(const std::vector<Uav>& uavs)
{
    std::int64_t kinds = 1;
    for (std::size_t u = 1; u < uavs.size(); ++u)
        kinds += isAlike(uavs[u - 1], uavs[u]) ? 0 : 1;
    return kinds;
}

Travel travelIn(const Scenario& scenario, const Uav& uav, const Point& velocity_mps)
{
    const double airspeed_mps = uav.spec.airspeed_mps;
    const Point wind_mps = scenario.wind_mps - velocity_mps;
    if (wind_mps.norm() <= kStrongWind * airspeed_mps)
        return {.airspeed_mps = airspeed_mps, .wind_mps = wind_mps};
    return {.airspeed_mps = airspeed_mps + wind_mps.norm()};
}

} // namespace

GroupLowerBound::GroupLowerBound(const Scenario& scenario, const TrueMotion& motion,
                                 const std::vector<SigmaFloor>& floors, std::vector<int> icebergs)
    : m_scenario(scenario)
    , m_motion(motion)
    , m_floors(floors)
    , m_icebergs(std::move(icebergs))
    , m_floor_m2(static_cast<std::size_t>(motion.blocks()), 0.0)
{
}

std::vector<int> GroupLowerBound::present(const BoundWindow& window) const
{
    std::vector<int> result;
    for (const int i : m_icebergs)
        if (std::llround(m_scenario.icebergs[static_cast<std::size_t>(i)].appears_s /
                         m_scenario.dt_s) <= m_motion.edgeStep(window.begin) + 1)
            result.push_back(i);
    return result;
}

Point GroupLowerBound::meanVelocity_mps(const std::vector<int>& icebergs,
                                        const BoundWindow& window) const
{
    Point sum_m = Point::Zero();
    for (const int i : icebergs)
        sum_m += m_motion.position_m(i, window.end) - m_motion.position_m(i, window.from);
    return sum_m / (static_cast<double>(icebergs.size()) *
                    (m_motion.edge_s(window.end) - m_motion.edge_s(window.from)));
}

double GroupLowerBound::spread(const BoundWindow& window) const
{
    const std::vector<int> icebergs = present(window);
    if (icebergs.empty())
        return 0;
    const Point velocity_mps = meanVelocity_mps(icebergs, window);
    double radius_m = 0;
    for (const int i : icebergs)
        radius_m += m_motion.enclosure(i, window.from, window.end, velocity_mps).radius_m;
    return radius_m / static_cast<double>(icebergs.size()) /
           region({}, m_scenario.uavs.at(0)).half_m.norm();
}

ViewRegion GroupLowerBound::region(const Circle& enclosure, const Uav& uav) const
{
    ViewRegion result{.centre_m = enclosure.centre_m,
                      .disk = m_scenario.fovShape != FovShape::North};
    if (result.disk) // The disk holds the view at any heading.
        result.half_m.setConstant(
            FieldOfView::reach_m({.fov_m = uav.fov_m, .shape = m_scenario.fovShape}));
    else // The first extent of the view points north.
        result.half_m = Point(uav.fov_m.y(), uav.fov_m.x()) / 2;
    result.half_m.array() += enclosure.radius_m + kSlack_m;
    return result;
}

double GroupLowerBound::growth_m2ps(int iceberg) const
{
    return m_scenario.icebergs[static_cast<std::size_t>(iceberg)].q_m2ps;
}

std::int64_t GroupLowerBound::workOf(const BoundWindow& window, int perRegion) const
{
    const int icebergs = static_cast<int>(present(window).size());
    if (icebergs == 0)
        return 0;
    const std::vector<Uav>& uavs = m_scenario.uavs;
    const auto sets = std::int64_t{1} << icebergs;
    const auto fromStarts =
        window.from == 0
            ? static_cast<std::int64_t>(uavs.size() * (1 + startMultipliers(perRegion).size()))
            : 0;
    const std::int64_t parts =
        // One more call finds the mean age.
        (window.end - window.begin - 1) / blocksPerPart(window) + 2;
    return kindsOf(uavs) * legWork(icebergs, perRegion) + (window.end - window.begin) * sets +
           (kindsOf(uavs) + fromStarts) * chainWork(icebergs, perRegion) +
           parts * shareWork(static_cast<std::size_t>(icebergs), uavs.size());
}

void GroupLowerBound::raise(const BoundWindow& window, int perRegion, WorkMeter& meter)
{
    const std::vector<int> icebergs = present(window);
    if (icebergs.empty())
        return;
    const std::vector<FloorLine> lines = linesOf(icebergs, window);
    const std::optional<std::vector<Chains>> chains =
        chainsOf(icebergs, lines, window, perRegion, meter);
    if (!chains)
        return;
    double growth = 0;
    for (const FloorLine& line : lines)
        growth += line.slope_m2ps;
    if (growth > 0) {
        const std::vector<double> cost_m2 = sharedOut(*chains, std::nullopt, meter);
        m_meanAge_s = std::max(m_meanAge_s, cost_m2.back() / growth);
    }
    raiseBlocks(window, icebergs, lines, *chains, meter);
}

std::vector<FloorLine> GroupLowerBound::linesOf(const std::vector<int>& icebergs,
                                                const BoundWindow& window) const
{
    std::vector<FloorLine> lines;
    const double most_s = m_motion.edge_s(window.end) - m_motion.edge_s(window.from);
    for (const int i : icebergs) {
        FloorLine& line = lines.emplace_back(FloorLine{.slope_m2ps = growth_m2ps(i)});
        if (m_floors.empty())
            continue;
        const SigmaFloor& floor = m_floors[static_cast<std::size_t>(i)];
        line = floor.lineAt(floor.least(window.from, window.end), window.age_s, most_s);
    }
    return lines;
}

std::optional<std::vector<GroupLowerBound::Chains>>
GroupLowerBound::chainsOf(const std::vector<int>& icebergs, const std::vector<FloorLine>& lines,
                          const BoundWindow& window, int perRegion, WorkMeter& meter) const
{
    const Point velocity_mps = meanVelocity_mps(icebergs, window);
    std::vector<ViewRegion> regions;
    StageCost price;
    for (const FloorLine& line : lines)
        price.perSeen.push_back(line.slope_m2ps);
    std::optional<ViewCells> cells;
    std::vector<Chains> all;
    for (const Uav& uav : m_scenario.uavs) {
        Chains chains;
        if (!all.empty() && isAlike(uav, m_scenario.uavs[all.size() - 1])) {
            chains.priced.push_back(all.back().priced.front());
        } else {
            regions.clear();
            for (const int i : icebergs)
                regions.push_back(
                    region(m_motion.enclosure(i, window.from, window.end, velocity_mps), uav));
            if (!meter.spend(legWork(static_cast<int>(icebergs.size()), perRegion)))
                return std::nullopt;
            cells.emplace(regions, perRegion, travelIn(m_scenario, uav, velocity_mps), meter.stop);
            if (!meter.continues())
                return std::nullopt;
            chains.priced.push_back({.cost_m2 = chainCosts(*cells, price, {}, meter)});
        }
        if (window.from == 0)
            reachFromStart(chains, *cells, uav.position_m, price, meter);
        if (!meter.continues())
            return std::nullopt;
        if (window.from == 0)
            seeAtStart(chains, regions, uav.position_m);
        all.push_back(std::move(chains));
    }
    return all;
}

void GroupLowerBound::reachFromStart(Chains& chains, const ViewCells& cells, const Point& start_m,
                                     StageCost price, WorkMeter& meter)
{
    const std::vector<float> fromStart_s = cells.legsFrom_s(start_m);
    const StageCost time{.perSeen = std::vector<double>(price.perSeen.size(), 0.0), .always = 1};
    chains.soonest_s = chainCosts(cells, time, fromStart_s, meter);
    const double growth = std::accumulate(price.perSeen.begin(), price.perSeen.end(), 0.0);
    for (const double share : startMultipliers(cells.perRegion())) {
        price.always = share * growth;
        chains.priced.push_back(
            {.perSecond = price.always, .cost_m2 = chainCosts(cells, price, fromStart_s, meter)});
    }
}

void GroupLowerBound::seeAtStart(Chains& chains, const std::vector<ViewRegion>& regions,
                                 const Point& start_m)
{
    std::size_t seen = 0;
    for (std::size_t i = 0; i < regions.size(); ++i)
        if (regions[i].contains(start_m))
            seen |= std::size_t{1} << i;
    for (std::size_t part = seen; part != 0; part = (part - 1) & seen) {
        chains.soonest_s[part] = 0;
        for (WeightedChains& priced : chains.priced)
            priced.cost_m2[part] = 0;
    }
}

std::vector<double> GroupLowerBound::seenBy(const Chains& chains, std::optional<double> time_s)
{
    std::vector<double> cost_m2 = chains.priced.front().cost_m2;
    if (!time_s)
        return cost_m2;
    for (std::size_t set = 1; set < cost_m2.size(); ++set) {
        if (!chains.soonest_s.empty() && chains.soonest_s[set] > *time_s) {
            cost_m2[set] = std::numeric_limits<double>::infinity();
            continue;
        }
        double seen_m2 = 0;
        for (const WeightedChains& priced : chains.priced)
            seen_m2 = std::max(seen_m2, priced.cost_m2[set] - priced.perSecond * *time_s);
        cost_m2[set] = seen_m2;
    }
    return cost_m2;
}

std::vector<double> GroupLowerBound::sharedOut(const std::vector<Chains>& chains,
                                               std::optional<double> time_s, WorkMeter& meter)
{
    std::vector<double> all_m2 = seenBy(chains.front(), time_s);
    if (!meter.spend(
            shareWork(static_cast<std::size_t>(std::countr_zero(all_m2.size())), chains.size())))
        return all_m2;
    for (std::size_t u = 1; u < chains.size(); ++u)
        all_m2 = berg::sharedOut(all_m2, seenBy(chains[u], time_s));
    return all_m2;
}

std::vector<GroupLowerBound::Unseen> GroupLowerBound::unseenSets(const std::vector<int>& icebergs,
                                                                 bool sinceStart) const
{
    std::vector<Unseen> unseen(std::size_t{1} << icebergs.size());
    for (std::size_t set = 0; set < unseen.size(); ++set)
        for (std::size_t i = 0; i < icebergs.size(); ++i) {
            if ((set >> i & 1U) != 0)
                continue;
            // In a later window the icebergs were last seen at its beginning, at best.
            if (sinceStart)
                unseen[set].base_m2 +=
                    initialSigma_m2(m_scenario.icebergs[static_cast<std::size_t>(icebergs[i])]);
            unseen[set].rate_m2ps += growth_m2ps(icebergs[i]);
        }
    return unseen;
}

int GroupLowerBound::blocksPerPart(const BoundWindow& window) const
{
    const int blocks = window.end - window.begin;
    if (window.from > 0)
        return blocks; // The start does not matter, so the time does not either.
    return m_scenario.uavs.size() == 1 ? 1 : (blocks - 1) / kPartsOfWindow + 1;
}

void GroupLowerBound::addOthers(std::vector<double>& cost_m2, const std::vector<int>& icebergs,
                                const std::vector<FloorLine>& lines, const BoundWindow& window,
                                double first_s) const
{
    const std::size_t sets = cost_m2.size();
    std::vector<double> unseen_m2(sets, 0.0); // The index is the set of the other icebergs.
    std::vector<double> offset_m2(sets, 0.0);
    std::vector<double> least_m2(sets, 0.0);
    for (std::size_t set = 1; set < sets; ++set) {
        const auto i = static_cast<std::size_t>(std::countr_zero(set));
        const std::size_t rest = set & (set - 1);
        const SigmaFloor& floor = m_floors[static_cast<std::size_t>(icebergs[i])];
        if (rest == 0) {
            unseen_m2[set] = window.from == 0 ? floor.unseen_m2(first_s)
                                              : floor.seen_m2(lines[i].least, first_s);
            offset_m2[set] = lines[i].offset_m2;
            least_m2[set] = lines[i].least.position_m2;
            continue;
        }
        const std::size_t one = set ^ rest;
        unseen_m2[set] = unseen_m2[rest] + unseen_m2[one];
        offset_m2[set] = offset_m2[rest] + offset_m2[one];
        least_m2[set] = least_m2[rest] + least_m2[one];
    }
    for (std::size_t set = 0; set < sets; ++set)
        cost_m2[set] =
            std::max(cost_m2[set] - offset_m2[set], least_m2[set]) + unseen_m2[sets - 1 - set];
}

void GroupLowerBound::raiseBlocks(const BoundWindow& window, const std::vector<int>& icebergs,
                                  const std::vector<FloorLine>& lines,
                                  const std::vector<Chains>& chains, WorkMeter& meter)
{
    const std::vector<Unseen> unseen = unseenSets(icebergs, window.from == 0);
    const double from_s = m_motion.edge_s(window.from);
    const int perPart = blocksPerPart(window);
    std::vector<double> seen_m2;
    for (int block = window.begin; block < window.end; ++block) {
        if (!meter.spend(static_cast<std::int64_t>(unseen.size())))
            return;
        if ((block - window.begin) % perPart == 0) {
            // Chains get no costlier with time, so those of the last block hold for all before it.
            const int last = std::min(block + perPart, window.end);
            seen_m2 = sharedOut(chains, m_motion.edge_s(last) - from_s, meter);
            if (!meter.continues())
                return;
        }
        // This is the first step of the block.
        const double first_s = m_motion.edge_s(block) + m_scenario.dt_s - from_s;
        double least_m2 = unseen.front().base_m2 + unseen.front().rate_m2ps * first_s;
        if (m_floors.empty()) {
            for (std::size_t set = 1; set < unseen.size(); ++set)
                least_m2 = std::min(least_m2, seen_m2[set] + unseen[set].base_m2 +
                                                  unseen[set].rate_m2ps * first_s);
        } else {
            std::vector<double> cost_m2 = seen_m2;
            cost_m2.front() = 0;
            addOthers(cost_m2, icebergs, lines, window, first_s);
            least_m2 = *std::ranges::min_element(cost_m2);
        }
        double& floor_m2 = m_floor_m2[static_cast<std::size_t>(block)];
        floor_m2 = std::max(floor_m2, least_m2);
    }
}

} // namespace berg
