#include "core/checks/validate.h"
#include "core/geometry/geometry.h"
#include "core/geometry/outline.h"
#include "core/permit/airspace.h"
#include "core/permit/operation.h"
#include "tests/support/approx.h"
#include "tests/support/flight/scenario_builder.h"

#include <QTest>

#include <algorithm>

using namespace berg;
using namespace berg::test;

namespace {

/** One UAV at 22 m/s and 120 m, one iceberg to the east. */
Scenario eastward()
{
    Scenario s = emptySea(3600);
    s.startUtc = "2026-05-01T06:00:00Z";
    addIceberg(s, 4000, 0);
    return s;
}

AirspaceArea squareAt(double east_m, double north_m)
{
    return {.name = "Somewhere",
            .kind = "D",
            .corners_m = {{east_m, north_m},
                          {east_m + 500, north_m},
                          {east_m + 500, north_m + 500},
                          {east_m, north_m + 500}}};
}

std::size_t entered(const Scenario& scenario)
{
    const std::vector<Issue> issues = validate(scenario);
    return static_cast<std::size_t>(std::ranges::count_if(issues, [](const Issue& issue) {
        return issue.reason.id == IssueId::AirspaceEntered && issue.severity == Severity::Warning;
    }));
}

} // namespace

class TestOperation : public QObject
{
    Q_OBJECT

private slots:
    /**
     * Example for the formulas by hand: 3 + 3 + 1 + 22 + 484 / 5.6638, 120 + 4 + 15.554 + 14.801.
     */
    void widthsAreThoseOfTheFormulas()
    {
        const OperationVolume volume = operationVolume(eastward(), {});
        QCOMPARE(volume.speed_mps, 22.0);
        QCOMPARE(volume.height_m, 120.0);
        QVERIFY(std::abs(volume.outside_m - 114.45) < 0.01);
        QVERIFY(std::abs(volume.ceiling_m - 154.36) < 0.01);
        QVERIFY(std::abs(volume.buffer_m - 155.86) < 0.01);
        QCOMPARE(volume.adjacent_m, 5000.0);
    }

    void adjacentAreaIsWithinItsBounds()
    {
        Scenario s = eastward();
        s.uavs[0].spec.airspeed_mps = 100;
        QCOMPARE(operationVolume(s, {}).adjacent_m, 18000.0);
        QCOMPARE(operationVolume(s, {.adjacentMost_m = 12000}).adjacent_m, 12000.0);
        QCOMPARE(operationVolume(s, {.adjacentLeast_m = 20000}).adjacent_m, 20000.0);
    }

    void windAndTheFastestUavCount()
    {
        Scenario s = eastward();
        s.uavs.push_back(s.uavs[0]);
        s.uavs[1].id = "uav-2";
        s.uavs[1].spec.airspeed_mps = 30;
        s.uavs[0].spec.altitude_m = 200;
        s.wind_mps = {-3, 4};
        const OperationVolume volume = operationVolume(s, {});
        QCOMPARE(volume.speed_mps, 35.0);
        QCOMPARE(volume.height_m, 200.0);
    }

    void holdsAllPlacesOfPlansWithTheMargin()
    {
        Scenario s = eastward();
        s.icebergs[0].velocity_mps = {0, 0.5}; // 1800 m to the north until the end
        s.uavs[0].home_m = Point(0, -3000);
        const OperationVolume volume = operationVolume(s, {.margin_m = 400});
        const std::vector<Point>& geography_m = volume.outline_m(VolumePart::Geography);
        for (const Point& place_m :
             {Point(0, 0), Point(0, -3000), Point(4000, 0), Point(4000, 1800)})
            QVERIFY(insidePolygon(geography_m, place_m) &&
                    distanceToEdges(geography_m, place_m) > 399.9);
        QVERIFY(!insidePolygon(geography_m, {4000, 2300}));
    }

    void placesOutsideTheAreaAreNotFlownTo()
    {
        Scenario s = eastward();
        addIceberg(s, 50000, 0);
        s.area_m = {{-1000, -1000}, {9000, -1000}, {9000, 1000}, {-1000, 1000}};
        QVERIFY(!insidePolygon(operationVolume(s, {}).outline_m(VolumePart::Adjacent), {20000, 0}));
    }

    void fenceIsTheGeography()
    {
        Scenario s = eastward();
        s.area_m = {{-1000, 2000}, {9000, 2000}, {9000, -2000}, {-1000, -2000}}; // clockwise
        s.geofence = true;
        const OperationVolume volume = operationVolume(s, {.margin_m = 9000});
        QCOMPARE(signedArea(volume.outline_m(VolumePart::Geography)), 10000.0 * 4000);
        const std::vector<Point>& outside_m = volume.outline_m(VolumePart::Contingency);
        QVERIFY(insidePolygon(outside_m, {4000, 2114}));
        QVERIFY(!insidePolygon(outside_m, {4000, 2115}));
    }

    void eachPartHoldsTheOneBefore()
    {
        const OperationVolume volume = operationVolume(eastward(), {});
        for (std::size_t part = 1; part < kVolumeParts; ++part)
            for (const Point& corner_m : volume.outlines_m[part - 1])
                QVERIFY(insidePolygon(volume.outlines_m[part], corner_m));
    }

    void airspaceIsEnteredByPlaceHeightAndTime_data()
    {
        QTest::addColumn<AirspaceArea>("area");
        QTest::addColumn<bool>("isEntered");
        const AirspaceArea near = squareAt(2000, 0);
        const auto changed = [&](const auto& change) {
            AirspaceArea area = near;
            change(area);
            return area;
        };
        QTest::newRow("there") << near << true;
        QTest::newRow("elsewhere") << squareAt(0, 3000) << false;
        QTest::newRow("in the contingency volume") << squareAt(0, 560) << true;
        QTest::newRow("all round") << changed([](AirspaceArea& a) {
            a.corners_m = {{-9e4, -9e4}, {9e4, -9e4}, {9e4, 9e4}, {-9e4, 9e4}};
        }) << true;
        QTest::newRow("just above") << changed([](AirspaceArea& a) { a.floor_m = 155; }) << false;
        QTest::newRow("just below") << changed([](AirspaceArea& a) { a.floor_m = 154; }) << true;
        QTest::newRow("over before")
            << changed([](AirspaceArea& a) { a.untilUtc = "2026-05-01T05:59:59Z"; }) << false;
        QTest::newRow("from the end on")
            << changed([](AirspaceArea& a) { a.fromUtc = "2026-05-01T07:00Z"; }) << true;
        QTest::newRow("after the end")
            << changed([](AirspaceArea& a) { a.fromUtc = "2026-05-01T07:00:01Z"; }) << false;
    }
    void airspaceIsEnteredByPlaceHeightAndTime()
    {
        QFETCH(AirspaceArea, area);
        QFETCH(bool, isEntered);
        Scenario s = eastward();
        s.airspace = {area};
        QCOMPARE(entered(s), std::size_t{isEntered});
        s.startUtc.clear(); // without a start, times of airspace have no effect
        area.fromUtc.clear();
        area.untilUtc.clear();
        Scenario always = s;
        always.airspace = {area};
        QCOMPARE(entered(s), entered(always));
    }

    void enteredAirspaceIsNamed()
    {
        Scenario s = eastward();
        s.airspace = {squareAt(2000, 0)};
        const std::vector<Issue> issues = airspaceIssues(s);
        QCOMPARE(issues.size(), std::size_t{1});
        QCOMPARE(issues[0].field, std::string("airspace[0].area_m"));
        QCOMPARE(issues[0].message(),
                 std::string("the operation may enter the airspace \"D Somewhere\", which begins "
                             "at 0 m"));
    }
};

QTEST_APPLESS_MAIN(TestOperation)
#include "tst_operation.moc"
