#include "core/geometry/geometry.h"
#include "tests/support/window/ids.h"
#include "tests/support/window/map_fixture.h"

#include <QSignalSpy>

using namespace berg;
using namespace Qt::StringLiterals;
using test::Ids;

namespace {

const std::vector<Point> kSquare_m{{2000, 1500}, {3000, 1500}, {3000, 2500}, {2000, 2500}};

/** Most that a click can be away from where it was meant: a pixel of these maps. */
constexpr double kPixel_m = 20;

struct AreaFixture : test::MapFixture
{
    QSignalSpy said{&view.tools(), &MapToolbox::statusText};

    explicit AreaFixture(MapToolKind kind = MapToolKind::Area) { view.tools().setKind(kind); }

    void clickAll(const std::vector<Point>& corners_m)
    {
        for (const Point& corner_m : corners_m)
            click(pixelOf(corner_m));
    }
    void draw()
    {
        clickAll(kSquare_m);
        QTest::keyClick(&view, Qt::Key_Return);
    }
    [[nodiscard]] const std::vector<Point>& area_m() const { return scenario().area_m; }
    [[nodiscard]] QString status() const
    {
        return said.isEmpty() ? QString() : said.last().at(0).toString();
    }
    [[nodiscard]] QString undoText() const { return document.undoStack()->undoText(); }
    void key(Qt::Key which, Qt::KeyboardModifiers keys = {})
    {
        QTest::keyClick(&view, which, keys);
    }
};

bool isNear(const std::vector<Point>& area_m, const std::vector<Point>& wanted_m)
{
    return std::equal(area_m.begin(), area_m.end(), wanted_m.begin(), wanted_m.end(),
                      [](const Point& a, const Point& b) { return (a - b).norm() < kPixel_m; });
}

} // namespace

/** Drawing the area of a scenario on the map and changing its outline. */
class TestAreaTool : public QObject
{
    Q_OBJECT

private slots:
    void init()
    {
        QTest::failOnWarning(
            QRegularExpression(u"^(?!This plugin does not support propagateSizeHints)"_s));
    }

    void drawingIsClosedByClickKeyOrButton_data()
    {
        QTest::addColumn<QString>("how");
        for (const char* how : {"first corner", "Enter", "double click", "right button"})
            QTest::newRow(how) << QString::fromLatin1(how);
    }

    void drawingIsClosedByClickKeyOrButton()
    {
        QFETCH(QString, how);
        AreaFixture map;
        const QSignalSpy menu(&map.view, &MapView::contextMenuRequested);
        map.clickAll(kSquare_m);
        QVERIFY(map.area_m().empty()); // not before it is whole
        QCOMPARE(map.undoCount(), 0);
        if (how == u"first corner")
            map.click(map.pixelOf(kSquare_m.front()) + QPoint(4, -3));
        else if (how == u"Enter")
            map.key(Qt::Key_Return);
        else if (how == u"double click")
            QTest::mouseDClick(&map.view, Qt::LeftButton, {}, map.pixelOf(kSquare_m.back()));
        else
            QTest::mouseClick(&map.view, Qt::RightButton, {}, QPoint(500, 350));
        QVERIFY(isNear(map.area_m(), kSquare_m));
        QCOMPARE(map.undoCount(), 1);
        QCOMPARE(map.undoText(), u"Add area"_s);
        QCOMPARE(map.selection.ids(), (Ids{kAreaKey}));
        QVERIFY(map.view.tools().kind() == MapToolKind::Area); // stays until it is left
        QVERIFY(!map.view.tools().isDrawing());
        QCOMPARE(menu.count(), 0);
        map.document.undoStack()->undo();
        QVERIFY(map.area_m().empty());
        QVERIFY(map.selection.isEmpty());
    }

    /** A zero length is not shown. */
    void edgeIsMeasuredWhenThereIsOne()
    {
        AreaFixture map(MapToolKind::NoFly);
        const QPoint corner = map.pixelOf(kSquare_m[0]);
        map.click(corner);
        QTest::mouseMove(&map.view, corner + QPoint(1, 0));
        const QImage onCorner = map.view.grab().toImage();
        QTest::mouseMove(&map.view, corner + QPoint(40, 0));
        const QImage away = map.view.grab().toImage();
        const auto hasBubble = [&](const QImage& image, const QPoint& pointer) {
            for (int x = pointer.x() + 20; x < pointer.x() + 50; ++x)
                for (int y = pointer.y() + 16; y < pointer.y() + 28; ++y)
                    if (image.pixelColor(x, y) != Theme::light().sea)
                        return true;
            return false;
        };
        QVERIFY(!hasBubble(onCorner, corner));
        QVERIFY(hasBubble(away, corner + QPoint(40, 0)));
    }

    void anotherAreaTakesItsPlace()
    {
        AreaFixture map;
        map.draw();
        const Scenario first = map.scenario();
        map.clickAll({{2200, 1700}, {2800, 1700}, {2500, 2300}});
        QVERIFY(map.scenario() == first);
        map.key(Qt::Key_Enter);
        QCOMPARE(map.area_m().size(), std::size_t{3});
        QCOMPARE(map.undoText(), u"Replace area"_s);
        map.document.undoStack()->undo();
        QVERIFY(map.scenario() == first);
    }

    void noFlyAreasAreOneMoreEach()
    {
        AreaFixture map(MapToolKind::NoFly);
        map.draw();
        QCOMPARE(map.undoText(), u"Add no-fly area"_s);
        map.clickAll({{3500, 1700}, {4000, 1700}, {3800, 2300}});
        map.key(Qt::Key_Enter);
        QVERIFY(map.area_m().empty());
        const std::vector<NoFlyArea>& noFly = map.scenario().noFly;
        QCOMPARE(noFly.size(), std::size_t{2});
        QVERIFY(isNear(noFly[0].corners_m, kSquare_m));
        QCOMPARE(map.selection.ids(), (Ids{noFlyKey(1)}));
        const Scenario before = map.scenario();
        map.drag(map.pixelOf(kSquare_m[2]), map.pixelOf({3200, 2700}));
        QCOMPARE(map.undoText(), u"Move corner"_s);
        QVERIFY((map.scenario().noFly[0].corners_m[2] - Point(3200, 2700)).norm() < kPixel_m);
        QVERIFY(map.scenario().noFly[1] == before.noFly[1]);
        map.click(map.pixelOf(kSquare_m[0]));
        map.key(Qt::Key_Delete);
        QCOMPARE(map.scenario().noFly[0].corners_m.size(), std::size_t{3});
        map.document.undoStack()->undo();
        map.document.undoStack()->undo();
        QVERIFY(map.scenario() == before);
    }

    void noFlyAreasAreSelectedMovedAndRemoved()
    {
        AreaFixture map(MapToolKind::NoFly);
        map.draw();
        map.clickAll({{3500, 1700}, {4000, 1700}, {3800, 2300}});
        map.key(Qt::Key_Enter);
        map.view.tools().setKind(MapToolKind::Select);
        map.selection.clear();
        const QPoint edge = map.pixelOf({3000, 1750});
        map.click(edge);
        QCOMPARE(map.selection.ids(), (Ids{noFlyKey(0)}));
        const Scenario before = map.scenario();
        map.drag(edge, edge + QPoint(-40, 20));
        QCOMPARE(map.undoText(), u"Move no-fly area"_s);
        QVERIFY((map.scenario().noFly[0].corners_m[0] - before.noFly[0].corners_m[0]).norm() > 100);
        QVERIFY(map.scenario().noFly[1] == before.noFly[1]);
        QTest::keyClick(&map.view, Qt::Key_Delete);
        QCOMPARE(map.undoText(), u"Remove no-fly area"_s);
        QCOMPARE(map.scenario().noFly.size(), std::size_t{1});
        QVERIFY(map.scenario().noFly[0] == before.noFly[1]);
        map.document.undoStack()->undo();
        map.document.undoStack()->undo();
        QVERIFY(map.scenario() == before);
    }

    void escapeLeavesOneThingAfterTheOther()
    {
        AreaFixture map;
        map.draw();
        map.clickAll({{2200, 1700}, {2800, 1700}});
        map.key(Qt::Key_Escape);
        QVERIFY(!map.view.tools().isDrawing());
        QVERIFY(map.view.tools().kind() == MapToolKind::Area);
        QVERIFY(isNear(map.area_m(), kSquare_m));
        map.key(Qt::Key_Escape);
        QVERIFY(map.view.tools().kind() == MapToolKind::Select);
        QVERIFY(map.selection.contains(kAreaKey));
        map.key(Qt::Key_Escape);
        QVERIFY(map.selection.isEmpty());
        QCOMPARE(map.undoCount(), 1);
    }

    void anotherToolDropsTheHalfDrawnOne()
    {
        AreaFixture map;
        map.clickAll({kSquare_m[0], kSquare_m[1], kSquare_m[2]});
        map.view.tools().setKind(MapToolKind::Pan);
        map.view.tools().setKind(MapToolKind::Area);
        map.key(Qt::Key_Return);
        QVERIFY(map.area_m().empty());
    }

    void lastCornerIsRemoved_data()
    {
        QTest::addColumn<Qt::Key>("key");
        QTest::addColumn<Qt::KeyboardModifiers>("modifiers");
        QTest::newRow("Backspace") << Qt::Key_Backspace << Qt::KeyboardModifiers();
        QTest::newRow("Ctrl+Z") << Qt::Key_Z << Qt::KeyboardModifiers(Qt::ControlModifier);
        QTest::newRow("Del") << Qt::Key_Delete << Qt::KeyboardModifiers();
    }

    /** Earlier edits are unaffected. */
    void lastCornerIsRemoved()
    {
        QFETCH(Qt::Key, key);
        QFETCH(Qt::KeyboardModifiers, modifiers);
        AreaFixture map;
        map.document.edit(u"Before"_s, [](Scenario& s) { s.icebergs.pop_back(); });
        const Scenario before = map.scenario();
        map.clickAll({kSquare_m[0], kSquare_m[1], kSquare_m[2], {2500, 2450}});
        map.key(key, modifiers);
        map.click(map.pixelOf(kSquare_m[3]));
        for (int i = 0; i < 4; ++i) {
            QVERIFY(map.view.tools().isDrawing());
            map.key(key, modifiers);
            QVERIFY(map.scenario() == before);
            QCOMPARE(map.undoIndex(), 1);
        }
        QVERIFY(!map.view.tools().isDrawing());
        map.clickAll(kSquare_m);
        map.key(Qt::Key_Return);
        QVERIFY(isNear(map.area_m(), kSquare_m));
    }

    void crossingEdgeIsRejected()
    {
        AreaFixture map;
        map.clickAll({kSquare_m[0], kSquare_m[1], kSquare_m[2]});
        map.move(map.pixelOf({2500, 1200}));
        QVERIFY(map.status().contains(u"cross"_s));
        map.click(map.pixelOf({2500, 1200})); // below the first edge
        QVERIFY(map.status().contains(u"cross"_s));
        map.move(map.pixelOf(kSquare_m[3]));
        QVERIFY(!map.status().contains(u"cross"_s));
        map.click(map.pixelOf(kSquare_m[3]));
        map.key(Qt::Key_Return);
        QVERIFY(isNear(map.area_m(), kSquare_m));
    }

    /** All edges are clear, but the one that would close it is not. */
    void crossingIsRefusedWhenItCloses()
    {
        AreaFixture map;
        map.clickAll(
            {{2000, 1500}, {3000, 1500}, {3000, 2500}, {2500, 2500}, {2500, 1600}, {2800, 1900}});
        QVERIFY(map.view.tools().isDrawing());
        map.key(Qt::Key_Return);
        QVERIFY(map.area_m().empty());
        QVERIFY(map.status().contains(u"cross"_s));
        map.key(Qt::Key_Backspace);
        map.key(Qt::Key_Return);
        QCOMPARE(map.area_m().size(), std::size_t{5});
        QVERIFY(isSimplePolygon(map.area_m()));
    }

    void twoCornersAreNoArea()
    {
        AreaFixture map;
        map.clickAll({kSquare_m[0], kSquare_m[1]});
        map.key(Qt::Key_Return);
        QVERIFY(map.status().contains(u"three corners"_s));
        QVERIFY(map.view.tools().isDrawing());
        QCOMPARE(map.undoCount(), 0);
    }

    void cornerOutsideTheMapIsNotSet()
    {
        AreaFixture map;
        map.press(map.pixelOf(kSquare_m[0]));
        map.release(QPoint(-20, 300));
        QVERIFY(!map.view.tools().isDrawing());
    }

    void arrowKeysPanDuringADrawing()
    {
        AreaFixture map;
        map.selection.set({"berg-1"});
        map.clickAll({kSquare_m[0], kSquare_m[1]});
        const Scenario before = map.scenario();
        const QPointF corner = map.view.toScreen({0, 0});
        map.key(Qt::Key_Right);
        QVERIFY(map.view.toScreen({0, 0}) != corner);
        QVERIFY(map.scenario() == before);
        QVERIFY(map.view.tools().isDrawing());
    }

    void takeOffDropsIt()
    {
        AreaFixture map;
        map.clickAll({kSquare_m[0], kSquare_m[1], kSquare_m[2]});
        map.view.setLocked(true);
        QVERIFY(map.view.tools().kind() == MapToolKind::Select);
        QVERIFY(!map.view.tools().isDrawing());
        map.view.tools().setKind(MapToolKind::Area);
        QVERIFY(map.view.tools().kind() == MapToolKind::Select);
        map.view.setLocked(false);
        QVERIFY(map.area_m().empty());
    }

    void openingAnotherScenarioDropsIt()
    {
        AreaFixture map;
        map.clickAll({kSquare_m[0], kSquare_m[1], kSquare_m[2]});
        map.document.edit(u"Tau"_s, [](Scenario& s) { s.planner.tau = 3; });
        QVERIFY(map.view.tools().isDrawing()); // an edit of something else does not
        map.document.reset(test::emptySea());
        QVERIFY(!map.view.tools().isDrawing());
    }

    void outlineIsChanged_data()
    {
        QTest::addColumn<MapToolKind>("tool");
        QTest::newRow("with the tool") << MapToolKind::Area;
        QTest::newRow("selected") << MapToolKind::Select;
    }

    void outlineIsChanged()
    {
        QFETCH(MapToolKind, tool);
        AreaFixture map;
        map.draw();
        map.view.tools().setKind(tool);
        const Scenario before = map.scenario();
        map.drag(map.pixelOf(kSquare_m[2]), map.pixelOf({3200, 2700})); // corner
        QCOMPARE(map.undoCount(), 2);
        QCOMPARE(map.undoText(), u"Move corner"_s);
        QVERIFY((map.area_m()[2] - Point(3200, 2700)).norm() < kPixel_m);
        map.drag(map.pixelOf({2500, 1500}), map.pixelOf({2500, 1300})); // middle of an edge
        QCOMPARE(map.undoText(), u"Add corner"_s);
        QCOMPARE(map.area_m().size(), std::size_t{5});
        QVERIFY((map.area_m()[1] - Point(2500, 1300)).norm() < kPixel_m);
        map.click(map.pixelOf(map.area_m()[1]));
        map.key(Qt::Key_Delete);
        QCOMPARE(map.undoText(), u"Remove corner"_s);
        QCOMPARE(map.area_m().size(), std::size_t{4});
        QCOMPARE(map.undoCount(), 4);
        for (int i = 0; i < 3; ++i)
            map.document.undoStack()->undo();
        QVERIFY(map.scenario() == before);
    }

    void threeCornersStay()
    {
        AreaFixture map;
        map.clickAll({kSquare_m[0], kSquare_m[1], kSquare_m[2]});
        map.key(Qt::Key_Return);
        const QSignalSpy refused(&map.view, &MapView::refused);
        map.click(map.pixelOf(kSquare_m[1]));
        map.key(Qt::Key_Delete);
        QCOMPARE(map.area_m().size(), std::size_t{3});
        QCOMPARE(refused.count(), 1);
        map.key(Qt::Key_Delete); // no corner is current any more: the area as a whole
        QVERIFY(map.area_m().empty());
        QCOMPARE(map.undoText(), u"Remove area"_s);
    }

    void aCornerStaysWhereItDoesNotCross()
    {
        AreaFixture map;
        map.draw();
        map.press(map.pixelOf(kSquare_m[0]));
        map.move(map.pixelOf({2300, 1800}));
        map.move(map.pixelOf({3400, 2000})); // beyond the opposite edge
        QVERIFY(map.status().contains(u"cross"_s));
        map.release(map.pixelOf({3400, 2000}));
        QVERIFY(isSimplePolygon(map.area_m()));
        QVERIFY((map.area_m()[0] - Point(2300, 1800)).norm() < kPixel_m);
        QCOMPARE(map.undoCount(), 2);
    }

    void escapeAndDropOutsideTakeACornerBack()
    {
        AreaFixture map;
        map.draw();
        const Scenario before = map.scenario();
        map.drag(map.pixelOf(kSquare_m[2]), map.pixelOf({3200, 2700}), {}, false);
        QVERIFY(!(map.scenario() == before));
        map.key(Qt::Key_Escape);
        map.release(map.pixelOf({3200, 2700}));
        QVERIFY(map.scenario() == before);
        map.drag(map.pixelOf(kSquare_m[2]), QPoint(400, -40));
        QVERIFY(map.scenario() == before);
        QCOMPARE(map.undoCount(), 1);
    }

    void theWholeAreaIsSelectedMovedAndRemoved()
    {
        AreaFixture map;
        map.draw();
        map.view.tools().setKind(MapToolKind::Select);
        map.selection.clear();
        const QPoint edge = map.pixelOf({3000, 1750}); // away from corners and middle
        map.click(edge);
        QCOMPARE(map.selection.ids(), (Ids{kAreaKey}));
        const Scenario before = map.scenario();
        map.drag(edge, edge + QPoint(40, 20));
        QCOMPARE(map.undoText(), u"Move area"_s);
        const Point path_m = map.area_m()[0] - before.area_m[0];
        QVERIFY(path_m.norm() > 100);
        for (std::size_t i = 0; i < 4; ++i)
            QVERIFY((map.area_m()[i] - before.area_m[i] - path_m).norm() < 1e-6);
        QTest::keyClick(&map.view, Qt::Key_Delete);
        QVERIFY(map.area_m().empty());
        QVERIFY(map.selection.isEmpty());
        map.document.undoStack()->undo();
        map.document.undoStack()->undo();
        QVERIFY(map.scenario() == before);
    }
};

QTEST_MAIN(TestAreaTool)
#include "tst_area_tool.moc"
