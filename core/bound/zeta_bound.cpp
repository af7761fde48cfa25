#include "core/bound/zeta_bound.h"

#include "core/bound/ground_time.h"
#include "core/bound/group_floor.h"
#include "core/bound/spread_groups.h"
#include "core/bound/stays_inside.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <span>

namespace berg {

namespace {

/** Icebergs of one dynamic programme: its work grows by a factor of 2.3 with each. */
constexpr int kMostTogether = 14;
/** So many groups are always that large. The first of them tell the mean age. */
constexpr std::size_t kFewGroups = 8;
/** Of more groups one pass takes this part of the work limit at most: they are smaller then. */
constexpr std::int64_t kPassesInLimit = 3;
constexpr std::size_t kMostAppearances = 16;
constexpr int kCoarsestCells = 8;
constexpr int kFinestCells = 128;
/** Cells for icebergs that move: more would be lost in how far they get in a window. */
constexpr int kCellsOfSlices = 16;
/** Motion below this share of the view's reach is not worth a window of its own. */
constexpr double kStandingSpread = 0.02;
/** How far back flights are looked at, and how long a slice is, over the mean age. */
constexpr double kLookBack = 2.5;
constexpr double kShortestSlice = 0.5;
/** Slices when nothing says how old sightings get: none there at the start, or all in view. */
constexpr int kSlicesOfNoAge = 16;
/** Off the result: more than rounding in the sums, here and in the simulation, can come to. */
constexpr double kRoundingShare = 1e-9;

class BoundSearch
{
public:
    BoundSearch(const Scenario& scenario, const BoundOptions& options)
        : m_scenario(scenario)
        , m_options(options)
        , m_motion(scenario, options.stop)
        , m_meter{.limit = options.workLimit, .stop = options.stop}
    {
        if (options.stop.stop_requested())
            return; // the motion is not complete
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
        // What is known of a velocity gets better with time: slices tell that apart, too.
        const bool moving = moves() || !m_sigmas.empty();
        // A first look at standing icebergs tells the mean age: of some groups, of all it would
        // take as long as a pass.
        if (moving && !look({{.from = 0, .begin = 0, .end = 1}}, kCoarsestCells, kFewGroups))
            return;
        for (int cells = kCoarsestCells; cells <= kCellsOfSlices; cells *= 2)
            if (!look(windows(1), cells))
                return;
        int slices = 1;
        while (moving && slices < finestSlices()) {
            slices = std::min(4 * slices, finestSlices());
            if (!look(windows(slices), kCellsOfSlices))
                return;
        }
        const int finestCells = moving ? kFinestCells / 2 : kFinestCells;
        for (int cells = 2 * kCellsOfSlices; cells <= finestCells; cells *= 2)
            if (!look(windows(slices), cells))
                return;
    }

    [[nodiscard]] ZetaBound result() const
    {
        ZetaBound bound{.work = m_meter.used, .cancelled = m_options.stop.stop_requested()};
        bound.curve.push_back({});
        std::vector<double> floors_m2;
        for (int block = 0; block < m_motion.blocks(); ++block) {
            double sigma_m2 = 0;
            for (const GroupFloor& floor : m_floors)
                sigma_m2 += floor.floor_m2()[static_cast<std::size_t>(block)];
            floors_m2.push_back(sigma_m2 * (1 - kRoundingShare));
        }
        const std::vector<double> ground_m2s = groundCosts_m2s(m_scenario, m_motion, floors_m2);
        double aloft_m2s = 0;
        for (int block = 0; block < m_motion.blocks(); ++block) {
            const auto k = static_cast<std::size_t>(block);
            aloft_m2s += floors_m2[k] * (m_motion.edge_s(block + 1) - m_motion.edge_s(block));
            bound.zeta_m2s = aloft_m2s + ground_m2s[k] * (1 - kRoundingShare);
            bound.curve.push_back({.time_s = m_motion.edge_s(block + 1),
                                   .sigma_m2 = floors_m2[k],
                                   .zeta_m2s = bound.zeta_m2s});
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
            for (const GroupFloor& floor : m_floors)
                work += floor.workOf(window, kCoarsestCells);
        return work;
    }

    [[nodiscard]] bool moves() const
    {
        return std::any_of(m_floors.begin(), m_floors.end(), [&](const GroupFloor& floor) {
            return floor.spread({.from = 0, .begin = 0, .end = m_motion.blocks()}) >
                   kStandingSpread;
        });
    }

    [[nodiscard]] double meanAge_s() const
    {
        double age_s = 0;
        for (const GroupFloor& floor : m_floors)
            age_s = std::max(age_s, floor.meanAge_s());
        return age_s;
    }

    /** So many that none is longer than is worth it. */
    [[nodiscard]] int finestSlices() const
    {
        const double shortest_s = kShortestSlice * meanAge_s();
        if (!(shortest_s > 0))
            return kSlicesOfNoAge;
        const double most = std::ceil(m_motion.edge_s(m_motion.blocks()) / shortest_s);
        return static_cast<int>(std::clamp(most, 1.0, static_cast<double>(m_motion.blocks())));
    }

    /** Edges of blocks from which on one iceberg more is there; not all when they are many. */
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

    /** The run in so many slices, cut also where icebergs appear; one slice looks back to the
     * start. */
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
                   m_motion.edge_s(begin) - m_motion.edge_s(from) > kLookBack * meanAge_s())
                ++from;
            result.push_back({.from = from, .begin = begin, .end = edges[i]});
        }
        return result;
    }

    /** False when the work is at its end. */
    bool look(const std::vector<BoundWindow>& windows, int cells,
              std::size_t groups = std::numeric_limits<std::size_t>::max())
    {
        for (BoundWindow window : windows) {
            window.age_s = m_sigmas.empty() ? 0 : meanAge_s();
            for (GroupFloor& floor : std::span(m_floors).first(std::min(groups, m_floors.size()))) {
                if (m_meter.used + floor.workOf(window, cells) > m_meter.limit)
                    return false; // what is cut would be wasted
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
    const BoundOptions& m_options;
    TrueMotion m_motion;
    std::vector<SigmaFloor> m_sigmas; ///< of measured icebergs
    WorkMeter m_meter;
    std::vector<GroupFloor> m_floors;
};

} // namespace

double ZetaBound::by_m2s(double time_s) const
{
    const auto after = std::ranges::upper_bound(curve, time_s, {}, &BoundPoint::time_s);
    return after == curve.begin() ? 0 : std::prev(after)->zeta_m2s;
}

ZetaBound zetaLowerBound(const Scenario& scenario, const BoundOptions& options)
{
    // Those that may leave the area may stop counting: what bounds the rest bounds them all.
    Scenario staying = scenario;
    std::erase_if(staying.icebergs, [&](const Iceberg& iceberg) {
        return !staysInside(scenario, iceberg, options.stop);
    });
    BoundSearch search(staying, options);
    search.run();
    return search.result();
}

} // namespace berg
