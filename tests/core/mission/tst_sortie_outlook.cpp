#include "core/mission/sortie_outlook.h"
#include "tests/support/approx.h"

#include <QTest>

#include <algorithm>
#include <random>

using namespace berg;
using namespace berg::test;

namespace {

/** 20 m/s, 1000 s of which 800 can be used, home at the origin. */
Uav uavOf()
{
    Uav uav;
    uav.spec = {.airspeed_mps = 20, .endurance_s = 1000};
    return uav;
}

/** A path east from the origin; all of it belongs to this sortie unless changed. */
PlannedPath pathTo(std::initializer_list<double> east_m)
{
    PlannedPath path{.places_m = {{0, 0}}};
    for (const double x_m : east_m)
        path.places_m.emplace_back(x_m, 0);
    path.thisSortie = path.places_m.size();
    return path;
}

/**
 * An independent computation with other random numbers and the time by components of a straight
 * leg.
 */
double percentileBySampling(const PlannedPath& path, double airspeed_mps, double usable_s)
{
    std::mt19937_64 engine(7);
    std::normal_distribution<double> normal;
    std::vector<double> margins_s;
    const Point wind_mps = path.wind_mps.at_mps(0);
    const double windSd_mps = 1 + 0.15 * wind_mps.norm();
    for (int flight = 0; flight < 100'000; ++flight) {
        const double u_mps = airspeed_mps * (1 + 0.03 * normal(engine));
        const double east_mps = wind_mps.x() + windSd_mps * normal(engine);
        const double north_mps = wind_mps.y() + windSd_mps * normal(engine);
        const double along_mps = std::sqrt(u_mps * u_mps - north_mps * north_mps);
        const double length_m = path.places_m.back().x();
        margins_s.push_back(usable_s - length_m / (along_mps + east_mps) -
                            length_m / (along_mps - east_mps));
    }
    std::ranges::nth_element(margins_s, margins_s.begin() + 5000);
    return margins_s[5000];
}

} // namespace

class TestSortieOutlook : public QObject
{
    Q_OBJECT

private slots:
    void reserveClimbAndLandingAreKept()
    {
        Uav uav = uavOf();
        const PlannedPath path = pathTo({4000});
        COMPARE_NEAR(sortieOutlook({}, uav, path).margin_s.value(), 800.0 - 400, 1e-9);
        uav.spec.climb_s = 50;
        uav.spec.landing_s = 30;
        COMPARE_NEAR(sortieOutlook({}, uav, path).margin_s.value(), 320.0, 1e-9);
        uav.spec.reserve_s = 0;
        COMPARE_NEAR(sortieOutlook({}, uav, path).margin_s.value(), 520.0, 1e-9);
        PlannedPath later = path;
        later.aloft_s = 100;
        COMPARE_NEAR(sortieOutlook({}, uav, later).margin_s.value(), 420.0, 1e-9);
        uav.spec.endurance_s = 0;
        QVERIFY(!sortieOutlook({}, uav, path).margin_s && !lowMargin_s(uav, path));
    }

    void noReturnIsWhereTheReserveBegins()
    {
        const Uav uav = uavOf();
        PlannedPath path = pathTo({3000, 12000});
        path.thisSortie = 2; // the second place is left for the next sortie
        const SortieOutlook outlook = sortieOutlook({}, uav, path);
        COMPARE_NEAR(outlook.noReturn.value().time_s, 400.0, 1e-3);
        COMPARE_NEAR(outlook.noReturn->path_m.back().x(), 8000.0, 0.02);
        COMPARE_NEAR(outlook.margin_s.value(), 500.0, 1e-9);
        QVERIFY(!sortieOutlook({}, uav, pathTo({7999})).noReturn);

        // Out at 25 m/s, home at 15: t + 25 t / 15 = 800.
        PlannedPath downWind = pathTo({12000});
        downWind.wind_mps = Point(5, 0);
        COMPARE_NEAR(sortieOutlook({}, uav, downWind).noReturn.value().time_s, 300.0, 1e-3);
    }

    /**
     * A wall crosses the straight path home: 3-4-5 triangles round its end, plus the turns that the
     * fence adds.
     */
    void theWayHomeLeadsRoundTheFence()
    {
        Uav uav = uavOf();
        PlannedPath path = pathTo({6000});
        const double straight_s = sortieOutlook({}, uav, path).margin_s.value();
        COMPARE_NEAR(straight_s, 200.0, 1e-9);
        const Motion motion{.airspeed_mps = 20, .limit_radps = maxTurnRate_radps(uav.spec)};
        path.fence = std::make_shared<const Geofence>(
            std::vector<Point>(), motion,
            std::vector<std::vector<Point>>{
                {{2990, -4000}, {3010, -4000}, {3010, 4000}, {2990, 4000}}});
        const double round_s = sortieOutlook({}, uav, path).margin_s.value();
        // Both paths are 2 x 5000 m in place of 6000 m; a corner is passed outside at about a turn
        // radius.
        QVERIFY2(round_s < 200 - 2 * 200 && round_s > 200 - 2 * 225, QByteArray::number(round_s));
        QVERIFY(sortieOutlook({}, uav, path).noReturn);
        QVERIFY(lowMargin_s(uav, path).value() < round_s);
    }

    /** If it is already too late, the point of no return is the present position. */
    void noReturnMayBeBehind()
    {
        PlannedPath path = pathTo({100});
        path.aloft_s = 900;
        const SortieOutlook outlook = sortieOutlook({}, uavOf(), path);
        QVERIFY(outlook.noReturn.value().path_m == std::vector<Point>{Point(0, 0)});
        QVERIFY(outlook.margin_s.value() < 0);
    }

    void oneFlightInTwentyIsWorse_data()
    {
        QTest::addColumn<Point>("wind_mps");
        QTest::newRow("still") << Point(0, 0);
        QTest::newRow("along") << Point(8, 0);
        QTest::newRow("across") << Point(0, 9);
    }

    void oneFlightInTwentyIsWorse()
    {
        QFETCH(Point, wind_mps);
        const Uav uav = uavOf();
        PlannedPath path = pathTo({5000});
        path.wind_mps = wind_mps;
        const double expected_s = percentileBySampling(path, 20, 800);
        const double margin_s = sortieOutlook({}, uav, path).margin_s.value();
        // The 5th percentile of 1,000 draws has a standard deviation of 2.1/sqrt(1000) times that
        // of a draw.
        COMPARE_NEAR(lowMargin_s(uav, path).value(), expected_s, 0.25 * (margin_s - expected_s));
        QVERIFY(expected_s < margin_s);
        QCOMPARE(lowMargin_s(uav, path), lowMargin_s(uav, path));
    }

    void contactIsLostOutsideTheRing()
    {
        Scenario scenario;
        scenario.groundStation = GroundStation{.range_m = 1000};
        Uav uav = uavOf();
        // 3 of 4 km out and back are outside; half of a chord 600 m off the station is 800 m.
        COMPARE_NEAR(sortieOutlook(scenario, uav, pathTo({4000})).noContact_s, 300.0, 1e-9);
        scenario.groundStation->position_m = {2000, 600};
        uav.spec.endurance_s = 0; // no path home
        COMPARE_NEAR(sortieOutlook(scenario, uav, pathTo({4000})).noContact_s, (4000.0 - 1600) / 20,
                     1e-9);
        scenario.groundStation->position_m = {2000, 2000};
        COMPARE_NEAR(sortieOutlook(scenario, uav, pathTo({4000})).noContact_s, 200.0, 1e-9);
        scenario.groundStation.reset();
        QCOMPARE(sortieOutlook(scenario, uav, pathTo({4000})).noContact_s, 0.0);
    }

    void theRangeIsGivenOrTheHorizon()
    {
        // 4.12 km (sqrt(16) + sqrt(100)): the radio horizon of 4/3 of the Earth's radius.
        COMPARE_NEAR(linkRange_m({.antenna_m = 16}, 100), 57'680.0, 1e-6);
        QCOMPARE(linkRange_m({.antenna_m = 16, .range_m = 3000}, 100), 3000.0);
    }

    void whatCallsForAttentionIsSaid()
    {
        QVERIFY(sortieIssues(0, {.margin_s = 60}, 5).empty());
        const std::vector<Issue> issues =
            sortieIssues(1, {.margin_s = 60, .noContact_s = 90}, -12.4);
        QCOMPARE(issues.size(), std::size_t{2});
        QCOMPARE(issues[0].field, std::string("uavs[1].endurance_s"));
        QVERIFY(issues[0].reason.id == IssueId::ThinReserve);
        QVERIFY(issues[0].message().find("12 s") != std::string::npos);
        QCOMPARE(issues[1].field, std::string("uavs[1]"));
        QVERIFY(issues[1].reason.id == IssueId::NoContact);
        QVERIFY(issues[1].message().find("90 s") != std::string::npos);
    }

    /** At 22 m/s against a wind of 17 m/s, one wind in twenty exceeds the airspeed. */
    void windTooStrongToComeHomeIsSaid()
    {
        Uav uav;
        uav.spec.endurance_s = 7200;
        const std::optional<double> low_s =
            lowMargin_s(uav, {.places_m = {Point(0, 0), Point(1000, 0)}, .wind_mps = Point(17, 0)});
        QVERIFY(low_s.has_value() && std::isinf(*low_s) && *low_s < 0);
        const std::vector<Issue> issues = sortieIssues(0, {.margin_s = 5000}, low_s);
        QCOMPARE(issues.size(), std::size_t{1});
        QVERIFY(issues[0].reason.id == IssueId::MayNotReturn);
    }
};

QTEST_APPLESS_MAIN(TestSortieOutlook)
#include "tst_sortie_outlook.moc"
