#include "core/bound/ground_time.h"

#include "core/base/angles.h"
#include "core/scenario/fence.h"
#include "core/vehicle/safety_guard.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace berg {

namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

/**
 * Returns whether there is a single UAV with an endurance that returns home in time whatever its
 * orders.
 */
bool isSureOfHome(const Scenario& scenario)
{
    if (scenario.uavs.size() != 1 || !sortieOf(scenario.uavs.front()))
        return false;
    const Uav& uav = scenario.uavs.front();
    GuardedUav guarded{.motion = {.airspeed_mps = uav.spec.airspeed_mps,
                                  .limit_radps = maxTurnRate_radps(uav.spec),
                                  .wind_mps = scenario.wind_mps},
                       .sortie = sortieOf(uav),
                       .clock = {.dt_s = scenario.dt_s,
                                 .steps = std::max<std::int64_t>(
                                     1, std::llround(uav.spec.autopilot_s / scenario.dt_s))}};
    if (fenceOf(scenario, uav.spec.altitude_m, guarded.motion) ||
        uav.spec.autopilot_s > kSlowestHoming_s)
        return false;
    const DubinsState pose{.position_m = uav.position_m,
                           .psi_rad = psiFromHeading(uav.heading_deg)};
    return SafetyGuard(std::move(guarded)).homeMargin_s(pose, 0, 0).value_or(-1) >= 0;
}

class GroundTimes
{
public:
    GroundTimes(const Scenario& scenario, const TrueMotion& motion,
                const std::vector<double>& sigma_m2)
        : m_scenario(scenario)
        , m_motion(motion)
        , m_sigma_m2(sigma_m2)
        , m_sortie(*sortieOf(scenario.uavs.front()))
        , m_atTakeOff_m2s(sigma_m2.size() + 1, kNever)
        , m_least_m2s(sigma_m2.size(), kNever)
    {
        m_atTakeOff_m2s.front() = 0; // aloft at the start
    }

    std::vector<double> least_m2s()
    {
        for (int block = 0; block < m_motion.blocks(); ++block) {
            const double aloft_m2s = aloft(block);
            double& least_m2s = m_least_m2s[static_cast<std::size_t>(block)];
            least_m2s = std::min(least_m2s, aloft_m2s);
            if (aloft_m2s < kNever)
                stand(block, aloft_m2s);
        }
        return std::move(m_least_m2s);
    }

private:
    /**
     * Returns the least cost of being in the air in this block, with the last take-off within the
     * endurance.
     */
    [[nodiscard]] double aloft(int block) const
    {
        constexpr double kSlack_s = 2 + kHomeReserve_s;
        double least_m2s = kNever;
        for (int from = block;
             from >= 0 &&
             m_motion.edge_s(block) <= m_motion.edge_s(from + 1) + m_sortie.endurance_s + kSlack_s;
             --from)
            least_m2s = std::min(least_m2s, m_atTakeOff_m2s[static_cast<std::size_t>(from)]);
        return least_m2s;
    }

    [[nodiscard]] double growth_m2ps(int block) const
    {
        double growth_m2ps = 0;
        for (const Iceberg& iceberg : m_scenario.icebergs)
            growth_m2ps += iceberg.appears_s <= m_motion.edge_s(block) ? iceberg.q_m2ps : 0;
        return growth_m2ps;
    }

    /** Adds the costs of landing in this block and standing in the next ones until take-off. */
    void stand(int landing, double cost_m2s)
    {
        const double dt_s = m_scenario.dt_s;
        const double growth_m2ps = this->growth_m2ps(landing);
        const double until_s = m_motion.edge_s(landing) + m_sortie.turnaround_s - 2 * dt_s;
        double sigma_m2 = m_sigma_m2[static_cast<std::size_t>(landing)] + growth_m2ps * dt_s;
        for (int block = landing + 1; block < m_motion.blocks(); ++block) {
            const auto k = static_cast<std::size_t>(block);
            const double length_s = m_motion.edge_s(block + 1) - m_motion.edge_s(block);
            if (m_motion.edge_s(block + 1) >= until_s)
                m_atTakeOff_m2s[k] = std::min(m_atTakeOff_m2s[k], cost_m2s);
            sigma_m2 = std::max(sigma_m2, m_sigma_m2[k]);
            cost_m2s += (sigma_m2 - m_sigma_m2[k]) * length_s;
            m_least_m2s[k] = std::min(m_least_m2s[k], cost_m2s);
            sigma_m2 += growth_m2ps * length_s;
        }
    }

    const Scenario& m_scenario;
    const TrueMotion& m_motion;
    const std::vector<double>& m_sigma_m2;
    SortieSpec m_sortie;
    std::vector<double> m_atTakeOff_m2s; ///< Least cost for each block of take-off.
    std::vector<double> m_least_m2s;     ///< Least cost by the end of each block.
};

} // namespace

std::vector<double> groundCosts_m2s(const Scenario& scenario, const TrueMotion& motion,
                                    const std::vector<double>& sigma_m2)
{
    if (!isSureOfHome(scenario))
        return std::vector<double>(sigma_m2.size(), 0.0);
    return GroundTimes(scenario, motion, sigma_m2).least_m2s();
}

} // namespace berg
