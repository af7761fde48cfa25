#include "core/plan/problem/tvp.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace berg {

VisitOrder ascendingOrder(int icebergs)
{
    VisitOrder order(static_cast<std::size_t>(icebergs));
    std::iota(order.begin(), order.end(), NodeIndex(1));
    return order;
}

VisitOrder nodesOf(std::span<const int> numbers)
{
    VisitOrder nodes(numbers.size());
    std::ranges::transform(numbers, nodes.begin(),
                           [](int number) { return NodeIndex::of(number); });
    return nodes;
}

std::vector<int> numbersOf(std::span<const NodeIndex> nodes)
{
    std::vector<int> numbers(nodes.size());
    std::ranges::transform(nodes, numbers.begin(), &NodeIndex::number);
    return numbers;
}

bool isVisitOrder(const TvpProblem& problem, std::span<const NodeIndex> order)
{
    if (static_cast<int>(order.size()) != problem.icebergCount())
        return false;
    std::vector<bool> seen(problem.sigma_m2.size(), false);
    for (const NodeIndex node : order) {
        if (node < 1 || node.number() >= problem.nodeCount() || seen[toIndex(node)])
            return false;
        seen[toIndex(node)] = true;
    }
    return true;
}

double weightedLatency(const Eigen::MatrixXd& distance_m, std::span<const double> sigma_m2,
                       std::span<const NodeIndex> order)
{
    double sum = 0;
    follow(distance_m, Route::Open, order,
           [&](NodeIndex node, double flown_m) { sum += sigma_m2[toIndex(node)] * flown_m; });
    return sum;
}

double flownDistance(const TvpProblem& problem, std::span<const NodeIndex> order)
{
    return follow(problem.distance_m, problem.route, order, [](NodeIndex, double) {});
}

double uncertaintyReward(const TvpProblem& problem, std::span<const NodeIndex> order)
{
    double reward = 0;
    int t = 1; // t(UAV) = 1, Eq. (6)
    for (const NodeIndex node : order) {
        ++t;
        reward += problem.sigma_m2[toIndex(node)] * (problem.nodeCount() - t);
    }
    return reward;
}

double objective(const TvpProblem& problem, std::span<const NodeIndex> order)
{
    require(isVisitOrder(problem, order), "objective: not a visiting order of this problem");
    if (problem.criterion == Criterion::Latency)
        return problem.mu * weightedLatency(problem.distance_m, problem.sigma_m2, order);
    return problem.mu * flownDistance(problem, order) - uncertaintyReward(problem, order);
}

TvpProblem restrictedTo(const TvpProblem& problem, std::span<const NodeIndex> nodes)
{
    const auto size = static_cast<Eigen::Index>(nodes.size()) + 1;
    VisitOrder all{0};
    all.insert(all.end(), nodes.begin(), nodes.end());
    TvpProblem sub{.distance_m = Eigen::MatrixXd(size, size),
                   .sigma_m2 = {},
                   .mu = problem.mu,
                   .route = problem.route,
                   .criterion = problem.criterion};
    for (Eigen::Index j = 0; j < size; ++j)
        for (Eigen::Index i = 0; i < size; ++i)
            sub.distance_m(i, j) = legBetween(problem.distance_m, all[static_cast<std::size_t>(i)],
                                              all[static_cast<std::size_t>(j)]);
    for (const NodeIndex node : all)
        sub.sigma_m2.push_back(problem.sigma_m2[toIndex(node)]);
    return sub;
}

Eigen::MatrixXd euclideanDistances(const Eigen::MatrixX2d& points_m)
{
    const Eigen::Index n = points_m.rows();
    Eigen::MatrixXd distance_m(n, n);
    for (Eigen::Index j = 0; j < n; ++j)
        for (Eigen::Index i = 0; i < n; ++i)
            distance_m(i, j) = std::hypot(points_m(i, 0) - points_m(j, 0), //
                                          points_m(i, 1) - points_m(j, 1));
    return distance_m;
}

namespace {

std::string at(const char* field, Eigen::Index i)
{
    return std::string(field) + '[' + std::to_string(i) + ']';
}

/** Checks along the columns, which is several times faster than by row. */
bool areDistances(const Eigen::MatrixXd& distance_m)
{
    for (Eigen::Index j = 0; j < distance_m.cols(); ++j)
        for (Eigen::Index i = 0; i < distance_m.rows(); ++i)
            if (i != j && !(std::isfinite(distance_m(i, j)) && distance_m(i, j) >= 0))
                return false;
    return true;
}

void validateDistances(const TvpProblem& problem, std::vector<Issue>& issues)
{
    const Eigen::Index n = problem.nodeCount();
    if (problem.distance_m.rows() != n || problem.distance_m.cols() != n) {
        issues.push_back({Severity::Error, "distance_m", {IssueId::NotSquare}});
        return;
    }
    if (areDistances(problem.distance_m))
        return;
    for (Eigen::Index i = 0; i < n; ++i)
        for (Eigen::Index j = 0; j < n; ++j) {
            const double d_m = problem.distance_m(i, j);
            if (i != j && !(std::isfinite(d_m) && d_m >= 0))
                issues.push_back({Severity::Error,
                                  at("distance_m", i) + '[' + std::to_string(j) + ']',
                                  {IssueId::Negative}});
        }
}

/** Costs may reach this, so that every sum and square of them stays finite. */
constexpr double kLargestCost = 1e100;
/** Smaller costs other than 0 would lose digits, as numbers near 1e-308 do. */
constexpr double kSmallestCost = 1e-290;

/** Extremes of the numbers of a problem. */
struct ProblemExtremes
{
    double sum_m2 = 0;
    double least_m2 = std::numeric_limits<double>::infinity(); ///< without zeros
    double longest_m = 0;
    double shortest_m = std::numeric_limits<double>::infinity(); ///< without zeros
};

ProblemExtremes extremesOf(const TvpProblem& problem)
{
    ProblemExtremes found;
    for (const double sigma_m2 : problem.sigma_m2) {
        found.sum_m2 += sigma_m2;
        if (sigma_m2 > 0)
            found.least_m2 = std::min(found.least_m2, sigma_m2);
    }
    for (Eigen::Index j = 0; j < problem.distance_m.cols(); ++j)
        for (Eigen::Index i = 0; i < problem.distance_m.rows(); ++i) {
            const double d_m = problem.distance_m(i, j);
            if (i == j) // the diagonal may hold anything
                continue;
            found.longest_m = std::max(found.longest_m, d_m);
            if (d_m > 0)
                found.shortest_m = std::min(found.shortest_m, d_m);
        }
    return found;
}

/**
 * Checks bounds on the total cost of an order: finite factors may have an infinite product, or one
 * that is nearly 0.
 */
void validateCosts(const TvpProblem& problem, std::vector<Issue>& issues)
{
    const double n = problem.nodeCount();
    const auto [sum_m2, least_m2, longest_m, shortest_m] = extremesOf(problem);
    const auto expect = [&issues](double cost, const char* field) {
        if (!(cost <= kLargestCost))
            issues.push_back({Severity::Error, field, {IssueId::CostTooLarge, {kLargestCost}}});
    };
    const auto expectDigits = [&issues](double cost, const char* field) {
        if (cost < kSmallestCost)
            issues.push_back({Severity::Error, field, {IssueId::CostTooSmall, {kSmallestCost}}});
    };
    expect(n * sum_m2, "sigma");
    expect(n * longest_m, "distance_m");
    expectDigits(least_m2, "sigma");
    const bool isLatency = problem.criterion == Criterion::Latency;
    expect(problem.mu * longest_m * n * (isLatency ? sum_m2 : 1), "mu");
    // Beside a sigma with all its digits, legs that cost next to nothing may lose theirs.
    if (problem.mu > 0 && (isLatency || sum_m2 == 0))
        expectDigits(problem.mu * shortest_m, "mu");
    if (problem.mu > 0 && isLatency)
        expectDigits(std::min(1.0, problem.mu) * shortest_m * least_m2, "mu");
}

} // namespace

std::vector<Issue> validate(const TvpProblem& problem)
{
    std::vector<Issue> issues;
    if (problem.sigma_m2.empty())
        issues.push_back({Severity::Error, "sigma", {IssueId::LeastEntries, {1}}});
    for (std::size_t i = 0; i < problem.sigma_m2.size(); ++i) {
        const double sigma_m2 = problem.sigma_m2[i];
        if (!(std::isfinite(sigma_m2) && sigma_m2 >= 0))
            issues.push_back(
                {Severity::Error, at("sigma", static_cast<Eigen::Index>(i)), {IssueId::Negative}});
        else if (i == 0 && sigma_m2 != 0)
            issues.push_back({Severity::Error, "sigma[0]", {IssueId::SigmaOfUav}});
    }
    validateDistances(problem, issues);
    if (!(std::isfinite(problem.mu) && problem.mu >= 0))
        issues.push_back({Severity::Error, "mu", {IssueId::Negative}});
    if (issues.empty())
        validateCosts(problem, issues);
    return issues;
}

} // namespace berg
