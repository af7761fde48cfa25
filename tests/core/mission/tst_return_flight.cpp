#include "core/checks/validate.h"
#include "core/mission/mission.h"
#include "tests/support/flight/return_case.h"

#include <QTest>

using namespace berg;

namespace {

/** Result of one sortie. */
struct Sortie
{
    bool isInside = true;
    std::optional<double> landed_s;
};

Sortie flown(const Scenario& s, const Geofence& fence)
{
    Sortie sortie;
    Mission mission(s, {.workLimit = 20'000, .record = false});
    while (!mission.simulation().finished() && !sortie.landed_s) {
        mission.advance(mission.simulation().time_s() + s.dt_s);
        const UavState& uav = mission.simulation().uav(0);
        sortie.isInside = sortie.isInside && fence.contains(uav.pose.position_m);
        if (uav.mode == FlightMode::Ground)
            sortie.landed_s = mission.simulation().time_s();
    }
    return sortie;
}

Sortie flown(const Scenario& s)
{
    return flown(s, Geofence(s.area_m, {}));
}

bool isCalledUnsafe(const Scenario& s)
{
    const std::vector<Issue> issues = validate(s);
    return hasErrors(issues) || std::any_of(issues.begin(), issues.end(), [](const Issue& issue) {
               return issue.reason.id == IssueId::NoSafeReturn ||
                      issue.reason.id == IssueId::NoPathHome;
           });
}

/** A corner of the fence points inwards between the UAV and its home behind it. */
Scenario homeBehindACorner()
{
    Scenario s;
    s.duration_s = 992;
    s.noise = false;
    s.wind_mps = {0.05975387368135676, -5.93523624793702};
    s.area_m = {{-1500, -1000}, {6000, -1000}, {6000, 5500}, {3000, 3500}, {-1500, 5500}};
    s.geofence = true;
    Uav uav{.id = "u", .position_m = {3327.007932828814, 3394.3925703259833}};
    uav.heading_deg = 39.62392800488104;
    uav.spec.airspeed_mps = 24.1;
    uav.spec.reservePercent = 0;
    uav.spec.endurance_s = 102.5641330934424;
    uav.home_m = Point(2832, 2989);
    uav.turnaround_s = 1e6;
    s.uavs = {uav};
    s.icebergs = {{.id = "x", .position_m = {5500, -500}, .velocity_mps = {0, 0}}};
    return s;
}

} // namespace

/** Return flights inside a geofence. */
class TestReturnFlight : public QObject
{
    Q_OBJECT

private slots:
    /** Choosing the side anew at each command led straight away from home, 174 s late. */
    void homeBehindACornerIsReachedInTime()
    {
        const Scenario s = homeBehindACorner();
        QVERIFY(!isCalledUnsafe(s));
        const Sortie sortie = flown(s);
        QVERIFY(sortie.isInside);
        QVERIFY(sortie.landed_s);
        QVERIFY(*sortie.landed_s <= s.uavs.front().spec.endurance_s);
    }

    /** Flies BERGWATCH_RETURN_CASES cases. */
    void allAreHomeInTimeAndInside_data()
    {
        QTest::addColumn<int>("kind");
        QTest::newRow("fence") << static_cast<int>(test::ReturnCase::FenceOnly);
        QTest::newRow("no-fly areas") << static_cast<int>(test::ReturnCase::WithAreas);
    }
    void allAreHomeInTimeAndInside()
    {
        QFETCH(int, kind);
        const int cases = qEnvironmentVariableIntValue("BERGWATCH_RETURN_CASES");
        int safe = 0;
        const int all = cases > 0 ? cases : 150;
        for (int seed = 0; seed < all; ++seed) {
            const test::ReturnCase returning(static_cast<std::uint64_t>(seed),
                                             static_cast<test::ReturnCase::Kind>(kind));
            if (isCalledUnsafe(returning.scenario()))
                continue;
            ++safe;
            const Sortie sortie = flown(returning.scenario(), *returning.fence());
            const double endurance_s = returning.scenario().uavs.front().spec.endurance_s;
            QVERIFY2(sortie.isInside, qPrintable(QString("case %1: outside").arg(seed)));
            QVERIFY2(sortie.landed_s && *sortie.landed_s <= endurance_s,
                     qPrintable(QString("case %1: late").arg(seed)));
        }
        QVERIFY2(safe > 0.85 * all, qPrintable(QString::number(safe)));
    }

    /** A UAV that only follows its proven path, despite targets, ends at home and stays there. */
    void pathFlownToItsEndEndsAtHome()
    {
        const test::ReturnCase returning(3469, test::ReturnCase::WithAreas);
        const Scenario& s = returning.scenario();
        QVERIFY(!isCalledUnsafe(s));
        const Sortie sortie = flown(s, *returning.fence());
        QVERIFY(sortie.isInside);
        QVERIFY(sortie.landed_s && *sortie.landed_s <= s.uavs.front().spec.endurance_s);
    }

    /** Conversely, a start without a safe return is reported. */
    void noSafeStartIsAFinding()
    {
        Scenario s = homeBehindACorner();
        s.area_m = {{0, 0}, {6000, 0}, {6000, 150}, {0, 150}}; // no turn fits
        s.wind_mps = Point::Zero();
        s.icebergs.front().position_m = {5500, 75};
        s.uavs.front().position_m = {3000, 75};
        s.uavs.front().heading_deg = 90;
        s.uavs.front().home_m = Point(500, 75);
        s.uavs.front().spec.reservePercent = 0;
        s.uavs.front().spec.endurance_s = 600;
        QVERIFY(isCalledUnsafe(s));
        s.uavs.front().heading_deg = 270;
        QVERIFY(!isCalledUnsafe(s));
        QVERIFY(flown(s).landed_s);
    }

    /** The UAV is also home between sorties, whatever the heading at landing. */
    void everySortieIsHomeInTime()
    {
        int landings = 0;
        for (std::uint64_t seed = 0; seed < 20; ++seed) {
            Scenario s = test::ReturnCase(seed).scenario();
            if (isCalledUnsafe(s))
                continue;
            s.uavs.front().turnaround_s = 10;
            s.uavs.front().spec.endurance_s += 300;
            s.duration_s = 1500;
            Mission mission(s, {.workLimit = 20'000});
            mission.advance(s.duration_s);
            for (const MissionEvent& event : mission.events()) {
                QVERIFY(event.kind != EventKind::LateHome);
                landings += event.kind == EventKind::Landed ? 1 : 0;
            }
        }
        QVERIFY(landings >= 30);
    }
};

QTEST_APPLESS_MAIN(TestReturnFlight)
#include "tst_return_flight.moc"
