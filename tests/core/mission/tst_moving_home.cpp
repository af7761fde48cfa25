#include "core/io/export/content/export_content.h"
#include "core/io/export/missions/mission_upload.h"
#include "core/io/files/run_json.h"
#include "core/mission/mission_instant.h"
#include "tests/support/expect_error.h"
#include "tests/support/files/file_texts.h"
#include "tests/support/flight/scenario_builder.h"

#include <QTest>

using namespace berg;

namespace {

constexpr double kEndurance_s = 1500;

/** A UAV of limited endurance that lands near its start. */
Scenario shipScenario(bool isFenced)
{
    Scenario scenario = test::emptySea(3000);
    Uav& uav = scenario.uavs.front();
    uav.spec.endurance_s = kEndurance_s;
    uav.home_m = {100, 0};
    uav.turnaround_s = 60;
    for (const auto& [east_m, north_m] : {std::pair(3000, 1000), {-2000, 4000}, {4000, -3000}})
        test::addIceberg(scenario, east_m, north_m);
    scenario.geofence = isFenced;
    scenario.area_m = {{-9000, -9000}, {9000, -9000}, {9000, 9000}, {-9000, 9000}};
    return scenario;
}

Intervention homeAt(const Point& place_m)
{
    return {.home = HomeMove{.uav = "uav-1", .place_m = place_m}};
}

/** Returns where the UAV landed first. */
std::optional<Point> landingPlace(const Mission& mission)
{
    for (const MissionEvent& event : mission.events())
        if (event.kind == EventKind::Landed)
            return instantAt(mission, event.time_s).simulation.uav(0).pose.position_m;
    return std::nullopt;
}

void replaysEqually(const Mission& mission)
{
    const RunFile run = runFromJson(runToJson(runOf(mission)), "run");
    QVERIFY(run == runOf(mission));
    QVERIFY(runOf(replay(run)) == run);
    const double now_s = mission.simulation().time_s();
    QVERIFY(instantAt(mission, now_s).simulation.state() == mission.simulation().state());
}

} // namespace

/** Homes that a ship carries. */
class TestMovingHome : public QObject
{
    Q_OBJECT

private slots:
    void landsOnTheShip_data()
    {
        QTest::addColumn<bool>("isFenced");
        QTest::newRow("open sea") << false;
        QTest::newRow("geofence") << true;
    }

    void landsOnTheShip()
    {
        QFETCH(bool, isFenced);
        Mission mission(shipScenario(isFenced));
        const Point start_m(100, 0);
        Point ship_m = start_m;
        for (double time_s = 10; time_s < 2800; time_s += 10) { // 4 m/s to the north-east
            static_cast<void>(mission.advance(time_s));
            ship_m = start_m + Point(2.8, 2.8) * time_s;
            mission.intervene(homeAt(ship_m));
            if (landingPlace(mission))
                break;
        }
        const std::optional<Point> landed_m = landingPlace(mission);
        QVERIFY(landed_m);
        QVERIFY((*landed_m - ship_m).norm() < kLandingRadius_m + 60); // a step of the ship is 40 m
        QVERIFY((*landed_m - start_m).norm() > 1000);
        QVERIFY(mission.simulation().uav(0).pose.position_m == ship_m); // carried on deck
        replaysEqually(mission);
    }

    /** A home far off needs the way back at once. */
    void turnsHomeWhenHomeMovesAway()
    {
        Mission mission(shipScenario(false));
        static_cast<void>(mission.advance(600));
        QVERIFY(mission.simulation().uav(0).mode != FlightMode::Home);
        mission.intervene(homeAt({25'000, 0}));
        QVERIFY(mission.simulation().uav(0).mode == FlightMode::Home);
        static_cast<void>(mission.advance(700));
        replaysEqually(mission);
    }

    /** Uploads in flight return to where home is now. */
    void uploadsFollow()
    {
        const Scenario scenario = shipScenario(false);
        Mission mission(scenario);
        static_cast<void>(mission.advance(100));
        mission.intervene(homeAt({900, -700}));
        const ExportContent content = exportContent(
            {.scenario = scenario, .plan = *mission.plans().front(), .mission = &mission},
            {.what = ExportScope::Order, .returnHome = true});
        QCOMPARE(content.uavs.front().home_m, Point(900, -700));
        const std::vector<MissionPart> parts = missionParts(content, content.uavs.front());
        const LatLon rally = LocalFrame(scenario.origin).toGeographic({900, -700});
        QCOMPARE(parts.front().type, MissionType::Rally); // there is no fence
        QVERIFY(std::abs(parts.front().items.front().x - rally.latitude_deg * 1e7) < 20);
    }

    void faultyMovesAreRefused()
    {
        Mission mission(shipScenario(true));
        const WorldState before = mission.simulation().state();
        const auto refusal = [&](const Intervention& change) {
            return test::codeOf([&] { mission.intervene(change); });
        };
        const std::string refused = test::codeName(ErrorCode::InvalidInput);
        QCOMPARE(refusal({.home = HomeMove{.uav = "nobody", .place_m = {0, 0}}}), refused);
        QCOMPARE(refusal(homeAt({20'000, 0})), refused); // outside the fence
        QVERIFY(mission.interventions().empty());
        QVERIFY(mission.simulation().state() == before);
    }

    void filesNameTheUav()
    {
        Mission mission(shipScenario(false));
        static_cast<void>(mission.advance(10));
        mission.intervene(homeAt({200, 0}));
        std::string text = runToJson(runOf(mission));
        const std::size_t at = text.rfind("\"uav\": \"uav-1\"");
        QVERIFY(at != std::string::npos);
        text.replace(at, 14, "\"uav\": \"uav-9\"");
        const std::optional<Error> error =
            test::errorOf([&] { static_cast<void>(runFromJson(text, "run")); });
        QVERIFY(error && test::names(error->issues(), "interventions[0].home.uav"));
    }
};

QTEST_APPLESS_MAIN(TestMovingHome)
#include "tst_moving_home.moc"
