#include "core/checks/validate.h"
#include "tests/support/window/ids.h"
#include "tests/support/window/map_fixture.h"
#include "tests/support/window/panel_test.h"
#include "widgets/panels/fields/number_field.h"
#include "widgets/panels/inspector/inspector_panel.h"

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

using namespace berg;
using namespace Qt::StringLiterals;
using test::Ids;

namespace {

const Point kWater_m(2500, 2000);
constexpr double kPixel_m = 20; // more than a pixel of these maps is wide

Scenario withAsset()
{
    Scenario scenario = test::MapFixture::fourIcebergs();
    scenario.asset = Asset{.name = "Hibernia", .position_m = kWater_m};
    return scenario;
}

struct PanelFixture
{
    ScenarioDocument document;
    Selection selection;
    InspectorPanel panel{document, selection};

    explicit PanelFixture(const Scenario& scenario)
    {
        document.reset(scenario);
        panel.setLocale(QLocale::c());
        panel.resize(test::kDock_px, 500);
        panel.show();
    }
    [[nodiscard]] QString title() const
    {
        return test::child<QLabel>(panel, u"inspectorTitle"_s).text();
    }
    [[nodiscard]] const Asset& asset() const { return *document.scenario().asset; }
    void enter(const QString& key, const QString& text)
    {
        test::enter(test::child<QWidget>(panel, key), text);
    }
};

} // namespace

/** The protected asset on the map and in the inspector, with area and scenario. */
class TestAssetTool : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnWarnings(); }

    void clickPlacesAndMovesIt()
    {
        test::MapFixture map;
        const Scenario before = map.scenario();
        map.view.tools().setKind(MapToolKind::Asset);
        map.click(map.pixelOf(kWater_m));
        QVERIFY(map.scenario().asset.has_value());
        QVERIFY((map.scenario().asset->position_m - kWater_m).norm() < kPixel_m);
        QCOMPARE(map.document.undoStack()->undoText(), u"Place asset"_s);
        QCOMPARE(map.selection.ids(), (Ids{kAssetKey}));
        QVERIFY(map.view.tools().kind() == MapToolKind::Asset);
        map.click(map.pixelOf({2500, 2800}));
        QCOMPARE(map.document.undoStack()->undoText(), u"Move asset"_s);
        QVERIFY((map.scenario().asset->position_m - Point(2500, 2800)).norm() < kPixel_m);
        QCOMPARE(map.undoCount(), 2);
        map.document.undoStack()->undo();
        map.document.undoStack()->undo();
        QVERIFY(map.scenario() == before);
        QVERIFY(map.selection.isEmpty());
    }

    /** Also far out: it can be seen and saved. */
    void ringSuitsTheView()
    {
        for (const double zoom : {1.0, 0.05, 1e-9}) {
            test::MapFixture map;
            map.view.camera().zoomBy(zoom, QRectF(map.view.rect()).center());
            map.view.tools().setKind(MapToolKind::Asset);
            map.click(map.view.rect().center());
            const double range_m = map.scenario().asset->range_m;
            const double radius_px = range_m * map.view.view().scale_pxpm();
            QVERIFY2(radius_px > 0.1 * map.view.height() && radius_px < 0.35 * map.view.height(),
                     QByteArray::number(radius_px));
            QVERIFY(!hasErrors(validate(map.scenario())));
        }
    }

    void dragIsOneUndoStepAndCanBeCancelled()
    {
        test::MapFixture map;
        map.document.reset(withAsset());
        map.view.tools().setKind(MapToolKind::Asset);
        const QPoint at = map.pixelOf(kWater_m);
        map.drag(at, at + QPoint(60, 40));
        QCOMPARE(map.undoCount(), 1);
        QCOMPARE(map.scenario().asset->name, std::string("Hibernia"));
        const Scenario moved = map.scenario();
        const QPoint there = map.pixelOf(moved.asset->position_m);
        map.drag(there, there + QPoint(50, 0), {}, false);
        QTest::keyClick(&map.view, Qt::Key_Escape);
        map.release(there);
        QVERIFY(map.scenario() == moved);
        map.selection.set({"berg-1"});
        map.drag(there, {-20, 200}); // dropped outside
        QVERIFY(map.scenario() == moved);
        QCOMPARE(map.selection.ids(), (Ids{"berg-1"}));
        map.click(there); // on it: selects
        QVERIFY(map.scenario() == moved);
        QCOMPARE(map.undoCount(), 1);
    }

    void selectToolMovesAndDeletesIt()
    {
        test::MapFixture map;
        map.document.reset(withAsset());
        const Scenario before = map.scenario();
        map.drag(map.pixelOf(kWater_m), map.pixelOf({2500, 2600}));
        QCOMPARE(map.selection.ids(), (Ids{kAssetKey}));
        QVERIFY((map.scenario().asset->position_m - Point(2500, 2600)).norm() < kPixel_m);
        QTest::keyClick(&map.view, Qt::Key_Right);
        QCOMPARE(map.document.undoStack()->undoText(), u"Move asset"_s);
        map.click(map.iceberg(0), Qt::ControlModifier);
        QTest::keyClick(&map.view, Qt::Key_Delete);
        QCOMPARE(map.document.undoStack()->undoText(), u"Delete 2 objects"_s);
        QVERIFY(!map.scenario().asset);
        QCOMPARE(map.scenario().icebergs.size(), std::size_t{3});
        while (map.document.undoStack()->canUndo())
            map.document.undoStack()->undo();
        QVERIFY(map.scenario() == before);
    }

    void rubberBandTakesItWithTheIcebergs()
    {
        test::MapFixture map;
        map.document.reset(withAsset());
        map.drag(map.pixelOf({1200, 3500}), map.pixelOf({2900, 1500}));
        QCOMPARE(map.selection.ids(), (Ids{"berg-3", kAssetKey}));
    }

    void inspectorEditsIt()
    {
        const test::UnitsInUse units(test::kComponents);
        PanelFixture f(withAsset());
        QCOMPARE(f.title(), u"Scenario"_s);
        f.selection.set({kAssetKey});
        QCOMPARE(f.title(), u"Asset"_s);
        test::enter(test::child<QLineEdit>(f.panel, u"asset.name"_s), u"Hebron"_s);
        f.enter(u"assetEast"_s, u"123.5"_s);
        f.enter(u"assetNorth"_s, u"-77"_s);
        f.enter(u"assetVelocityEast"_s, u"1.5"_s);
        f.enter(u"assetVelocityNorth"_s, u"2"_s);
        f.enter(u"asset.range_m"_s, u"8000"_s);
        f.enter(u"asset.gain"_s, u"3"_s);
        QCOMPARE(f.asset(), (Asset{.name = "Hebron",
                                   .position_m = {123.5, -77},
                                   .velocity_mps = {1.5, 2},
                                   .range_m = 8000,
                                   .gain = 3}));
        QCOMPARE(test::child<QLabel>(f.panel, u"assetVelocity"_s).text(),
                 u"2.5 m/s towards 037°"_s); // 3-4-5 triangle
        QCOMPARE(f.document.undoStack()->count(), 7);
        test::child<QPushButton>(f.panel, u"assetRemove"_s).click();
        QVERIFY(!f.document.scenario().asset);
        QCOMPARE(f.document.undoStack()->undoText(), u"Remove asset"_s);
        f.document.undoStack()->setIndex(0);
        QVERIFY(f.document.scenario() == withAsset());
    }

    void inspectorShowsTheArea()
    {
        Scenario scenario = test::emptySea();
        scenario.area_m = {{0, 0}, {4000, 0}, {4000, 3000}, {0, 3000}};
        PanelFixture f(scenario);
        f.selection.set({kAreaKey});
        QCOMPARE(f.title(), u"Area"_s);
        QVERIFY(test::child<QLabel>(f.panel, u"areaSize"_s).text().startsWith(u"4 corners"_s));
        QVERIFY(test::child<QLabel>(f.panel, u"areaSize"_s).text().contains(u"12.0 km²"_s));
        f.panel.setLocked(true);
        auto& remove = test::child<QPushButton>(f.panel, u"areaRemove"_s);
        QVERIFY(!remove.isEnabled());
        f.panel.setLocked(false);
        remove.click();
        QVERIFY(f.document.scenario().area_m.empty());
    }

    void icebergsComeBeforeTheAsset()
    {
        PanelFixture f(withAsset());
        f.selection.set({kAssetKey, "berg-1"});
        QCOMPARE(f.title(), u"Iceberg"_s);
    }

    void scenarioHasEverySettingOfTheFile()
    {
        PanelFixture f(test::emptySea());
        f.enter(u"scenarioLatitude"_s, u"78.25"_s);
        f.enter(u"scenarioLongitude"_s, u"-12.5"_s);
        f.enter(u"planner.reach_radius_m"_s, u"250"_s);
        const auto choose = [&](const QString& key) {
            auto& combo = test::child<QComboBox>(f.panel, key);
            combo.setFocus();
            QTest::keyClick(&combo, Qt::Key_Down);
        };
        choose(u"planner.fov_shape"_s);
        choose(u"planner.formulation"_s);
        Scenario wanted = test::emptySea();
        wanted.origin = {.latitude_deg = 78.25, .longitude_deg = -12.5};
        wanted.reachRadius_m = 250;
        wanted.fovShape = FovShape::North;
        wanted.planner.formulation = Formulation::Printed;
        QVERIFY(f.document.scenario() == wanted);
        QCOMPARE(f.document.undoStack()->count(), 5);
        f.enter(u"planner.reach_radius_m"_s, u"0"_s);
        QVERIFY(!f.document.scenario().reachRadius_m.has_value());
    }

    /** A time that is none is never part of the scenario. */
    void startIsATimeOrNothing()
    {
        PanelFixture f(test::emptySea());
        auto& start = test::child<QLineEdit>(f.panel, u"start_utc"_s);
        test::enter(start, u"2024-05-01T06:00:00Z"_s);
        QCOMPARE(f.document.scenario().startUtc, std::string("2024-05-01T06:00:00Z"));
        QCOMPARE(f.document.undoStack()->count(), 1);
        test::enter(start, u"2024-13-01"_s);
        QVERIFY(!hasErrors(f.document.issues()));
        QCOMPARE(start.text(), QString::fromStdString(f.document.scenario().startUtc));
    }
};

QTEST_MAIN(TestAssetTool)
#include "tst_asset_tool.moc"
