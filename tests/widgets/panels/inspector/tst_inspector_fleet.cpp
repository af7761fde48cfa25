#include "tests/support/flight/mission_builder.h"
#include "tests/support/window/ids.h"
#include "tests/support/window/panel_test.h"
#include "widgets/document/scenario_edits.h"
#include "widgets/panels/fields/number_field.h"
#include "widgets/panels/inspector/inspector_panel.h"
#include "widgets/theme/palette.h"

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QUndoStack>

using namespace berg;
using namespace Qt::StringLiterals;
using test::Ids;

namespace {

Scenario threeUavs()
{
    Scenario scenario = test::fourIcebergs();
    while (scenario.uavs.size() < 3)
        scenario.uavs.push_back(
            anotherUav(scenario, {0, 1000.0 * static_cast<double>(scenario.uavs.size())}));
    scenario.uavs[2].name = "North";
    scenario.icebergs[1].uav = scenario.uavs[2].id;
    return scenario;
}

struct FleetInspectorFixture
{
    ScenarioDocument document;
    Selection selection;
    InspectorPanel panel{document, selection};

    explicit FleetInspectorFixture(const Scenario& scenario = threeUavs())
    {
        document.reset(scenario);
        panel.setLocale(QLocale::c());
        panel.resize(test::kDock_px, 900);
        panel.show();
    }
    [[nodiscard]] const Scenario& scenario() const { return document.scenario(); }
    [[nodiscard]] QComboBox& visitor() { return test::child<QComboBox>(panel, u"icebergs.uav"_s); }
    [[nodiscard]] QLabel& chip() { return test::child<QLabel>(panel, u"inspectorChip"_s); }
    [[nodiscard]] QColor chipColour() { return chip().pixmap().toImage().pixelColor(2, 2); }
    [[nodiscard]] bool isShown(const QString& name) const
    {
        return test::child<QWidget>(panel, name).isVisibleTo(&panel);
    }
    void chooseVisitor(int choice)
    {
        visitor().setCurrentIndex(choice);
        emit visitor().activated(choice);
    }
};

} // namespace

/** Several UAVs in the Inspector. */
class TestInspectorFleet : public QObject
{
    Q_OBJECT

private slots:
    /** The button is shown while two UAVs share a layer, and raises the later ones. */
    void altitudesAreSeparated()
    {
        Scenario scenario = threeUavs();
        for (std::size_t k = 0; k < 3; ++k)
            scenario.uavs[k].spec.altitude_m = 120 + 10 * static_cast<double>(k);
        FleetInspectorFixture f(scenario);
        QVERIFY(f.isShown(u"scenarioLayers"_s));
        test::child<QPushButton>(f.panel, u"scenarioLayers"_s).click();
        QCOMPARE(f.scenario().uavs[0].spec.altitude_m, 120.0);
        QCOMPARE(f.scenario().uavs[1].spec.altitude_m, 150.0);
        QCOMPARE(f.scenario().uavs[2].spec.altitude_m, 180.0);
        QVERIFY(!f.isShown(u"scenarioLayers"_s));
        f.document.undoStack()->undo();
        QCOMPARE(f.scenario(), scenario);
        QVERIFY(f.isShown(u"scenarioLayers"_s));
    }

    void init() { test::failOnWarnings(); }

    void theSelectedOneIsEdited()
    {
        FleetInspectorFixture f;
        f.selection.set({"uav-2"});
        test::enter(test::child<NumberField>(f.panel, u"uavs.altitude_m"_s), u"300"_s);
        QCOMPARE(f.scenario().uavs[1].spec.altitude_m, 300.0);
        QCOMPARE(f.scenario().uavs[0].spec, threeUavs().uavs[0].spec);
        f.selection.set({"uav-1", "uav-3"});
        test::enter(test::child<NumberField>(f.panel, u"uavs.airspeed_mps"_s), u"30"_s);
        QCOMPARE(f.scenario().uavs[0].spec.airspeed_mps, 30.0);
        QCOMPARE(f.scenario().uavs[1].spec.airspeed_mps, 22.0);
        QCOMPARE(f.scenario().uavs[2].spec.airspeed_mps, 30.0);
        QCOMPARE(f.document.undoStack()->count(), 2);
    }

    void theChipHasItsColour()
    {
        FleetInspectorFixture f;
        QVERIFY(!f.isShown(u"inspectorChip"_s));
        f.selection.set({"uav-2"});
        QVERIFY(f.isShown(u"inspectorChip"_s));
        QCOMPARE(f.chipColour(), uavColour(Theme::light(), 1));
        f.panel.setTheme(Theme::dark());
        QCOMPARE(f.chipColour(), uavColour(Theme::dark(), 1));
        f.selection.set({"uav-2", "uav-3"});
        QVERIFY(!f.isShown(u"inspectorChip"_s));
        FleetInspectorFixture one(test::fourIcebergs());
        one.selection.set({"uav-1"});
        QCOMPARE(one.chipColour(), Theme::light().uav);
    }

    void renamingRenamesWhatRefersToIt()
    {
        FleetInspectorFixture f;
        f.selection.set({"uav-3"});
        test::enter(test::child<QLineEdit>(f.panel, u"uavId"_s), u"north"_s);
        QCOMPARE(f.scenario().uavs[2].id, std::string("north"));
        QCOMPARE(f.scenario().icebergs[1].uav, std::string("north"));
        QCOMPARE(f.selection.ids(), (Ids{"north"}));
        f.document.undoStack()->undo();
        QVERIFY(f.scenario() == threeUavs());
    }

    void idsAreThereOnce()
    {
        FleetInspectorFixture f;
        f.selection.set({"uav-3"});
        auto& line = test::child<QLineEdit>(f.panel, u"uavId"_s);
        for (const QString& id : {u"uav-1"_s, u"berg-1"_s, QString()}) {
            line.setFocus();
            line.selectAll();
            QTest::keyClick(&line, Qt::Key_Delete);
            QTest::keyClicks(&line, id);
            QVERIFY(f.isShown(u"uavIdFault"_s));
            QTest::keyClick(&line, Qt::Key_Return);
            QCOMPARE(line.text(), u"uav-3"_s);
        }
        QVERIFY(f.scenario() == threeUavs());
        f.selection.set({"uav-1", "uav-2"});
        QVERIFY(!f.isShown(u"uavId"_s));
    }

    void icebergsAreAssignedToAUav()
    {
        FleetInspectorFixture f;
        f.selection.set({"berg-1"});
        QVERIFY(f.isShown(u"icebergs.uav"_s));
        QCOMPARE(f.visitor().count(), 4);
        QCOMPARE(f.visitor().itemText(0), u"any UAV"_s);
        QCOMPARE(f.visitor().itemText(3), u"North"_s);
        QCOMPARE(f.visitor().currentIndex(), 0);
        f.chooseVisitor(2);
        QCOMPARE(f.scenario().icebergs[0].uav, std::string("uav-2"));
        f.selection.set({"berg-2"});
        QCOMPARE(f.visitor().currentIndex(), 3);
        f.selection.set({"berg-1", "berg-2"});
        QCOMPARE(f.visitor().currentIndex(), -1); // mixed
        f.chooseVisitor(0);
        QVERIFY(f.scenario().icebergs[0].uav.empty() && f.scenario().icebergs[1].uav.empty());
        QCOMPARE(f.document.undoStack()->count(), 2);
    }

    void optionsFollowTheScenario()
    {
        FleetInspectorFixture f;
        f.selection.set({"berg-2"});
        f.document.edit(u"Delete UAV"_s,
                        [](Scenario& s) { removeObjects(s, std::vector<std::string>{"uav-2"}); });
        QCOMPARE(f.visitor().count(), 3);
        QCOMPARE(f.visitor().currentIndex(), 2);
        f.document.edit(u"Delete UAV"_s,
                        [](Scenario& s) { removeObjects(s, std::vector<std::string>{"uav-3"}); });
        QVERIFY(!f.isShown(u"icebergs.uav"_s));
    }

    void separationIsEditedWhereItMatters()
    {
        FleetInspectorFixture f;
        QVERIFY(f.isShown(u"separation_m"_s));
        auto& field = test::child<NumberField>(f.panel, u"separation_m"_s);
        test::enter(field, u"350"_s);
        QCOMPARE(f.scenario().separation_m, 350.0);
        test::enter(field, u"0"_s);
        QCOMPARE(f.scenario().separation_m, 0.0);
        QCOMPARE(field.text(), u"no separation"_s);
        FleetInspectorFixture one(test::fourIcebergs());
        QVERIFY(!one.isShown(u"separation_m"_s));
    }

    void nothingIsEditedInFlight()
    {
        FleetInspectorFixture f;
        f.selection.set({"berg-2"});
        f.panel.setLocked(true);
        QVERIFY(!f.visitor().isEnabled());
        QCOMPARE(f.visitor().currentIndex(), 3);
        f.selection.set({"uav-2"});
        QVERIFY(test::child<QLineEdit>(f.panel, u"uavId"_s).isReadOnly());
    }
};

QTEST_MAIN(TestInspectorFleet)
#include "tst_inspector_fleet.moc"
