#include "tests/support/flight/fleet_case.h"
#include "tests/support/flight/pad_fleet.h"
#include "tests/support/flight/scenario_builder.h"

#include <QTest>

using namespace berg;
using namespace berg::test;

namespace {

/** Three to five UAVs on one side of their pad, in wind, without a limit of endurance. */
Scenario withoutLimit(std::uint64_t seed)
{
    Random random(seed, 9);
    Scenario s = emptySea(1200);
    const Uav first = s.uavs.front();
    s.uavs.clear();
    const auto count = 3 + random.below(3);
    const double wind_rad = random.uniform(-kPi, kPi);
    s.wind_mps = random.uniform(5, 10) * Point(std::cos(wind_rad), std::sin(wind_rad));
    const double side_rad = random.uniform(-kPi, kPi);
    for (std::uint64_t i = 0; i < count; ++i) {
        const double from_rad = side_rad + random.uniform(-0.8, 0.8);
        Uav uav = first;
        uav.id = "uav-" + std::to_string(i + 1);
        uav.position_m =
            (800 + 450 * static_cast<double>(i)) * Point(std::cos(from_rad), std::sin(from_rad));
        uav.home_m = Point(0, 0);
        s.uavs.push_back(uav);
    }
    for (int i = 0; i < 8; ++i) {
        const double east_m = random.uniform(-2500, 2500);
        addIceberg(s, east_m, random.uniform(-2500, 2500));
    }
    return s;
}

Point inBox_m(Random& random, const Point& middle_m)
{
    const double east_m = random.uniform(-800, 800);
    return middle_m + Point(east_m, random.uniform(-800, 800));
}

/**
 * The path home of the first UAV leads between two no-fly areas, without room for a circle, or far
 * around them. The two others fly to and fro on both sides.
 */
Scenario withPassage(std::uint64_t seed)
{
    Random random(seed, 31);
    Scenario s = emptySea(1800);
    s.geofence = true;
    s.area_m = {{-2500, -4000}, {8000, -4000}, {8000, 3000}, {-2500, 3000}};
    const double from_m = random.uniform(2000, 2600);
    const double to_m = from_m + random.uniform(300, 1200);
    const double half_m = random.uniform(40, 80);
    s.noFly = {{.name = "north"}, {.name = "south"}};
    s.noFly[0].corners_m = {{from_m, half_m}, {to_m, half_m}, {to_m, 2990}, {from_m, 2990}};
    s.noFly[1].corners_m = {{from_m, -2000}, {to_m, -2000}, {to_m, -half_m}, {from_m, -half_m}};
    const Uav first = s.uavs.front();
    for (const char* id : {"uav-2", "uav-3"}) {
        s.uavs.push_back(first);
        s.uavs.back().id = id;
    }
    const double beyond_m = to_m + 1500;
    s.uavs[0].position_m = {beyond_m, 0};
    s.uavs[0].home_m = Point(0, 0);
    s.uavs[0].spec.endurance_s = random.uniform(800, 1000);
    s.uavs[0].turnaround_s = 600;
    s.uavs[1].position_m = {0, 1000};
    s.uavs[2].position_m = {0, -1000};
    for (int i = 0; i < 12; ++i) {
        const Point place_m = inBox_m(random, {i % 2 == 0 ? beyond_m : 0, 0});
        addIceberg(s, place_m.x(), place_m.y()).uav = i % 4 == 0   ? "uav-1"
                                                      : i % 4 == 1 ? "uav-2"
                                                                   : "uav-3";
    }
    return s;
}

} // namespace

/** UAVs that share a pad or must pass each other to land. */
class TestPadFleets : public QObject
{
    Q_OBJECT

private slots:
    /**
     * Flies BERGWATCH_FLEET_CASES fleets. With 500, fewer than one landing in a hundred uses
     * reserve.
     */
    void allLandInTimeAndApart()
    {
        const int cases = qEnvironmentVariableIntValue("BERGWATCH_FLEET_CASES");
        int left = cases > 0 ? cases : 40;
        int landings = 0;
        int reserves = 0;
        for (std::int64_t seed = 1; left > 0; ++seed) {
            const std::optional<Scenario> s = flyablePadFleet(seed);
            if (!s)
                continue;
            --left;
            const FleetOutcome flight = flownFleet(*s);
            const QString fleet = QString("fleet %1").arg(seed);
            QVERIFY2(flight.spent == 0, qPrintable(fleet));
            QVERIFY2(flight.staysApart, qPrintable(fleet));
            QVERIFY2(flight.isInside, qPrintable(fleet));
            QVERIFY2(flight.late == 0 || isWarnedOfCrowd(*s), qPrintable(fleet));
            landings += flight.landings;
            reserves += flight.late;
        }
        QVERIFY2(100 * reserves < landings,
                 qPrintable(QString("%1 of %2").arg(reserves).arg(landings)));
    }

    /** No UAV is due before another; the first one stays first to the end. */
    void orderedHomeAtOnceAllLand()
    {
        for (std::uint64_t seed = 1; seed <= 40; ++seed) {
            const Scenario s = withoutLimit(seed);
            Mission mission(s, {.workLimit = 3'000, .record = false});
            mission.advance(60);
            for (const Uav& uav : s.uavs)
                mission.intervene(
                    {.time_s = 60,
                     .commanded = UavCommand{.uav = uav.id, .order = FlightOrder::ReturnNow}});
            mission.advance(60 + 330 + 55.0 * static_cast<double>(s.uavs.size() - 1));
            const Fleet& fleet = mission.simulation().fleet();
            const auto landed = std::ranges::count_if(fleet.autopilots(), &Autopilot::isOnGround);
            QVERIFY2(landed == fleet.count(),
                     qPrintable(QString("fleet %1: %2").arg(seed).arg(landed)));
        }
    }

    void aPassageIsFlownThroughAsAWhole()
    {
        int flown = 0;
        for (std::uint64_t seed = 1; flown < 10; ++seed) {
            const Scenario s = withPassage(seed);
            if (hasErrors(validate(s)))
                continue;
            ++flown;
            const FleetOutcome flight = flownFleet(s);
            const QString fleet = QString("fleet %1").arg(seed);
            QVERIFY2(flight.landings > 0, qPrintable(fleet));
            QVERIFY2(flight.spent == 0, qPrintable(fleet));
            QVERIFY2(flight.isInside && flight.staysApart, qPrintable(fleet));
        }
    }
};

QTEST_APPLESS_MAIN(TestPadFleets)
#include "tst_pad_fleets.moc"
