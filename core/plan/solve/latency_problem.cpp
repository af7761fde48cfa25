#include "core/plan/solve/latency_problem.h"

#include <algorithm>

namespace berg {

TvpProblem latencyProblem(TvpProblem problem)
{
    problem.criterion = Criterion::Latency;
    problem.route = Route::Open;
    problem.mu = 1;
    const auto isZero = [](double sigma_m2) { return sigma_m2 == 0; };
    if (std::ranges::all_of(problem.sigma_m2, isZero) && !problem.sigma_m2.empty())
        std::fill(problem.sigma_m2.begin() + 1, problem.sigma_m2.end(), 1.0);
    return problem;
}

TvpProblem withReturn(const TvpProblem& problem)
{
    constexpr double kSigmaOfReturn_m2 = 1;
    require(problem.criterion == Criterion::Latency, "withReturn: needs the criterion latency");
    double least_m2 = kSigmaOfReturn_m2;
    for (std::size_t i = 1; i < problem.sigma_m2.size(); ++i)
        least_m2 = std::min(least_m2, problem.sigma_m2[i]);
    require(least_m2 > 0, "withReturn: every iceberg needs a sigma above 0");

    const Eigen::Index n = problem.nodeCount();
    TvpProblem extended = problem;
    extended.sigma_m2.push_back(kSigmaOfReturn_m2);
    extended.distance_m = Eigen::MatrixXd::Zero(n + 1, n + 1);
    extended.distance_m.topLeftCorner(n, n) = problem.distance_m;
    extended.distance_m.diagonal().setZero(); // the diagonal of the problem may hold anything
    const double longest_m = extended.distance_m.maxCoeff();
    extended.distance_m.col(n).head(n) = extended.distance_m.col(0).head(n);
    extended.distance_m.row(n).head(n).setConstant(2 * (1 + 1 / least_m2) * longest_m);
    return extended;
}

void putReturnLast(const TvpProblem& withReturn, SolveOutcome& outcome)
{
    if (outcome.status == SolveStatus::None)
        return;
    VisitOrder& order = outcome.plan.front();
    const auto place = std::ranges::find(order, NodeIndex::of(withReturn.icebergCount()));
    std::rotate(place, place + 1, order.end());
    outcome.objective = objective(withReturn, order);
    if (outcome.bound)
        outcome.bound = std::min(*outcome.bound, outcome.objective);
}

} // namespace berg
