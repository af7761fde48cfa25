#include "core/base/angles.h"
#include "core/checks/validate.h"
#include "tests/support/approx.h"
#include "tests/support/window/fleet_maps.h"
#include "tests/support/window/ids.h"
#include "widgets/document/scenario_edits.h"
#include "widgets/map/paint/map_painter.h"
#include "widgets/map/view/map_handles.h"
#include "widgets/theme/palette.h"

#include <QSignalSpy>

using namespace berg;
using namespace berg::test;
using namespace Qt::StringLiterals;

namespace {

const Point kWater_m(2500, 1800);

struct FleetFixture : test::MapFixture
{
    FleetFixture()
    {
        document.reset(twoUavs());
        view.camera().fit();
    }
    [[nodiscard]] const Uav& uavOf(std::size_t i) const { return scenario().uavs[i]; }
    [[nodiscard]] QPoint pixelOfUav(std::size_t i) const { return pixelOf(uavOf(i).position_m); }
    /** That far by the mouse is as good as there. */
    [[nodiscard]] double pixel_m() const { return 1.5 / view.view().scale_pxpm(); }
    /** Handles as the map has them: its own scene is not to be seen from outside. */
    [[nodiscard]] std::vector<MapHandle> handles()
    {
        MapScene scene;
        scene.setRect(QRectF(view.rect()));
        scene.setPicture(withScenario(plainPicture(), scenario()));
        scene.setView(view.view());
        return handlesOf(scene, selection);
    }
    void undoAll()
    {
        while (document.undoStack()->canUndo())
            document.undoStack()->undo();
    }
};

} // namespace

/** Several UAVs on the map before take-off. */
class TestMapFleet : public QObject
{
    Q_OBJECT

private slots:
    void init()
    {
        QTest::failOnWarning(
            QRegularExpression(u"^(?!This plugin does not support propagateSizeHints)"_s));
    }

    void everyUavIsInThePicture()
    {
        const Scenario scenario = twoUavs();
        const MapPicture picture = withScenario({}, scenario);
        QCOMPARE(picture.uavs.size(), std::size_t{2});
        QCOMPARE(picture.uavs[0].label, u"uav-1"_s);
        QCOMPARE(picture.uavs[1].label, u"West"_s);
        QCOMPARE(picture.uavs[1].place, 1);
        QVERIFY(picture.uavs[1].position_m == kSecond_m);
        QVERIFY(std::abs(std::remainder(picture.uavs[1].psi_rad - kPi, 2 * kPi)) < 1e-12);
        QVERIFY(!picture.uavs[0].home_m); // never lands
        QVERIFY(picture.uavs[1].home_m == Point(500, 2500));
    }

    void theOnlyOneHasNoName()
    {
        Scenario scenario = twoUavs();
        scenario.uavs.pop_back();
        const MapPicture picture = withScenario({}, scenario);
        QCOMPARE(picture.uavs.size(), std::size_t{1});
        QVERIFY(picture.uavs[0].label.isEmpty());
        QCOMPARE(uavColour(Theme::light(), picture.uavs[0].place), Theme::light().uav);
    }

    void whatAnyOfThemSeesIsInView()
    {
        Scenario scenario = twoUavs();
        QVERIFY(!withScenario({}, scenario).icebergs[2].inView);
        scenario.uavs[1].position_m = scenario.icebergs[2].position_m;
        QVERIFY(withScenario({}, scenario).icebergs[2].inView);
    }

    void eachIsDrawnInItsColour_data()
    {
        QTest::addColumn<bool>("isDark");
        QTest::newRow("light") << false;
        QTest::newRow("dark") << true;
    }

    void eachIsDrawnInItsColour()
    {
        QFETCH(bool, isDark);
        const Theme theme = isDark ? Theme::dark() : Theme::light();
        const MapPicture picture = withScenario({}, twoUavs());
        const MapStyle style{.theme = theme, .locale = QLocale::c()};
        const QSize size(1000, 700);
        const MapLayout layout = arrangeMap(picture, style, QRectF(QPointF(0, 0), size));
        const QImage image = mapImage(picture, style, size, 1);
        const auto around = [&](const Point& place_m) {
            const QPointF at = layout.view.toPixel(place_m);
            return QRectF(at.x() - 8, at.y() - 8, 16, 16);
        };
        for (const MapUav& uav : picture.uavs)
            QVERIFY(hasColour(image, around(uav.position_m), uavColour(theme, uav.place)));
        QVERIFY(hasColour(image, around(*picture.uavs[1].home_m), uavColour(theme, 1)));
        QCOMPARE(layout.uavLabels.size(), std::size_t{2});
        for (const PlacedLabel& label : layout.labels)
            for (const QRectF& name : layout.uavLabels)
                QVERIFY(!label.rect.intersects(name));
        QVERIFY(hasColour(image, layout.uavLabels[1], theme.text));
    }

    void theSelectedOneIsFollowed()
    {
        FleetFixture map;
        const auto middle_m = [&] { return map.view.toWorld(QRectF(map.view.rect()).center()); };
        map.view.camera().setFollowUav(true);
        QVERIFY((middle_m() - map.uavOf(0).position_m).norm() < map.pixel_m());
        map.view.camera().zoomBy(8, {10, 10});
        map.selection.set({"uav-2"});
        QVERIFY(map.view.camera().followsUav());
        QVERIFY(map.view.rect().contains(map.pixelOfUav(1)));
        QVERIFY(!map.view.rect().contains(map.pixelOfUav(0)));
    }

    void eachIsSelectedAndMoved()
    {
        FleetFixture map;
        map.click(map.pixelOfUav(1));
        QCOMPARE(map.selection.ids(), (Ids{"uav-2"}));
        map.click(map.pixelOfUav(1) + QPoint(0, 20)); // its name
        QCOMPARE(map.selection.ids(), (Ids{"uav-2"}));
        map.drag(map.pixelOfUav(1), map.pixelOf(kWater_m));
        QVERIFY((map.uavOf(1).position_m - kWater_m).norm() < map.pixel_m());
        QVERIFY(map.uavOf(0).position_m.isZero(0));
        QCOMPARE(map.undoCount(), 1);
        map.undoAll();
        QVERIFY(map.scenario() == twoUavs());
    }

    void eachUavHasAHeadingHandleInItsColour()
    {
        FleetFixture map;
        map.selection.set({"uav-1", "uav-2"});
        const std::vector<MapHandle> handles = map.handles();
        QCOMPARE(handles.size(), std::size_t{2});
        QCOMPARE(handles[1].id, std::string("uav-2"));
        QCOMPARE(handles[1].uav, 1);
        map.drag(handles[1].at_px.toPoint(), map.pixelOfUav(1) + QPoint(0, -90));
        COMPARE_NEAR(std::remainder(map.uavOf(1).heading_deg, 360.0), 0, 1);
        COMPARE_NEAR(map.uavOf(0).heading_deg, 90, 0);
    }

    void theToolMovesTheSelectedOne()
    {
        FleetFixture map;
        map.view.tools().setKind(MapToolKind::Uav);
        map.click(map.pixelOf(kWater_m));
        QVERIFY((map.uavOf(0).position_m - kWater_m).norm() < map.pixel_m());
        map.selection.set({"uav-2"});
        map.click(map.pixelOf({3000, 2000}));
        QVERIFY((map.uavOf(1).position_m - Point(3000, 2000)).norm() < map.pixel_m());
        QCOMPARE(map.scenario().uavs.size(), std::size_t{2});
        map.undoAll();
        QVERIFY(map.scenario() == twoUavs());
    }

    void theToolTurnsTheOneUnderIt()
    {
        FleetFixture map;
        map.view.tools().setKind(MapToolKind::Uav);
        map.drag(map.pixelOfUav(1), map.pixelOfUav(1) + QPoint(80, 0));
        QVERIFY(map.uavOf(1).position_m == kSecond_m);
        COMPARE_NEAR(map.uavOf(1).heading_deg, 90, 1);
        QCOMPARE(map.selection.ids(), (Ids{"uav-2"}));
    }

    void controlAddsOne()
    {
        FleetFixture map;
        map.view.tools().setKind(MapToolKind::Uav);
        map.click(map.pixelOf(kWater_m), Qt::ControlModifier);
        QCOMPARE(map.scenario().uavs.size(), std::size_t{3});
        QCOMPARE(map.document.undoStack()->undoText(), u"Add UAV"_s);
        Uav expected = twoUavs().uavs[0];
        expected.id = "uav-3";
        expected.spec.altitude_m = 230; // a layer above the highest
        expected.position_m = map.uavOf(2).position_m;
        QVERIFY(map.uavOf(2) == expected);
        QVERIFY((expected.position_m - kWater_m).norm() < map.pixel_m());
        QCOMPARE(map.selection.ids(), (Ids{"uav-3"}));
        map.undoAll();
        QVERIFY(map.scenario() == twoUavs());
    }

    void menusAddOne()
    {
        FleetFixture map;
        map.view.edits().addUavAt({1234.56, 2000});
        QCOMPARE(map.uavOf(2).id, std::string("uav-3"));
        QVERIFY((map.uavOf(2).position_m - Point(1234.6, 2000)).norm() < 1e-6);
        map.view.edits().addUav(); // the cursor is nowhere: in the middle
        QCOMPARE(map.scenario().uavs.size(), std::size_t{4});
        QVERIFY(
            (map.uavOf(3).position_m - map.view.toWorld(QRectF(map.view.rect()).center())).norm() <
            10 * map.pixel_m());
        COMPARE_NEAR(map.uavOf(3).spec.altitude_m, 260, 0);
        QCOMPARE(map.undoCount(), 2);
    }

    void thereIsRoomForSoMany()
    {
        FleetFixture map;
        Scenario full = map.scenario();
        while (full.uavs.size() < kMostUavs)
            full.uavs.push_back(anotherUav(full, {0, 0}));
        map.document.reset(full);
        const QSignalSpy refused(&map.view, &MapView::refused);
        map.view.edits().addUavAt({0, 0});
        map.selection.set({"uav-1"});
        map.view.edits().duplicateSelected();
        QCOMPARE(refused.size(), 2);
        map.view.tools().setKind(MapToolKind::Uav);
        map.click(map.pixelOf(kWater_m), Qt::ControlModifier);
        QVERIFY(map.scenario() == full);
    }

    void copiesAreBesideTheOriginal()
    {
        FleetFixture map;
        map.selection.set({"uav-2", "uav-1"});
        map.view.edits().duplicateSelected();
        QCOMPARE(map.undoCount(), 1);
        QCOMPARE(map.scenario().uavs.size(), std::size_t{4});
        QCOMPARE(map.selection.ids(), (Ids{"uav-3", "uav-4"}));
        const Point path_m = map.uavOf(2).position_m - map.uavOf(0).position_m;
        QVERIFY(path_m.x() > 0 && path_m.y() < 0);
        QVERIFY((map.uavOf(3).position_m - map.uavOf(1).position_m - path_m).norm() < 1e-6);
        QVERIFY((*map.uavOf(3).home_m - *map.uavOf(1).home_m - path_m).norm() < 1e-6);
        QVERIFY(map.uavOf(3).name.empty());
        COMPARE_NEAR(map.uavOf(2).spec.altitude_m, 230, 0);
        COMPARE_NEAR(map.uavOf(3).spec.altitude_m, 260, 0);
        QVERIFY(!hasErrors(validate(map.scenario())));
    }

    void icebergsOfADeletedUavAreUnassigned()
    {
        FleetFixture map;
        map.selection.set({"uav-2"});
        map.view.edits().deleteSelected();
        QCOMPARE(map.document.undoStack()->undoText(), u"Delete UAV"_s);
        QCOMPARE(map.scenario().uavs.size(), std::size_t{1});
        QVERIFY(map.scenario().icebergs[0].uav.empty());
        QVERIFY(map.selection.isEmpty());
        map.undoAll();
        QVERIFY(map.scenario() == twoUavs());
    }

    void theLastOneStays()
    {
        FleetFixture map;
        const QSignalSpy refused(&map.view, &MapView::refused);
        map.selection.set({"uav-2", "uav-1", "berg-3"});
        map.view.edits().deleteSelected();
        QCOMPARE(map.scenario().uavs.size(), std::size_t{1});
        QCOMPARE(map.uavOf(0).id, std::string("uav-1"));
        QCOMPARE(map.scenario().icebergs.size(), std::size_t{3});
        QCOMPARE(refused.size(), 0);
        const Scenario before = map.scenario();
        map.selection.set({"uav-1"});
        map.view.edits().deleteSelected();
        QCOMPARE(refused.size(), 1);
        QVERIFY(map.scenario() == before);
    }

    void copiesOfIcebergsKeepTheirUav()
    {
        FleetFixture map;
        Scenario there = map.scenario();
        const std::vector<Iceberg> assigned{there.icebergs[0]};
        (void)addCopies(there, assigned, {10, 10});
        QCOMPARE(there.icebergs.back().uav, std::string("uav-2"));
        Scenario elsewhere = test::MapFixture::fourIcebergs();
        (void)addCopies(elsewhere, assigned, {10, 10});
        QVERIFY(elsewhere.icebergs.back().uav.empty());
    }

    void renamingKeepsReferences()
    {
        Scenario scenario = twoUavs();
        renameObject(scenario, "uav-2", "west");
        QCOMPARE(scenario.uavs[1].id, std::string("west"));
        QCOMPARE(scenario.icebergs[0].uav, std::string("west"));
        renameObject(scenario, "berg-1", "west-1");
        QCOMPARE(scenario.icebergs[0].id, std::string("west-1"));
        QCOMPARE(scenario.icebergs[0].uav, std::string("west"));
        QVERIFY(!hasErrors(validate(scenario)));
    }
};

QTEST_MAIN(TestMapFleet)
#include "tst_map_fleet.moc"
