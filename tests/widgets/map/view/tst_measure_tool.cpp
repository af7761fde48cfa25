#include "core/base/angles.h"
#include "tests/support/approx.h"
#include "tests/support/window/map_fixture.h"
#include "widgets/map/view/measure_tool.h"

#include <QSignalSpy>

using namespace berg;
using namespace Qt::StringLiterals;

/** Distances, bearings and times on the map. */
class TestMeasureTool : public QObject
{
    Q_OBJECT

private slots:
    void init()
    {
        QTest::failOnWarning(
            QRegularExpression(u"^(?!This plugin does not support propagateSizeHints)"_s));
    }

    /** From the origin the plane is exact: it is the definition of the projection. */
    void fromTheOriginLikeThePlane()
    {
        const Scenario scenario = test::emptySea();
        const MeasuredLeg leg = measureLeg(scenario, scenario.wind_mps, {0, 0}, {30000, 40000});
        COMPARE_NEAR(leg.length_m, 50000, 1e-6);
        COMPARE_NEAR(leg.bearing_deg, 36.8698976458, 1e-9);
        COMPARE_NEAR(leg.time_s.value(), 50000.0 / 22, 1e-6);
    }

    void degreesOfTheMeridian_data()
    {
        QTest::addColumn<double>("latitude_deg");
        QTest::addColumn<double>("length_m");
        // Lengths of a degree of the meridian centred there: WGS 84, a(1-e^2)/(1-e^2 sin^2)^1.5.
        QTest::newRow("equator") << 0.0 << 110574.3;
        QTest::newRow("47 N") << 47.0 << 111170.6;
        QTest::newRow("79 N") << 79.0 << 111652.0;
    }

    void degreesOfTheMeridian()
    {
        QFETCH(double, latitude_deg);
        QFETCH(double, length_m);
        Scenario scenario = test::emptySea();
        scenario.origin = {.latitude_deg = latitude_deg, .longitude_deg = 12};
        const LocalFrame plane(scenario.origin);
        // Beside the origin by two degrees, where plane and globe differ.
        const Point south_m =
            plane.toPlane({.latitude_deg = latitude_deg - 0.5, .longitude_deg = 14});
        const Point north_m =
            plane.toPlane({.latitude_deg = latitude_deg + 0.5, .longitude_deg = 14});
        const MeasuredLeg leg = measureLeg(scenario, scenario.wind_mps, south_m, north_m);
        COMPARE_NEAR(leg.length_m, length_m, 1.5); // the formula is of an arc at one latitude
        COMPARE_NEAR(std::remainder(leg.bearing_deg, 360), 0, 1e-7);
        COMPARE_NEAR(measureLeg(scenario, scenario.wind_mps, north_m, south_m).bearing_deg, 180,
                     1e-7);
    }

    /** The leg takes the short path across the antimeridian and over the pole. */
    void legIsTheShorterPath()
    {
        Scenario scenario = test::emptySea();
        scenario.origin = {.latitude_deg = 89.9, .longitude_deg = 180};
        const LocalFrame plane(scenario.origin);
        const Point over_m = plane.toPlane({.latitude_deg = 89.9, .longitude_deg = 0});
        // 0.2 degrees of the meridian at the pole, 111 694 m each.
        COMPARE_NEAR(measureLeg(scenario, scenario.wind_mps, {0, 0}, over_m).length_m, 0.2 * 111694,
                     1);
        const Point east_m = plane.toPlane({.latitude_deg = 80, .longitude_deg = -179});
        const Point west_m = plane.toPlane({.latitude_deg = 80, .longitude_deg = 179});
        QVERIFY(measureLeg(scenario, scenario.wind_mps, west_m, east_m).length_m < 40000);
    }

    void windCounts()
    {
        Scenario scenario = test::emptySea();
        scenario.wind_mps = {10, 0};
        COMPARE_NEAR(measureLeg(scenario, scenario.wind_mps, {0, 0}, {3200, 0}).time_s.value(), 100,
                     1e-6); // 32 m/s
        COMPARE_NEAR(measureLeg(scenario, scenario.wind_mps, {0, 0}, {-1200, 0}).time_s.value(),
                     100,
                     1e-6);          // 12 m/s
        scenario.wind_mps = {30, 0}; // faster than it flies
        QVERIFY(!measureLeg(scenario, scenario.wind_mps, {0, 0}, {3200, 0}).time_s);
        COMPARE_NEAR(measureLeg(scenario, scenario.wind_mps, {5, 5}, {5, 5}).length_m, 0, 1e-6);
    }

    void clicksDrawAndNothingIsStored()
    {
        test::MapFixture map;
        const Scenario before = map.scenario();
        map.view.tools().setKind(MapToolKind::Measure);
        const QImage empty = map.view.grab().toImage();
        for (const Point& place_m : {Point(2000, 1500), Point(3000, 1500), Point(2500, 2500)})
            map.click(map.pixelOf(place_m));
        QVERIFY(map.view.tools().isDrawing());
        const QImage drawn = map.view.grab().toImage();
        QVERIFY(drawn != empty);
        QTest::keyClick(&map.view, Qt::Key_Return); // ends the line, which stays
        QVERIFY(!map.view.tools().isDrawing());
        map.move({200, 200});
        QVERIFY(map.view.grab().toImage() != empty);
        QVERIFY(map.scenario() == before);
        QCOMPARE(map.undoCount(), 0);
        QTest::keyClick(&map.view, Qt::Key_Escape); // clears
        QVERIFY(map.view.tools().kind() == MapToolKind::Measure);
        QCOMPARE(map.view.grab().toImage(), empty);
        QTest::keyClick(&map.view, Qt::Key_Escape); // leaves
        QVERIFY(map.view.tools().kind() == MapToolKind::Select);
    }

    void backspaceRemovesPoints()
    {
        test::MapFixture map;
        map.document.edit(u"Before"_s, [](Scenario& s) { s.icebergs.pop_back(); });
        map.view.tools().setKind(MapToolKind::Measure);
        map.click(map.pixelOf({2000, 1500}));
        map.click(map.pixelOf({3000, 1500}));
        QTest::keyClick(&map.view, Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(map.view.tools().isDrawing());
        QTest::keyClick(&map.view, Qt::Key_Backspace);
        QVERIFY(!map.view.tools().isDrawing());
        QCOMPARE(map.undoIndex(), 1);
    }

    void measuresInFlight()
    {
        test::MapFixture map;
        map.view.setPicture(withScenario({}, map.scenario()));
        map.view.setLocked(true);
        map.view.tools().setKind(MapToolKind::Measure);
        QVERIFY(map.view.tools().kind() == MapToolKind::Measure);
        map.click(map.pixelOf({2000, 1500}));
        QVERIFY(map.view.tools().isDrawing());
        map.view.setLocked(false);
        QVERIFY(map.view.tools().isDrawing());
        map.document.reset(test::emptySea());
        QVERIFY(!map.view.tools().isDrawing());
    }
};

QTEST_MAIN(TestMeasureTool)
#include "tst_measure_tool.moc"
