#include "tests/support/approx.h"
#include "tests/support/window/ids.h"
#include "tests/support/window/map_fixture.h"
#include "tests/support/window/panel_test.h"
#include "widgets/document/wind.h"
#include "widgets/map/paint/wind_panel.h"

#include <QSignalSpy>

using namespace berg;
using namespace berg::test;
using namespace Qt::StringLiterals;

namespace {

const Point kAsset_m(2500, 2000);
const Point kWater_m(2500, 3200);
constexpr double kPixel_m = 20; // more than a pixel of these maps is wide

/** A map in flight with spies on its signals. */
struct FlightFixture : MapFixture
{
    QSignalSpy winds{&view, &MapView::windEdited};
    QSignalSpy assets{&view, &MapView::assetMoved};
    QSignalSpy placed{&view, &MapView::icebergPlaced};
    QSignalSpy status{&view.tools(), &MapToolbox::statusText};
    Scenario flown;

    FlightFixture()
    {
        flown = scenario();
        flown.wind_mps = windOf(8, 250);
        flown.asset = Asset{.name = "Hibernia", .position_m = kAsset_m, .range_m = 2000};
        document.reset(flown);
        view.setPicture(withScenario(plainPicture(), flown));
        view.setLocked(true);
        view.setMayIntervene(true);
    }
    ~FlightFixture()
    {
        if (!(scenario() == flown) || undoCount() > 0)
            qFatal("the scenario was edited in flight");
    }

    [[nodiscard]] QPoint tip()
    {
        MapScene scene;
        scene.setRect(QRectF(view.rect()));
        scene.setPicture(withScenario(plainPicture(), flown));
        scene.setView(view.view());
        return windTip(scene.layout().wind, airOf(flown)).toPoint();
    }
    [[nodiscard]] QImage shown() { return view.grab().toImage(); }
    [[nodiscard]] bool isQuiet() const
    {
        return winds.isEmpty() && assets.isEmpty() && placed.isEmpty();
    }
};

} // namespace

/** Drags and clicks on a map in flight: drawn during the gesture, emitted at its end. */
class TestFlightDrag : public QObject
{
    Q_OBJECT

private slots:
    void init() { failOnWarnings(); }

    void windIsEmittedOnce()
    {
        FlightFixture map;
        const QPoint from = map.tip();
        const QImage before = map.shown();
        map.press(from);
        for (int i = 1; i <= 12; ++i)
            map.move(from + QPoint(-i, i));
        QVERIFY(map.isQuiet());
        QVERIFY(map.shown() != before); // the arrow follows
        map.release(from + QPoint(-12, 12));
        QCOMPARE(map.winds.count(), 1);
        const auto wind_mps = map.winds.front().front().value<Point>();
        QVERIFY(!wind_mps.isApprox(map.flown.wind_mps));
        QVERIFY(wind_mps.norm() < 22);
    }

    void takenBack_data()
    {
        QTest::addColumn<bool>("isWind");
        QTest::addColumn<bool>("byKey");
        QTest::newRow("wind, Esc") << true << true;
        QTest::newRow("wind, dropped outside") << true << false;
        QTest::newRow("asset, Esc") << false << true;
        QTest::newRow("asset, dropped outside") << false << false;
    }

    void takenBack()
    {
        QFETCH(bool, isWind);
        QFETCH(bool, byKey);
        FlightFixture map;
        const QPoint from = isWind ? map.tip() : map.pixelOf(kAsset_m);
        map.drag(from, from + QPoint(14, 25), {}, false);
        const QImage meanwhile = map.shown();
        if (byKey)
            QTest::keyClick(&map.view, Qt::Key_Escape);
        map.release(QPoint(-30, 300));
        QVERIFY(map.isQuiet());
        QVERIFY(map.shown() != meanwhile);
    }

    void assetPositionIsEmitted()
    {
        FlightFixture map;
        const QImage before = map.shown();
        const QPoint from = map.pixelOf(kAsset_m) + QPoint(3, -2); // not quite in its middle
        const Point to_m = kAsset_m + Point(600, 300);
        map.drag(from, map.pixelOf(to_m) + QPoint(3, -2), {}, false);
        QVERIFY(map.isQuiet());
        QVERIFY(map.shown() != before);
        map.release(map.pixelOf(to_m) + QPoint(3, -2));
        QCOMPARE(map.assets.count(), 1);
        QVERIFY((map.assets.front().front().value<Point>() - to_m).norm() < kPixel_m);
    }

    void clickIsNoDrag()
    {
        FlightFixture map;
        map.click(map.tip());
        map.click(map.pixelOf(kAsset_m));
        QVERIFY(map.isQuiet());
        QCOMPARE(map.selection.ids(), (Ids{kAssetKey}));
    }

    void nothingElseMoves()
    {
        FlightFixture map;
        map.drag(map.iceberg(0), map.iceberg(0) + QPoint(60, 40));
        map.drag(map.uav(), map.uav() + QPoint(60, 40));
        QVERIFY(map.isQuiet());
    }

    void icebergIsPlaced()
    {
        FlightFixture map;
        map.view.tools().setKind(MapToolKind::Iceberg);
        QVERIFY(map.view.tools().kind() == MapToolKind::Iceberg);
        QVERIFY(map.status.last().at(0).toString().contains(u"cannot be undone"_s));
        map.click(map.pixelOf(kWater_m));
        QCOMPARE(map.placed.count(), 1);
        const auto placed = map.placed.front().front().value<Iceberg>();
        QVERIFY((placed.position_m - kWater_m).norm() < kPixel_m);
        QCOMPARE(placed.sigma0_m2, errorOf(SightingSource::Radar).sigma_m2());
        QVERIFY(placed.velocity_mps.isZero(0));
        map.click(map.pixelOf(kWater_m));
        QCOMPARE(map.placed.count(), 2);
    }

    void icebergIsPlacedWithItsDrift()
    {
        FlightFixture map;
        map.view.tools().setKind(MapToolKind::Iceberg);
        const QImage before = map.shown();
        const QPoint at = map.pixelOf(kWater_m);
        map.drag(at, at + QPoint(50, 0), {}, false);
        QVERIFY(map.isQuiet());
        QVERIFY(map.shown() != before);
        map.release(at + QPoint(50, 0));
        QCOMPARE(map.placed.count(), 1);
        const auto placed = map.placed.front().front().value<Iceberg>();
        QVERIFY(placed.velocity_mps.x() > 0.05);
        QVERIFY(std::abs(placed.velocity_mps.y()) < 0.05 * placed.velocity_mps.x());
        map.drag(at, at + QPoint(50, 0), {}, false);
        QTest::keyClick(&map.view, Qt::Key_Escape);
        map.release(at + QPoint(50, 0));
        QCOMPARE(map.placed.count(), 1);
    }

    void icebergToolSelectsExistingIcebergs()
    {
        FlightFixture map;
        map.view.tools().setKind(MapToolKind::Iceberg);
        map.drag(map.iceberg(1), map.iceberg(1) + QPoint(50, 20));
        QVERIFY(map.isQuiet());
        QCOMPARE(map.selection.ids(), (Ids{"berg-2"}));
    }

    /** Also by keys, for whoever has no mouse. */
    void enterPlacesOneInTheMiddle()
    {
        FlightFixture map;
        map.view.camera().panBy({90, 60}); // moves the asset out of the place clicked
        map.view.tools().setKind(MapToolKind::Iceberg);
        QTest::keyClick(&map.view, Qt::Key_Return);
        QCOMPARE(map.placed.count(), 1);
    }

    /** While looking back, or at the end. */
    void nothingIsDraggedIfInterventionIsImpossible()
    {
        FlightFixture map;
        map.view.setMayIntervene(false);
        const QPoint tip = map.tip();
        map.drag(tip, tip + QPoint(10, 10));
        map.drag(map.pixelOf(kAsset_m), map.pixelOf(kAsset_m) + QPoint(50, 50));
        QVERIFY(map.isQuiet());
    }

    void lookingBackEndsADrag()
    {
        FlightFixture map;
        const QPoint tip = map.tip();
        map.drag(tip, tip + QPoint(10, 10), {}, false);
        map.view.setMayIntervene(false);
        map.release(tip + QPoint(10, 10));
        QVERIFY(map.isQuiet());
    }

    void landingEndsADrag()
    {
        FlightFixture map;
        const QPoint tip = map.tip();
        map.drag(tip, tip + QPoint(10, 10), {}, false);
        map.view.setMayIntervene(false);
        map.view.setLocked(false);
        map.release(tip + QPoint(10, 10));
        QVERIFY(map.isQuiet());
    }
};

QTEST_MAIN(TestFlightDrag)
#include "tst_flight_drag.moc"
