#include "core/base/angles.h"
#include "core/bound/zeta_bound.h"
#include "core/checks/validate.h"
#include "core/io/files/run_json.h"
#include "core/mission/mission_instant.h"
#include "core/mission/sortie_outlook.h"
#include "core/mission/visits.h"
#include "core/presets/presets.h"
#include "tests/support/approx.h"
#include "tests/support/files/file_texts.h"
#include "tests/support/flight/scenario_builder.h"
#include "tests/support/flight/weather_builder.h"

#include <QtTest>

#include <algorithm>
#include <cmath>
#include <thread>

using namespace berg;
using namespace berg::test;

namespace {

constexpr double kHour_s = 3600;
constexpr double kEndurance_s = 5400;

/** Wind that turns and grows, and a tide that differs from place to place. */
ForecastEntry tideAndWind(const LatLon& place, double hours)
{
    const double angle_rad = 0.7 * hours;
    const double share = place.latitude_deg - std::floor(place.latitude_deg);
    return {.time = {},
            .wind_mps = Point((2 + hours) * Point(std::cos(angle_rad), std::sin(angle_rad))),
            .current_mps = Point(0.2 * std::sin(2 * kPi * hours / 12.4), 0.1 + 0.1 * share)};
}

/** Adds a second UAV, which starts beside the first. */
Scenario withTwoUavs(Scenario scenario)
{
    scenario.uavs.push_back(scenario.uavs.front());
    scenario.uavs.back().id = "second";
    scenario.uavs.back().position_m += Point(1500, 0);
    return scenario;
}

/** Two UAVs with sorties, over icebergs that wind and current carry. */
Scenario fleetInWeather(ObserverModel model, PolicyKind policy)
{
    Scenario scenario =
        withTwoUavs(randomScenario(5, {.icebergs = 8, .size_m = Point(9000, 9000)}));
    scenario.duration_s = 3 * kHour_s;
    scenario.dt_s = 0.5;
    scenario.observer.model = model;
    scenario.planner.policy = policy;
    for (Uav& uav : scenario.uavs)
        uav.spec.endurance_s = kEndurance_s;
    for (std::size_t i = 0; i < scenario.icebergs.size(); i += 2)
        scenario.icebergs[i].length_m = 40.0 + 20.0 * static_cast<double>(i);
    if (model == ObserverModel::Kalman)
        letVelocitiesChange(scenario);
    letWeatherChange(scenario, 3, 5, tideAndWind);
    return scenario;
}

Mission flownIn(const Scenario& scenario, double until_s)
{
    Mission mission(scenario, {.workLimit = 20'000, .keyframeInterval_s = 600});
    mission.advance(until_s);
    return mission;
}

/** A forecast whose wind and current are always those of the scenario. */
Scenario withConstantForecast(Scenario scenario, int places)
{
    const Point wind_mps = scenario.wind_mps;
    const Point current_mps = scenario.current_mps;
    letWeatherChange(scenario, places, 9, [&](const LatLon&, double) {
        return ForecastEntry{.time = {}, .wind_mps = wind_mps, .current_mps = current_mps};
    });
    return scenario;
}

bool isSameFlight(const Mission& a, const Mission& b)
{
    const WorldState first = a.simulation().state();
    const WorldState second = b.simulation().state();
    bool isSame = a.metrics() == b.metrics() && first.uavs == second.uavs &&
                  a.events().size() == b.events().size() && a.plans().size() == b.plans().size();
    for (const IcebergIndex i : a.simulation().icebergs())
        isSame = isSame && a.simulation().truth_m(i) == b.simulation().truth_m(i) &&
                 first.tracks[toIndex(i)].variances() == second.tracks[toIndex(i)].variances() &&
                 a.simulation().observer().estimate_m(i) == b.simulation().observer().estimate_m(i);
    return isSame;
}

} // namespace

/** Flights in a wind and a current that change. */
class TestChangingWeather : public QObject
{
    Q_OBJECT

private slots:
    void aConstantForecastChangesNothing_data()
    {
        QTest::addColumn<int>("model");
        QTest::addColumn<int>("policy");
        QTest::addColumn<double>("endurance");
        QTest::addColumn<bool>("geofence");
        const auto simple = static_cast<int>(ObserverModel::Simple);
        const auto kalman = static_cast<int>(ObserverModel::Kalman);
        const auto visitation = static_cast<int>(PolicyKind::Visitation);
        const auto coverage = static_cast<int>(PolicyKind::Coverage);
        QTest::newRow("simple") << simple << visitation << 0.0 << false;
        QTest::newRow("sorties") << simple << visitation << 1800.0 << false;
        QTest::newRow("geofence") << simple << visitation << 1800.0 << true;
        QTest::newRow("kalman") << kalman << visitation << 1800.0 << false;
        QTest::newRow("coverage") << simple << coverage << 0.0 << false;
    }

    void aConstantForecastChangesNothing()
    {
        QFETCH(int, model);
        QFETCH(int, policy);
        QFETCH(double, endurance);
        QFETCH(bool, geofence);
        Scenario scenario = withTwoUavs(randomScenario(11, {.icebergs = 6}));
        scenario.duration_s = 2000;
        scenario.wind_mps = {4, -3};
        scenario.current_mps = {0.15, 0.05};
        scenario.observer.model = static_cast<ObserverModel>(model);
        scenario.planner.policy = static_cast<PolicyKind>(policy);
        scenario.geofence = geofence;
        scenario.area_m = {{-6000, -6000}, {16000, -6000}, {16000, 16000}, {-6000, 16000}};
        for (Uav& uav : scenario.uavs)
            uav.spec.endurance_s = endurance;
        if (scenario.observer.model == ObserverModel::Kalman)
            letVelocitiesChange(scenario);
        scenario.icebergs[1].appears_s = 700;
        const Mission constant = flownIn(scenario, scenario.duration_s);
        QVERIFY(isSameFlight(constant, flownIn(withConstantForecast(scenario, 1), 2000)));
        QVERIFY(isSameFlight(constant, flownIn(withConstantForecast(scenario, 3), 2000)));
    }

    /** A UAV that flies against a wind of 0 to 12 m/s arrives when U t - a t^2 / 2 is its distance.
     */
    void legsTakeTheTimeOfTheWind()
    {
        const double a = 12 / kHour_s;
        constexpr double kView_m = 100;
        for (const double way_m : {10'000.0, 30'000.0, 50'000.0}) {
            Scenario scenario = emptySea(kHour_s);
            scenario.uavs[0].fov_m = {2 * kView_m, 2 * kView_m};
            addIceberg(scenario, way_m, 0).q_m2ps = 1;
            letWeatherChange(scenario, 1, 2, growingWind({-12, 0}));
            const double u = scenario.uavs[0].spec.airspeed_mps;
            const auto time_s = [&](double to_m) {
                return (u - std::sqrt(u * u - 2 * a * to_m)) / a;
            };
            COMPARE_NEAR(plannedVisits(scenario, {IcebergIndex::of(0)}, {}).front().time_s,
                         time_s(way_m), 0.001 * time_s(way_m));
            Mission mission(scenario);
            while (mission.metrics().visits == 0 && !mission.simulation().finished())
                mission.advance(mission.simulation().time_s() + 1);
            QCOMPARE(mission.metrics().visits, 1);
            COMPARE_NEAR(mission.simulation().time_s(), time_s(way_m - kView_m),
                         0.01 * time_s(way_m));
        }
    }

    void theOutlookKnowsTheWindOfTheWayBack()
    {
        Scenario scenario = emptySea(kHour_s);
        Uav& uav = scenario.uavs[0];
        uav.spec.endurance_s = 7200;
        letWeatherChange(scenario, 1, 3, growingWind({-12, 0}));
        const PlannedPath path{.places_m = {Point(0, 0), Point(-20'000, 0)},
                               .thisSortie = 2,
                               .aloft_s = 0,
                               .wind_mps = windFromStart(scenario),
                               .fence = nullptr};
        const SortieOutlook outlook = sortieOutlook(scenario, uav, path);
        // Out with the wind, back against what it has become.
        const double a = 12 / kHour_s;
        const double u = uav.spec.airspeed_mps;
        const double out_s = (-u + std::sqrt(u * u + 2 * a * 20'000)) / a;
        const double left = u - a * out_s;
        const double back_s = (left - std::sqrt(left * left - 2 * a * 20'000)) / a;
        const double margin_s = usableEndurance_s(uav.spec) - out_s - back_s;
        COMPARE_NEAR(*outlook.margin_s, margin_s, 0.01 * (out_s + back_s));
    }

    /** Wherever the wind goes, the UAV is home in time: no event says otherwise. */
    void safeReturnInARisingWind()
    {
        for (const bool geofence : {false, true})
            for (int direction = 0; direction < 6; ++direction) {
                const double angle_rad = direction * kPi / 3;
                Scenario scenario = randomScenario(20 + direction, {.icebergs = 10});
                scenario.duration_s = 1.5 * kHour_s;
                scenario.dt_s = 0.5;
                scenario.uavs[0].spec.endurance_s = 2400;
                scenario.planner.policy = PolicyKind::Uncertainty; // the longest legs
                if (geofence) {
                    scenario.geofence = true;
                    scenario.area_m = {{-9000, -9000}, {9000, -9000}, {9000, 9000}, {-9000, 9000}};
                }
                letWeatherChange(scenario, 1, 3,
                                 growingWind(10 * Point(std::cos(angle_rad), std::sin(angle_rad))));
                const Mission mission = flownIn(scenario, scenario.duration_s);
                int landings = 0;
                for (const MissionEvent& event : mission.events()) {
                    QVERIFY(event.kind != EventKind::LateHome);
                    QVERIFY(event.kind != EventKind::LeftFence);
                    landings += event.kind == EventKind::Landed ? 1 : 0;
                }
                QVERIFY(landings >= 1);
            }
    }

    void flightsAreRepeatedBitForBit_data()
    {
        QTest::addColumn<int>("model");
        QTest::addColumn<int>("policy");
        QTest::newRow("simple") << static_cast<int>(ObserverModel::Simple)
                                << static_cast<int>(PolicyKind::Visitation);
        QTest::newRow("kalman") << static_cast<int>(ObserverModel::Kalman)
                                << static_cast<int>(PolicyKind::Visitation);
        QTest::newRow("coverage") << static_cast<int>(ObserverModel::Kalman)
                                  << static_cast<int>(PolicyKind::Coverage);
    }

    /** A flight is the same on another thread, restored at an earlier instant, and flown again from
     * its file.
     */
    void flightsAreRepeatedBitForBit()
    {
        QFETCH(int, model);
        QFETCH(int, policy);
        Scenario scenario =
            fleetInWeather(static_cast<ObserverModel>(model), static_cast<PolicyKind>(policy));
        if (scenario.planner.policy == PolicyKind::Coverage)
            scenario.duration_s = 1500;
        const double end_s = scenario.duration_s;
        const Mission mission = flownIn(scenario, end_s);
        QVERIFY(mission.metrics().visits > 3);
        std::optional<Mission> other;
        std::thread([&] { other.emplace(flownIn(scenario, end_s)); }).join();
        QVERIFY(isSameFlight(mission, *other));
        for (const double share : {0.31, 0.77}) {
            const double then_s = std::floor(share * end_s);
            const MissionInstant instant = instantAt(mission, then_s);
            const Mission then = flownIn(scenario, then_s);
            QVERIFY(instant.simulation.state() == then.simulation().state());
            QVERIFY(instant.metrics == then.metrics());
        }
        const RunFile run = runOf(mission);
        QVERIFY(runFromJson(runToJson(run), "run") == run);
        const Mission again = replay(run);
        QVERIFY(isSameFlight(mission, again));
    }

    /** A report of the crew replaces the forecast for the UAVs, not for the icebergs. */
    void reportedWindOverridesTheForecast()
    {
        Scenario scenario = fleetInWeather(ObserverModel::Simple, PolicyKind::Visitation);
        scenario.duration_s = kHour_s;
        const Mission without = flownIn(scenario, scenario.duration_s);
        Mission mission(scenario, {.workLimit = 20'000});
        mission.advance(1000);
        mission.intervene({.wind_mps = Point(1, -2)});
        mission.advance(scenario.duration_s);
        QCOMPARE(mission.simulation().motion(0).wind_mps, Point(1, -2));
        QVERIFY(without.simulation().motion(0).wind_mps != Point(1, -2));
        for (const IcebergIndex i : mission.simulation().icebergs())
            QVERIFY(mission.simulation().truth_m(i) == without.simulation().truth_m(i));
        const MissionInstant instant = instantAt(mission, 2000);
        QCOMPARE(instant.simulation.motion(0).wind_mps, Point(1, -2));
    }

    /** Knowledge keeps up with the drift: in the simple model without noise it is exact. */
    void estimatesFollowTheCurrent()
    {
        Scenario scenario = fleetInWeather(ObserverModel::Simple, PolicyKind::Visitation);
        scenario.noise = false;
        scenario.icebergs[3].appears_s = 2000;
        const Mission mission = flownIn(scenario, scenario.duration_s);
        for (const IcebergIndex i : mission.simulation().icebergs()) {
            const Point off_m =
                mission.simulation().observer().estimate_m(i) - mission.simulation().truth_m(i);
            QVERIFY2(off_m.norm() < 1e-3, qPrintable(QString::number(off_m.norm())));
        }
    }

    void theLowerBoundHolds()
    {
        for (const ObserverModel model : {ObserverModel::Simple, ObserverModel::Kalman}) {
            Scenario scenario = fleetInWeather(model, PolicyKind::Latency);
            scenario.duration_s = kHour_s;
            const Mission mission = flownIn(scenario, scenario.duration_s);
            const double bound_m2s = zetaLowerBound(scenario, {.workLimit = 20'000'000}).zeta_m2s;
            QVERIFY(bound_m2s > 0);
            QVERIFY(bound_m2s <= mission.metrics().zeta_m2s);
        }
    }
};

QTEST_APPLESS_MAIN(TestChangingWeather)
#include "tst_changing_weather.moc"
