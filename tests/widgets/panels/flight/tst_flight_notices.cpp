#include "tests/support/approx.h"
#include "tests/support/flight/scenario_builder.h"
#include "tests/support/plan/test_solvers.h"
#include "tests/support/window/panel_test.h"
#include "widgets/document/selection.h"
#include "widgets/panels/flight/flight_notices.h"

#include <stdexcept>

using namespace berg;
using namespace Qt::StringLiterals;

namespace {

const QLocale kLocale(QLocale::English);

/** Returns two icebergs that drift towards a platform at the origin; the second arrives first. */
Scenario twoComing()
{
    Scenario scenario = test::emptySea(3000);
    scenario.planner.policy = PolicyKind::Nearest;
    scenario.uavs.front().position_m = {-5000, -5000};
    test::addIceberg(scenario, 2000, 0).velocity_mps = {-0.5, 0};
    test::addIceberg(scenario, 0, 1600).velocity_mps = {0, -0.5};
    test::addIceberg(scenario, -3000, 0).velocity_mps = {-0.5, 0};
    scenario.icebergs[1].name = "Storberget";
    scenario.asset = Asset{.name = "Rig", .range_m = 4000, .alarm_m = 1000};
    return scenario;
}

FlightRecord recordAt(const Mission& mission, double time_s)
{
    FlightRecord record = recordOf(mission);
    record.now.phase = RunPhase::Paused;
    record.instant = snapshotAt(mission, time_s);
    return record;
}

/** Returns the record of a flight in that mode. */
FlightRecord inMode(FlightMode mode)
{
    const Mission mission(twoComing());
    FlightRecord record = recordOf(mission);
    record.scenario.asset.reset();
    record.now.asset.reset();
    record.now.phase = RunPhase::Paused;
    record.now.world.uavs.front().mode = mode;
    return record;
}

/** Returns a flight of uav-1 and, `apart_m` east of it, "East". */
FlightRecord twoUavs(double apart_m)
{
    Scenario scenario = test::emptySea();
    scenario.uavs.push_back({.id = "uav-2", .name = "East", .position_m = Point(apart_m, 0)});
    const Mission mission(scenario);
    FlightRecord record = recordOf(mission);
    record.now.phase = RunPhase::Paused;
    return record;
}

QStringList textsOf(const FlightRecord& record)
{
    QStringList texts;
    for (const FlightNotice& notice : flightNotices(record, kLocale))
        texts << notice.text;
    return texts;
}

} // namespace

class TestFlightNotices : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnWarnings(); }

    void windAboveTheLimitIsShown()
    {
        FlightRecord record = twoUavs(50'000);
        record.scenario.uavs[1].weather.wind_mps = 10;
        for (Motion& motion : record.now.motions)
            motion.wind_mps = {8, 6};
        QCOMPARE(textsOf(record), QStringList());
        record.scenario.uavs[1].weather.wind_mps = 9.5;
        QCOMPARE(textsOf(record),
                 QStringList(u"East: Wind above its limit: 10.0 m/s, limit 9.50 m/s"_s));
        record.scenario.uavs[1].weather = {};
        record.scenario.uavs[1].spec.airspeed_mps = 14;
        QCOMPARE(textsOf(record),
                 QStringList(u"East: Makes little headway: wind 10.0 m/s, airspeed 14.0 m/s"_s));
        record.now.world.uavs[1].mode = FlightMode::Ground;
        QVERIFY(!textsOf(record).join(u' ').contains(u"limit"));
    }

    /** It is shown from the failure until the next successful plan, at any instant shown. */
    void plannerFailureIsShownUntilAPlanSucceeds()
    {
        int calls = 0;
        test::SolverScript script;
        script.answer = [&calls](const TvpProblem& problem) {
            if (++calls == 2)
                throw std::runtime_error("out of order");
            return test::triedAll(problem);
        };
        Scenario scenario = test::emptySea(600);
        scenario.planner.policy = PolicyKind::Visitation;
        for (const double east_m : {2000.0, 4000.0, 6000.0, 8000.0})
            test::addIceberg(scenario, east_m, 0);
        Mission mission(scenario, {}, std::make_unique<test::ScriptedSolver>(script));
        mission.advance(600);
        QVERIFY(calls >= 3);
        const std::vector<PlanPointer>& plans = mission.plans();
        QVERIFY(plans[1]->fellBack);
        const QString words = u"The planner failed: continuing with the previous plan"_s;
        QVERIFY(!textsOf(recordAt(mission, plans[1]->time_s - 1)).contains(words));
        QVERIFY(textsOf(recordAt(mission, plans[1]->time_s)).contains(words));
        QVERIFY(textsOf(recordAt(mission, plans[2]->time_s - 1)).contains(words));
        QVERIFY(!textsOf(recordAt(mission, plans[2]->time_s)).contains(words));
        const std::vector<FlightNotice> notices =
            flightNotices(recordAt(mission, plans[1]->time_s), kLocale);
        QVERIFY(notices.front().kind == NoticeKind::PlannerFailed);
    }

    /** The first plan of all may fail too. */
    void failureBeforeTakeOffIsShown()
    {
        test::SolverScript script;
        script.answer = [](const TvpProblem&) -> SolveOutcome {
            throw std::runtime_error("out of order");
        };
        Scenario scenario = test::emptySea(600);
        test::addIceberg(scenario, 2000, 0);
        test::addIceberg(scenario, 4000, 0);
        scenario.planner.policy = PolicyKind::Visitation;
        Mission mission(scenario, {}, std::make_unique<test::ScriptedSolver>(script));
        mission.advance(0);
        FlightRecord record = recordOf(mission);
        record.now.phase = RunPhase::Ready;
        QCOMPARE(textsOf(record).size(), 1);
    }

    /** berg-1 crosses the ring of 1000 m after 2000 s, Storberget after 1200 s. */
    void alarmCountsDownAtTheInstantShown()
    {
        Mission mission(twoComing());
        mission.advance(3000);
        const QStringList soon = textsOf(recordAt(mission, 600));
        QCOMPARE(soon.size(), 1);
        QVERIFY2(soon.front().contains(u"enters the inner ring in"_s), qPrintable(soon.front()));
        QVERIFY(soon.front().endsWith(u", and 1 more"_s));
        const QString all = flightNotices(recordAt(mission, 600), kLocale).front().toolTip;
        QCOMPARE(flightNotices(recordAt(mission, 600), kLocale).front().about,
                 (std::vector<std::string>{kAssetKey, "berg-2", "berg-1"}));
        QCOMPARE(all, u"Storberget enters the inner ring in 10 min\n"
                      "berg-1 enters the inner ring in 23 min"_s);
        const QString late = flightNotices(recordAt(mission, 1170), kLocale).front().toolTip;
        QVERIFY2(late.contains(u"Storberget enters the inner ring in 30 s"_s), qPrintable(late));
        const QString inside = flightNotices(recordAt(mission, 1300), kLocale).front().toolTip;
        QVERIFY2(inside.contains(u"Storberget is inside the inner ring"_s), qPrintable(inside));
    }

    /** The alarm detected last comes first, whichever iceberg arrives first. */
    void newestAlarmIsShown()
    {
        Mission mission(twoComing());
        mission.advance(10);
        FlightRecord record = recordAt(mission, 10);
        for (const IcebergIndex newest : IcebergRange(2)) {
            record.history.events = {{.time_s = 3,
                                      .kind = EventKind::Alarm,
                                      .iceberg = IcebergIndex::of(1 - newest.number())},
                                     {.time_s = 5, .kind = EventKind::Alarm, .iceberg = newest}};
            const QString name = newest == 0 ? u"berg-1"_s : u"Storberget"_s;
            QVERIFY2(textsOf(record).front().startsWith(name), qPrintable(textsOf(record).front()));
        }
    }

    void noAssetNoAlarm()
    {
        Scenario scenario = twoComing();
        scenario.asset.reset();
        Mission mission(scenario);
        mission.advance(100);
        QVERIFY(textsOf(recordAt(mission, 100)).isEmpty());
    }

    void modesAreShown_data()
    {
        QTest::addColumn<FlightMode>("mode");
        QTest::addColumn<QStringList>("texts");
        QTest::newRow("leg") << FlightMode::Leg << QStringList{};
        QTest::newRow("circle") << FlightMode::Circle << QStringList{};
        QTest::newRow("search") << FlightMode::Search << QStringList{u"Searching for Storberget"_s};
        QTest::newRow("home") << FlightMode::Home << QStringList{u"Returning home"_s};
        QTest::newRow("ground") << FlightMode::Ground
                                << QStringList{u"On the ground, takes off in 9 min"_s};
    }

    void modesAreShown()
    {
        QFETCH(FlightMode, mode);
        QFETCH(QStringList, texts);
        FlightRecord record = inMode(mode);
        record.now.world.uavs.front().ground_s = 530;
        Search search;
        search.iceberg = 1;
        record.now.world.uavs.front().search = search;
        QCOMPARE(textsOf(record), texts);
        record.now.phase = RunPhase::Ready; // nothing is flown yet
        QVERIFY(textsOf(record).isEmpty());
    }

    void lateReturnIsShownUntilLanding()
    {
        FlightRecord record = inMode(FlightMode::Home);
        record.history.events = {{.time_s = 0, .kind = EventKind::LateHome, .uav = 0}};
        QCOMPARE(textsOf(record).front(), u"Home cannot be reached in time"_s);
        record.history.events.push_back({.time_s = 0, .kind = EventKind::Landed, .uav = 0});
        QCOMPARE(textsOf(record), QStringList{u"Returning home"_s});
    }

    void severalUavsAreNamed()
    {
        FlightRecord record = twoUavs(5000);
        record.now.world.uavs[1].mode = FlightMode::Home;
        record.history.events = {{.time_s = 0, .kind = EventKind::LateHome, .uav = 1},
                                 {.time_s = 0, .kind = EventKind::Landed, .uav = 0}};
        QCOMPARE(textsOf(record), (QStringList{u"East: Home cannot be reached in time"_s,
                                               u"East: Returning home"_s}));
    }

    void lostIcebergsAreWarnedOf()
    {
        FlightRecord record = inMode(FlightMode::Leg);
        record.now.world.tracks[1].status = TrackStatus::Lost;
        QCOMPARE(textsOf(record), QStringList{u"Storberget is lost"_s});
        const FlightNotice notice = flightNotices(record, kLocale).front();
        QVERIFY(notice.kind == NoticeKind::LostIceberg);
        QVERIFY(rankOf(notice.kind) == NoticeRank::Warning);
        QCOMPARE(notice.about, std::vector{record.now.icebergs[1].id});
        record.now.world.tracks[1].status = TrackStatus::GivenUp;
        QCOMPARE(textsOf(record), QStringList{u"Storberget is lost; the search was abandoned"_s});
        record.now.world.tracks[1].status = TrackStatus::Tracked;
        QVERIFY(textsOf(record).isEmpty());
    }

    /** Both UAVs are aloft in one layer, nearer than the separation of 200 m. */
    void closeUavsAreAWarning()
    {
        const QStringList close{u"uav-1 and East are 150 m apart"_s};
        QCOMPARE(textsOf(twoUavs(150)), close);
        QVERIFY(textsOf(twoUavs(250)).isEmpty());
        QVERIFY(flightNotices(twoUavs(150), kLocale).front().kind == NoticeKind::UavsClose);
        FlightRecord layers = twoUavs(150);
        layers.scenario.uavs[1].spec.altitude_m += 30;
        QVERIFY(textsOf(layers).isEmpty());
        layers.scenario.uavs[1].spec.altitude_m -= 1;
        QCOMPARE(textsOf(layers), close);
        FlightRecord landed = twoUavs(150);
        landed.now.world.uavs[0].mode = FlightMode::Ground;
        QVERIFY(!textsOf(landed).contains(close.front()));
    }
};

QTEST_MAIN(TestFlightNotices)
#include "tst_flight_notices.moc"
