#include "core/scenario/presets.h"
#include "tests/support/approx.h"
#include "tests/support/map_fixture.h"

#include <QContextMenuEvent>
#include <QNativeGestureEvent>
#include <QPointingDevice>
#include <QSignalSpy>
#include <QWheelEvent>

using namespace berg;
using namespace Qt::StringLiterals;
using Ids = std::vector<std::string>;

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

class TestMapWidget : public QObject
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
        map.view.panBy({4000, -3000});
        map.view.fit();
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
        map.view.zoomBy(factor, at);
        QVERIFY((map.view.view().scale_pxpm() > scale_pxpm) == (factor > 1));
        QVERIFY(QLineF(map.view.toScreen(before_m), at).length() < 1e-6);
    }

    void zoomEndsAtTheWholeRange()
    {
        test::MapFixture map;
        const QPointF middle = QRectF(map.view.rect()).center();
        map.view.zoomBy(1e-9, middle);
        const double scale_pxpm = map.view.view().scale_pxpm();
        QVERIFY(2 * kLargestCoordinate_m * scale_pxpm < map.view.width()); // all fits
        map.view.zoomBy(0.5, middle);
        COMPARE_NEAR(map.view.view().scale_pxpm(), scale_pxpm, 0);
        map.view.zoomBy(1e9, middle);
        map.view.zoomBy(2, middle);
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
        map.view.panBy({30, -20});
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
            map.view.panBy({1e6, 1e6});
        const Point middle_m = map.view.toWorld(QRectF(map.view.rect()).center());
        QVERIFY(middle_m.cwiseAbs().maxCoeff() <= kLargestCoordinate_m + 1e-3);
    }

    void viewStaysWhenThePictureChanges()
    {
        test::MapFixture map;
        map.view.zoomBy(2, {200, 200});
        const MapViewTransform before = map.view.view();
        map.view.setPicture(test::MapFixture::plainPicture());
        map.document.edit(u"Far"_s, [](Scenario& s) { s.icebergs[0].position_m = {9000, 9000}; });
        QVERIFY(map.view.view() == before);
        // Also when it was fitted and nobody has moved it since.
        map.view.fit();
        const MapViewTransform fitted = map.view.view();
        map.document.edit(u"Back"_s, [](Scenario& s) { s.icebergs[0].position_m = {0, 500}; });
        map.view.setPicture(test::MapFixture::plainPicture());
        QVERIFY(map.view.view() == fitted);
    }

    void anotherScenarioIsFitted()
    {
        test::MapFixture map;
        map.view.zoomBy(3, {10, 10});
        Scenario far = test::emptySea();
        far.uavs[0].position_m = {50000, 50000};
        test::addIceberg(far, 52000, 51000);
        map.document.reset(far);
        QVERIFY(map.view.rect().contains(map.iceberg(0)));
        map.view.setPicture(test::MapFixture::plainPicture());
        QVERIFY(map.view.rect().contains(map.iceberg(0)));
        QVERIFY(map.view.rect().contains(map.uav()));
    }

    void aNewSizeKeepsTheMiddleOrTheFit()
    {
        test::MapFixture map;
        map.view.resize(1400, 900);
        for (std::size_t i = 0; i < 4; ++i)
            QVERIFY(map.view.rect().contains(map.iceberg(i)));
        map.view.zoomBy(2, {300, 300});
        const Point middle_m = map.view.toWorld({700, 450});
        const double scale_pxpm = map.view.view().scale_pxpm();
        map.view.resize(800, 600);
        QVERIFY(apart_m(map.view.toWorld({400, 300}), middle_m) < 1e-6);
        COMPARE_NEAR(map.view.view().scale_pxpm(), scale_pxpm, 1e-12);
    }

    void followingKeepsTheUavInTheMiddlePart()
    {
        test::MapFixture map;
        const QSignalSpy follows(&map.view, &MapView::followUavChanged);
        map.view.setFollowUav(true);
        QVERIFY(QLineF(map.view.toScreen({0, 0}), {500, 350}).length() < 1e-6);
        map.view.setLocked(true);
        MapPicture picture = test::MapFixture::plainPicture();
        for (int i = 1; i <= 100; ++i) {
            picture.uav = MapUav{.position_m = {100.0 * i, 60.0 * i}};
            map.view.setPicture(picture);
            const QPointF at = map.view.toScreen(picture.uav->position_m);
            QVERIFY(QRectF(299, 209, 402, 282).contains(at));
        }
        map.view.panBy({5, 5}); // by hand: no longer following
        QCOMPARE(follows.count(), 2);
        QVERIFY(!map.view.followsUav());
        const MapViewTransform before = map.view.view();
        picture.uav->position_m = {-90000, 0};
        map.view.setPicture(picture);
        QVERIFY(map.view.view() == before);
    }

    void arrowsPanWithoutSelection()
    {
        test::MapFixture map;
        const QPointF before = map.view.toScreen({0, 0});
        QTest::keyClick(&map.view, Qt::Key_Right);
        const double step_px = before.x() - map.view.toScreen({0, 0}).x();
        QVERIFY(step_px > 0); // the view goes right, so the map goes left
        QTest::keyClick(&map.view, Qt::Key_Left);
        QTest::keyClick(&map.view, Qt::Key_Up, Qt::ShiftModifier);
        QVERIFY(map.view.toScreen({0, 0}).y() - before.y() > 2 * step_px);
        QCOMPARE(map.undoCount(), 0);
    }

    void keysZoomAndFit()
    {
        test::MapFixture map;
        const MapViewTransform fitted = map.view.view();
        QTest::keyClick(&map.view, Qt::Key_Plus);
        QVERIFY(map.view.view().scale_pxpm() > fitted.scale_pxpm());
        QTest::keyClick(&map.view, Qt::Key_Minus);
        COMPARE_NEAR(map.view.view().scale_pxpm(), fitted.scale_pxpm(), 1e-9);
        QTest::keyClick(&map.view, Qt::Key_Left);
        QTest::keyClick(&map.view, Qt::Key_F);
        QVERIFY(map.view.view() == fitted);
    }

    void keysSelectAndDelete()
    {
        test::MapFixture map;
        QTest::keyClick(&map.view, Qt::Key_A, Qt::ControlModifier);
        QCOMPARE(map.selection.ids(), (Ids{"berg-1", "berg-2", "berg-3", "berg-4"}));
        map.selection.set({"berg-2", "uav-1", "berg-4"});
        const Scenario before = map.scenario();
        QTest::keyClick(&map.view, Qt::Key_Delete);
        QCOMPARE(map.scenario().icebergs.size(), std::size_t{2});
        QCOMPARE(map.scenario().uavs.size(), std::size_t{1});
        QCOMPARE(map.selection.ids(), (Ids{"uav-1"}));
        QCOMPARE(map.undoCount(), 1);
        QTest::keyClick(&map.view, Qt::Key_Delete); // only the UAV is left in the selection
        QCOMPARE(map.undoCount(), 1);
        map.document.undoStack()->undo();
        QVERIFY(map.scenario() == before);
    }

    void escapeLeavesTheToolThenTheSelection()
    {
        test::MapFixture map;
        map.selection.set({"berg-1"});
        map.view.setTool(MapToolKind::Iceberg);
        QTest::keyClick(&map.view, Qt::Key_Escape);
        QVERIFY(map.view.tool() == MapToolKind::Select);
        QVERIFY(!map.selection.isEmpty());
        QTest::keyClick(&map.view, Qt::Key_Escape);
        QVERIFY(map.selection.isEmpty());
    }

    void cursorAndHoverAreTold()
    {
        test::MapFixture map;
        QSignalSpy moved(&map.view, &MapView::cursorMoved);
        QSignalSpy hovered(&map.view, &MapView::hovered);
        const QSignalSpy left(&map.view, &MapView::cursorLeft);
        const QPointF at(map.iceberg(2));
        QMouseEvent over(QEvent::MouseMove, at, map.view.mapToGlobal(at), Qt::NoButton,
                         Qt::NoButton, Qt::NoModifier);
        QCoreApplication::sendEvent(&map.view, &over);
        QVERIFY(!moved.isEmpty());
        const auto place_m = moved.last().at(0).value<Point>();
        QVERIFY(apart_m(place_m, map.view.toWorld(at)) < 1e-9);
        QCOMPARE(hovered.last().at(0).value<std::string>(), std::string("berg-3"));
        QEvent leave(QEvent::Leave);
        QCoreApplication::sendEvent(&map.view, &leave);
        QCOMPARE(left.count(), 1);
        QCOMPARE(hovered.last().at(0).value<std::string>(), std::string());
    }

    void doubleClickAsksToEdit()
    {
        test::MapFixture map;
        QSignalSpy asked(&map.view, &MapView::editRequested);
        QTest::mouseDClick(&map.view, Qt::LeftButton, {}, map.iceberg(1));
        QCOMPARE(asked.count(), 1);
        QCOMPARE(asked.last().at(0).value<std::string>(), std::string("berg-2"));
        QTest::mouseDClick(&map.view, Qt::LeftButton, {}, map.pixelOf({2500, 2000}));
        QCOMPARE(asked.count(), 1);
        QCOMPARE(map.undoCount(), 0);
    }

    void rightClickAsksForAMenu()
    {
        test::MapFixture map;
        QSignalSpy asked(&map.view, &MapView::contextMenuRequested);
        map.selection.set({"berg-1", "berg-2"});
        QTest::mouseClick(&map.view, Qt::RightButton, {}, map.iceberg(1));
        QCOMPARE(asked.count(), 1);
        QCOMPARE(asked.last().at(0).toPoint(), map.view.mapToGlobal(map.iceberg(1)));
        QCOMPARE(map.selection.ids().size(), std::size_t{2}); // on the selection: it stays
        QTest::mouseClick(&map.view, Qt::RightButton, {}, map.iceberg(2));
        QCOMPARE(map.selection.ids(), (Ids{"berg-3"}));
        // The menu key asks at the selection.
        QContextMenuEvent byKey(QContextMenuEvent::Keyboard, {}, {});
        QCoreApplication::sendEvent(&map.view, &byKey);
        QCOMPARE(asked.count(), 3);
        QVERIFY(apart_m(asked.last().at(1).value<Point>(), {1500, 3000}) < 1e-6);
    }

    /** An edit is on the map before any new picture comes; a stale picture does not undo it. */
    void editsAreSeenAtOnce()
    {
        test::MapFixture map;
        MapPicture old = withScenario(test::MapFixture::plainPicture(), map.scenario());
        old.plan = {2, 0, 3};
        map.view.setPicture(old);
        map.document.edit(u"Move"_s, [](Scenario& s) { s.icebergs[2].position_m = {2500, 2000}; });
        map.click(map.pixelOf({2500, 2000}));
        QCOMPARE(map.selection.ids(), (Ids{"berg-3"}));
        map.view.setPicture(old);
        map.selection.clear();
        map.click(map.pixelOf({2500, 2000}));
        QCOMPARE(map.selection.ids(), (Ids{"berg-3"}));
    }

    void planFollowsItsIcebergs()
    {
        Scenario scenario = test::MapFixture::fourIcebergs();
        MapPicture picture = withScenario({}, scenario);
        picture.plan = {2, 0, 3};
        scenario.icebergs.erase(scenario.icebergs.begin());
        scenario.icebergs[0].appears_s = 90;
        const MapPicture shown = withScenario(picture, scenario);
        QCOMPARE(shown.icebergs.size(), std::size_t{3});
        QCOMPARE(shown.plan, (std::vector<int>{1, 2})); // berg-3 and berg-4
        COMPARE_NEAR(shown.icebergs[0].appears_s, 90, 0);
    }

    void whatTheUavSeesIsCertain()
    {
        Scenario scenario = test::emptySea();
        test::addIceberg(scenario, 299, 0, 7);
        test::addIceberg(scenario, 301, 0, 7); // field of view 600 m: half of it
        const MapPicture shown = withScenario({}, scenario);
        QVERIFY(shown.icebergs[0].inView);
        COMPARE_NEAR(shown.icebergs[0].sigma_m2, 0, 0);
        QVERIFY(!shown.icebergs[1].inView);
        COMPARE_NEAR(shown.icebergs[1].sigma_m2, 7, 0);
    }

    /** Selection and highlight change pixels round their symbols and nowhere else. */
    void marksAreDrawn()
    {
        test::MapFixture map;
        const QImage plain = map.view.grab().toImage();
        const QRect round(map.iceberg(3) - QPoint(40, 40), QSize(80, 80));
        map.selection.set({"berg-4"});
        const QImage selected = map.view.grab().toImage();
        map.selection.clear();
        map.view.setHighlight("berg-4");
        const QImage marked = map.view.grab().toImage();
        QVERIFY(selected.copy(round) != plain.copy(round));
        QVERIFY(marked.copy(round) != plain.copy(round));
        QVERIFY(marked.copy(round) != selected.copy(round));
        const QRect elsewhere(map.iceberg(0) - QPoint(40, 40), QSize(80, 80));
        QCOMPARE(selected.copy(elsewhere), plain.copy(elsewhere));
        map.view.setHighlight({});
        QCOMPARE(map.view.grab().toImage(), plain);
    }

    void themesAreShown()
    {
        test::MapFixture map;
        map.view.setTheme(Theme::light());
        const QPoint water = map.pixelOf({2500, 1700});
        QCOMPARE(map.view.grab().toImage().pixelColor(water), Theme::light().sea);
        map.view.setTheme(Theme::dark());
        QCOMPARE(map.view.grab().toImage().pixelColor(water), Theme::dark().sea);
    }

    void isNamedForScreenReaders()
    {
        test::MapFixture map;
        QVERIFY(!map.view.accessibleName().isEmpty());
        QVERIFY(map.view.accessibleDescription().contains(u"4"_s));
    }

    /** Names stay where they are while the UAV passes: a moving map is calm. */
    void labelsStayWhileOnlyTheUavMoves()
    {
        MapScene scene;
        scene.setRect({0, 0, 1000, 700});
        MapPicture picture = withScenario({}, test::MapFixture::fourIcebergs());
        picture.uav->position_m = {-500, 2000};
        scene.setPicture(picture);
        scene.fit();
        const std::vector<PlacedLabel> before = scene.layout().labels;
        for (int i = 1; i <= 20; ++i) {
            picture.uav->position_m += Point(20, 0);
            scene.setPicture(picture);
            for (std::size_t k = 0; k < before.size(); ++k)
                QCOMPARE(scene.layout().labels[k].rect, before[k].rect);
        }
    }

    /** With too many names for one frame they keep their places until there is time. */
    void manyLabelsSettleLater()
    {
        Scenario scenario = test::emptySea();
        for (int i = 0; i < 100; ++i)
            test::addIceberg(scenario, 400.0 * (i % 10), 400.0 * (i / 10));
        MapScene scene;
        scene.setRect({0, 0, 1000, 700});
        scene.setPicture(withScenario({}, scenario));
        scene.fit();
        QVERIFY(!scene.layout().labels.empty());
        QVERIFY(!scene.isUnsettled());
        scene.setView(scene.view().moved({15, 0}));
        QVERIFY(!scene.layout().labels.empty());
        QVERIFY(scene.isUnsettled());
        scene.settle();
        QVERIFY(!scene.layout().labels.empty());
        QVERIFY(!scene.isUnsettled());
    }

    /** No frame waits for the names of a very full map: they come in parts and then stay. */
    void veryManyLabelsComeInParts()
    {
        constexpr int kSide = 20;
        Scenario scenario = test::emptySea();
        for (int i = 0; i < kSide * kSide; ++i)
            test::addIceberg(scenario, 400.0 * (i % kSide), 400.0 * (i / kSide));
        MapScene scene;
        scene.setRect({0, 0, 1600, 1200});
        scene.setPicture(withScenario({}, scenario));
        scene.fit();
        const auto shown = [&scene] {
            const std::vector<PlacedLabel>& labels = scene.layout().labels;
            return std::count_if(labels.begin(), labels.end(),
                                 [](const PlacedLabel& label) { return !label.rect.isNull(); });
        };
        auto before = shown();
        int parts = 1;
        for (; scene.isUnsettled() && parts < kSide * kSide; ++parts) {
            scene.settle();
            const auto now = shown();
            QVERIFY(now - before < kSide * kSide / 4);
            before = now;
        }
        QVERIFY(!scene.isUnsettled());
        QVERIFY(parts > 4);
        QVERIFY(before > 0);
        scene.setView(scene.view().moved({15, 0}));
        QVERIFY(std::abs(shown() - before) <= kSide * kSide / 4); // none has to come again
    }
};

QTEST_MAIN(TestMapWidget)
#include "tst_map_widget.moc"
