#pragma once

#include "core/base/angles.h"
#include "core/base/random.h"
#include "core/checks/validate.h"
#include "core/presets/presets.h"
#include "core/scenario/limits.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace berg::test {

/**
 * Two to five UAVs that share pads: they start on a pad or near it at the same time, and must land
 * on it; wind, fences, no-fly areas, altitude layers and equal or similar endurances are drawn at
 * random.
 */
class PadFleet
{
public:
    explicit PadFleet(std::int64_t seed) : m_random(static_cast<std::uint64_t>(seed), 41)
    {
        const double size_m = m_random.uniform(3000, 6000);
        m_scenario = randomScenario(seed, {.icebergs = 3 + static_cast<int>(m_random.below(13)),
                                           .size_m = {size_m, 0.8 * size_m}});
        m_scenario.duration_s = 2400;
        m_scenario.separation_m = m_random.uniform(50, 250);
        constexpr std::array kPolicies{PolicyKind::Visitation, PolicyKind::Latency,
                                       PolicyKind::Nearest, PolicyKind::Tour};
        m_scenario.planner.policy = kPolicies[m_random.below(kPolicies.size())];
        if (oneIn(2)) {
            const double from_rad = m_random.uniform(-kPi, kPi);
            m_scenario.wind_mps =
                m_random.uniform(0, 9) * Point(std::cos(from_rad), std::sin(from_rad));
        }
        drawUavs(size_m);
        if (oneIn(3))
            drawFence(size_m);
        if (oneIn(3))
            drawAreas(size_m);
    }

    [[nodiscard]] const Scenario& scenario() const { return m_scenario; }

private:
    bool oneIn(std::uint64_t count) { return m_random.below(count) == 0; }

    void drawUavs(double size_m)
    {
        const Uav first = m_scenario.uavs.front();
        m_scenario.uavs.clear();
        const auto count = 2 + m_random.below(4);
        // at least two UAVs of each pad and layer
        const std::uint64_t pads = count >= 4 && oneIn(3) ? 2 : 1;
        const std::uint64_t layers = count >= 4 && pads == 1 && oneIn(3) ? 2 : 1;
        const bool isAlike = !oneIn(3);
        const bool isOnPad = !oneIn(4);
        const double endurance_s = m_random.uniform(700, 1300);
        const double airspeed_mps = m_random.uniform(18, 26);
        const double autopilot_s = oneIn(3) ? 1 : 0;
        const double percent = oneIn(4) ? m_random.uniform(8, 20) : first.spec.reservePercent;
        const Point pad_m(m_random.uniform(0, size_m), m_random.uniform(-600, 0));
        for (std::uint64_t i = 0; i < count; ++i) {
            Uav uav = first;
            uav.id = "uav-" + std::to_string(i + 1);
            uav.spec.airspeed_mps = isAlike ? airspeed_mps : m_random.uniform(18, 26);
            uav.spec.autopilot_s = autopilot_s;
            uav.spec.altitude_m += static_cast<double>(i % layers) * kLayerHeight_m;
            uav.spec.endurance_s = endurance_s + (isAlike ? 0 : m_random.uniform(-40, 40));
            uav.spec.reservePercent = percent;
            uav.turnaround_s = m_random.uniform(20, 200);
            uav.home_m = pad_m + Point(1500.0 * static_cast<double>(i % pads), 0);
            uav.position_m = *uav.home_m;
            uav.heading_deg = isAlike ? 20 : m_random.uniform(0, 360);
            if (!isOnPad) { // aloft near the pad and leaving it
                const double away_rad = m_random.uniform(-kPi, kPi);
                uav.position_m +=
                    m_random.uniform(0, 400) * Point(std::cos(away_rad), std::sin(away_rad));
                uav.heading_deg = headingFromPsi(away_rad + m_random.uniform(-0.1, 0.1));
            }
            m_scenario.uavs.push_back(uav);
        }
    }

    void drawFence(double size_m)
    {
        m_scenario.geofence = true;
        const double beyond_m = m_random.uniform(1500, 2500);
        m_scenario.area_m = {{-beyond_m, -beyond_m},
                             {size_m + beyond_m, -beyond_m},
                             {size_m + beyond_m, size_m + beyond_m}};
        if (oneIn(2)) // a corner pointing inwards
            m_scenario.area_m.push_back({size_m / 2, m_random.uniform(0.5, 1) * size_m});
        m_scenario.area_m.push_back({-beyond_m, size_m + beyond_m});
    }

    /** Draws areas clear of the pads. */
    void drawAreas(double size_m)
    {
        const auto count = 1 + m_random.below(4);
        for (std::uint64_t i = 0; i < count; ++i) {
            const double radius_m = m_random.uniform(150, 600);
            const Point middle_m(m_random.uniform(0, size_m), m_random.uniform(0, 0.8 * size_m));
            if (std::ranges::any_of(m_scenario.uavs, [&](const Uav& uav) {
                    return std::min((uav.position_m - middle_m).norm(),
                                    (*uav.home_m - middle_m).norm()) < radius_m + 900;
                }))
                continue;
            NoFlyArea area{.name = "area-" + std::to_string(i + 1)};
            for (int k = 0; k < 5; ++k) {
                const double angle_rad = 2 * kPi * (k + m_random.uniform(-0.3, 0.3)) / 5;
                area.corners_m.push_back(middle_m +
                                         m_random.uniform(0.5, 1) * radius_m *
                                             Point(std::cos(angle_rad), std::sin(angle_rad)));
            }
            m_scenario.noFly.push_back(std::move(area));
        }
    }

    Random m_random;
    Scenario m_scenario;
};

/** Returns the fleet of the seed if it can be flown: no errors, and paths home for each UAV. */
[[nodiscard]] inline std::optional<Scenario> flyablePadFleet(std::int64_t seed)
{
    Scenario scenario = PadFleet(seed).scenario();
    const std::vector<Issue> issues = validate(scenario);
    constexpr std::array kUnfit{IssueId::NoPathHome, IssueId::NoSafeReturn, IssueId::NoRoundTrip,
                                IssueId::HomeNearFence, IssueId::StartNearFence};
    if (hasErrors(issues) || std::ranges::any_of(issues, [&](const Issue& issue) {
            return std::ranges::find(kUnfit, issue.reason.id) != kUnfit.end();
        }))
        return std::nullopt;
    return scenario;
}

/** Returns whether `validate` warns of UAVs that get into each other's way. */
[[nodiscard]] inline bool isWarnedOfCrowd(const Scenario& scenario)
{
    constexpr std::array kCrowds{IssueId::SameLayer, IssueId::CrowdedReturn, IssueId::RecoverySlot};
    return std::ranges::any_of(validate(scenario), [&](const Issue& issue) {
        return issue.severity == Severity::Warning &&
               std::ranges::find(kCrowds, issue.reason.id) != kCrowds.end();
    });
}

} // namespace berg::test
