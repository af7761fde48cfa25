#pragma once

#include "core/base/random.h"
#include "core/scenario/scenario.h"
#include "core/tracking/drift.h"
#include "core/tracking/observer.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

namespace berg::test {

/**
 * Flights better than those of any UAV: points that turn on the spot, may hover, know the true
 * positions, and have their cameras at the best heading for each iceberg at once. Searches flights
 * of low zeta or of low final sigma, and records the lowest sum of sigma at each step.
 */
class IdealFlights
{
public:
    explicit IdealFlights(const Scenario& scenario)
        : m_scenario(scenario)
        , m_steps(static_cast<std::size_t>(std::llround(scenario.duration_s / scenario.dt_s)))
        , m_lowestSigma_m2(m_steps + 1, 1e300)
    {
        for (const Iceberg& iceberg : scenario.icebergs) {
            DriftModel drift({.position_m = iceberg.position_m,
                              .velocity_mps = iceberg.velocity_mps + scenario.current_mps,
                              .q_m2ps = iceberg.q_m2ps,
                              .track = iceberg.track.empty()
                                           ? nullptr
                                           : std::make_shared<const RecordedTrack>(iceberg.track)},
                             static_cast<std::uint64_t>(scenario.seed), iceberg.id, scenario.noise);
            m_truth_m.emplace_back();
            for (std::size_t k = 0; k <= m_steps; ++k)
                m_truth_m.back().push_back(
                    drift.position_m(static_cast<double>(k) * scenario.dt_s));
        }
    }

    /** Runs simulated annealing from random flights; returns the lowest zeta of all flown. */
    double search(std::uint64_t seed, int flights, bool forLastSigma)
    {
        Random random(seed);
        Plan plan = draw(random);
        double value = flown(plan).value(forLastSigma);
        const double hot = 0.05 * value;
        for (int i = 0; i < flights; ++i) {
            Plan next = plan;
            change(next, random);
            const double nextValue = flown(next).value(forLastSigma);
            const double left = 1 - static_cast<double>(i) / flights;
            if (nextValue <= value - hot * left * left * std::log(1 - random.uniform()) * 0.1) {
                plan = std::move(next);
                value = nextValue;
            }
        }
        return m_lowestZeta_m2s;
    }

    /** Lowest sum of sigma by step, over all flights so far. */
    [[nodiscard]] const std::vector<double>& lowestSigma_m2() const { return m_lowestSigma_m2; }

private:
    /** A place beside an iceberg, drifting with it. */
    struct Aim
    {
        std::size_t iceberg = 0;
        Point offset_m = Point::Zero();
    };
    using Aims = std::vector<Aim>;  // flown in turn, repeatedly
    using Plan = std::vector<Aims>; // by UAV

    struct Flown
    {
        double zeta_m2s = 0;
        double lastSigma_m2 = 0;
        [[nodiscard]] double value(bool forLastSigma) const
        {
            return forLastSigma ? lastSigma_m2 : zeta_m2s;
        }
    };

    [[nodiscard]] bool sees(const Uav& uav, const Point& off_m) const
    {
        const Point half_m = uav.fov_m / 2;
        switch (m_scenario.fovShape) {
        case FovShape::Body:
            return off_m.norm() <= half_m.norm();
        case FovShape::North:
            return std::abs(off_m.x()) <= half_m.y() && std::abs(off_m.y()) <= half_m.x();
        case FovShape::Disk:
            break;
        }
        return off_m.norm() <= half_m.x();
    }

    [[nodiscard]] Aim drawAim(Random& random) const
    {
        const double reach_m = m_scenario.uavs[0].fov_m.norm() / 2;
        return {.iceberg = random.below(m_truth_m.size()),
                .offset_m = {random.uniform(-reach_m, reach_m), random.uniform(-reach_m, reach_m)}};
    }
    [[nodiscard]] Plan draw(Random& random) const
    {
        Plan plan(m_scenario.uavs.size());
        for (Aims& aims : plan)
            for (std::size_t i = 0; i < 2 * m_truth_m.size(); ++i)
                aims.push_back(drawAim(random));
        return plan;
    }
    void change(Plan& all, Random& random) const
    {
        Aims& plan = all[all.size() == 1 ? 0 : random.below(all.size())];
        const auto at = [&]() -> Aim& { return plan[random.below(plan.size())]; };
        switch (random.below(6)) {
        case 0:
            at() = drawAim(random);
            break;
        case 1:
            std::swap(at(), at());
            break;
        case 2:
            plan.push_back(drawAim(random));
            std::rotate(plan.begin() + static_cast<std::ptrdiff_t>(random.below(plan.size())),
                        plan.end() - 1, plan.end());
            break;
        case 3:
            if (plan.size() > 1)
                plan.erase(plan.begin() + static_cast<std::ptrdiff_t>(random.below(plan.size())));
            break;
        default:
            at().offset_m += 60 * Point(random.normal(), random.normal());
        }
    }

    Flown flown(const Plan& plan)
    {
        const double dt_s = m_scenario.dt_s;
        std::vector<Point> uavs_m;
        for (const Uav& uav : m_scenario.uavs)
            uavs_m.push_back(uav.position_m);
        std::vector<std::size_t> next(plan.size(), 0);
        Flown result;
        std::vector<double> sigma_m2;
        for (const Iceberg& iceberg : m_scenario.icebergs)
            sigma_m2.push_back(initialSigma_m2(iceberg));
        for (std::size_t k = 0; k <= m_steps; ++k) {
            for (std::size_t u = 0; k > 0 && u < plan.size(); ++u) {
                const double step_m = m_scenario.uavs[u].spec.airspeed_mps * dt_s;
                const Aim& aim = plan[u][next[u] % plan[u].size()];
                const Point air_m = m_truth_m[aim.iceberg][k] + aim.offset_m - uavs_m[u] -
                                    m_scenario.wind_mps * dt_s;
                const bool there = air_m.norm() <= step_m;
                uavs_m[u] += m_scenario.wind_mps * dt_s +
                             (there ? air_m : Point(air_m * (step_m / air_m.norm())));
                next[u] += there ? 1 : 0;
            }
            result.lastSigma_m2 = observe(k, uavs_m, sigma_m2);
            if (k > 0) {
                m_lowestSigma_m2[k] = std::min(m_lowestSigma_m2[k], result.lastSigma_m2);
                result.zeta_m2s += result.lastSigma_m2 * dt_s;
            }
        }
        m_lowestZeta_m2s = std::min(m_lowestZeta_m2s, result.zeta_m2s);
        return result;
    }

    /**
     * Updates sigma by (22)-(23) at step k; returns the sum over the icebergs that have appeared.
     */
    double observe(std::size_t k, const std::vector<Point>& uavs_m,
                   std::vector<double>& sigma_m2) const
    {
        double sum_m2 = 0;
        for (std::size_t i = 0; i < m_truth_m.size(); ++i) {
            const Iceberg& iceberg = m_scenario.icebergs[i];
            if (k > 0)
                sigma_m2[i] += iceberg.q_m2ps * m_scenario.dt_s;
            if (std::llround(iceberg.appears_s / m_scenario.dt_s) > static_cast<long long>(k))
                continue;
            for (std::size_t u = 0; u < uavs_m.size(); ++u)
                if (sees(m_scenario.uavs[u], m_truth_m[i][k] - uavs_m[u]))
                    sigma_m2[i] = 0;
            sum_m2 += sigma_m2[i];
        }
        return sum_m2;
    }

    const Scenario& m_scenario;
    std::size_t m_steps;
    std::vector<std::vector<Point>> m_truth_m; ///< by iceberg and step
    std::vector<double> m_lowestSigma_m2;
    double m_lowestZeta_m2s = 1e300;
};

} // namespace berg::test
