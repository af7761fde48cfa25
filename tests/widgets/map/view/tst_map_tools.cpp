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

class TestMapTools : public QObject
{
    Q_OBJECT

private slots:
    void init()
    {
        QTest::failOnWarning(
            QRegularExpression(u"^(?!This plugin does not support propagateSizeHints)"_s));
    }

    void clickSelectsAndClears()
    {
        test::MapFixture map;
        map.click(map.iceberg(0));
        QCOMPARE(map.selection.ids(), (Ids{"berg-1"}));
        map.click(map.iceberg(3));
        QCOMPARE(map.selection.ids(), (Ids{"berg-4"}));
        map.click(map.uav());
        QCOMPARE(map.selection.ids(), (Ids{"uav-1"}));
        map.click(map.pixelOf(kWater_m));
        QVERIFY(map.selection.isEmpty());
        QCOMPARE(map.undoCount(), 0);
    }

    void modifiersToggle_data()
    {
        QTest::addColumn<Qt::KeyboardModifiers>("keys");
        QTest::newRow("Ctrl") << Qt::KeyboardModifiers(Qt::ControlModifier);
        QTest::newRow("Shift") << Qt::KeyboardModifiers(Qt::ShiftModifier);
    }

    void modifiersToggle()
    {
        QFETCH(Qt::KeyboardModifiers, keys);
        test::MapFixture map;
        map.click(map.iceberg(0));
        map.click(map.iceberg(1), keys);
        map.click(map.uav(), keys);
        QCOMPARE(map.selection.ids(), (Ids{"berg-1", "berg-2", "uav-1"}));
        map.click(map.iceberg(0), keys);
        QCOMPARE(map.selection.ids(), (Ids{"berg-2", "uav-1"}));
        map.click(map.pixelOf(kWater_m), keys); // missed: nothing is lost
        QCOMPARE(map.selection.ids(), (Ids{"berg-2", "uav-1"}));
        map.click(map.iceberg(1)); // one of several, without the key: this one alone
        QCOMPARE(map.selection.ids(), (Ids{"berg-2"}));
    }

    void dragIsOneUndoStep()
    {
        test::MapFixture map;
        const Scenario before = map.scenario();
        const QPoint from = map.iceberg(2);
        map.press(from);
        for (int i = 1; i <= 25; ++i)
            map.move(from + QPoint(3 * i, -2 * i));
        map.release(from + QPoint(75, -50));
        QCOMPARE(map.undoCount(), 1);
        QVERIFY(QLineF(map.iceberg(2), from + QPoint(75, -50)).length() < 2);
        QCOMPARE(map.selection.ids(), (Ids{"berg-3"}));
        QVERIFY(map.scenario().icebergs[0] == before.icebergs[0]);
        const Scenario after = map.scenario();
        map.document.undoStack()->undo();
        QVERIFY(map.scenario() == before);
        map.document.undoStack()->redo();
        QVERIFY(map.scenario() == after);
    }

    void twoDragsAreTwoSteps()
    {
        test::MapFixture map;
        map.drag(map.iceberg(0), map.iceberg(0) + QPoint(40, 20));
        map.drag(map.iceberg(0), map.iceberg(0) + QPoint(40, 20));
        QCOMPARE(map.undoCount(), 2);
    }

    void wholeSelectionMoves()
    {
        test::MapFixture map;
        const Scenario before = map.scenario();
        map.selection.set({"berg-1", "berg-4", "uav-1"});
        map.drag(map.iceberg(3), map.iceberg(3) + QPoint(-50, 35));
        QCOMPARE(map.undoCount(), 1);
        const Point path_m = map.scenario().icebergs[3].position_m - before.icebergs[3].position_m;
        QVERIFY(path_m.norm() > 100);
        // Same offset for all; the tolerance is for rounding of doubles only.
        const auto moved = [&](const Point& now_m, const Point& was_m) {
            return (now_m - was_m - path_m).norm() < 1e-9;
        };
        QVERIFY(moved(map.scenario().icebergs[0].position_m, before.icebergs[0].position_m));
        QVERIFY(moved(map.scenario().uavs[0].position_m, before.uavs[0].position_m));
        QVERIFY(map.scenario().icebergs[1] == before.icebergs[1]);
        map.document.undoStack()->undo();
        QVERIFY(map.scenario() == before);
    }

    void undoTextsCount_data()
    {
        QTest::addColumn<QStringList>("ids");
        QTest::addColumn<QString>("text");
        QTest::newRow("iceberg") << QStringList{u"berg-1"_s} << u"Move iceberg"_s;
        QTest::newRow("icebergs") << QStringList{u"berg-1"_s, u"berg-2"_s} << u"Move 2 icebergs"_s;
        QTest::newRow("UAV") << QStringList{u"uav-1"_s} << u"Move UAV"_s;
        QTest::newRow("both") << QStringList{u"berg-1"_s, u"uav-1"_s} << u"Move 2 objects"_s;
    }

    void undoTextsCount()
    {
        QFETCH(QStringList, ids);
        QFETCH(QString, text);
        test::MapFixture map;
        Ids selected;
        for (const QString& id : ids)
            selected.push_back(id.toStdString());
        map.selection.set(selected);
        map.view.edits().nudge(10, 0);
        QCOMPARE(map.document.undoStack()->undoText(), text);
    }

    void belowTheThresholdNothingMoves()
    {
        test::MapFixture map;
        const Scenario before = map.scenario();
        const QPoint at = map.iceberg(1);
        const int almost = QApplication::startDragDistance() - 1;
        map.drag(at, at + QPoint(almost, 0));
        QVERIFY(map.scenario() == before);
        QCOMPARE(map.undoCount(), 0);
        QCOMPARE(map.selection.ids(), (Ids{"berg-2"}));
    }

    void escapeTakesADragBack()
    {
        test::MapFixture map;
        const Scenario before = map.scenario();
        const QPoint from = map.iceberg(1);
        map.drag(from, from + QPoint(70, 40), {}, false);
        QVERIFY(!(map.scenario() == before)); // plans follow while it is dragged
        QTest::keyClick(&map.view, Qt::Key_Escape);
        QVERIFY(map.scenario() == before);
        map.move(from + QPoint(90, 60)); // the button is still down, but means nothing now
        map.release(from + QPoint(90, 60));
        QVERIFY(map.scenario() == before);
        QCOMPARE(map.undoCount(), 0);
        QVERIFY(map.document.isClean());
    }

    /** Redo is still possible after a cancelled drag. */
    void cancelledDragKeepsRedo()
    {
        test::MapFixture map;
        map.drag(map.iceberg(0), map.iceberg(0) + QPoint(40, 40));
        const Scenario moved = map.scenario();
        map.document.undoStack()->undo();
        const Scenario before = map.scenario();
        const QPoint from = map.iceberg(1);
        map.drag(from, from + QPoint(70, 40), {}, false);
        // Seen although it is not in the document yet: the symbol is under the cursor.
        QVERIFY(map.scenario() == before);
        const QImage dragged = map.view.grab().toImage();
        QTest::keyClick(&map.view, Qt::Key_Escape);
        QVERIFY(map.view.grab().toImage() != dragged);
        map.release(from + QPoint(70, 40));
        QVERIFY(map.document.undoStack()->canRedo());
        map.document.undoStack()->redo();
        QVERIFY(map.scenario() == moved);
    }

    /** With something to redo a finished drag is one step all the same. */
    void aFinishedDragReplacesRedo()
    {
        test::MapFixture map;
        map.drag(map.iceberg(0), map.iceberg(0) + QPoint(40, 40));
        map.document.undoStack()->undo();
        const Scenario before = map.scenario();
        map.drag(map.iceberg(1), map.iceberg(1) + QPoint(50, 30));
        QCOMPARE(map.undoCount(), 1);
        QVERIFY(!map.document.undoStack()->canRedo());
        QVERIFY(!(map.scenario().icebergs[1] == before.icebergs[1]));
        map.document.undoStack()->undo();
        QVERIFY(map.scenario() == before);
    }

    void dropOutsideTakesBack_data()
    {
        QTest::addColumn<QPoint>("outside");
        QTest::newRow("left") << QPoint(-30, 300);
        QTest::newRow("below") << QPoint(500, 760);
        QTest::newRow("right and above") << QPoint(1100, -5);
    }

    void dropOutsideTakesBack()
    {
        QFETCH(QPoint, outside);
        test::MapFixture map;
        const Scenario before = map.scenario();
        map.drag(map.iceberg(1), outside);
        QVERIFY(map.scenario() == before);
        QCOMPARE(map.undoCount(), 0);
    }

    void anotherButtonTakesBack()
    {
        test::MapFixture map;
        const Scenario before = map.scenario();
        const QSignalSpy menu(&map.view, &MapView::contextMenuRequested);
        const QPoint from = map.iceberg(1);
        map.drag(from, from + QPoint(70, 40), {}, false);
        QTest::mouseClick(&map.view, Qt::RightButton, {}, from + QPoint(70, 40));
        map.release(from + QPoint(70, 40));
        QVERIFY(map.scenario() == before);
        QCOMPARE(map.undoCount(), 0);
        QCOMPARE(menu.count(), 0);
    }

    /** Events that end a sequence of nudges do not split a drag. */
    void dragIsAlwaysOneUndoStep()
    {
        test::MapFixture map;
        const QPoint from = map.iceberg(1);
        map.drag(from, from + QPoint(40, 20), {}, false);
        map.view.clearFocus();
        map.move(from + QPoint(50, 30));
        map.selection.set({"berg-2", "berg-3"});
        QTest::mousePress(&map.view, Qt::MiddleButton, {}, from + QPoint(50, 30));
        QTest::mouseRelease(&map.view, Qt::MiddleButton, {}, from + QPoint(50, 30));
        map.move(from + QPoint(60, 40));
        map.release(from + QPoint(60, 40));
        QCOMPARE(map.undoCount(), 1);
    }

    /** Ctrl+Z in the middle of a drag undoes the drag and ends it. */
    void undoInADragEndsIt()
    {
        test::MapFixture map;
        const Scenario before = map.scenario();
        const QPoint from = map.iceberg(1);
        map.drag(from, from + QPoint(70, 40), {}, false);
        map.document.undoStack()->undo();
        QVERIFY(map.scenario() == before);
        map.move(from + QPoint(90, 50));
        map.release(from + QPoint(90, 50));
        QVERIFY(map.scenario() == before);
    }

    void openingInADragEndsIt()
    {
        test::MapFixture map;
        const QPoint from = map.iceberg(1);
        map.drag(from, from + QPoint(70, 40), {}, false);
        Scenario other = test::emptySea();
        test::addIceberg(other, 700, 700);
        map.document.reset(other);
        map.move(from + QPoint(90, 50));
        map.release(from + QPoint(90, 50));
        QVERIFY(map.scenario() == other);
        QCOMPARE(map.undoCount(), 0);
    }

    void foreignChangeEndsThePressedAction_data()
    {
        QTest::addColumn<MapToolKind>("tool");
        QTest::addColumn<Point>("pressed_m");
        const Point iceberg_m(1500, 1000);
        const Point corner_m(500, 500);
        const Point edge_m(2500, 500);
        QTest::newRow("select an iceberg") << MapToolKind::Select << iceberg_m;
        QTest::newRow("select a corner") << MapToolKind::Select << corner_m;
        QTest::newRow("select water") << MapToolKind::Select << kWater_m;
        QTest::newRow("drift of an iceberg") << MapToolKind::Iceberg << iceberg_m;
        QTest::newRow("new iceberg") << MapToolKind::Iceberg << kWater_m;
        QTest::newRow("UAV") << MapToolKind::Uav << kWater_m;
        QTest::newRow("asset") << MapToolKind::Asset << kWater_m;
        QTest::newRow("corner") << MapToolKind::Area << corner_m;
        QTest::newRow("edge") << MapToolKind::Area << edge_m;
        QTest::newRow("measure") << MapToolKind::Measure << kWater_m;
        QTest::newRow("pan") << MapToolKind::Pan << kWater_m;
    }

    /** Whatever is pressed may be gone. */
    void foreignChangeEndsThePressedAction()
    {
        QFETCH(MapToolKind, tool);
        QFETCH(Point, pressed_m);
        test::MapFixture map;
        map.document.edit(u"Area"_s, [](Scenario& s) {
            s.area_m = {{500, 500}, {4500, 500}, {4500, 3500}, {500, 3500}};
        });
        map.selection.set({kAreaKey});
        map.view.tools().setKind(tool);
        const QPoint from = map.pixelOf(pressed_m);
        map.press(from);
        map.document.edit(u"Empty sea"_s, [](Scenario& s) {
            s.icebergs.clear();
            s.area_m.clear();
            s.asset.reset();
        });
        const Scenario emptied = map.scenario();
        const MapViewTransform view = map.view.view();
        const Ids selected = map.selection.ids();
        map.move(from + QPoint(30, 20));
        map.move(from + QPoint(60, 40));
        map.release(from + QPoint(60, 40));
        QVERIFY(map.scenario() == emptied);
        QCOMPARE(map.view.toScreen(kWater_m), view.toPixel(kWater_m));
        QCOMPARE(map.selection.ids(), selected);
    }

    void boxSelectsItsContent()
    {
        test::MapFixture map;
        map.selection.set({"berg-2"});
        const QPoint corner = map.pixelOf({1000, 3400});
        map.drag(corner, map.pixelOf({1900, 600}));
        QCOMPARE(map.selection.ids(), (Ids{"berg-1", "berg-3"}));
        map.drag(map.pixelOf({4000, 3500}), map.pixelOf({3000, 2600}), Qt::ControlModifier);
        QCOMPARE(map.selection.ids(), (Ids{"berg-1", "berg-3", "berg-4"}));
        QCOMPARE(map.undoCount(), 0);
    }

    void escapeTakesARubberBandBack()
    {
        test::MapFixture map;
        map.selection.set({"berg-2"});
        map.drag(map.pixelOf({1000, 3400}), map.pixelOf({1900, 600}), {}, false);
        QCOMPARE(map.selection.ids(), (Ids{"berg-1", "berg-3"}));
        QTest::keyClick(&map.view, Qt::Key_Escape);
        QCOMPARE(map.selection.ids(), (Ids{"berg-2"}));
        map.release(map.pixelOf({1900, 600}));
        QCOMPARE(map.selection.ids(), (Ids{"berg-2"}));
    }

    void lockedMapEditsNothing()
    {
        test::MapFixture map;
        map.view.tools().setKind(MapToolKind::Iceberg);
        map.view.setPicture(withScenario({}, map.scenario())); // in flight the picture is all
        map.view.setLocked(true);
        QVERIFY(map.view.tools().kind() == MapToolKind::Select);
        const Scenario before = map.scenario();
        map.click(map.iceberg(2));
        QCOMPARE(map.selection.ids(), (Ids{"berg-3"}));
        map.drag(map.iceberg(2), map.iceberg(2) + QPoint(60, 40));
        map.view.edits().nudge(10, 10);
        map.view.edits().deleteSelected();
        QTest::keyClick(&map.view, Qt::Key_Delete);
        QTest::keyClick(&map.view, Qt::Key_Up);
        map.view.tools().setKind(MapToolKind::Uav);
        QVERIFY(map.view.tools().kind() == MapToolKind::Select);
        map.click(map.pixelOf(kWater_m));
        QVERIFY(map.scenario() == before);
        QCOMPARE(map.undoCount(), 0);
        map.view.setLocked(false);
        map.drag(map.iceberg(2), map.iceberg(2) + QPoint(60, 40));
        QCOMPARE(map.undoCount(), 1);
    }

    void takeOffInADragTakesItBack()
    {
        test::MapFixture map;
        const Scenario before = map.scenario();
        const QPoint from = map.iceberg(1);
        map.drag(from, from + QPoint(70, 40), {}, false);
        map.view.setLocked(true);
        QVERIFY(map.scenario() == before);
        map.release(from + QPoint(70, 40));
        QCOMPARE(map.undoCount(), 0);
    }

    void nudgesMergeWhileTheyFollowEachOther()
    {
        test::MapFixture map;
        const Scenario before = map.scenario();
        map.selection.set({"berg-1", "berg-2"});
        for (int i = 0; i < 5; ++i)
            QTest::keyClick(&map.view, Qt::Key_Right);
        QTest::keyClick(&map.view, Qt::Key_Up, Qt::ShiftModifier);
        QCOMPARE(map.undoCount(), 1);
        const Point path_m = map.scenario().icebergs[0].position_m - before.icebergs[0].position_m;
        QVERIFY(path_m.x() > 0);
        COMPARE_NEAR(path_m.y(), 2 * path_m.x(), 1e-9); // one step of ten, five of one
        map.selection.set({"berg-3"});
        QTest::keyClick(&map.view, Qt::Key_Right);
        QCOMPARE(map.undoCount(), 2);
        map.document.undoStack()->undo();
        map.document.undoStack()->undo();
        QVERIFY(map.scenario() == before);
    }

    void panToolMovesTheMapOnly()
    {
        test::MapFixture map;
        const Scenario before = map.scenario();
        map.view.tools().setKind(MapToolKind::Pan);
        const QPointF corner = map.view.toScreen({0, 0});
        map.drag(map.iceberg(2), map.iceberg(2) + QPoint(50, 20));
        COMPARE_NEAR(map.view.toScreen({0, 0}).x(), corner.x() + 50, 1e-6);
        COMPARE_NEAR(map.view.toScreen({0, 0}).y(), corner.y() + 20, 1e-6);
        QVERIFY(map.scenario() == before);
        QCOMPARE(map.undoCount(), 0);
    }

    void positionsStayInRange()
    {
        test::MapFixture map;
        map.view.camera().zoomBy(1e-9,
                                 QRectF(map.view.rect()).center()); // the whole range and more
        map.view.tools().setKind(MapToolKind::Iceberg);
        map.click({985, 300});
        const Iceberg& added = map.scenario().icebergs.back();
        QVERIFY(added.position_m.cwiseAbs().maxCoeff() <= kLargestCoordinate_m);
        QVERIFY(map.document.issues().empty() || !hasErrors(map.document.issues()));
    }

    void toolsExplainTheNextStep()
    {
        test::MapFixture map;
        QSignalSpy said(&map.view.tools(), &MapToolbox::statusText);
        QSet<QString> texts;
        for (const MapToolKind kind :
             {MapToolKind::Iceberg, MapToolKind::Uav, MapToolKind::Pan, MapToolKind::Select}) {
            map.view.tools().setKind(kind);
            QVERIFY(!said.isEmpty());
            texts.insert(said.last().at(0).toString());
        }
        QCOMPARE(texts.size(), 4);
        QVERIFY(!texts.contains(QString()));
    }
};

QTEST_MAIN(TestMapTools)
#include "tst_map_tools.moc"
