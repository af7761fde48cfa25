#pragma once

#include "core/base/random.h"
#include "core/plan/fleet/fleet_problem.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace berg::test {

// Problems that are legal but that no mission would pose: ties, places and sigmas that agree to the
// last digits, zeros, scales from 1e-12 to 1e9. Proofs about them must still be true. Deterministic
// from the seed.

/** Draws one nasty property at a time. */
class NastyDraw
{
public:
    explicit NastyDraw(std::uint64_t seed) : m_random(seed, 79) {}

    [[nodiscard]] int below(int count)
    {
        return static_cast<int>(m_random.below(static_cast<std::uint64_t>(count)));
    }
    [[nodiscard]] bool oneIn(int count) { return below(count) == 0; }
    [[nodiscard]] double magnitude(double low, double high)
    {
        return std::pow(10.0, m_random.uniform(low, high));
    }
    [[nodiscard]] double scale()
    {
        constexpr std::array kScales{1.0, 1.0, 1.0, 1.0, 1e-3, 1e5, 1e9, 1e-12};
        return kScales[static_cast<std::size_t>(below(static_cast<int>(kScales.size())))];
    }

    /**
     * Returns distances; the first `starts` rows are those of UAVs, which share the columns after
     * them.
     */
    [[nodiscard]] Eigen::MatrixXd distances_m(int places)
    {
        Eigen::MatrixXd d_m = layout(places);
        const int change = below(5);
        const double spread = magnitude(-16, -9);
        for (double& entry_m : d_m.reshaped()) {
            if (change == 0) // wind
                entry_m *= m_random.uniform(1.0, 1.5);
            else if (change == 1) // nearly symmetric, nearly ties
                entry_m *= 1 + spread * m_random.uniform();
            else if (change == 2 && oneIn(6))
                entry_m = 0;
        }
        return scale() * d_m;
    }

    [[nodiscard]] std::vector<double> sigmas_m2(int icebergs)
    {
        const int kind = below(8);
        const double spread = magnitude(-16, -9);
        const double unit = scale();
        std::vector<double> sigma_m2{0.0};
        for (int i = 1; i <= icebergs; ++i)
            sigma_m2.push_back(unit * sigma(kind, spread, i));
        return sigma_m2;
    }

    /** Returns a weight that makes both terms of Eq. (1) count, or only one of them, or none. */
    [[nodiscard]] double mu(const Eigen::MatrixXd& distance_m, const std::vector<double>& sigma_m2)
    {
        constexpr std::array kTradeOffs{1e-9, 0.1, 0.5, 1.0, 3.0, 10.0, 1e3};
        const double tau =
            kTradeOffs[static_cast<std::size_t>(below(static_cast<int>(kTradeOffs.size())))];
        double sigmas_m2 = 0;
        for (const double each_m2 : sigma_m2)
            sigmas_m2 += each_m2;
        const double places = static_cast<double>(distance_m.rows());
        const double usual = tau * sigmas_m2 * places / distance_m.sum();
        if (oneIn(16))
            return 0;
        if (oneIn(6))
            return magnitude(-6, 6);
        return std::isfinite(usual) && usual > 0 ? usual : 1.0;
    }

    [[nodiscard]] VisitOrder shuffled(int count)
    {
        VisitOrder order;
        for (const NodeIndex i : icebergNodes(count))
            order.insert(order.begin() + below(i.number()), i);
        return order;
    }

private:
    [[nodiscard]] double sigma(int kind, double spread, int number)
    {
        switch (kind) {
        case 0: // few values give ties
            return 1 + below(10);
        case 1:
            return 5;
        case 2:
            return 5 * (1 + spread * m_random.uniform());
        case 3:
            return oneIn(3) ? 0 : m_random.uniform(1, 10);
        case 4:
            return number == 1 ? 890 : below(3) == 0 ? 2 : 0;
        case 5:
            return magnitude(-12, 9);
        case 6:
            return oneIn(8) ? 0 : std::pow(10.0, 9 - 7 * below(4)); // 1e9, 1e2, 1e-5, 1e-12
        default:
            return m_random.uniform(1, 10);
        }
    }

    [[nodiscard]] Eigen::MatrixXd layout(int places)
    {
        const int kind = below(9);
        if (kind == 0)
            return Eigen::MatrixXd::Constant(places, places, oneIn(4) ? 0 : 1000);
        Eigen::MatrixXd d_m(places, places);
        Eigen::MatrixX2d points_m(places, 2);
        for (Eigen::Index i = 0; i < places; ++i)
            points_m.row(i) = place(kind, static_cast<int>(i));
        for (Eigen::Index i = 0; i < places; ++i)
            for (Eigen::Index j = 0; j < places; ++j)
                // Violates the triangle inequality.
                d_m(i, j) = kind == 1   ? m_random.uniform(0, 5000)
                            : kind == 2 ? magnitude(-12, 9)
                                        : (points_m.row(i) - points_m.row(j)).norm();
        return d_m;
    }
    [[nodiscard]] Eigen::RowVector2d place(int kind, int number)
    {
        switch (kind) {
        case 3:
            return {500.0 * below(4), 500.0 * below(4)};
        case 4:
            return {100.0 * number, 0};
        case 5: // a few places with icebergs that differ by rounding or not at all
            return {1000.0 * below(3) + (oneIn(2) ? 1e-9 : 0) * m_random.uniform(), 0};
        case 6: // two clusters
            return {(oneIn(2) ? 4000 : 0) + 1e-3 * m_random.uniform(), m_random.uniform(0, 1e-3)};
        default:
            return {m_random.uniform(0, 5000), m_random.uniform(0, 5000)};
        }
    }

    Random m_random;
};

[[nodiscard]] inline TvpProblem nastyProblem(std::uint64_t seed, int icebergs, Criterion criterion)
{
    NastyDraw draw(seed);
    TvpProblem problem{.distance_m = draw.distances_m(icebergs + 1),
                       .sigma_m2 = draw.sigmas_m2(icebergs),
                       .mu = 0,
                       .route = draw.oneIn(3) ? Route::Closed : Route::Open,
                       .criterion = criterion};
    problem.mu = draw.mu(problem.distance_m, problem.sigma_m2);
    return problem;
}

/** Returns UAVs with one start, differing UAVs, or icebergs that only some may visit. */
[[nodiscard]] inline FleetProblem nastyFleet(std::uint64_t seed, int uavs, int icebergs,
                                             Criterion criterion)
{
    NastyDraw draw(seed);
    const Eigen::MatrixXd d_m = draw.distances_m(uavs + icebergs);
    FleetProblem problem{.sigma_m2 = draw.sigmas_m2(icebergs),
                         .mu = draw.mu(d_m, problem.sigma_m2),
                         .route = draw.oneIn(3) ? Route::Closed : Route::Open,
                         .criterion = criterion};
    const bool oneStart = draw.oneIn(4);
    const bool unlike = draw.oneIn(4);
    for (int uav = 0; uav < uavs; ++uav) {
        std::vector<int> nodes{oneStart ? 0 : uav};
        for (int i = 0; i < icebergs; ++i)
            nodes.push_back(uavs + i);
        problem.distance_m.emplace_back((unlike ? 1 + 0.25 * uav : 1.0) * d_m(nodes, nodes));
    }
    if (!draw.oneIn(3))
        return problem;
    const auto columns = static_cast<std::size_t>(icebergs) + 1;
    problem.allowed.assign(static_cast<std::size_t>(uavs), std::vector<bool>(columns, true));
    for (std::size_t i = 1; i < columns; ++i) {
        const int owner = draw.below(uavs);
        for (int uav = 0; uav < uavs; ++uav)
            problem.allowed[static_cast<std::size_t>(uav)][i] = uav == owner || draw.oneIn(2);
    }
    return problem;
}

} // namespace berg::test
