#include "core/plan/layered_bound.h"

#include "core/plan/graph_search.h"
#include "core/plan/layered_graph.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <numeric>

namespace berg {

namespace {

/** Relative margin of every cut and of every bound: far above rounding, far below interest. */
constexpr double kMargin = 1e-9;
/** Steps of the multipliers: first relaxation (at least), first graph, later graphs. */
constexpr int kPlainSteps = 80;
constexpr int kFirstSteps = 60;
constexpr int kLaterSteps = 20;
constexpr int kMostRounds = 60;
/** Largest graph: 24 MB, and a sweep takes under 10 ms. */
constexpr std::int64_t kMostArcs = 6'000'000;
/** Work counts the arcs of a sweep as 1; the rest by measurement. */
constexpr std::int64_t kWorkOfNode = 3;
constexpr std::int64_t kWorkOfRefining = 10;
constexpr std::int64_t kWorkOfSearching = 25;
/** Relaxed paths whose cycles make the memory grow: those of the last steps. */
constexpr std::size_t kRecentPaths = 12;
constexpr std::size_t kMostCyclesAtOnce = 800;
/** A cycle is forbidden where it was seen and in as many positions before and behind. */
constexpr int kMemoryWindow = 10;

/**
 * Subgradient ascent of the multipliers: step length by the distance to the incumbent (Polyak
 * 1969), direction deflected by the one before (Camerini, Fratta and Maffioli 1975).
 */
class Ascent
{
public:
    explicit Ascent(Eigen::VectorXd lambda)
        : m_lambda(std::move(lambda))
        , m_best(m_lambda)
        , m_direction(Eigen::VectorXd::Zero(m_lambda.size()))
    {
    }

    /** Best bound since the last restart. */
    [[nodiscard]] double bound() const { return m_bound; }
    [[nodiscard]] Prices here(double cutoff) const { return {m_lambda, m_lambda.sum(), cutoff}; }
    [[nodiscard]] Prices best(double cutoff) const { return {m_best, m_best.sum(), cutoff}; }

    /** For another graph: goes on from the best multipliers. */
    void restart()
    {
        m_lambda = m_best;
        m_direction.setZero();
        m_bound = -std::numeric_limits<double>::infinity();
        m_step = kFirstStep;
        m_idle = 0;
    }

    /** `path` and `bound` belong to the multipliers `here`; `target` is the incumbent's cost. */
    void step(const std::vector<int>& path, double bound, double target)
    {
        m_idle = bound > m_bound + 1e-7 * target ? 0 : m_idle + 1;
        if (m_idle >= kPatience) {
            m_step *= 0.7;
            m_idle = 0;
        }
        if (bound > m_bound) {
            m_bound = bound;
            m_best = m_lambda;
        }
        Eigen::VectorXd gradient = Eigen::VectorXd::Ones(m_lambda.size());
        gradient(0) = 0;
        for (const int i : path)
            gradient(i) -= 1;
        m_direction = gradient + 0.7 * m_direction;
        const double norm = m_direction.squaredNorm();
        if (norm > 0)
            m_lambda += m_step * std::max(target - bound, 0.0) / norm * m_direction;
    }

private:
    static constexpr double kFirstStep = 0.4;
    static constexpr int kPatience = 8;

    Eigen::VectorXd m_lambda;
    Eigen::VectorXd m_best;
    Eigen::VectorXd m_direction;
    double m_bound = -std::numeric_limits<double>::infinity();
    double m_step = kFirstStep;
    int m_idle = 0;
};

/**
 * First multipliers: about what an iceberg must cost. The shortest leg to it, and for waiting
 * the integral over sigma of t(sigma), a line fitted to the order: at that price an iceberg of
 * any sigma is indifferent to a small change of its position.
 */
Eigen::VectorXd firstPrices(const VisitCosts& costs, const VisitOrder& order)
{
    const int n = costs.icebergs;
    const Eigen::VectorXd sigma = Eigen::Map<const Eigen::VectorXd>(costs.sigma.data(), n + 1);
    Eigen::VectorXd t = Eigen::VectorXd::Zero(n + 1);
    for (int k = 0; k < n; ++k)
        t(order[static_cast<std::size_t>(k)]) = k + 2;
    const double meanSigma = sigma.tail(n).mean();
    const double meanT = t.tail(n).mean();
    const Eigen::ArrayXd deviation = sigma.tail(n).array() - meanSigma;
    const double square = deviation.square().sum();
    const double slope =
        square > 0 ? (deviation * (t.tail(n).array() - meanT)).sum() / square : 0.0;
    const double start = meanT - slope * meanSigma;

    Eigen::VectorXd prices = Eigen::VectorXd::Zero(n + 1);
    for (int j = 1; j <= n; ++j) {
        double shortest = costs.leg(0, j);
        for (int i = 1; i <= n; ++i)
            if (i != j)
                shortest = std::min(shortest, costs.leg(i, j));
        prices(j) = shortest + start * sigma(j) + slope * sigma(j) * sigma(j) / 2;
    }
    return prices;
}

/** Every iceberg remembers its `count` nearest ones, in all positions. */
NgSets nearestSets(const VisitCosts& costs, int count)
{
    const int n = costs.icebergs;
    NgSets sets(n);
    std::vector<int> others;
    for (int i = 1; i <= n; ++i) {
        others.resize(static_cast<std::size_t>(n));
        std::iota(others.begin(), others.end(), 1);
        others.erase(others.begin() + (i - 1));
        const auto distance = [&](int j) { return costs.leg(i, j) + costs.leg(j, i); };
        std::sort(others.begin(), others.end(), [&](int a, int b) {
            return std::pair(distance(a), a) < std::pair(distance(b), b);
        });
        others.resize(std::min(others.size(), static_cast<std::size_t>(count)));
        for (int p = 1; p <= n; ++p)
            for (const int j : others)
                sets.at(p, i).insert(j);
    }
    return sets;
}

/** A path's return to an iceberg: it is at positions `first` and `last`, not between. */
struct Cycle
{
    const std::vector<int>* path = nullptr;
    int first = 0;
    int last = 0;
};

/** All cycles of the paths, the shortest first. */
std::vector<Cycle> cyclesOf(const std::deque<std::vector<int>>& paths)
{
    std::vector<Cycle> cycles;
    std::vector<int> seen;
    for (const std::vector<int>& path : paths) {
        seen.assign(path.size() + 1, 0);
        for (std::size_t k = 0; k < path.size(); ++k) {
            int& before = seen[static_cast<std::size_t>(path[k])];
            const int position = static_cast<int>(k) + 1;
            if (before > 0)
                cycles.push_back({&path, before, position});
            before = position;
        }
    }
    std::stable_sort(cycles.begin(), cycles.end(), [](const Cycle& a, const Cycle& b) {
        return a.last - a.first < b.last - b.first;
    });
    cycles.resize(std::min(cycles.size(), kMostCyclesAtOnce));
    return cycles;
}

/**
 * Makes the icebergs between the two ends of each cycle remember its iceberg, as far as no
 * memory grows above `cap`: many memories grown at once would make the graph explode.
 */
void forbidCycles(NgSets& sets, const std::deque<std::vector<int>>& paths, int cap)
{
    for (const Cycle& cycle : cyclesOf(paths)) {
        const auto node = [&](int position) {
            return (*cycle.path)[static_cast<std::size_t>(position) - 1];
        };
        const int twice = node(cycle.first);
        bool room = true;
        for (int p = cycle.first + 1; p < cycle.last; ++p) {
            const NodeSet& memory = sets.at(p, node(p));
            room = room && (memory.contains(twice) || memory.size() < cap);
        }
        if (!room)
            continue;
        const int n = static_cast<int>(cycle.path->size());
        for (int p = cycle.first + 1; p < cycle.last; ++p)
            for (int q = std::max(1, p - kMemoryWindow); q <= std::min(n, p + kMemoryWindow); ++q)
                if (sets.at(q, node(p)).size() < cap + 2)
                    sets.at(q, node(p)).insert(twice);
    }
}

/** The run of `improveBound`: an incumbent, a bound, and a graph of what may lie between. */
class BoundSearch
{
public:
    BoundSearch(const VisitCosts& costs, const VisitOrder& order, const BoundOptions& options)
        : m_costs(costs)
        , m_options(options)
        , m_cost(costs.total(order))
        , m_ascent(firstPrices(costs, order))
    {
        m_result.order = order;
    }

    BoundResult run()
    {
        LayeredPaths paths(m_costs);
        relaxWithoutMemory(paths);
        if (!finished() && m_costs.icebergs < NodeSet::kCapacity)
            relaxWithMemory(paths);
        return std::move(m_result);
    }

private:
    /** Orders of at least this cost are of no interest. */
    [[nodiscard]] double cutoff() const { return m_cost * (1 - std::max(kMargin, m_options.gap)); }
    [[nodiscard]] bool finished() const
    {
        return m_result.reached || m_result.work >= m_options.workLimit ||
               (m_options.cut && m_options.cut());
    }

    [[nodiscard]] static std::int64_t workOfSweep(const LayeredGraph& graph)
    {
        return graph.arcCount() + kWorkOfNode * graph.nodeCount();
    }

    /** Takes a lower bound on all orders below the cutoff. */
    void takeBound(double bound)
    {
        if (bound >= cutoff()) {
            m_result.bound = std::max(m_result.bound, cutoff());
            m_result.reached = true;
        } else {
            m_result.bound = std::max(m_result.bound, bound - kMargin * m_cost);
        }
    }
    /** Takes an order; returns whether it is a better one. */
    bool takeOrder(const VisitOrder& order)
    {
        const double cost = m_costs.total(order);
        if (cost >= m_cost * (1 - kMargin))
            return false;
        m_cost = cost;
        m_result.order = order;
        return true;
    }
    void takePath(const std::vector<int>& path)
    {
        NodeSet visited;
        for (const int i : path) {
            if (i >= NodeSet::kCapacity || visited.contains(i))
                return;
            visited.insert(i);
        }
        if (takeOrder(path))
            report();
    }
    void report() const
    {
        if (m_options.onImproved)
            m_options.onImproved(m_result.order, m_result.bound);
    }

    void relaxWithoutMemory(LayeredPaths& paths)
    {
        const std::int64_t n = m_costs.icebergs;
        // The order of magnitude of a bound matters more than the last tenth of it.
        const std::int64_t steps = std::max<std::int64_t>(kPlainSteps, 2 * n);
        for (std::int64_t k = 0; k < steps && !finished(); ++k) {
            const double bound = paths.sweep(m_ascent.here(cutoff()), m_options.cut);
            m_result.work += n * n * n / 2;
            if (!std::isfinite(bound))
                return;
            const std::vector<int> path = paths.shortestPath();
            takePath(path);
            m_ascent.step(path, bound, m_cost);
            takeBound(m_ascent.bound());
        }
        report();
    }

    void relaxWithMemory(LayeredPaths& paths)
    {
        const std::int64_t n = m_costs.icebergs;
        const Prices prices = m_ascent.best(cutoff());
        if (!std::isfinite(paths.sweep(prices, m_options.cut)))
            return;
        LayeredGraph graph(m_costs, paths, prices);
        m_result.work += 2 * n * n * n;

        constexpr int kNearest = 3;
        const int nearest = n <= 50 ? kNearest : 1; // large graphs must grow slowly
        NgSets sets = nearestSets(m_costs, nearest);
        for (int round = 0; round < kMostRounds && !finished(); ++round) {
            if (!refine(graph, sets))
                return;
            ascend(graph, round == 0 ? kFirstSteps : kLaterSteps);
            if (finished())
                return;
            searchIn(graph);
            report();
            forbidCycles(sets, m_recent, nearest + 1 + round);
        }
    }

    /** False when the refined graph would be larger than the work that is left allows. */
    bool refine(LayeredGraph& graph, const NgSets& sets)
    {
        const Prices prices = m_ascent.best(cutoff());
        graph.sweep(prices);
        const std::int64_t left = m_options.workLimit - m_result.work;
        const std::int64_t most = std::min(kMostArcs, left / (kWorkOfRefining + kLaterSteps));
        std::optional<LayeredGraph> refined = graph.refined(sets, prices, most, m_options.cut);
        if (!refined)
            return false;
        graph = std::move(*refined);
        m_result.work += kWorkOfRefining * workOfSweep(graph);
        return true;
    }

    void ascend(LayeredGraph& graph, int steps)
    {
        m_ascent.restart();
        m_recent.clear();
        for (int k = 0; k < steps && !finished(); ++k) {
            const double bound = graph.sweep(m_ascent.here(cutoff()));
            m_result.work += workOfSweep(graph);
            const std::vector<int> path = graph.shortestPath();
            if (path.empty()) {
                takeBound(cutoff()); // nothing below the cutoff is left
                return;
            }
            takePath(path);
            m_recent.push_back(path);
            if (m_recent.size() > kRecentPaths)
                m_recent.pop_front();
            m_ascent.step(path, bound, m_cost);
            takeBound(m_ascent.bound());
            // Early steps gain most, so they are followed by a clearing up sooner.
            if (k == 0 || k == 3 || k == 6 || k % 10 == 9)
                trim(graph);
        }
        trim(graph);
    }

    void trim(LayeredGraph& graph)
    {
        const Prices prices = m_ascent.best(cutoff());
        graph.sweep(prices);
        graph.trim(prices, m_options.cut);
        m_result.work += 3 * workOfSweep(graph);
    }

    void searchIn(LayeredGraph& graph)
    {
        const Prices prices = m_ascent.best(cutoff());
        graph.sweep(prices);
        // The mean width of the graph: about the work of a few sweeps.
        const int states = std::max(100, graph.nodeCount() / m_costs.icebergs);
        const GraphSearchResult found =
            searchGraph(graph, prices, {.mostStates = states, .cut = m_options.cut});
        m_result.work += kWorkOfSearching * found.work;
        if (!found.order.empty())
            takeOrder(found.order);
        takeBound(found.bound);
    }

    const VisitCosts& m_costs;
    const BoundOptions& m_options;
    BoundResult m_result;
    double m_cost; ///< of m_result.order
    Ascent m_ascent;
    std::deque<std::vector<int>> m_recent; ///< relaxed paths of the last steps
};

} // namespace

BoundResult improveBound(const VisitCosts& costs, const VisitOrder& order,
                         const BoundOptions& options)
{
    return BoundSearch(costs, order, options).run();
}

} // namespace berg
