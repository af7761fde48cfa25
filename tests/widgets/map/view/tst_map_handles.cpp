#include "core/base/angles.h"
#include "tests/support/approx.h"
#include "tests/support/window/ids.h"
#include "tests/support/window/map_fixture.h"
#include "widgets/map/view/map_handles.h"

#include <QSignalSpy>

using namespace berg;
using namespace Qt::StringLiterals;
using test::Ids;

namespace {

double heading_deg(const Point& path)
{
    return headingFromPsi(std::atan2(path.y(), path.x()));
}

struct HandleFixture : test::MapFixture
{
    /** Handles as the map has them: its own scene is not to be seen from outside. */
    [[nodiscard]] std::vector<MapHandle> handles()
    {
        MapScene scene;
        scene.setRect(QRectF(view.rect()));
        scene.setPicture(withScenario(plainPicture(), scenario()));
        scene.setView(view.view());
        scene.setLayers(view.layers());
        return handlesOf(scene, selection);
    }
    [[nodiscard]] QPoint handleOf(const std::string& id)
    {
        for (const MapHandle& handle : handles())
            if (handle.id == id)
                return handle.at_px.toPoint();
        qFatal("no handle of %s", id.c_str());
    }
    [[nodiscard]] Point velocity_mps(std::size_t i) const
    {
        return scenario().icebergs[i].velocity_mps;
    }
};

} // namespace

/** Drift and heading dragged out of what is selected. */
class TestMapHandles : public QObject
{
    Q_OBJECT

private slots:
    void init()
    {
        QTest::failOnWarning(
            QRegularExpression(u"^(?!This plugin does not support propagateSizeHints)"_s));
    }

    void onlySelectedObjectsHaveHandles()
    {
        HandleFixture map;
        QVERIFY(map.handles().empty());
        map.selection.set({"berg-1", "berg-3", "uav-1"});
        QCOMPARE(map.handles().size(), std::size_t{3});
    }

    /** At the tip of the arrow, so that a drag goes on where the arrow ends. */
    void theTipFollowsTheCursor()
    {
        HandleFixture map;
        map.selection.set({"berg-3"});
        const Scenario before = map.scenario();
        const QPoint from = map.handleOf("berg-3");
        map.press(from);
        for (int i = 1; i <= 20; ++i)
            map.move(from + QPoint(i, 2 * i));
        map.release(from + QPoint(20, 40));
        QCOMPARE(map.undoCount(), 1);
        QCOMPARE(map.document.undoStack()->undoText(), u"Change drift"_s);
        QVERIFY(map.scenario().icebergs[2].position_m == before.icebergs[2].position_m);
        const QPointF path = QPointF(from + QPoint(20, 40)) -
                             map.view.toScreen(map.scenario().icebergs[2].position_m);
        // Half a pixel of some dozens, and 1 mm/s of some tenths of a metre.
        COMPARE_NEAR(
            std::remainder(heading_deg(map.velocity_mps(2)) - heading_deg({path.x(), -path.y()}),
                           360),
            0, 1.5);
        map.document.undoStack()->undo();
        QVERIFY(map.scenario() == before);
    }

    /** The tip shown is that of a day, cut short; taken, the drift is still what it was. */
    void cappedArrowIsGrabbedAtItsTip()
    {
        HandleFixture map;
        MapLayers layers;
        layers.horizon_s = 86400;
        map.view.setLayers(layers);
        map.selection.set({"berg-3"});
        const double before_mps = map.velocity_mps(2).norm();
        const QPoint from = map.handleOf("berg-3");
        const QPointF centre = map.view.toScreen(map.scenario().icebergs[2].position_m);
        const QPointF along = (from - centre) / QLineF(centre, from).length();
        map.press(from);
        for (int i = 1; i <= 8; ++i) // beyond where a press becomes a drag
            map.move((from + i * along).toPoint());
        const double longer_mps = map.velocity_mps(2).norm();
        QVERIFY2(longer_mps > before_mps && longer_mps < before_mps + 0.2,
                 qPrintable(QString::number(longer_mps)));
        for (int i = 8; i >= 0; --i)
            map.move((from + i * along).toPoint());
        COMPARE_NEAR(map.velocity_mps(2).norm(), before_mps, 0.01);
        map.release(from);
    }

    void aStandingIcebergHasOneAtItsRim()
    {
        HandleFixture map;
        map.selection.set({"berg-1"});
        QVERIFY(map.velocity_mps(0).isZero(0));
        const QPoint from = map.handleOf("berg-1");
        map.drag(from, from + QPoint(50, 0));
        QVERIFY(map.velocity_mps(0).x() > 0);
        QCOMPARE(map.undoCount(), 1);
        // Back into the symbol: it stands still again.
        map.drag(map.handleOf("berg-1"), map.iceberg(0));
        QVERIFY(map.velocity_mps(0).isZero(0));
    }

    void currentIsNotPartOfTheDrift()
    {
        HandleFixture map;
        map.document.edit(u"Current"_s, [](Scenario& s) { s.current_mps = {0.3, -0.2}; });
        map.selection.set({"berg-1"}); // its arrow is the current
        const QPoint from = map.handleOf("berg-1");
        map.drag(from, map.iceberg(0));
        // The tip inside the symbol: at rest over its own water.
        QVERIFY(map.velocity_mps(0).isZero(0));
        map.drag(map.handleOf("berg-1"), map.iceberg(0) + QPoint(60, 0));
        const Point overGround_mps = map.velocity_mps(0) + Point(0.3, -0.2);
        COMPARE_NEAR(heading_deg(overGround_mps), 90, 1);
    }

    void allSelectedGetTheSameDrift()
    {
        HandleFixture map;
        map.selection.set({"berg-1", "berg-3", "uav-1"});
        const Scenario before = map.scenario();
        const QPoint from = map.handleOf("berg-3");
        map.drag(from, from + QPoint(-10, 60));
        QCOMPARE(map.undoCount(), 1);
        QCOMPARE(map.document.undoStack()->undoText(), u"Change drift of 2 icebergs"_s);
        QVERIFY(map.velocity_mps(0) == map.velocity_mps(2));
        QVERIFY(map.velocity_mps(2) != before.icebergs[2].velocity_mps);
        QVERIFY(map.scenario().icebergs[1] == before.icebergs[1]);
        QVERIFY(map.scenario().uavs == before.uavs);
        map.document.undoStack()->undo();
        QVERIFY(map.scenario() == before);
    }

    void shiftSnapsTheDirection()
    {
        HandleFixture map;
        map.selection.set({"berg-3"});
        const QPoint from = map.handleOf("berg-3");
        for (int i = 0; i < 8; ++i) {
            map.press(map.handleOf("berg-3"), Qt::ShiftModifier);
            const QPoint to = map.iceberg(2) + QPoint(40 + 5 * i, 17 * i - 60);
            QMouseEvent move(QEvent::MouseMove, to, map.view.mapToGlobal(to), Qt::NoButton,
                             Qt::LeftButton, Qt::ShiftModifier);
            QCoreApplication::sendEvent(&map.view, &move);
            map.release(to, Qt::ShiftModifier);
            const double off_deg = std::remainder(heading_deg(map.velocity_mps(2)), 15.0);
            COMPARE_NEAR(off_deg, 0, 0.5); // 1 mm/s of a few tenths of a metre per second
        }
        QVERIFY(from != map.handleOf("berg-3"));
    }

    void driftStaysWithinTheLimits()
    {
        HandleFixture map;
        map.view.camera().zoomBy(0.01, QRectF(map.view.rect()).center());
        map.selection.set({"berg-3"});
        map.drag(map.handleOf("berg-3"), {990, 690});
        QVERIFY(map.velocity_mps(2).cwiseAbs().maxCoeff() <= kLargestVelocity_mps);
        QVERIFY(!hasErrors(map.document.issues()));
    }

    void uavIsTurned()
    {
        HandleFixture map;
        map.selection.set({"uav-1"});
        const Scenario before = map.scenario();
        map.drag(map.handleOf("uav-1"), map.uav() + QPoint(0, -90));
        QCOMPARE(map.document.undoStack()->undoText(), u"Turn UAV"_s);
        COMPARE_NEAR(std::remainder(map.scenario().uavs[0].heading_deg, 360), 0, 1);
        QVERIFY(map.scenario().uavs[0].position_m == before.uavs[0].position_m);
        QCOMPARE(map.undoCount(), 1);
        map.document.undoStack()->undo();
        QVERIFY(map.scenario() == before);
    }

    void takenBack_data()
    {
        QTest::addColumn<bool>("byKey");
        QTest::newRow("Esc") << true;
        QTest::newRow("dropped outside") << false;
    }

    void takenBack()
    {
        QFETCH(bool, byKey);
        HandleFixture map;
        map.selection.set({"berg-3"});
        const Scenario before = map.scenario();
        const QPoint from = map.handleOf("berg-3");
        map.drag(from, from + QPoint(30, 50), {}, false);
        QVERIFY(!(map.scenario() == before));
        if (byKey)
            QTest::keyClick(&map.view, Qt::Key_Escape);
        map.release(QPoint(-30, 300));
        QVERIFY(map.scenario() == before);
        QCOMPARE(map.undoCount(), 0);
        QCOMPARE(map.selection.ids(), (Ids{"berg-3"}));
    }

    /** A press that goes nowhere selects what is under the handle, and changes nothing. */
    void aClickIsNoDrag()
    {
        HandleFixture map;
        map.document.edit(u"Near"_s, [](Scenario& s) {
            s.icebergs[1].position_m = s.icebergs[0].position_m + Point(0, 150);
        });
        map.selection.set({"berg-1"});
        const Scenario before = map.scenario();
        const QPoint at = map.handleOf("berg-1");
        map.drag(at, at + QPoint(2, 1));
        QVERIFY(map.scenario() == before);
        QCOMPARE(map.selection.ids(), (Ids{"berg-2"}));
    }

    void lockedMapHasNone()
    {
        HandleFixture map;
        map.selection.set({"berg-3"});
        const QPoint from = map.handleOf("berg-3");
        map.view.setPicture(withScenario({}, map.scenario()));
        map.view.setLocked(true);
        const Scenario before = map.scenario();
        map.drag(from, from + QPoint(30, 50));
        QVERIFY(map.scenario() == before);
    }

    void takeOffInADragTakesItBack()
    {
        HandleFixture map;
        map.selection.set({"berg-3"});
        const Scenario before = map.scenario();
        const QPoint from = map.handleOf("berg-3");
        map.drag(from, from + QPoint(30, 50), {}, false);
        map.view.setLocked(true);
        map.release(from + QPoint(30, 50));
        QVERIFY(map.scenario() == before);
    }

    void statusExplainsTheHandle()
    {
        HandleFixture map;
        QSignalSpy said(&map.view.tools(), &MapToolbox::statusText);
        map.selection.set({"berg-1", "berg-3"});
        map.move(map.handleOf("berg-3"));
        QVERIFY(!said.isEmpty());
        QCOMPARE(said.last().at(0).toString(),
                 u"Drag to give all 2 selected icebergs the same drift."_s);
        map.move(map.pixelOf({2500, 2000}));
        QVERIFY(said.last().at(0).toString().startsWith(u"Click to select"_s));
    }
};

QTEST_MAIN(TestMapHandles)
#include "tst_map_handles.moc"
