// Checks certificates of optimality: check_certificate FILE...
// Shares no code with the planner. Every number that stands for a cost is rounded down at every
// step (`Low`), so what is proven here holds for the exact numbers that the file's doubles are. For
// each proof it confirms bound <= optimum <= cost of the orders, in F + N sum(sigma) =
// sum(sigma t) + mu D, or latency: sums of positive terms. Ways to prove it, by `method`:
//   enumeration  dynamic programming over subsets of icebergs, done here again
//   sorting      mu = 0: the most uncertain icebergs first
//   relaxation   Lagrangian multipliers on a layered graph whose nodes remember icebergs
//                (ng-paths). Each step deletes, with its multipliers, the arcs on no path below the
//                bound, and may first make nodes remember more. No order left may be below it.

#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

namespace {
using Json = nlohmann::json;
using Index = std::size_t; ///< of icebergs (0 is the start), UAVs, positions, nodes
constexpr Index kMostStates = 4'000'000;
constexpr double kMost = 1e100; ///< of any number in a file: no sum of products is infinite

void expect(bool holds, const std::string& what)
{
    if (!holds)
        throw std::runtime_error(what);
}
double down(double value)
{
    return std::isinf(value) ? value : std::nextafter(value, -HUGE_VAL);
}
/** A number not above the exact one; infinite: there is none. Products are not negative. */
struct Low
{
    double value = 0;
    friend Low operator+(Low a, Low b) { return {down(a.value + b.value)}; }
    friend Low operator*(Low a, Low b) { return {std::max(0.0, down(a.value * b.value))}; }
    void lowerTo(Low other) { value = std::min(value, other.value); }
};
constexpr Low kNone{HUGE_VAL};

/** Icebergs remembered or visited, up to 127: bit i is iceberg i. */
__extension__ using Set = unsigned __int128;
constexpr auto holds = [](Set set, Index i) { return (set >> i & 1U) != 0; };

std::vector<double> numbersOf(const Json& json, Index size, double least)
{
    auto values = json.get<std::vector<double>>();
    expect(values.size() == size, "a list with a wrong size");
    for (const double value : values)
        expect(value >= least && value <= kMost, "a number out of range");
    return values;
}

/** Whole and not below 0; nlohmann would cut the rest of others off. */
std::vector<Index> indicesOf(const Json& json)
{
    for (const Json& entry : json)
        expect(entry.is_number_unsigned(), "a number that is not whole");
    return json.get<std::vector<Index>>();
}

struct Problem
{
    std::vector<std::vector<std::vector<double>>> distance; ///< by UAV, from, to
    std::vector<double> sigma;
    std::vector<std::vector<bool>> allowed; ///< by UAV and iceberg
    double mu = 0;
    bool latency = false;
    bool closed = false; ///< the way back counts
    explicit Problem(const Json& json)
        : sigma(numbersOf(json.at("sigma"), json.at("sigma").size(), 0))
        , allowed(json.value("allowed", std::vector<std::vector<bool>>()))
        , latency(json.at("criterion") == "latency")
        , closed(json.at("route") == "closed" && !latency)
    {
        expect(json.at("version") == 1, "an unknown version");
        expect(latency || json.at("criterion") == "visitation", "an unknown criterion");
        expect(json.at("route") == "closed" || json.at("route") == "open", "an unknown route");
        expect(!sigma.empty() && sigma.size() <= 128 && sigma[0] == 0, "sigma has a wrong size");
        for (const Json& matrix : json.at("distance_m")) {
            expect(matrix.size() == sigma.size(), "distance_m has a wrong size");
            distance.emplace_back();
            for (const Json& row : matrix)
                distance.back().push_back(numbersOf(row, sigma.size(), 0));
        }
        if (allowed.empty())
            allowed.assign(distance.size(), std::vector<bool>(sigma.size(), true));
    }
    [[nodiscard]] Index icebergs() const { return sigma.size() - 1; }
    /** mu d, for latency times the sigma ahead of it; to 0 is the way back. */
    [[nodiscard]] Low leg(Index uav, Index from, Index to, Low ahead = {}) const
    {
        if (to == 0 && (!closed || from == 0))
            return {};
        const Low once = Low{mu} * Low{distance[uav][from][to]};
        return latency ? ahead * once : once;
    }
    /** Cost of a visit at `position`, from 1; t is one more. */
    [[nodiscard]] Low visit(Index i, Index position) const
    {
        return latency ? Low{} : Low{sigma[i]} * Low{static_cast<double>(position + 1)};
    }
    [[nodiscard]] Low unseen(Set visited) const
    {
        Low sum;
        for (Index i = 1; i < sigma.size(); ++i)
            sum = holds(visited, i) ? sum : sum + Low{sigma[i]};
        return sum;
    }
};

/** Checks that the orders cost at most the claimed amount, within 1e-13. */
double costOf(const Problem& problem, const std::vector<std::vector<Index>>& orders)
{
    expect(orders.size() == problem.distance.size(), "not one order for each UAV");
    std::vector<int> visits(problem.sigma.size(), 0);
    const long double mu = problem.mu;
    long double sum = 0;
    for (Index uav = 0; uav < orders.size(); ++uav) {
        const auto& distance = problem.distance[uav];
        long double flown = 0;
        Index from = 0;
        int t = 1;
        for (const Index to : orders[uav]) {
            const bool mayVisit = to >= 1 && problem.allowed.at(uav).at(to);
            expect(mayVisit, "an order with an iceberg that the UAV may not visit");
            ++visits[to];
            const long double leg = mu * distance[from][to];
            flown += leg;
            sum += problem.latency ? problem.sigma[to] * flown : problem.sigma[to] * ++t + leg;
            from = to;
        }
        sum += problem.closed && from != 0 ? mu * distance[from][0] : 0;
    }
    for (Index i = 1; i < visits.size(); ++i)
        expect(visits[i] == 1, "iceberg " + std::to_string(i) + " is not visited once");
    return static_cast<double>(sum) * (1 + 1e-13);
}

/** By set (bit i - 1 is iceberg i): the least cost of one UAV's orders of exactly these icebergs.
 * The sigma ahead of a leg is charged with it, or once and all sigma once more: that is sigma t. */
std::vector<Low> costBySet(const Problem& problem, Index uav)
{
    const Index n = problem.icebergs();
    std::vector<Low> result(Index{1} << n);
    std::vector<std::vector<Low>> onwards(result.size(), std::vector<Low>(n + 1, kNone));
    for (Index i = 0; i <= n; ++i)
        onwards[0][i] = problem.leg(uav, i, 0);
    for (Index set = 1; set < result.size(); ++set) {
        const Low sigma = problem.unseen(~(Set{set} << 1U));
        const Low visits = problem.latency ? Low{} : sigma; // are one later by each leg
        for (Index i = 0; i <= n; ++i)
            for (Index j = 1; j <= n; ++j)
                if (i != j && holds(set, j - 1) && problem.allowed.at(uav).at(j))
                    onwards[set][i].lowerTo(problem.leg(uav, i, j, sigma) + visits +
                                            onwards[set & ~(Index{1} << (j - 1))][j]);
        result[set] = onwards[set][0] + visits;
    }
    return result;
}

Low boundByEnumeration(const Problem& problem)
{
    expect(problem.icebergs() <= 16, "too many icebergs to enumerate");
    std::vector<Low> best = costBySet(problem, 0); // of a set, for the UAVs so far
    for (Index uav = 1; uav < problem.distance.size(); ++uav) {
        const std::vector<Low> own = costBySet(problem, uav);
        std::vector<Low> shared = best; // this UAV visits nothing
        for (Index set = 0; set < best.size(); ++set)
            for (Index part = set; part != 0; part = (part - 1) & set)
                shared[set].lowerTo(own[part] + best[set & ~part]);
        best = std::move(shared);
    }
    return best.back();
}

Low boundBySorting(const Problem& problem)
{
    const bool isFree = problem.mu == 0 && !problem.latency;
    expect(isFree && problem.distance.size() == 1, "sorting proves nothing here");
    std::vector<double> sigma = problem.sigma;
    std::sort(sigma.rbegin(), sigma.rend() - 1);
    Low sum;
    for (Index k = 1; k < sigma.size(); ++k)
        sum = sum + Low{sigma[k]} * Low{static_cast<double>(k + 1)};
    return sum;
}

struct Step
{
    std::vector<double> lambda;         ///< by node, [0] is 0
    std::vector<std::vector<Set>> sets; ///< by band and iceberg, from 1
    Low sum;                            ///< of lambda
    Step(const Json& json, Index size) : lambda(numbersOf(json.at("lambda"), size, -kMost))
    {
        expect(lambda[0] == 0, "a multiplier of the start");
        for (const double value : lambda)
            sum = sum + Low{value};
        for (const Json& band : json.value("sets", Json::array())) {
            sets.emplace_back();
            for (const Json& text : band) {
                Set& set = sets.back().emplace_back(0); // any set is sound
                for (const char digit : text.get<std::string>()) {
                    const Index value = std::string_view("0123456789abcdef").find(digit);
                    expect(value < 16, "a set that is no hexadecimal number");
                    set = set * 16 + value;
                }
            }
        }
    }
};

struct Node
{
    Index level = 0;
    Index iceberg = 0;
    Low unseen = kNone; ///< how much sigma any path to it leaves unseen at least
    std::vector<Index> arcs = {};
    Low length = kNone;  ///< least to it, its own visit not included
    Low onwards = kNone; ///< least from before its visit to the end
};

/** The relaxation of one UAV: paths from node 0 to the last level, by the `rises` of icebergs. */
class Relaxation
{
public:
    Relaxation(const Problem& problem, std::vector<Index> rises, double bound)
        : m_problem(problem), m_bound(bound), m_n(problem.icebergs())
    {
        if (!problem.latency)
            rises.assign(m_n + 1, 1); // levels are positions
        for (Index i = 1; i <= m_n; ++i) {
            expect(rises.at(i) >= 1 && rises[i] < 100'000, "a rise that is none");
            m_last += rises[i];
        }
        m_leastUnseen.assign(m_last + 1, kNone);
        m_leastUnseen[m_last] = {};
        for (Index i = 1; i <= m_n; ++i)
            for (Index level = 0; level + rises[i] <= m_last; ++level)
                m_leastUnseen[level].lowerTo(m_leastUnseen[level + rises[i]] +
                                             Low{problem.sigma[i]});
        for (Index v = 0; v <= m_last * m_n; ++v) {
            m_inOrder.push_back(v);
            Node& node = m_nodes.emplace_back();
            node = {.level = (v + m_n - 1) / m_n, .iceberg = v == 0 ? 0 : (v - 1) % m_n + 1};
            for (Index j = 1; j <= m_n; ++j)
                if (j != node.iceberg && node.level + rises[j] <= m_last)
                    node.arcs.push_back((node.level + rises[j] - 1) * m_n + j);
        }
    }

    /** The graph times the memories of the step, less arcs on no path below the bound. With `all`
     * icebergs in the memories it is the orders, and none of them may be below the bound. */
    void follow(const Step& step, bool all)
    {
        sweep(step);
        std::vector<Node> nodes{{.length = {}}};
        std::map<std::tuple<Index, Index, Set>, Index> made{{{0, 0, 0}, 0}}; // level, old, memory
        m_inOrder.clear();
        for (const auto& [key, v] : made) { // which grows behind this place only
            const Node& old = m_nodes[std::get<1>(key)];
            const Set memory = std::get<2>(key) | (Set{1} << old.iceberg);
            const Low unseen = all ? m_problem.unseen(memory) : old.unseen;
            m_inOrder.push_back(v);
            for (const Index to : old.arcs) {
                const Node& next = m_nodes[to];
                const Low there = afterVisit(old, nodes[v].length, step) +
                                  m_problem.leg(0, old.iceberg, next.iceberg, unseen);
                if (holds(memory, next.iceberg) ||
                    (there + next.onwards + step.sum).value >= m_bound)
                    continue;
                expect(!all || next.level < m_last, "an order inside the graph is below the bound");
                Set kept = all ? memory : 0;
                if (!all && !step.sets.empty())
                    kept =
                        memory & step.sets.at((next.level - 1) * m_n / m_last).at(next.iceberg - 1);
                const auto [place, isNew] = made.try_emplace({next.level, to, kept}, nodes.size());
                if (isNew)
                    nodes.push_back({.level = next.level, .iceberg = next.iceberg});
                expect(nodes.size() < kMostStates, "too many orders are left to go through");
                nodes[place->second].length.lowerTo(there);
                nodes[v].arcs.push_back(place->second);
            }
        }
        m_nodes = std::move(nodes);
    }

private:
    [[nodiscard]] Low afterVisit(const Node& node, Low length, const Step& step) const
    {
        return length + m_problem.visit(node.iceberg, node.level) + Low{-step.lambda[node.iceberg]};
    }
    /** Weights of the legs from every node, and least lengths to the end. */
    void sweep(const Step& step)
    {
        m_nodes[0].unseen = m_problem.unseen(0);
        for (const Index v : m_inOrder) {
            Node& node = m_nodes[v];
            node.unseen = node.unseen + Low{-m_problem.sigma[node.iceberg]};
            node.unseen.value = std::max(node.unseen.value, m_leastUnseen[node.level].value);
            for (const Index to : node.arcs)
                m_nodes[to].unseen.lowerTo(node.unseen);
        }
        for (auto v = m_inOrder.rbegin(); v != m_inOrder.rend(); ++v) {
            Node& node = m_nodes[*v];
            const Index i = node.iceberg;
            Low rest = node.level == m_last ? m_problem.leg(0, i, 0) : kNone;
            for (const Index to : node.arcs)
                rest.lowerTo(m_problem.leg(0, i, m_nodes[to].iceberg, node.unseen) +
                             m_nodes[to].onwards);
            node.onwards = afterVisit(node, rest, step);
        }
    }

    const Problem& m_problem;
    double m_bound;
    Index m_n;
    Index m_last = 0;
    std::vector<Low> m_leastUnseen; ///< by level: of any icebergs that lead from it to the last
    std::vector<Node> m_nodes;
    std::vector<Index> m_inOrder; ///< nodes by level
};

/** Several UAVs: multipliers and memories, nothing deleted. Orders may end anywhere. */
Low boundOfFleet(const Problem& problem, const Step& step)
{
    expect(!problem.latency, "no relaxation for the latency of several UAVs");
    Low sum = step.sum;
    for (Index uav = 0; uav < problem.distance.size(); ++uav) {
        std::map<std::pair<Index, Set>, Low> next, labels{{{0, 0}, {}}}; // by iceberg and memory
        Low best;                                                        // of no visit
        const std::vector<bool>& may = problem.allowed.at(uav);
        const auto most = static_cast<Index>(std::count(may.begin() + 1, may.end(), true));
        for (Index position = 1; position <= most; ++position) {
            next.clear();
            for (const auto& [last, length] : labels)
                for (Index j = 1; j <= problem.icebergs(); ++j) {
                    const Set seen = last.second | Set{1} << last.first;
                    if (holds(seen, j) || !may.at(j))
                        continue;
                    const Low there = length + problem.leg(uav, last.first, j) +
                                      problem.visit(j, position) + Low{-step.lambda[j]};
                    const Set kept = step.sets.empty() ? 0 : step.sets.at(position - 1).at(j - 1);
                    next.try_emplace({j, seen & kept}, kNone).first->second.lowerTo(there);
                    best.lowerTo(there + problem.leg(uav, j, 0));
                }
            labels.swap(next);
        }
        sum = sum + best;
    }
    return sum;
}

Low boundOf(const Problem& problem, const Json& proof, double claimed)
{
    const std::string method = proof.at("method").get<std::string>();
    if (method == "enumeration")
        return boundByEnumeration(problem);
    if (method == "sorting")
        return boundBySorting(problem);
    expect(method == "relaxation", "an unknown method");
    std::vector<Step> steps;
    for (const Json& step : proof.at("steps"))
        steps.emplace_back(step, problem.sigma.size());
    expect(!steps.empty(), "a relaxation without multipliers");
    if (problem.distance.size() > 1)
        return boundOfFleet(problem, steps.back());
    Relaxation relaxation(problem, indicesOf(proof.value("rises", Json::array())), claimed);
    for (const Step& step : steps)
        relaxation.follow(step, false);
    relaxation.follow(steps.back(), true);
    return {claimed};
}

/** Word for word; the gap, relative, is that of the numbers. */
void checkClaim(const std::string& claim, double gap)
{
    constexpr double kOptimal = 1.001e-8; // 1e-8 is claimed of a cost that was rounded
    constexpr std::string_view kBefore = "the orders are within ";
    constexpr std::string_view kAfter = " % of optimal";
    if (claim == "the orders are optimal") {
        expect(gap <= kOptimal, "the orders are not known to be optimal");
        return;
    }
    expect(claim.size() > kBefore.size() + kAfter.size() && claim.starts_with(kBefore) &&
               claim.ends_with(kAfter),
           "a claim in unknown words");
    const std::string number =
        claim.substr(kBefore.size(), claim.size() - kBefore.size() - kAfter.size());
    double percent = 0;
    const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), percent,
                                              std::chars_format::fixed);
    expect(error == std::errc() && end == number.data() + number.size() &&
               number.find_first_not_of("0123456789.") == std::string::npos,
           "a claim without a number");
    expect(100 * gap <= percent, "the orders are not known to be so near the optimum");
}

void check(const char* name, const Json& proof, Problem& problem)
{
    problem.mu = numbersOf(Json::array({proof.at("mu")}), 1, 0)[0];
    const double bound = proof.at("bound").get<double>();
    std::vector<std::vector<Index>> orders;
    for (const Json& order : proof.at("orders"))
        orders.push_back(indicesOf(order));
    const double cost = costOf(problem, orders);
    expect(cost <= proof.at("cost").get<double>() * (1 + 1e-12), "the orders cost more than said");
    expect(bound <= cost, "the bound is above the cost");
    const Low known = bound > 0 ? boundOf(problem, proof, bound) : Low{}; // no cost is negative
    expect(known.value >= bound, "a plan costs no more than " + std::to_string(known.value));
    const double gap = cost > 0 ? (cost - bound) / cost : 0;
    checkClaim(proof.at("claim").get<std::string>(), gap);
    std::printf("%s: %.10g <= optimum <= %.10g, gap %.2g %%\n", name, bound, cost, 100 * gap);
}

} // namespace

int main(int argc, char** argv)
{
    bool isWrong = false;
    for (int k = 1; k < argc; ++k)
        try {
            const Json json = Json::parse(std::ifstream(argv[k]));
            expect(json.at("format") == "bergwatch-certificate", "not a certificate");
            Problem problem(json);
            expect(!json.at("proofs").empty(), "nothing is proven");
            for (const Json& proof : json.at("proofs"))
                check(argv[k], proof, problem);
        } catch (const std::exception& error) {
            std::printf("%s: WRONG: %s\n", argv[k], error.what());
            isWrong = true;
        }
    return isWrong ? 1 : 0;
}
