#include "core/presets/presets.h"
#include "tests/support/approx.h"
#include "tests/support/window/map_fixture.h"

#include <QNativeGestureEvent>
#include <QPointingDevice>
#include <QSignalSpy>
#include <QWheelEvent>

using namespace berg;
using namespace Qt::StringLiterals;

namespace {

/** Moves the wheel; `pixels` as touch pads report them, else null. */
void wheel(MapView& view, const QPointF& at, int eighths, const QPoint& pixels = {})
{
    QWheelEvent event(at, view.mapToGlobal(at), pixels, QPoint(0, eighths), Qt::NoButton,
                      Qt::NoModifier, Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(&view, &event);
}

/** Metres between the two places. */
double apart_m(const Point& a, const Point& b)
{
    return (a - b).norm();
}

} // namespace

/** Fit, zoom, pan and follow: what part of the world the map shows. */
class TestMapNavigation : public QObject
{
    Q_OBJECT

private slots:
    void init()
    {
        QTest::failOnWarning(
            QRegularExpression(u"^(?!This plugin does not support propagateSizeHints)"_s));
    }

    void worldAndScreenAreInverse()
    {
        const test::MapFixture map;
        for (const Point& p_m : {Point(0, 0), Point(-1234.5, 987.25), Point(1e6, -1e6)}) {
            // Rounding of doubles only.
            QVERIFY(apart_m(map.view.toWorld(map.view.toScreen(p_m)), p_m) < 1e-6);
        }
    }

    void fitShowsAllSymbolsInTheOpen_data()
    {
        QTest::addColumn<QSize>("size");
        QTest::newRow("design size") << QSize(1280, 800);
        QTest::newRow("small") << QSize(640, 400);
        QTest::newRow("tall") << QSize(500, 900);
    }

    void fitShowsAllSymbolsInTheOpen()
    {
        QFETCH(QSize, size);
        test::MapFixture map;
        map.view.resize(size);
        map.view.camera().panBy({4000, -3000});
        map.view.camera().fit();
        std::vector<QPoint> places = {map.uav()};
        for (std::size_t i = 0; i < 4; ++i)
            places.push_back(map.iceberg(i));
        for (const QPoint& at : places) {
            QVERIFY(map.view.rect().contains(at));
            // A click would go through no panel: it hits the symbol.
            map.click(at);
            QCOMPARE(map.selection.ids().size(), std::size_t{1});
            map.selection.clear();
        }
    }

    void fitKeepsClearOfPanels_data()
    {
        QTest::addColumn<QSize>("size");
        QTest::newRow("design size") << QSize(1280, 800);
        QTest::newRow("between docks") << QSize(900, 500);
        QTest::newRow("small") << QSize(640, 400);
    }

    void fitKeepsClearOfPanels()
    {
        QFETCH(QSize, size);
        MapPicture picture = withScenario({}, defaultScenario());
        picture.title = u"Grand Banks, 12 icebergs"_s;
        picture.readouts = {{.caption = u"Time"_s, .value = u"16:40"_s, .unit = {}}};
        MapScene scene;
        scene.setRect(QRectF(QPointF(0, 0), QSizeF(size)));
        scene.setPicture(picture);
        scene.fit();
        QVERIFY(scene.layout().overlays().size() >= 3);
        for (const QRectF& panel : scene.layout().overlays())
            for (const LabelDisk& symbol : scene.layout().icebergs)
                QVERIFY(!overlaps(panel, symbol));
    }

    void fitShowsTheRingsOfTheAsset()
    {
        test::MapFixture map;
        Asset rig{.name = "Rig", .position_m = {2500, 2000}, .range_m = 2500, .alarm_m = 1000};
        const double before_pxpm = map.view.view().scale_pxpm();
        map.document.edit(u"Asset"_s, [&](Scenario& scenario) { scenario.asset = rig; });
        map.view.camera().fit();
        for (const Point& towards : {Point(1, 0), Point(-1, 0), Point(0, 1), Point(0, -1)})
            QVERIFY(map.view.rect().contains(map.pixelOf(rig.position_m + rig.range_m * towards)));
        // A ring that reaches far beyond the icebergs does not make them too small.
        rig.range_m = 90000;
        map.document.edit(u"Asset"_s, [&](Scenario& scenario) { scenario.asset = rig; });
        map.view.camera().fit();
        QVERIFY(map.view.view().scale_pxpm() > 0.4 * before_pxpm);
    }

    void zoomKeepsThePlaceUnderTheCursor_data()
    {
        QTest::addColumn<double>("factor");
        QTest::newRow("in") << 1.7;
        QTest::newRow("out") << 0.4;
        QTest::newRow("far beyond the largest scale") << 1e9;
        QTest::newRow("far out") << 0.02;
    }

    void zoomKeepsThePlaceUnderTheCursor()
    {
        QFETCH(double, factor);
        test::MapFixture map;
        const QPointF at(300, 200);
        const Point before_m = map.view.toWorld(at);
        const double scale_pxpm = map.view.view().scale_pxpm();
        map.view.camera().zoomBy(factor, at);
        QVERIFY((map.view.view().scale_pxpm() > scale_pxpm) == (factor > 1));
        QVERIFY(QLineF(map.view.toScreen(before_m), at).length() < 1e-6);
    }

    void zoomEndsAtTheWholeRange()
    {
        test::MapFixture map;
        const QPointF middle = QRectF(map.view.rect()).center();
        map.view.camera().zoomBy(1e-9, middle);
        const double scale_pxpm = map.view.view().scale_pxpm();
        QVERIFY(2 * kLargestCoordinate_m * scale_pxpm < map.view.width()); // all fits
        map.view.camera().zoomBy(0.5, middle);
        COMPARE_NEAR(map.view.view().scale_pxpm(), scale_pxpm, 0);
        map.view.camera().zoomBy(1e9, middle);
        map.view.camera().zoomBy(2, middle);
        QVERIFY(map.view.view().scale_pxpm() <= 10); // a tenth of a metre for each pixel
        QVERIFY(!map.view.grab().isNull());
    }

    void wheelZoomsAtTheCursor_data()
    {
        QTest::addColumn<int>("eighths");
        QTest::addColumn<QPoint>("pixels");
        QTest::addColumn<bool>("isIn");
        QTest::newRow("one notch up") << 120 << QPoint() << true;
        QTest::newRow("one notch down") << -120 << QPoint() << false;
        QTest::newRow("high resolution, an eighth of a notch") << 15 << QPoint() << true;
        QTest::newRow("touch pad") << 120 << QPoint(0, 7) << true;
        QTest::newRow("spun hard") << 12000 << QPoint() << true;
    }

    void wheelZoomsAtTheCursor()
    {
        QFETCH(int, eighths);
        QFETCH(QPoint, pixels);
        QFETCH(bool, isIn);
        test::MapFixture map;
        const QPointF at(640, 310);
        const Point before_m = map.view.toWorld(at);
        const double scale_pxpm = map.view.view().scale_pxpm();
        wheel(map.view, at, eighths, pixels);
        const double factor = map.view.view().scale_pxpm() / scale_pxpm;
        QVERIFY((factor > 1) == isIn && factor != 1);
        QVERIFY(factor <= 4.0001); // one event never throws the map away
        QVERIFY(QLineF(map.view.toScreen(before_m), at).length() < 1e-6);
    }

    void eightEighthsOfANotchAreOneNotch()
    {
        test::MapFixture smooth;
        test::MapFixture notched;
        for (int i = 0; i < 8; ++i)
            wheel(smooth.view, {500, 300}, 15);
        wheel(notched.view, {500, 300}, 120);
        COMPARE_NEAR(smooth.view.view().scale_pxpm(), notched.view.view().scale_pxpm(), 1e-9);
    }

    void pinchZooms()
    {
        test::MapFixture map;
        const double scale_pxpm = map.view.view().scale_pxpm();
        const QPointF at(400, 300);
        const Point before_m = map.view.toWorld(at);
        QNativeGestureEvent event(Qt::ZoomNativeGesture, QPointingDevice::primaryPointingDevice(),
                                  2, at, at, map.view.mapToGlobal(at), 0.25, {});
        QCoreApplication::sendEvent(&map.view, &event);
        COMPARE_NEAR(map.view.view().scale_pxpm() / scale_pxpm, 1.25, 1e-9);
        QVERIFY(QLineF(map.view.toScreen(before_m), at).length() < 1e-6);
    }

    void panMovesTheMap()
    {
        test::MapFixture map;
        const QPointF before = map.view.toScreen({1500, 1000});
        map.view.camera().panBy({30, -20});
        COMPARE_NEAR(map.view.toScreen({1500, 1000}).x(), before.x() + 30, 1e-6);
        COMPARE_NEAR(map.view.toScreen({1500, 1000}).y(), before.y() - 20, 1e-6);
    }

    void middleDragPans()
    {
        test::MapFixture map;
        const QPointF before = map.view.toScreen({1500, 1000});
        QTest::mousePress(&map.view, Qt::MiddleButton, {}, {500, 400});
        map.move({530, 380});
        map.move({570, 410});
        QTest::mouseRelease(&map.view, Qt::MiddleButton, {}, {570, 410});
        COMPARE_NEAR(map.view.toScreen({1500, 1000}).x(), before.x() + 70, 1e-6);
        COMPARE_NEAR(map.view.toScreen({1500, 1000}).y(), before.y() + 10, 1e-6);
        QCOMPARE(map.undoCount(), 0);
    }

    void theMapCannotBeLost()
    {
        test::MapFixture map;
        for (int i = 0; i < 200; ++i)
            map.view.camera().panBy({1e6, 1e6});
        const Point middle_m = map.view.toWorld(QRectF(map.view.rect()).center());
        QVERIFY(middle_m.cwiseAbs().maxCoeff() <= kLargestCoordinate_m + 1e-3);
    }

    void viewStaysWhenThePictureChanges()
    {
        test::MapFixture map;
        map.view.camera().zoomBy(2, {200, 200});
        const MapViewTransform before = map.view.view();
        map.showScenario();
        map.document.edit(u"Far"_s, [](Scenario& s) { s.icebergs[0].position_m = {9000, 9000}; });
        QVERIFY(map.view.view() == before);
        // Also when it was fitted and nobody has moved it since.
        map.view.camera().fit();
        const MapViewTransform fitted = map.view.view();
        map.document.edit(u"Back"_s, [](Scenario& s) { s.icebergs[0].position_m = {0, 500}; });
        map.showScenario();
        QVERIFY(map.view.view() == fitted);
    }

    void anotherScenarioIsFitted()
    {
        test::MapFixture map;
        map.view.camera().zoomBy(3, {10, 10});
        Scenario far = test::emptySea();
        far.uavs[0].position_m = {50000, 50000};
        test::addIceberg(far, 52000, 51000);
        map.document.reset(far);
        QVERIFY(map.view.rect().contains(map.iceberg(0)));
        map.showScenario();
        QVERIFY(map.view.rect().contains(map.iceberg(0)));
        QVERIFY(map.view.rect().contains(map.uav()));
    }

    void aNewSizeKeepsTheMiddleOrTheFit()
    {
        test::MapFixture map;
        map.view.resize(1400, 900);
        for (std::size_t i = 0; i < 4; ++i)
            QVERIFY(map.view.rect().contains(map.iceberg(i)));
        map.view.camera().zoomBy(2, {300, 300});
        const Point middle_m = map.view.toWorld({700, 450});
        const double scale_pxpm = map.view.view().scale_pxpm();
        map.view.resize(800, 600);
        QVERIFY(apart_m(map.view.toWorld({400, 300}), middle_m) < 1e-6);
        COMPARE_NEAR(map.view.view().scale_pxpm(), scale_pxpm, 1e-12);
    }

    /** A panel that was moved to the middle part is not over it. */
    void followedUavIsBesideThePanels()
    {
        test::MapFixture map;
        MapPicture picture = test::MapFixture::plainPicture();
        picture.title = u"A scenario with a long name"_s;
        MapPanelStates panels;
        panels[static_cast<std::size_t>(MapPanel::Title)].moved_px = {300, 215};
        map.view.panels().setStates(panels);
        map.view.setLocked(true);
        map.view.setPicture(picture);
        map.view.camera().setFollowUav(true);
        for (const QPointF& at_px : {QPointF(330, 245), QPointF(400, 235), QPointF(310, 400)}) {
            picture.uavs = {MapUav{.position_m = map.view.toWorld(at_px)}};
            map.view.setPicture(picture);
            const QPointF at = map.view.toScreen(picture.uavs[0].position_m);
            QVERIFY(!QRectF(312, 227, 120, 20).contains(at)); // at least not below the title
        }
    }

    void followingKeepsTheUavInTheMiddlePart()
    {
        test::MapFixture map;
        const QSignalSpy follows(&map.view.camera(), &MapCamera::followUavChanged);
        map.view.camera().setFollowUav(true);
        QVERIFY(QLineF(map.view.toScreen({0, 0}), {500, 350}).length() < 1e-6);
        map.view.setLocked(true);
        MapPicture picture = test::MapFixture::plainPicture();
        for (int i = 1; i <= 100; ++i) {
            picture.uavs = {MapUav{.position_m = {100.0 * i, 60.0 * i}}};
            map.view.setPicture(picture);
            const QPointF at = map.view.toScreen(picture.uavs[0].position_m);
            QVERIFY(QRectF(299, 209, 402, 282).contains(at));
        }
        map.view.camera().panBy({5, 5}); // by hand: no longer following
        QCOMPARE(follows.count(), 2);
        QVERIFY(!map.view.camera().followsUav());
        const MapViewTransform before = map.view.view();
        picture.uavs[0].position_m = {-90000, 0};
        map.view.setPicture(picture);
        QVERIFY(map.view.view() == before);
    }
};

QTEST_MAIN(TestMapNavigation)
#include "tst_map_navigation.moc"
