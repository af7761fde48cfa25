#include "core/presets/presets.h"
#include "tests/support/approx.h"
#include "tests/support/window/ids.h"
#include "tests/support/window/map_fixture.h"

#include <QContextMenuEvent>
#include <QSignalSpy>

using namespace berg;
using namespace Qt::StringLiterals;
using test::Ids;

namespace {

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
        map.view.tools().setKind(MapToolKind::Iceberg);
        QTest::keyClick(&map.view, Qt::Key_Escape);
        QVERIFY(map.view.tools().kind() == MapToolKind::Select);
        QVERIFY(!map.selection.isEmpty());
        QTest::keyClick(&map.view, Qt::Key_Escape);
        QVERIFY(map.selection.isEmpty());
    }

    void cursorAndHoverAreEmitted()
    {
        test::MapFixture map;
        QSignalSpy moved(&map.view, &MapView::cursorMoved);
        QSignalSpy hovered(&map.view.tools(), &MapToolbox::hoveredChanged);
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

    void planFollowsItsIcebergs()
    {
        Scenario scenario = test::MapFixture::fourIcebergs();
        MapPicture picture = withScenario({}, scenario);
        picture.routes[0].plan = {2, 0, 3};
        scenario.icebergs.erase(scenario.icebergs.begin());
        scenario.icebergs[0].appears_s = 90;
        const MapPicture shown = withScenario(picture, scenario);
        QCOMPARE(shown.icebergs.size(), std::size_t{3});
        QCOMPARE(shown.routes[0].plan, (MapPlaces{1, 2})); // berg-3 and berg-4
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
        picture.uavs[0].position_m = {-500, 2000};
        scene.setPicture(picture);
        scene.fit();
        const std::vector<PlacedLabel> before = scene.layout().labels;
        for (int i = 1; i <= 20; ++i) {
            picture.uavs[0].position_m += Point(20, 0);
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
