#include "core/base/angles.h"
#include "core/bound/zeta_bound.h"
#include "core/checks/validate.h"
#include "core/mission/mission.h"
#include "core/presets/presets.h"
#include "core/scenario/limits.h"
#include "tests/support/flight/flown_plans.h"

#include <QTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <thread>

using namespace berg;

namespace {

constexpr std::int64_t kSeeds = 3;
constexpr double kLength_s = 4000;
/** Patrols end when less than this is left. */
constexpr double kEnd_s = 1000;

/**
 * Three UAVs of one pad over a sparse field with a fence, in wind that does not change. Some fields
 * have icebergs in pairs, which are seen on the way, and endurances that allow for sorties.
 */
Scenario fencedPatrol(std::int64_t seed)
{
    Random random(static_cast<std::uint64_t>(seed), 57);
    constexpr double kSize_m = 14'000;
    Scenario s =
        randomScenario(seed, {.icebergs = 16, .size_m = {kSize_m, kSize_m}, .speedMax_mps = 0.1});
    for (std::size_t i = 1; i < s.icebergs.size(); i += 2)
        if (random.below(2) == 0) {
            const double away_rad = random.uniform(-kPi, kPi);
            s.icebergs[i].position_m =
                s.icebergs[i - 1].position_m + 700 * Point(std::cos(away_rad), std::sin(away_rad));
        }
    s.duration_s = kLength_s;
    s.planner.policy = PolicyKind::Coverage;
    const double wind_rad = random.uniform(-kPi, kPi);
    s.wind_mps = random.uniform(2, 8) * Point(std::cos(wind_rad), std::sin(wind_rad));
    s.geofence = true;
    constexpr double kBeyond_m = 2500;
    s.area_m = {{-kBeyond_m, -kBeyond_m},
                {kSize_m + kBeyond_m, -kBeyond_m},
                {kSize_m + kBeyond_m, kSize_m + kBeyond_m},
                {-kBeyond_m, kSize_m + kBeyond_m}};
    const Uav first = s.uavs.front();
    s.uavs.clear();
    const bool hasSorties = seed % 2 == 0;
    const Point pad_m(random.uniform(0, kSize_m), random.uniform(0, kSize_m));
    for (int u = 0; u < 3; ++u) {
        Uav uav = first;
        uav.id = "uav-" + std::to_string(u + 1);
        uav.position_m = pad_m;
        uav.home_m = pad_m;
        uav.heading_deg = 120.0 * u;
        uav.spec.altitude_m += kLayerHeight_m * u;
        uav.spec.endurance_s = hasSorties ? 2400 + 120.0 * u : 0;
        uav.turnaround_s = 300;
        s.uavs.push_back(uav);
    }
    return s;
}

/** The flight of a seed: one UAV is lost to the field halfway, when it is ordered home. */
Mission flownPatrol(std::int64_t seed)
{
    constexpr double kLost_s = 1500;
    Mission mission(fencedPatrol(seed), {.workLimit = 50'000, .record = false});
    mission.advance(kLost_s);
    mission.intervene({.time_s = kLost_s,
                       .commanded = UavCommand{.uav = "uav-2", .order = FlightOrder::ReturnNow}});
    mission.advance(kLength_s);
    return mission;
}

/** Returns whether a plan made while patrols are flown has later visits. */
bool fliesPatrols(const Mission& mission)
{
    return std::ranges::any_of(test::flownPlans(mission), [](const test::FlownPlan& plan) {
        return plan.time_s < kLength_s - kEnd_s && !plan.laterVisits.empty();
    });
}

} // namespace

/** Tests patrols with fence, wind, pad, sightings en route and a UAV that drops out. */
class TestPatrolSurroundings : public QObject
{
    Q_OBJECT

private slots:
    void flightsKeepTheirRules()
    {
        for (std::int64_t seed = 1; seed <= kSeeds; ++seed) {
            const QByteArray flight = "seed " + QByteArray::number(seed);
            const Scenario scenario = fencedPatrol(seed);
            QVERIFY2(!hasErrors(validate(scenario)), flight);
            const Mission mission = flownPatrol(seed);
            QVERIFY2(mission.simulation().time_s() == kLength_s, flight);
            QVERIFY2(fliesPatrols(mission), flight);
            for (const MissionEvent& event : mission.events()) {
                QVERIFY2(event.kind != EventKind::LeftFence, flight);
                QVERIFY2(event.kind != EventKind::PlannerFailed, flight);
                QVERIFY2(event.kind != EventKind::LateHome, flight);
            }
            const double bound_m2s = zetaLowerBound(scenario, {.workLimit = 2'000'000}).zeta_m2s;
            QVERIFY2(bound_m2s > 0 && bound_m2s <= mission.metrics().zeta_m2s, flight);
        }
    }

    void flightsAreTheSameInEveryThread()
    {
        std::array<double, kSeeds> together_m2s{};
        {
            std::vector<std::jthread> threads;
            for (std::int64_t seed = 1; seed <= kSeeds; ++seed)
                threads.emplace_back([seed, &together_m2s] {
                    together_m2s[static_cast<std::size_t>(seed - 1)] =
                        flownPatrol(seed).metrics().zeta_m2s;
                });
        }
        for (std::int64_t seed = 1; seed <= kSeeds; ++seed)
            QCOMPARE(flownPatrol(seed).metrics().zeta_m2s,
                     together_m2s[static_cast<std::size_t>(seed - 1)]);
    }
};

QTEST_APPLESS_MAIN(TestPatrolSurroundings)
#include "tst_patrol_surroundings.moc"
