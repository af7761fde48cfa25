#include "tests/support/approx.h"
#include "tests/support/panel_test.h"
#include "tests/support/scenario_builder.h"
#include "widgets/panels/fields/number_field.h"
#include "widgets/panels/inspector/inspector_panel.h"
#include "widgets/panels/inspector/inspector_rows.h"
#include "widgets/words/issue_text.h"

#include <QCheckBox>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QSignalSpy>
#include <QUndoStack>

using namespace berg;
using namespace Qt::StringLiterals;

namespace {

Scenario threeIcebergs()
{
    Scenario scenario = test::emptySea();
    test::addIceberg(scenario, 1000, 2000).velocity_mps = Point(0.3, 0.4);
    test::addIceberg(scenario, 3000, 2000, 8);
    test::addIceberg(scenario, 5000, 4000);
    return scenario;
}

struct Fixture
{
    ScenarioDocument document;
    Selection selection;
    InspectorPanel panel{document, selection};

    explicit Fixture(const Scenario& scenario = threeIcebergs())
    {
        document.reset(scenario);
        panel.setLocale(QLocale::c());
        panel.resize(test::kDock_px, 500);
        panel.show();
    }
    [[nodiscard]] NumberField& number(const QString& name) const
    {
        return test::child<NumberField>(panel, name);
    }
    [[nodiscard]] QLineEdit& line(const QString& name) const
    {
        return test::child<QLineEdit>(panel, name);
    }
    [[nodiscard]] QLabel& label(const QString& name) const
    {
        return test::child<QLabel>(panel, name);
    }
    [[nodiscard]] const Iceberg& iceberg(std::size_t i) const
    {
        return document.scenario().icebergs[i];
    }
    [[nodiscard]] int undoSteps() const { return document.undoStack()->count(); }
};

void addEveryNumber()
{
    QTest::addColumn<QString>("key");
    QTest::addColumn<QString>("id");
    const auto add = [](const std::vector<InspectorRow>& rows, const QString& id) {
        for (const InspectorRow& row : rows)
            if (const auto* number = std::get_if<NumberRow>(&row))
                QTest::newRow(qPrintable(number->words.key)) << number->words.key << id;
    };
    add(icebergRows(), u"berg-1"_s);
    add(uavRows(), u"uav-1"_s);
    add(scenarioRows(), QString());
}

} // namespace

class TestInspectorPanel : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnWarnings(); }

    void showsTheSelectionWithoutEditing()
    {
        Fixture f;
        QCOMPARE(f.label(u"inspectorTitle"_s).text(), u"Scenario"_s);
        QCOMPARE(f.number(u"scenarioDuration"_s).value(), 1000.0);
        f.selection.set({"berg-1"});
        QCOMPARE(f.label(u"inspectorTitle"_s).text(), u"Iceberg"_s);
        QCOMPARE(f.line(u"icebergId"_s).text(), u"berg-1"_s);
        QCOMPARE(f.number(u"icebergEast"_s).text(), u"1000 m"_s);
        QCOMPARE(f.number(u"icebergGrowth"_s).text(), u"0.025 m²/s"_s);
        f.selection.set({"uav-1"});
        QCOMPARE(f.label(u"inspectorTitle"_s).text(), u"UAV uav-1"_s);
        QCOMPARE(f.number(u"uavHeading"_s).value(), 90.0);
        QCOMPARE(f.number(u"uavEndurance"_s).text(), u"unlimited"_s);
        QCOMPARE(f.undoSteps(), 0);
    }

    void derivedValuesAreWrittenOut()
    {
        Fixture f;
        f.selection.set({"berg-1"});
        QCOMPARE(f.label(u"icebergDeviation"_s).text(), u"standard deviation 2.24 m"_s);
        // 2000 m north of 47 N: 2000 / 111175 degrees of the meridian there are 1.079 minutes.
        QCOMPARE(f.line(u"icebergLatitude"_s).text(), u"47° 01.079′ N"_s);
        QVERIFY(f.line(u"icebergLongitude"_s).text().endsWith(u" W"_s));
    }

    void placeIsTypedAsAngles()
    {
        Fixture f;
        f.selection.set({"berg-1"});
        const LocalFrame frame(f.document.scenario().origin);
        const LatLon before = frame.toGeographic(f.iceberg(0).position_m);
        test::enter(f.line(u"icebergLatitude"_s), u"47 06.0"_s);
        LatLon at = frame.toGeographic(f.iceberg(0).position_m);
        COMPARE_NEAR(at.latitude_deg, 47.1, 1e-9);
        COMPARE_NEAR(at.longitude_deg, before.longitude_deg, 1e-9);
        QCOMPARE(f.line(u"icebergLatitude"_s).text(), u"47° 06.000′ N"_s);
        // A whole coordinate, as it is pasted, sets both.
        test::enter(f.line(u"icebergLongitude"_s), u"47.2, -48.25"_s);
        at = frame.toGeographic(f.iceberg(0).position_m);
        COMPARE_NEAR(at.latitude_deg, 47.2, 1e-9);
        COMPARE_NEAR(at.longitude_deg, -48.25, 1e-9);
        QCOMPARE(f.undoSteps(), 2);
        QTest::keyClick(&f.line(u"icebergLatitude"_s), Qt::Key_Return);
        QCOMPARE(f.undoSteps(), 2); // what is shown has fewer digits than there are
    }

    void latitudeOfSeveralIsSetTogether()
    {
        Fixture f;
        f.selection.set({"berg-1", "berg-3"});
        QCOMPARE(f.line(u"icebergLatitude"_s).text(), QString());
        QCOMPARE(f.line(u"icebergLatitude"_s).placeholderText(), u"mixed"_s);
        const LocalFrame frame(f.document.scenario().origin);
        const double before_deg = frame.toGeographic(f.iceberg(2).position_m).longitude_deg;
        test::enter(f.line(u"icebergLatitude"_s), u"47.05 N"_s);
        for (const std::size_t i : {std::size_t{0}, std::size_t{2}})
            COMPARE_NEAR(frame.toGeographic(f.iceberg(i).position_m).latitude_deg, 47.05, 1e-9);
        COMPARE_NEAR(frame.toGeographic(f.iceberg(2).position_m).longitude_deg, before_deg, 1e-9);
        QCOMPARE(f.undoSteps(), 1);
    }

    /** A whole place would put several on one point. */
    void wholePlaceIsForOneOnly()
    {
        Fixture f;
        f.selection.set({"berg-1", "berg-3"});
        const Scenario before = f.document.scenario();
        test::enter(f.line(u"icebergLatitude"_s), u"47.1 N 48.2 W"_s);
        QVERIFY(f.document.scenario() == before);
        QCOMPARE(f.label(u"icebergLatitudeFault"_s).text(),
                 u"Type one angle: a whole coordinate would put all of them at one place."_s);
    }

    void whatIsNoPlaceIsToldAndLeft_data()
    {
        QTest::addColumn<QString>("typed");
        QTest::addColumn<QString>("reason");
        QTest::newRow("no angle") << u"zzz"_s
                                  << u"There is no place of this name here, and it is not a "
                                     "coordinate."_s;
        QTest::newRow("too far north") << u"91"_s << u"Latitudes go from 90° S to 90° N."_s;
        QTest::newRow("the other half")
            << u"48 W"_s << u"This is a longitude, a latitude is needed."_s;
        QTest::newRow("nothing") << QString()
                                 << u"A coordinate or the name of a place is needed."_s;
        QTest::newRow("out of reach")
            << u"20 N"_s
            << u"This is 2 990 km from the origin of the scenario, which reaches 1 000 km."_s;
    }

    void whatIsNoPlaceIsToldAndLeft()
    {
        QFETCH(QString, typed);
        QFETCH(QString, reason);
        Fixture f;
        f.selection.set({"berg-1"});
        QLineEdit& line = f.line(u"icebergLatitude"_s);
        const QString before = line.text();
        line.setFocus();
        line.selectAll();
        QTest::keyClick(&line, Qt::Key_Delete);
        QTest::keyClicks(&line, typed);
        QVERIFY(!f.label(u"icebergLatitudeFault"_s).isVisible()); // not while it is typed
        QTest::keyClick(&line, Qt::Key_Return);
        QCOMPARE(f.label(u"icebergLatitudeFault"_s).text(), reason);
        QCOMPARE(line.text(), before);
        QCOMPARE(f.undoSteps(), 0);
    }

    void typingEditsOnce()
    {
        Fixture f;
        f.selection.set({"berg-1"});
        QSignalSpy changed(&f.document, &ScenarioDocument::scenarioChanged);
        test::enter(f.number(u"icebergEast"_s), u"1234.5"_s);
        QCOMPARE(f.iceberg(0).position_m, Point(1234.5, 2000));
        QCOMPARE(changed.count(), 1);
        QCOMPARE(f.undoSteps(), 1);
        QCOMPARE(f.document.undoStack()->undoText(), u"Change position"_s);
        f.document.undoStack()->undo();
        QCOMPARE(f.number(u"icebergEast"_s).value(), 1000.0);
        QCOMPARE(f.undoSteps(), 1);
    }

    void spinningOneFieldIsOneStep()
    {
        Fixture f;
        f.selection.set({"berg-1"});
        NumberField& east = f.number(u"icebergEast"_s);
        east.setFocus();
        for (int i = 0; i < 3; ++i)
            QTest::keyClick(&east, Qt::Key_Up);
        QCOMPARE(f.iceberg(0).position_m.x(), 1030.0);
        QCOMPARE(f.undoSteps(), 1);
        QTest::keyClick(&east, Qt::Key_Return); // ends the gesture
        QTest::keyClick(&east, Qt::Key_Up);
        QCOMPARE(f.undoSteps(), 2);
        f.document.undoStack()->undo();
        f.document.undoStack()->undo();
        QCOMPARE(f.iceberg(0).position_m.x(), 1000.0);
    }

    void anotherFieldIsAnotherStep()
    {
        Fixture f;
        f.selection.set({"berg-1"});
        f.number(u"icebergEast"_s).stepUp();
        f.number(u"icebergNorth"_s).stepUp();
        QCOMPARE(f.undoSteps(), 2);
    }

    void mixedValuesAreEmptyAndSetAll()
    {
        Fixture f;
        f.selection.set({"berg-1", "berg-2"});
        QCOMPARE(f.label(u"inspectorTitle"_s).text(), u"2 icebergs"_s);
        QVERIFY(!f.line(u"icebergId"_s).isVisible());
        NumberField& east = f.number(u"icebergEast"_s);
        QVERIFY(east.isMixed());
        QVERIFY(east.text().isEmpty());
        QVERIFY(!f.number(u"icebergNorth"_s).isMixed()); // both 2000
        test::enter(east, u"700"_s);
        QCOMPARE(f.iceberg(0).position_m, Point(700, 2000));
        QCOMPARE(f.iceberg(1).position_m, Point(700, 2000));
        QCOMPARE(f.iceberg(2).position_m, Point(5000, 4000));
        QVERIFY(!east.isMixed());
        QCOMPARE(east.text(), u"700 m"_s);
        QCOMPARE(f.undoSteps(), 1);
        f.document.undoStack()->undo();
        QVERIFY(east.isMixed());
    }

    void mixedTakesTheHiddenNumberToo()
    {
        // 1000 is what the first of the two has: typing it changes the second all the same.
        Fixture f;
        f.selection.set({"berg-1", "berg-2"});
        test::enter(f.number(u"icebergEast"_s), u"1000"_s);
        QCOMPARE(f.iceberg(1).position_m.x(), 1000.0);
        QCOMPARE(f.undoSteps(), 1);
    }

    void leavingAMixedFieldChangesNothing()
    {
        Fixture f;
        f.selection.set({"berg-1", "berg-2"});
        NumberField& east = f.number(u"icebergEast"_s);
        east.setFocus();
        QTest::keyClick(&east, Qt::Key_Return);
        f.number(u"icebergNorth"_s).setFocus();
        QVERIFY(east.isMixed());
        QCOMPARE(f.undoSteps(), 0);
    }

    void mixedNamesSetAll()
    {
        Scenario scenario = threeIcebergs();
        scenario.icebergs[0].name = "Tabular";
        Fixture f(scenario);
        f.selection.set({"berg-1", "berg-2"});
        QLineEdit& name = f.line(u"icebergName"_s);
        QVERIFY(name.text().isEmpty());
        QCOMPARE(name.placeholderText(), u"mixed"_s);
        name.setFocus();
        QTest::keyClicks(&name, u"Growler"_s);
        QTest::keyClick(&name, Qt::Key_Return);
        QCOMPARE(f.iceberg(0).name, "Growler");
        QCOMPARE(f.iceberg(1).name, "Growler");
        QCOMPARE(f.undoSteps(), 1); // all letters together
    }

    void idCanBeChanged()
    {
        Fixture f;
        connect(&f.document, &ScenarioDocument::scenarioChanged, &f.selection,
                [&f] { f.selection.keepExisting(f.document.scenario()); });
        f.selection.set({"berg-2"});
        test::enter(f.line(u"icebergId"_s), u"B07"_s);
        QCOMPARE(f.iceberg(1).id, "B07");
        QCOMPARE(f.selection.ids(), std::vector<std::string>{"B07"});
        QCOMPARE(f.line(u"icebergId"_s).text(), u"B07"_s);
        QCOMPARE(f.label(u"inspectorTitle"_s).text(), u"Iceberg"_s);
        QCOMPARE(f.undoSteps(), 1);
    }

    void idThatCannotBeIsRefused_data()
    {
        QTest::addColumn<QString>("id");
        QTest::newRow("another iceberg") << u"berg-3"_s;
        QTest::newRow("the UAV") << u"uav-1"_s;
        QTest::newRow("empty") << QString();
    }

    void idThatCannotBeIsRefused()
    {
        QFETCH(QString, id);
        Fixture f;
        f.selection.set({"berg-1"});
        QLineEdit& line = f.line(u"icebergId"_s);
        line.setFocus();
        QTest::keyClick(&line, Qt::Key_A, Qt::ControlModifier);
        if (id.isEmpty())
            QTest::keyClick(&line, Qt::Key_Delete);
        else
            QTest::keyClicks(&line, id);
        QLabel& fault = f.label(u"icebergIdFault"_s);
        QVERIFY(fault.isVisible()); // at once, not only when typing has ended
        QVERIFY(fault.text().contains(id));
        QTest::keyClick(&line, Qt::Key_Return);
        QCOMPARE(line.text(), u"berg-1"_s);
        QVERIFY(fault.isVisible());
        QCOMPARE(f.iceberg(0).id, "berg-1");
        QCOMPARE(f.undoSteps(), 0);
    }

    void typingBelongsToWhatWasSelected()
    {
        Fixture f;
        f.selection.set({"berg-1"});
        NumberField& east = f.number(u"icebergEast"_s);
        east.setFocus();
        QTest::keyClick(&east, Qt::Key_A, Qt::ControlModifier);
        QTest::keyClicks(&east, u"1500"_s);
        f.selection.set({"berg-2"});
        QCOMPARE(f.iceberg(0).position_m.x(), 1500.0);
        QCOMPARE(f.iceberg(1).position_m.x(), 3000.0);
        QCOMPARE(east.value(), 3000.0);
    }

    void finishTypingTakesWhatIsTyped()
    {
        Fixture f;
        f.selection.set({"berg-1"});
        NumberField& radius = f.number(u"icebergRadius"_s);
        radius.setFocus();
        QTest::keyClick(&radius, Qt::Key_A, Qt::ControlModifier);
        QTest::keyClicks(&radius, u"75"_s);
        QCOMPARE(f.undoSteps(), 0);
        f.panel.finishTyping();
        QCOMPARE(f.iceberg(0).radius_m, 75.0);
        QCOMPARE(f.undoSteps(), 1);
    }

    void headingGoesRoundNorth()
    {
        Scenario scenario = threeIcebergs();
        scenario.uavs.front().heading_deg = 357;
        Fixture f(scenario);
        f.selection.set({"uav-1"});
        NumberField& heading = f.number(u"uavHeading"_s);
        heading.stepUp();
        QCOMPARE(f.document.scenario().uavs.front().heading_deg, 2.0);
        QCOMPARE(heading.value(), 2.0);
        heading.stepDown();
        QCOMPARE(f.document.scenario().uavs.front().heading_deg, 357.0);
    }

    void lockedCanBeReadOnly()
    {
        Fixture f;
        f.selection.set({"berg-1"});
        f.panel.setLocked(true);
        QVERIFY(f.label(u"inspectorLock"_s).isVisible());
        QVERIFY(f.label(u"inspectorLock"_s).text().contains(u"flight"_s));
        NumberField& east = f.number(u"icebergEast"_s);
        test::enter(east, u"1"_s);
        QTest::keyClick(&east, Qt::Key_Up);
        test::enter(f.line(u"icebergId"_s), u"x"_s);
        test::enter(f.line(u"icebergName"_s), u"x"_s);
        f.selection.clear();
        QVERIFY(!test::child<QCheckBox>(f.panel, u"scenarioNoise"_s).isEnabled());
        QCOMPARE(f.undoSteps(), 0);
        QCOMPARE(f.document.scenario(), threeIcebergs());
        f.panel.setLocked(false);
        f.selection.set({"berg-1"});
        QVERIFY(!f.label(u"inspectorLock"_s).isVisible());
        test::enter(east, u"1"_s);
        QCOMPARE(f.iceberg(0).position_m.x(), 1.0);
    }

    void scenarioTextsAndFlag()
    {
        Fixture f;
        auto& notes = test::child<QPlainTextEdit>(f.panel, u"scenarioNotes"_s);
        notes.setFocus();
        QTest::keyClicks(&notes, u"calm"_s);
        QCOMPARE(f.document.scenario().notes, "calm");
        QCOMPARE(f.undoSteps(), 1);
        auto& noise = test::child<QCheckBox>(f.panel, u"scenarioNoise"_s);
        QTest::mouseClick(&noise, Qt::LeftButton, {}, QPoint(6, noise.height() / 2));
        QVERIFY(f.document.scenario().noise);
        QCOMPARE(f.undoSteps(), 2);
    }

    void everyEndOfEveryRangeIsValid_data() { addEveryNumber(); }

    void everyEndOfEveryRangeIsValid()
    {
        QFETCH(QString, key);
        QFETCH(QString, id);
        Scenario scenario = threeIcebergs();
        scenario.groundStation = GroundStation{.antenna_m = 5, .range_m = 500};
        scenario.wind_mps = Point(3, 4); // a direction is there only with a speed
        scenario.current_mps = Point(0.1, 0);
        Fixture f(scenario);
        if (!id.isEmpty())
            f.selection.set({id.toStdString()});
        NumberField& field = f.number(key);
        QSignalSpy changed(&f.document, &ScenarioDocument::scenarioChanged);
        field.setValue(field.maximum());
        QVERIFY(!hasErrors(f.document.issues()));
        field.setValue(field.minimum());
        QVERIFY(!hasErrors(f.document.issues()));
        QVERIFY(changed.count() > 0);
    }

    void driftIsSpeedAndDirection()
    {
        Fixture f;
        f.selection.set({"berg-1"});
        // 3-4-5 triangle; towards atan(0.3 / 0.4) = 36.9 degrees from north.
        QCOMPARE(f.number(u"icebergVelocitySpeed"_s).value(), 0.5);
        QCOMPARE(f.number(u"icebergVelocityDirection"_s).value(), 36.9);
        test::enter(f.number(u"icebergVelocityDirection"_s), u"90"_s);
        QCOMPARE(f.iceberg(0).velocity_mps, Point(0.5, 0));
        f.number(u"icebergVelocityDirection"_s).stepUp();
        test::enter(f.number(u"icebergVelocitySpeed"_s), u"0"_s);
        QCOMPARE(f.iceberg(0).velocity_mps, Point(0, 0));
        QVERIFY(!f.number(u"icebergVelocityDirection"_s).isVisible()); // it has none
        // Of several with other speeds only the direction is set.
        f.document.undoStack()->setIndex(0);
        f.document.edit(u"Drift"_s, [](Scenario& s) { s.icebergs[1].velocity_mps = {-2, 0}; });
        f.selection.set({"berg-1", "berg-2"});
        test::enter(f.number(u"icebergVelocityDirection"_s), u"180"_s);
        QCOMPARE(f.iceberg(0).velocity_mps, Point(0, -0.5));
        QCOMPARE(f.iceberg(1).velocity_mps, Point(0, -2));
    }

    /** One that was stopped goes on where it went. */
    void speedThroughZeroKeepsTheDirection()
    {
        Fixture f;
        f.selection.set({"berg-1"});
        test::enter(f.number(u"icebergVelocityDirection"_s), u"90"_s);
        test::enter(f.number(u"icebergVelocitySpeed"_s), u"0"_s);
        QCOMPARE(f.iceberg(0).velocity_mps, Point(0, 0));
        test::enter(f.number(u"icebergVelocitySpeed"_s), u"0.25"_s);
        QCOMPARE(f.iceberg(0).velocity_mps, Point(0.25, 0));
        // One that never went anywhere starts to the north; wind that was turned off comes back.
        f.selection.set({"berg-3"});
        QCOMPARE(f.iceberg(2).velocity_mps, Point(0, 0));
        test::enter(f.number(u"icebergVelocitySpeed"_s), u"0.25"_s);
        QCOMPARE(f.iceberg(2).velocity_mps, Point(0, 0.25));
        f.selection.clear();
        test::enter(f.number(u"scenarioWindSpeed"_s), u"8"_s);
        test::enter(f.number(u"scenarioWindDirection"_s), u"270"_s);
        test::enter(f.number(u"scenarioWindSpeed"_s), u"0"_s);
        test::enter(f.number(u"scenarioWindSpeed"_s), u"8"_s);
        QCOMPARE(f.document.scenario().wind_mps, Point(8, 0));
    }

    void driftIsComponentsWhereTheUserWants()
    {
        const test::UnitsInUse units(test::kComponents);
        Fixture f;
        f.selection.set({"berg-1"});
        QCOMPARE(f.label(u"icebergDrift"_s).text(), u"0.50 m/s towards 037°"_s);
        test::enter(f.number(u"icebergVelocityEast"_s), u"-1.5"_s);
        QCOMPARE(f.iceberg(0).velocity_mps, Point(-1.5, 0.4));
        QVERIFY(f.panel.findChild<NumberField*>(u"icebergVelocitySpeed"_s) == nullptr);
    }

    /** Wind is named by where it comes from, current by where it goes. */
    void windIsFromCurrentTowards()
    {
        Fixture f;
        test::enter(f.number(u"scenarioWindSpeed"_s), u"8"_s);
        test::enter(f.number(u"scenarioWindDirection"_s), u"270"_s);
        QCOMPARE(f.document.scenario().wind_mps, Point(8, 0));
        QCOMPARE(f.number(u"scenarioWindDirection"_s).value(), 270.0);
        test::enter(f.number(u"scenarioWindSpeed"_s), u"30"_s);
        QVERIFY(f.document.scenario().wind_mps.norm() < 22); // the airspeed
        test::enter(f.number(u"scenarioCurrentSpeed"_s), u"0.2"_s);
        test::enter(f.number(u"scenarioCurrentDirection"_s), u"90"_s);
        QCOMPARE(f.document.scenario().current_mps, Point(0.2, 0));
        QVERIFY(!hasErrors(f.document.issues()));
    }

    void windStaysSlowerThanTheUav()
    {
        const test::UnitsInUse units(test::kComponents);
        Scenario scenario = threeIcebergs();
        scenario.wind_mps = Point(0, 20);
        Fixture f(scenario);
        NumberField& east = f.number(u"scenarioWindEast"_s);
        // sqrt(22^2 - 20^2) = 9.165, and strictly slower in steps of 0.01.
        QCOMPARE(east.maximum(), 9.16);
        east.setValue(9.16);
        f.selection.set({"uav-1"});
        NumberField& airspeed = f.number(u"uavAirspeed"_s);
        airspeed.setValue(airspeed.minimum());
        QVERIFY(!hasErrors(f.document.issues()));
    }

    void findingsOfTheSelectionAreShown()
    {
        Scenario scenario = threeIcebergs();
        scenario.icebergs[1].appears_s = 5000;
        Fixture f(scenario);
        QLabel& issues = f.label(u"inspectorIssues"_s);
        f.selection.set({"berg-1"});
        QVERIFY(!issues.isVisible());
        f.selection.set({"berg-2"});
        QVERIFY(issues.isVisible());
        QCOMPARE(issues.text(), u"Appears after the end of the run, so it is never planned."_s);
        test::enter(f.number(u"icebergAppears"_s), u"10"_s);
        QVERIFY(!issues.isVisible());
    }

    void findingsAreAboutTheirObject()
    {
        const Issue issue{.severity = Severity::Error,
                          .field = "icebergs[12].q_m2ps",
                          .reason = {IssueId::NotFinite}};
        QCOMPARE(issueIndex(issue, "icebergs"), 12);
        QCOMPARE(issueIndex(issue, "uavs"), -1);
        QCOMPARE(issueIndex({.field = "icebergs"}, "icebergs"), -1);
        QCOMPARE(issueText(issue), u"Growth q must be a finite number."_s);
    }

    void longTextsFitTheDock()
    {
        const test::LongerTexts longer;
        Fixture f;
        f.selection.set({"berg-1", "berg-2"});
        auto& page = test::child<QWidget>(f.panel, u"inspectorScroll"_s);
        for (const QLabel* label : page.findChildren<QLabel*>())
            if (label->isVisible() && !label->wordWrap())
                QVERIFY2(label->width() >= label->sizeHint().width(), qPrintable(label->text()));
        for (const NumberField* field : page.findChildren<NumberField*>())
            if (field->isVisible())
                QVERIFY2(field->width() >= field->minimumSizeHint().width(),
                         qPrintable(field->objectName()));
    }

    void everyInputIsNamed_data() { addEveryNumber(); }

    void everyInputIsNamed()
    {
        QFETCH(QString, key);
        const Fixture f;
        const NumberField& field = f.number(key);
        QVERIFY(!field.accessibleName().isEmpty());
        QVERIFY(!field.toolTip().isEmpty());
        bool hasBuddy = false;
        for (const QLabel* label : f.panel.findChildren<QLabel*>())
            hasBuddy = hasBuddy || label->buddy() == &field;
        QVERIFY(hasBuddy);
    }
};

QTEST_MAIN(TestInspectorPanel)
#include "tst_inspector_panel.moc"
