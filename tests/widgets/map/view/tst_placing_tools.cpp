#include "tests/support/approx.h"
#include "tests/support/window/ids.h"
#include "tests/support/window/map_fixture.h"

#include <QSignalSpy>

using namespace berg;
using namespace Qt::StringLiterals;
using test::Ids;

namespace {

const Point kWater_m(2500, 2000); ///< between the icebergs

} // namespace

/** Placing icebergs and the UAV, and setting drift and heading, on the map. */
class TestPlacingTools : public QObject
{
    Q_OBJECT

private slots:
    void init()
    {
        QTest::failOnWarning(
            QRegularExpression(u"^(?!This plugin does not support propagateSizeHints)"_s));
    }

    void clickAddsAnIceberg()
    {
        test::MapFixture map;
        const Scenario before = map.scenario();
        const QSignalSpy toolChanged(&map.view.tools(), &MapToolbox::kindChanged);
        map.view.tools().setKind(MapToolKind::Iceberg);
        QCOMPARE(toolChanged.count(), 1);
        map.click(map.pixelOf(kWater_m));
        QCOMPARE(map.scenario().icebergs.size(), std::size_t{5});
        const Iceberg& added = map.scenario().icebergs.back();
        QCOMPARE(added.id, std::string("berg-5"));
        QCOMPARE(added.sigma0_m2, errorOf(SightingSource::Radar).sigma_m2());
        QVERIFY(added.velocity_mps == Point::Zero());
        // A pixel is several metres.
        QVERIFY((added.position_m - kWater_m).norm() < 2 / map.view.view().scale_pxpm());
        QCOMPARE(map.selection.ids(), (Ids{"berg-5"}));
        QCOMPARE(map.undoCount(), 1);
        QCOMPARE(map.document.undoStack()->undoText(), u"Add iceberg"_s);
        QVERIFY(map.view.tools().kind() == MapToolKind::Iceberg); // stays until it is left
        map.click(map.pixelOf({2500, 2900}));
        QCOMPARE(map.undoCount(), 2);
        map.document.undoStack()->undo();
        map.document.undoStack()->undo();
        QVERIFY(map.scenario() == before);
        QVERIFY(map.selection.isEmpty());
    }

    void clickOnAnIcebergAddsNothing()
    {
        test::MapFixture map;
        map.view.tools().setKind(MapToolKind::Iceberg);
        map.click(map.iceberg(0));
        QCOMPARE(map.undoCount(), 0);
        QCOMPARE(map.selection.ids(), (Ids{"berg-1"}));
    }

    void enterAddsInTheMiddle()
    {
        test::MapFixture map;
        map.view.tools().setKind(MapToolKind::Iceberg);
        QTest::keyClick(&map.view, Qt::Key_Return);
        QCOMPARE(map.scenario().icebergs.size(), std::size_t{5});
        const QPointF at = map.view.toScreen(map.scenario().icebergs.back().position_m);
        QVERIFY(QLineF(at, QRectF(map.view.rect()).center()).length() < 1);
    }

    /** Press and drag: the tip of the map's drift arrow is where the button is let go. */
    void pressDragSetsTheDrift()
    {
        test::MapFixture map;
        map.document.edit(u"Current"_s, [](Scenario& s) { s.current_mps = {0.05, -0.02}; });
        const int steps = map.undoCount();
        map.view.tools().setKind(MapToolKind::Iceberg);
        const QPoint from = map.pixelOf(kWater_m);
        map.drag(from, from + QPoint(48, -36));
        QCOMPARE(map.undoCount(), steps + 1);
        const Point drift_mps = map.scenario().icebergs.back().velocity_mps + Point(0.05, -0.02);
        // 60 px at 37 degrees; the drift is rounded to 1 mm/s, some tenths of a degree.
        COMPARE_NEAR(std::atan2(drift_mps.y(), drift_mps.x()), std::atan2(36.0, 48.0), 0.01);
        QVERIFY(drift_mps.norm() > 0.05 && drift_mps.norm() < 5);
        QVERIFY(map.selection.contains("berg-5"));
    }

    void driftGrowsWithTheArrow()
    {
        std::vector<double> speeds_mps;
        for (const int length_px : {60, 100, 140}) {
            test::MapFixture map;
            map.view.tools().setKind(MapToolKind::Iceberg);
            const QPoint from = map.pixelOf(kWater_m);
            map.drag(from, from + QPoint(length_px, 0));
            speeds_mps.push_back(map.scenario().icebergs.back().velocity_mps.norm());
        }
        QVERIFY(speeds_mps[0] > 0);
        // Equal steps of the arrow are equal steps of speed, rounded to 1 mm/s.
        COMPARE_NEAR(speeds_mps[2] - speeds_mps[1], speeds_mps[1] - speeds_mps[0], 0.0021);
    }

    void driftStaysWithinTheLimits()
    {
        test::MapFixture map;
        map.view.camera().zoomBy(0.002, QRectF(map.view.rect()).center());
        map.view.tools().setKind(MapToolKind::Iceberg);
        const QPoint from(480, 200);
        map.drag(from, QPoint(990, 690));
        const Point drift_mps = map.scenario().icebergs.back().velocity_mps;
        QVERIFY(drift_mps.cwiseAbs().maxCoeff() <= kLargestVelocity_mps);
        QVERIFY(drift_mps.norm() > 0);
    }

    void dragFromAnIcebergChangesItsDrift()
    {
        test::MapFixture map;
        const Scenario before = map.scenario();
        map.view.tools().setKind(MapToolKind::Iceberg);
        map.drag(map.iceberg(0), map.iceberg(0) + QPoint(70, 0));
        QCOMPARE(map.undoCount(), 1);
        QCOMPARE(map.scenario().icebergs.size(), std::size_t{4});
        QVERIFY(map.scenario().icebergs[0].position_m == before.icebergs[0].position_m);
        QVERIFY(map.scenario().icebergs[0].velocity_mps.x() > 0);
        map.document.undoStack()->undo();
        QVERIFY(map.scenario() == before);
    }

    void escapeTakesAnIcebergBack()
    {
        test::MapFixture map;
        map.view.tools().setKind(MapToolKind::Iceberg);
        const QPoint from = map.pixelOf(kWater_m);
        map.drag(from, from + QPoint(70, 30), {}, false);
        QTest::keyClick(&map.view, Qt::Key_Escape);
        QVERIFY(map.view.tools().kind() == MapToolKind::Iceberg); // the first Esc is for the drag
        map.release(from + QPoint(70, 30));
        QCOMPARE(map.scenario().icebergs.size(), std::size_t{4});
        QCOMPARE(map.undoCount(), 0);
        QVERIFY(map.selection.isEmpty());
    }

    void clickPlacesTheUav()
    {
        test::MapFixture map;
        const Scenario before = map.scenario();
        map.view.tools().setKind(MapToolKind::Uav);
        map.click(map.pixelOf(kWater_m));
        QCOMPARE(map.undoCount(), 1);
        const Uav& uav = map.scenario().uavs.front();
        QVERIFY((uav.position_m - kWater_m).norm() < 2 / map.view.view().scale_pxpm());
        COMPARE_NEAR(uav.heading_deg, before.uavs.front().heading_deg, 0);
        map.document.undoStack()->undo();
        QVERIFY(map.scenario() == before);
    }

    void pressDragTurnsTheUav_data()
    {
        QTest::addColumn<QPoint>("path");
        QTest::addColumn<double>("heading_deg");
        QTest::newRow("north") << QPoint(0, -80) << 0.0;
        QTest::newRow("east") << QPoint(80, 0) << 90.0;
        QTest::newRow("south-west") << QPoint(-60, 60) << 225.0;
    }

    void pressDragTurnsTheUav()
    {
        QFETCH(QPoint, path);
        QFETCH(double, heading_deg);
        test::MapFixture map;
        const Scenario before = map.scenario();
        map.view.tools().setKind(MapToolKind::Uav);
        const QPoint from = map.pixelOf(kWater_m);
        map.drag(from, from + path);
        QCOMPARE(map.undoCount(), 1);
        COMPARE_NEAR(map.scenario().uavs.front().heading_deg, heading_deg, 0);
        map.document.undoStack()->undo();
        // From the UAV itself it turns on the spot. Its centre is up to half a pixel from where the
        // press can be, which over 80 px is half a degree.
        const Point place_m = before.uavs.front().position_m;
        map.drag(map.uav(), map.uav() + path);
        QVERIFY(map.scenario().uavs.front().position_m == place_m);
        const double off_deg =
            std::remainder(map.scenario().uavs.front().heading_deg - heading_deg, 360.0);
        QVERIFY(std::abs(off_deg) <= 1);
    }

    void aScenarioWithoutUavGetsOne()
    {
        test::MapFixture map;
        Scenario scenario = map.scenario();
        scenario.uavs.clear();
        map.document.reset(scenario);
        map.view.tools().setKind(MapToolKind::Uav);
        map.click(map.pixelOf(kWater_m));
        QCOMPARE(map.scenario().uavs.size(), std::size_t{1});
        QCOMPARE(map.scenario().uavs.front().id, std::string("uav-1"));
        QCOMPARE(map.selection.ids(), (Ids{"uav-1"}));
    }
};

QTEST_MAIN(TestPlacingTools)
#include "tst_placing_tools.moc"
