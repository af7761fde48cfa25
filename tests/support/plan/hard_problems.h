#pragma once

#include "tests/support/plan/brute_force.h"

#include <array>
#include <string>
#include <vector>

namespace berg::test {

/** Properties that make a problem hard to prove. */
enum class Oddity
{
    None,
    RealSigmas,  ///< not integers
    ZeroSigmas,  ///< about a third are 0
    EqualSigmas, ///< ties
    Coincident,  ///< pairs of icebergs in one place
    Grid         ///< few different distances: ties
};

inline constexpr std::array kOddities{Oddity::None,        Oddity::RealSigmas, Oddity::ZeroSigmas,
                                      Oddity::EqualSigmas, Oddity::Coincident, Oddity::Grid};
inline constexpr std::array kTaus{0.0, 0.25, 0.5, 1.0, 3.0, 10.0};

/** Returns the problem with the oddity; deterministic from the seed. */
inline TvpProblem madeOdd(TvpProblem problem, Oddity oddity, std::uint64_t seed)
{
    Random random(seed, 78);
    const int n = problem.icebergCount();
    Eigen::MatrixXd& d = problem.distance_m;
    switch (oddity) {
    case Oddity::None:
        break;
    case Oddity::RealSigmas:
        for (std::size_t i = 1; i < problem.sigma_m2.size(); ++i)
            problem.sigma_m2[i] *= random.uniform(0.1, 1);
        break;
    case Oddity::ZeroSigmas:
        for (std::size_t i = 1; i < problem.sigma_m2.size(); ++i)
            if (random.below(3) == 0)
                problem.sigma_m2[i] = 0;
        break;
    case Oddity::EqualSigmas:
        std::fill(problem.sigma_m2.begin() + 1, problem.sigma_m2.end(), 5.0);
        break;
    case Oddity::Coincident:
        for (int j = 2; j <= n; j += 2) {
            d.row(j) = d.row(j - 1);
            d.col(j) = d.col(j - 1);
            d(j, j) = d(j, j - 1) = d(j - 1, j) = 0;
        }
        break;
    case Oddity::Grid:
        for (int i = 0; i <= n; ++i)
            for (int j = 0; j <= n; ++j)
                d(i, j) = 500.0 * (std::abs(i % 4 - j % 4) + std::abs(i / 4 - j / 4));
        break;
    }
    return problem;
}

/** Returns the variants of a size: numbers 0, 1, 2, … go through tau, route, wind and oddity. */
inline TvpProblem variedProblem(int icebergs, int number)
{
    const auto seed = static_cast<std::uint64_t>(1000 * icebergs + number);
    const double tau = kTaus[static_cast<std::size_t>(number) % kTaus.size()];
    const Route route = number / 6 % 2 == 0 ? Route::Open : Route::Closed;
    const bool asymmetric = number / 12 % 2 == 1;
    const Oddity oddity = kOddities[static_cast<std::size_t>(number / 24) % kOddities.size()];
    return madeOdd(randomProblem(seed, icebergs, tau, route, asymmetric), oddity, seed);
}

/** Returns the same variants for latency, which has no tau: mu is 1 / airspeed. */
inline TvpProblem variedLatencyProblem(int icebergs, int number)
{
    TvpProblem problem = variedProblem(icebergs, number);
    problem.criterion = Criterion::Latency;
    problem.mu = 1 / 22.0;
    return problem;
}

} // namespace berg::test
