#include "core/bound/zeta_bound.h"

#include "core/bound/frequency_bound.h"
#include "core/bound/ground_time.h"
#include "core/bound/group_lower_bound.h"
#include "core/bound/remains_in_area.h"
#include "core/bound/spread_groups.h"
#include "core/scenario/flight_weather.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <span>

namespace berg {

namespace {

/**
 * Largest number of icebergs in one dynamic programme, whose work grows by a factor of 2.3 with
 * each.
 */
constexpr int kMostTogether = 14;
/** Up to this number of groups, groups have the largest size. The first ones give the mean age. */
constexpr std::size_t kFewGroups = 8;
/**
 * With more groups one pass takes this part of the work limit at most, so the groups are smaller.
 */
constexpr std::int64_t kPassesInLimit = 3;
constexpr std::size_t kMostAppearances = 16;
constexpr int kCoarsestCells = 8;
constexpr int kFinestCells = 128;
/**
 * Number of cells for icebergs that move; the motion within a window outweighs the gain of more.
 */
constexpr int kCellsOfSlices = 16;
/** Motion below this share of the view's reach is not worth a window of its own. */
constexpr double kStandingSpread = 0.02;
/** How far back flights are considered, and the length of the shortest slice, over the mean age. */
constexpr double kMostBack = 2.5;
constexpr double kShortestSlice = 0.5;
/**
 * Number of slices if the mean age is 0, because no iceberg is there at the start or all are in
 * view.
 */
constexpr int kSlicesOfNoAge = 16;
/** With a smaller work limit `frequencyBound` is left out. */
constexpr std::int64_t kLeastForFrequencies = 1'000'000;
/**
 * The result is reduced by this share, which exceeds the rounding of the sums here and in the
 * simulation.
 */
constexpr double kRoundingShare = 1e-9;

class BoundSearch
{
public:
    /** The icebergs move as in `truth`, which differs from the scenario in wind and airspeeds. */
    BoundSearch(const Scenario& scenario, const Scenario& truth, const ZetaBoundOptions& options)
        : m_scenario(scenario)
        , m_options(options)
        , m_motion(truth, options.stop)
        , m_meter{.limit = options.workLimit, .stop = options.stop}
    {
        if (options.stop.stop_requested())
            return; // The motion is incomplete.
        if (scenario.observer.model != ObserverModel::Simple)
            for (const Iceberg& iceberg : scenario.icebergs)
                m_sigmas.emplace_back(scenario, iceberg, m_motion);
        std::vector<Point> middles_m;
        for (int i = 0; i < static_cast<int>(scenario.icebergs.size()); ++i)
            middles_m.push_back(
                (m_motion.position_m(i, 0) + m_motion.position_m(i, m_motion.blocks())) / 2);
        formGroups(middles_m, kMostTogether);
        for (int most = kMostTogether - 1; most > 0 && m_floors.size() > kFewGroups &&
                                           workOfPass() > m_meter.limit / kPassesInLimit;
             --most)
            formGroups(middles_m, most);
    }

    void run()
    {
        if (m_options.workLimit >= kLeastForFrequencies && m_meter.continues())
            m_frequency = frequencyBound(m_scenario, m_motion, m_options.stop);
        // Measured velocities get better known with time, which slices take into account.
        const bool moving = moves() || !m_sigmas.empty();
        // A first bound on standing icebergs gives the mean age. It uses some groups, because all
        // of them would take as long as a pass.
        if (moving && !raiseAll({{.from = 0, .begin = 0, .end = 1}}, kCoarsestCells, kFewGroups))
            return;
        for (int cells = kCoarsestCells; cells <= kCellsOfSlices; cells *= 2)
            if (!raiseAll(windows(1), cells))
                return;
        int slices = 1;
        while (moving && slices < finestSlices()) {
            slices = std::min(4 * slices, finestSlices());
            if (!raiseAll(windows(slices), kCellsOfSlices))
                return;
        }
        const int finestCells = moving ? kFinestCells / 2 : kFinestCells;
        for (int cells = 2 * kCellsOfSlices; cells <= finestCells; cells *= 2)
            if (!raiseAll(windows(slices), cells))
                return;
    }

    [[nodiscard]] ZetaBound result() const
    {
        ZetaBound bound{.work = m_meter.used, .cancelled = m_options.stop.stop_requested()};
        bound.curve.push_back({});
        std::vector<double> floors_m2;
        for (int block = 0; block < m_motion.blocks(); ++block) {
            double sigma_m2 = 0;
            for (const GroupLowerBound& floor : m_floors)
                sigma_m2 += floor.floor_m2()[static_cast<std::size_t>(block)];
            floors_m2.push_back(sigma_m2 * (1 - kRoundingShare));
        }
        const std::vector<double> ground_m2s = groundCosts_m2s(m_scenario, m_motion, floors_m2);
        if (m_frequency)
            bound.frequency_m2s = m_frequency->zeta_m2s.back();
        double aloft_m2s = 0;
        bool isFromRates = false;
        for (int block = 0; block < m_motion.blocks(); ++block) {
            const auto k = static_cast<std::size_t>(block);
            const double length_s = m_motion.edge_s(block + 1) - m_motion.edge_s(block);
            aloft_m2s += floors_m2[k] * length_s;
            const double atHome_m2s = aloft_m2s + ground_m2s[k] * (1 - kRoundingShare);
            bound.zeta_m2s += floors_m2[k] * length_s * (1 - kRoundingShare);
            isFromRates = isFromRates && bound.zeta_m2s >= atHome_m2s;
            bound.zeta_m2s = std::max(bound.zeta_m2s, atHome_m2s);
            const double time_s = m_motion.edge_s(block + 1);
            const double rates_m2s = m_frequency ? m_frequency->by_m2s(time_s) : 0;
            isFromRates = isFromRates || rates_m2s > bound.zeta_m2s;
            bound.zeta_m2s = std::max(bound.zeta_m2s, rates_m2s);
            bound.curve.push_back({.time_s = time_s,
                                   .sigma_m2 = floors_m2[k],
                                   .zeta_m2s = bound.zeta_m2s,
                                   .isFromRates = isFromRates});
        }
        return bound;
    }

private:
    void formGroups(const std::vector<Point>& middles_m, int most)
    {
        m_floors.clear();
        for (std::vector<int>& group : spreadGroups(middles_m, most))
            m_floors.emplace_back(m_scenario, m_motion, m_sigmas, std::move(group));
    }

    [[nodiscard]] std::int64_t workOfPass() const
    {
        std::int64_t work = 0;
        for (const BoundWindow& window : windows(1))
            for (const GroupLowerBound& floor : m_floors)
                work += floor.workOf(window, kCoarsestCells);
        return work;
    }

    [[nodiscard]] bool moves() const
    {
        return std::any_of(m_floors.begin(), m_floors.end(), [&](const GroupLowerBound& floor) {
            return floor.spread({.from = 0, .begin = 0, .end = m_motion.blocks()}) >
                   kStandingSpread;
        });
    }

    [[nodiscard]] double meanAge_s() const
    {
        double age_s = 0;
        for (const GroupLowerBound& floor : m_floors)
            age_s = std::max(age_s, floor.meanAge_s());
        return age_s;
    }

    /** Returns the number of slices of the shortest useful length. */
    [[nodiscard]] int finestSlices() const
    {
        const double shortest_s = kShortestSlice * meanAge_s();
        if (!(shortest_s > 0))
            return kSlicesOfNoAge;
        const double most = std::ceil(m_motion.edge_s(m_motion.blocks()) / shortest_s);
        return static_cast<int>(std::clamp(most, 1.0, static_cast<double>(m_motion.blocks())));
    }

    /** Returns the edges of blocks at which icebergs appear, thinned out if there are many. */
    [[nodiscard]] std::vector<int> appearances() const
    {
        std::vector<int> edges;
        for (const Iceberg& iceberg : m_scenario.icebergs) {
            const std::int64_t step = std::llround(iceberg.appears_s / m_scenario.dt_s);
            int edge = 0;
            while (edge < m_motion.blocks() && m_motion.edgeStep(edge) + 1 < step)
                ++edge;
            edges.push_back(edge);
        }
        std::sort(edges.begin(), edges.end());
        edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
        std::vector<int> chosen;
        const std::size_t stride = edges.size() / kMostAppearances + 1;
        for (std::size_t i = stride - 1; i < edges.size(); i += stride)
            chosen.push_back(edges[i]);
        return chosen;
    }

    /**
     * Returns the windows of a run in this number of slices, cut also where icebergs appear. One
     * slice considers flights from the start on.
     */
    [[nodiscard]] std::vector<BoundWindow> windows(int slices) const
    {
        std::vector<int> edges = appearances();
        for (int i = 0; i <= slices; ++i)
            edges.push_back(static_cast<int>(std::int64_t{m_motion.blocks()} * i / slices));
        std::sort(edges.begin(), edges.end());
        edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
        std::vector<BoundWindow> result;
        int from = 0;
        for (std::size_t i = 1; i < edges.size(); ++i) {
            const int begin = edges[i - 1];
            while (slices > 1 &&
                   m_motion.edge_s(begin) - m_motion.edge_s(from) > kMostBack * meanAge_s())
                ++from;
            result.push_back({.from = from, .begin = begin, .end = edges[i]});
        }
        return result;
    }

    /**
     * Raises the bounds of the first `groups` groups in all windows. Returns false if the work
     * limit or a stop ends it.
     */
    bool raiseAll(const std::vector<BoundWindow>& windows, int cells,
                  std::size_t groups = std::numeric_limits<std::size_t>::max())
    {
        for (BoundWindow window : windows) {
            window.age_s = m_sigmas.empty() ? 0 : meanAge_s();
            for (GroupLowerBound& floor :
                 std::span(m_floors).first(std::min(groups, m_floors.size()))) {
                if (m_meter.used + floor.workOf(window, cells) > m_meter.limit)
                    return false; // An interrupted call would waste its work.
                floor.raise(window, cells, m_meter);
                if (!m_meter.continues())
                    return false;
                report();
            }
        }
        return true;
    }

    void report() const
    {
        if (m_options.onProgress)
            m_options.onProgress(
                {.zeta_m2s = result().zeta_m2s,
                 .share = static_cast<double>(m_meter.used) / static_cast<double>(m_meter.limit)});
    }

    const Scenario& m_scenario;
    const ZetaBoundOptions& m_options;
    TrueMotion m_motion;
    std::optional<FrequencyBound> m_frequency;
    /** The floors of measured icebergs; the vector is empty in the simple model. */
    std::vector<SigmaFloor> m_sigmas;
    WorkMeter m_meter;
    std::vector<GroupLowerBound> m_floors;
};

/**
 * Returns a scenario without a forecast that permits every flight of this one: in a wind that
 * changes, no UAV is faster over ground than its airspeed and the strongest wind together.
 */
Scenario withoutForecast(const Scenario& scenario)
{
    const std::shared_ptr<const FlightWeather> weather = weatherOf(scenario);
    if (!weather)
        return scenario;
    Scenario fastest = scenario;
    fastest.forecast.reset();
    const bool isConstant = weather->wind()->wind_mps.size() == 1;
    fastest.wind_mps = isConstant ? weather->wind()->wind_mps.front() : Point(Point::Zero());
    if (!isConstant)
        for (Uav& uav : fastest.uavs)
            uav.spec.airspeed_mps += weather->strongestWind_mps();
    return fastest;
}

} // namespace

BoundPoint ZetaBound::by(double time_s) const
{
    const auto after = std::ranges::upper_bound(curve, time_s, {}, &BoundPoint::time_s);
    return after == curve.begin() ? BoundPoint() : *std::prev(after);
}

ZetaBound zetaLowerBound(const Scenario& scenario, const ZetaBoundOptions& options)
{
    // Icebergs that may leave the area may stop counting; a bound for the others is a bound for
    // all.
    Scenario staying = scenario;
    std::erase_if(staying.icebergs, [&](const Iceberg& iceberg) {
        return !remainsInArea(scenario, iceberg, options.stop);
    });
    const Scenario fastest = withoutForecast(staying);
    BoundSearch search(fastest, staying, options);
    search.run();
    return search.result();
}

} // namespace berg
