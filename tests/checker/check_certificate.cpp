// Checks certificates of optimality: check_certificate FILE...
//
// Written from the problem and the literature alone; it shares no code with the planner. Every
// number that stands for a cost is rounded down at every step (`Low`), so what is proven here holds
// for the exact real numbers that the file's doubles are. For each proof of a file it confirms
//   bound <= optimum <= cost of the order
// where all costs are F + N sum(sigma) = sum(sigma t) + mu D, or latency, which are sums of
// positive terms. Ways to prove the bound, by `method`:
//   enumeration  dynamic programming over subsets of icebergs, done here again
//   sorting      mu = 0: the most uncertain icebergs first
//   relaxation   Lagrangian multipliers on a layered graph whose nodes remember icebergs
//                (ng-paths). Steps are followed as written: each deletes, with its multipliers, the
//                arcs on no path below the bound, and may first make nodes remember more. At last
//                all orders still inside the graph are gone through, and none may be below the
//                bound.

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <functional>
#include <limits>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

using Json = nlohmann::json;
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::size_t kMostStates = 4'000'000;

struct Wrong : std::runtime_error
{
    using std::runtime_error::runtime_error;
};
void expect(bool holds, const std::string& what)
{
    if (!holds)
        throw Wrong(what);
}

double down(double value)
{
    return std::nextafter(value, -kInfinity);
}
/** A number not above the exact one it stands for. Products are of numbers that are not negative.
 */
struct Low
{
    double value = 0;
    [[nodiscard]] bool isKnown() const { return value < kInfinity; }
    friend Low operator+(Low a, Low b) { return {down(a.value + b.value)}; }
    /** Less an exact number. */
    friend Low operator-(Low a, double exact) { return {down(a.value - exact)}; }
    friend Low operator*(Low a, Low b) { return {std::max(0.0, down(a.value * b.value))}; }
    friend bool operator<(Low a, Low b) { return a.value < b.value; }
};
Low least(Low a, Low b)
{
    return b < a ? b : a;
}

using Set = std::uint32_t; ///< bit i - 1 is iceberg i
/** Icebergs remembered or visited, up to 127: bit i is iceberg i. */
__extension__ using Memory = unsigned __int128;
bool holds(Memory set, int i)
{
    return (set >> i & 1U) != 0;
}
Memory memoryOf(const std::string& hex)
{
    Memory set = 0;
    for (const char digit : hex)
        set = set * 16 + static_cast<unsigned>(std::stoi(std::string(1, digit), nullptr, 16));
    return set;
}
std::size_t at(int k)
{
    return static_cast<std::size_t>(k);
}

struct Problem
{
    std::vector<std::vector<std::vector<double>>> distance; ///< by UAV, from, to
    std::vector<double> sigma;
    std::vector<std::vector<bool>> allowed; ///< by UAV and iceberg; empty: all
    double mu = 0;
    bool closed = false;
    bool latency = false;

    [[nodiscard]] int icebergs() const { return static_cast<int>(sigma.size()) - 1; }
    [[nodiscard]] int uavs() const { return static_cast<int>(distance.size()); }
    [[nodiscard]] bool allows(int uav, int i) const
    {
        return allowed.empty() || allowed[at(uav)][at(i)];
    }
    /** mu d; to 0 is the way back. */
    [[nodiscard]] Low leg(int uav, int from, int to) const
    {
        if (to == 0 && (!closed || latency || from == 0))
            return {};
        return Low{mu} * Low{distance[at(uav)][at(from)][at(to)]};
    }
    /** Of a visit as number `position`, from 1: t is one more. */
    [[nodiscard]] Low visit(int i, int position) const
    {
        return latency ? Low{} : Low{sigma[at(i)]} * Low{position + 1.0};
    }
};

/** What orders cost at most, within 1e-13: that they cost so little is all that is claimed. */
double costOf(const Problem& problem, const std::vector<std::vector<int>>& orders)
{
    std::vector<int> visits(problem.sigma.size(), 0);
    long double sum = 0;
    expect(orders.size() == at(problem.uavs()), "not one order for each UAV");
    for (int uav = 0; uav < problem.uavs(); ++uav) {
        long double flown = 0;
        int from = 0;
        int t = 1;
        for (const int to : orders[at(uav)]) {
            expect(to >= 1 && to <= problem.icebergs(), "an order with an unknown iceberg");
            expect(problem.allows(uav, to), "an order with an iceberg that the UAV may not visit");
            ++visits[at(to)];
            const long double sigma = problem.sigma[at(to)];
            flown +=
                static_cast<long double>(problem.mu) * problem.distance[at(uav)][at(from)][at(to)];
            sum += problem.latency ? sigma * flown : sigma * ++t;
            from = to;
        }
        if (problem.closed && !problem.latency && from != 0)
            flown += static_cast<long double>(problem.mu) * problem.distance[at(uav)][at(from)][0];
        sum += problem.latency ? 0 : flown;
    }
    for (std::size_t i = 1; i < visits.size(); ++i)
        expect(visits[i] == 1, "iceberg " + std::to_string(i) + " is not visited once");
    return static_cast<double>(sum) * (1 + 1e-13);
}

/** By set: the least cost of one UAV's orders of exactly these icebergs. A leg is charged for the
 * sigma ahead of it: times its length, or once (and all sigma once more), which makes sigma t. */
std::vector<Low> costBySet(const Problem& problem, int uav)
{
    const int n = problem.icebergs();
    const std::size_t sets = std::size_t{1} << n;
    std::vector<Low> result(sets, Low{kInfinity});
    std::vector<std::vector<Low>> onwards(sets, std::vector<Low>(at(n) + 1, Low{kInfinity}));
    for (int i = 0; i <= n; ++i)
        onwards[0][at(i)] = problem.leg(uav, i, 0);
    result[0] = {};
    for (Set set = 1; set < sets; ++set) {
        Low sigma;
        for (int i = 1; i <= n; ++i)
            sigma = (set >> (i - 1) & 1U) != 0 ? sigma + Low{problem.sigma[at(i)]} : sigma;
        for (int i = 0; i <= n; ++i)
            for (int j = 1; j <= n; ++j) {
                const Low rest = onwards[set & ~(Set{1} << (j - 1))][at(j)];
                if (i == j || (set >> (j - 1) & 1U) == 0 || !problem.allows(uav, j) ||
                    !rest.isKnown())
                    continue;
                const Low leg = problem.leg(uav, i, j);
                onwards[set][at(i)] = least(onwards[set][at(i)],
                                            (problem.latency ? sigma * leg : sigma + leg) + rest);
            }
        if (onwards[set][0].isKnown())
            result[set] = problem.latency ? onwards[set][0] : onwards[set][0] + sigma;
    }
    return result;
}

void checkByEnumeration(const Problem& problem, double bound)
{
    expect(problem.icebergs() <= 16, "too many icebergs to enumerate");
    std::vector<Low> best = costBySet(problem, 0); // of a set, for the UAVs so far
    for (int uav = 1; uav < problem.uavs(); ++uav) {
        const std::vector<Low> own = costBySet(problem, uav);
        std::vector<Low> shared(best.size(), Low{kInfinity});
        for (Set set = 0; set < best.size(); ++set)
            for (Set part = set;; part = (part - 1) & set) {
                if (own[part].isKnown() && best[set & ~part].isKnown())
                    shared[set] = least(shared[set], own[part] + best[set & ~part]);
                if (part == 0)
                    break;
            }
        best = std::move(shared);
    }
    expect(best.back().value >= bound,
           "a plan costs no more than " + std::to_string(best.back().value));
}

void checkBySorting(const Problem& problem, double bound)
{
    expect(problem.mu == 0 && problem.uavs() == 1 && !problem.latency,
           "sorting proves nothing here");
    std::vector<double> sigma(problem.sigma.begin() + 1, problem.sigma.end());
    std::sort(sigma.begin(), sigma.end(), std::greater<>());
    Low sum;
    for (std::size_t k = 0; k < sigma.size(); ++k)
        sum = sum + Low{sigma[k]} * Low{static_cast<double>(k) + 2};
    expect(sum.value >= bound, "sorting costs less");
}

struct Step
{
    std::vector<double> lambda;            ///< by node, [0] is 0
    std::vector<std::vector<Memory>> sets; ///< by band and iceberg, from 1; empty: none
};

Low sumOf(const std::vector<double>& values)
{
    Low sum;
    for (const double value : values)
        sum = sum + Low{value};
    return sum;
}

struct Node
{
    int level = 0;
    int iceberg = 0;
    std::vector<int> arcs = {};
    Low unseen{kInfinity};  ///< how much sigma any path to it leaves unseen at least
    Low length{kInfinity};  ///< least to it, its own visit not included
    Low onwards{kInfinity}; ///< least from before its visit to the end
};

/** The relaxation of one UAV: every path from node 0 to the last level. */
class Relaxation
{
public:
    Relaxation(const Problem& problem, std::vector<int> rises, double bound)
        : m_problem(problem), m_rises(std::move(rises)), m_bound(bound), m_n(problem.icebergs())
    {
        if (!problem.latency)
            m_rises.assign(at(m_n) + 1, 1); // levels are positions
        expect(m_rises.size() == at(m_n) + 1, "not one rise for each iceberg");
        for (int i = 1; i <= m_n; ++i) {
            expect(m_rises[at(i)] >= 1 && m_rises[at(i)] < 100'000, "a rise that is none");
            m_last += m_rises[at(i)];
        }
        // By level: the least sigma that any set of icebergs which ends there leaves unseen.
        m_leastUnseen.assign(at(m_last) + 1, Low{kInfinity});
        m_leastUnseen[at(m_last)] = {};
        for (int i = 1; i <= m_n; ++i)
            for (int level = 0; level + m_rises[at(i)] <= m_last; ++level)
                if (const Low rest = m_leastUnseen[at(level + m_rises[at(i)])]; rest.isKnown())
                    m_leastUnseen[at(level)] =
                        least(m_leastUnseen[at(level)], rest + Low{problem.sigma[at(i)]});
        m_nodes = {Node{}};
        m_atLevel.assign(at(m_last) + 1, {});
        m_atLevel[0] = {0};
        for (int level = 1; level <= m_last; ++level)
            for (int i = 1; i <= m_n; ++i) {
                m_atLevel[at(level)].push_back(static_cast<int>(m_nodes.size()));
                m_nodes.push_back({.level = level, .iceberg = i});
            }
        for (Node& node : m_nodes)
            for (int j = 1; j <= m_n; ++j)
                if (const int next = node.level + m_rises[at(j)];
                    j != node.iceberg && next <= m_last)
                    node.arcs.push_back(m_atLevel[at(next)][at(j) - 1]);
    }

    /** The product of the graph with the memories of the step, less arcs on no path below the
     * bound. */
    void follow(const Step& step)
    {
        sweep(step.lambda);
        std::vector<Node> nodes{Node{.length = {}}};
        std::vector<std::map<std::pair<int, Memory>, int>> made(at(m_last) + 1); // old node, memory
        made[0][{0, Memory{0}}] = 0;
        std::vector<std::vector<int>> atLevel(at(m_last) + 1);
        for (const auto& level : made)
            for (const auto& [key, v] : level) {
                const Node& old = m_nodes[at(key.first)];
                atLevel[at(old.level)].push_back(v);
                for (const int to : old.arcs) {
                    const Node& next = m_nodes[at(to)];
                    const Low there = afterVisit(nodes[at(v)], step.lambda) + leg(old, next);
                    if (holds(key.second, next.iceberg) || !isBelow(there, next))
                        continue;
                    Memory memory = 0;
                    if (!step.sets.empty())
                        memory = (key.second | Memory{old.iceberg > 0} << old.iceberg) &
                                 step.sets.at(bandOf(next.level)).at(at(next.iceberg) - 1);
                    const auto [place, isNew] = made[at(next.level)].try_emplace(
                        {to, memory}, static_cast<int>(nodes.size()));
                    if (isNew)
                        nodes.push_back({.level = next.level, .iceberg = next.iceberg});
                    Node& target = nodes[at(place->second)];
                    target.length = least(target.length, there);
                    nodes[at(v)].arcs.push_back(place->second);
                }
            }
        m_nodes = std::move(nodes);
        m_atLevel = std::move(atLevel);
    }

    /** Goes through the orders inside the graph: none may be below the bound. */
    void checkOrders(const std::vector<double>& lambda)
    {
        sweep(lambda);
        std::map<std::pair<Memory, int>, Low> states{{{Memory{0}, 0}, Low{}}};
        std::size_t count = 0;
        for (int visits = 0; visits < m_n; ++visits) {
            std::map<std::pair<Memory, int>, Low> next;
            for (const auto& [key, length] : states) {
                Node node = m_nodes[at(key.second)];
                node.length = length;
                node.unseen = unseen(key.first); // as it is for this order
                for (const int to : node.arcs) {
                    const int j = m_nodes[at(to)].iceberg;
                    const Low there = afterVisit(node, lambda) + leg(node, m_nodes[at(to)]);
                    if (holds(key.first, j) || !isBelow(there, m_nodes[at(to)]))
                        continue;
                    expect(visits + 1 < m_n, "an order inside the graph is below the bound");
                    expect(++count < kMostStates, "too many orders are left to go through");
                    Low& other =
                        next.try_emplace({key.first | Memory{1} << j, to}, there).first->second;
                    other = least(other, there);
                }
            }
            states = std::move(next);
        }
    }

private:
    [[nodiscard]] Low unseen(Memory visited) const
    {
        Low sum;
        for (int i = 1; i <= m_n; ++i)
            sum = holds(visited, i) ? sum : sum + Low{m_problem.sigma[at(i)]};
        return sum;
    }
    [[nodiscard]] Low leg(const Node& from, const Node& to) const
    {
        const Low once = m_problem.leg(0, from.iceberg, to.iceberg);
        return m_problem.latency ? from.unseen * once : once;
    }
    [[nodiscard]] Low afterVisit(const Node& node, const std::vector<double>& lambda) const
    {
        if (node.iceberg == 0)
            return node.length;
        return node.length + m_problem.visit(node.iceberg, node.level) - lambda[at(node.iceberg)];
    }
    [[nodiscard]] bool isBelow(Low length, const Node& next) const
    {
        return next.onwards.isKnown() && (length + next.onwards + m_sum).value < m_bound;
    }
    [[nodiscard]] std::size_t bandOf(int level) const
    {
        return at(static_cast<int>(std::int64_t{level - 1} * m_n / m_last));
    }

    /** Weights of the legs from every node, and least lengths to the end. */
    void sweep(const std::vector<double>& lambda)
    {
        expect(lambda.size() == at(m_n) + 1 && lambda[0] == 0, "not one multiplier each");
        m_sum = sumOf(lambda);
        for (const std::vector<int>& level : m_atLevel)
            for (const int v : level) {
                Node& node = m_nodes[at(v)];
                if (v == 0)
                    node.unseen = unseen(0);
                else if (node.unseen.isKnown())
                    node.unseen = node.unseen - m_problem.sigma[at(node.iceberg)];
                const Low ofLevel = m_leastUnseen[at(node.level)];
                if (ofLevel.isKnown() && (!node.unseen.isKnown() || node.unseen < ofLevel))
                    node.unseen = ofLevel;
                for (const int to : node.arcs)
                    m_nodes[at(to)].unseen = least(m_nodes[at(to)].unseen, node.unseen);
            }
        for (std::size_t level = m_atLevel.size(); level-- > 0;)
            for (const int v : m_atLevel[level]) {
                Node node = m_nodes[at(v)];
                node.length =
                    node.level == m_last ? m_problem.leg(0, node.iceberg, 0) : Low{kInfinity};
                for (const int to : node.arcs)
                    if (const Node& next = m_nodes[at(to)]; next.onwards.isKnown())
                        node.length = least(node.length, leg(node, next) + next.onwards);
                m_nodes[at(v)].onwards =
                    node.length.isKnown() ? afterVisit(node, lambda) : Low{kInfinity};
            }
    }

    const Problem& m_problem;
    std::vector<int> m_rises; ///< of the level, by iceberg
    double m_bound;
    int m_n;
    int m_last = 0;
    std::vector<Low> m_leastUnseen;
    std::vector<Node> m_nodes;
    std::vector<std::vector<int>> m_atLevel;
    Low m_sum; ///< of the multipliers
};

/** Several UAVs: the multipliers on graphs without memory. Orders may end anywhere. */
void checkFleet(const Problem& problem, const std::vector<double>& lambda, double bound)
{
    const int n = problem.icebergs();
    expect(!problem.latency, "no relaxation for the latency of several UAVs");
    expect(lambda.size() == at(n) + 1, "not one multiplier for each iceberg");
    Low sum = sumOf(lambda);
    for (int uav = 0; uav < problem.uavs(); ++uav) {
        std::vector<Low> entry(at(n) + 1, Low{kInfinity}); // of the position after
        Low shortest;
        for (int position = n; position >= 0; --position) {
            std::vector<Low> here(at(n) + 1, Low{kInfinity});
            for (int i = position == 0 ? 0 : 1; i <= (position == 0 ? 0 : n); ++i) {
                Low length = problem.leg(uav, i, 0);
                for (int j = 1; j <= n; ++j)
                    if (j != i && problem.allows(uav, j) && entry[at(j)].isKnown())
                        length = least(length, problem.leg(uav, i, j) + entry[at(j)]);
                here[at(i)] =
                    position == 0 ? length : length + problem.visit(i, position) - lambda[at(i)];
            }
            entry = std::move(here);
        }
        sum = sum + least(shortest, entry[0]);
    }
    expect(sum.value >= bound, "the multipliers give no more than " + std::to_string(sum.value));
}

Problem problemOf(const Json& json)
{
    Problem problem;
    problem.sigma = json.at("sigma").get<std::vector<double>>();
    problem.distance = json.at("distance_m").get<std::vector<std::vector<std::vector<double>>>>();
    if (json.contains("allowed"))
        problem.allowed = json.at("allowed").get<std::vector<std::vector<bool>>>();
    problem.closed = json.at("route") == "closed";
    problem.latency = json.at("criterion") == "latency";
    const std::size_t size = problem.sigma.size();
    expect(size >= 1 && size <= 128 && problem.sigma[0] == 0, "sigma has a wrong size");
    for (const auto& rows : problem.distance) {
        expect(rows.size() == size, "distance_m has a wrong size");
        for (const auto& row : rows)
            expect(row.size() == size, "distance_m has a wrong size");
    }
    return problem;
}

std::string check(const Json& proof, Problem& problem)
{
    problem.mu = proof.at("mu").get<double>();
    const double bound = proof.at("bound").get<double>();
    const double cost = costOf(problem, proof.at("orders").get<std::vector<std::vector<int>>>());
    expect(cost <= proof.at("cost").get<double>() * (1 + 1e-12),
           "the order costs more than it says");
    expect(bound <= cost, "the bound is above the order's cost");
    const std::string method = proof.at("method").get<std::string>();
    if (bound <= 0) {
        // No cost is negative.
    } else if (method == "enumeration") {
        checkByEnumeration(problem, bound);
    } else if (method == "sorting") {
        checkBySorting(problem, bound);
    } else {
        expect(method == "relaxation", "an unknown method");
        std::vector<Step> steps;
        for (const Json& json : proof.at("steps")) {
            steps.push_back({.lambda = json.at("lambda").get<std::vector<double>>(), .sets = {}});
            for (const Json& band : json.value("sets", Json::array())) {
                steps.back().sets.emplace_back();
                for (const Json& set : band)
                    steps.back().sets.back().push_back(memoryOf(set.get<std::string>()));
            }
        }
        expect(!steps.empty(), "a relaxation without multipliers");
        if (problem.uavs() > 1) {
            checkFleet(problem, steps.back().lambda, bound);
        } else {
            Relaxation relaxation(problem, proof.value("rises", std::vector<int>()), bound);
            for (const Step& step : steps)
                relaxation.follow(step);
            relaxation.checkOrders(steps.back().lambda);
        }
    }
    char text[120];
    std::snprintf(text, sizeof text, "%.10g <= optimum <= %.10g, gap %.2g %%, %s", bound, cost,
                  cost > 0 ? 100 * (cost - bound) / cost : 0.0, method.c_str());
    return text;
}

} // namespace

int main(int argc, char** argv)
{
    int wrong = 0;
    for (int k = 1; k < argc; ++k)
        try {
            std::ifstream file(argv[k]);
            const Json json = Json::parse(file);
            expect(json.at("format") == "bergwatch-certificate", "not a certificate");
            Problem problem = problemOf(json);
            for (const Json& proof : json.at("proofs"))
                std::printf("%s: %s\n", argv[k], check(proof, problem).c_str());
        } catch (const std::exception& error) {
            std::printf("%s: WRONG: %s\n", argv[k], error.what());
            ++wrong;
        }
    return wrong == 0 ? 0 : 1;
}
