#include "tests/support/approx.h"
#include "tests/support/window/inspector_fixture.h"
#include "widgets/panels/inspector/inspector_rows.h"
#include "widgets/words/issue_text.h"

#include <QCheckBox>
#include <QPlainTextEdit>
#include <QScrollArea>
#include <QScrollBar>
#include <QSignalSpy>

using namespace berg;
using namespace Qt::StringLiterals;
using test::InspectorFixture;
using test::threeIcebergs;

namespace {

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
        InspectorFixture f;
        QCOMPARE(f.label(u"inspectorTitle"_s).text(), u"Scenario"_s);
        QCOMPARE(f.number(u"duration_s"_s).value(), 1000.0);
        f.selection.set({"berg-1"});
        QCOMPARE(f.label(u"inspectorTitle"_s).text(), u"Iceberg"_s);
        QCOMPARE(f.line(u"icebergId"_s).text(), u"berg-1"_s);
        QCOMPARE(f.number(u"icebergEast"_s).text(), u"1000 m"_s);
        QCOMPARE(f.number(u"icebergs.q_m2ps"_s).text(), u"0.025 m²/s"_s);
        f.selection.set({"uav-1"});
        QCOMPARE(f.label(u"inspectorTitle"_s).text(), u"UAV uav-1"_s);
        QCOMPARE(f.number(u"uavs.heading_deg"_s).value(), 90.0);
        QCOMPARE(f.number(u"uavs.endurance_s"_s).text(), u"unlimited"_s);
        QCOMPARE(f.undoSteps(), 0);
    }

    void derivedValuesAreWrittenOut()
    {
        InspectorFixture f;
        f.selection.set({"berg-1"});
        QCOMPARE(f.label(u"icebergDeviation"_s).text(), u"standard deviation 2.24 m"_s);
        // 2000 m north of 47 N: 2000 / 111175 degrees of the meridian there are 1.079 minutes.
        QCOMPARE(f.line(u"icebergLatitude"_s).text(), u"47° 01.079′ N"_s);
        QVERIFY(f.line(u"icebergLongitude"_s).text().endsWith(u" W"_s));
    }

    void typingEditsOnce()
    {
        InspectorFixture f;
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
        InspectorFixture f;
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
        InspectorFixture f;
        f.selection.set({"berg-1"});
        f.number(u"icebergEast"_s).stepUp();
        f.number(u"icebergNorth"_s).stepUp();
        QCOMPARE(f.undoSteps(), 2);
    }

    void mixedValuesAreEmptyAndSetAll()
    {
        InspectorFixture f;
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

    /** Equal speeds and directions computed from components differ by rounding. */
    void oneDriftForSeveralIsNotMixed()
    {
        Scenario scenario = threeIcebergs();
        for (std::size_t i = 0; i < 3; ++i)
            scenario.icebergs[i].velocity_mps =
                Point(0.31 - 0.17 * double(i), 0.07 + 0.1 * double(i));
        InspectorFixture f(scenario);
        f.selection.set({"berg-1", "berg-2", "berg-3"});
        NumberField& speed = f.number(u"icebergVelocitySpeed"_s);
        NumberField& towards = f.number(u"icebergVelocityDirection"_s);
        QVERIFY(speed.isMixed() && towards.isMixed());
        test::enter(speed, u"0.2"_s);
        QVERIFY(!speed.isMixed());
        QCOMPARE(speed.value(), 0.2);
        QVERIFY(towards.isMixed());
        test::enter(towards, u"30"_s);
        QVERIFY(!towards.isMixed() && !speed.isMixed());
        COMPARE_NEAR(f.iceberg(2).velocity_mps.x(), 0.1, 1e-12);
    }

    void mixedTakesTheHiddenNumberToo()
    {
        // 1000 is what the first of the two has: typing it changes the second all the same.
        InspectorFixture f;
        f.selection.set({"berg-1", "berg-2"});
        test::enter(f.number(u"icebergEast"_s), u"1000"_s);
        QCOMPARE(f.iceberg(1).position_m.x(), 1000.0);
        QCOMPARE(f.undoSteps(), 1);
    }

    void leavingAMixedFieldChangesNothing()
    {
        InspectorFixture f;
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
        InspectorFixture f(scenario);
        f.selection.set({"berg-1", "berg-2"});
        QLineEdit& name = f.line(u"icebergs.name"_s);
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
        InspectorFixture f;
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
        InspectorFixture f;
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
        InspectorFixture f;
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
        InspectorFixture f;
        f.selection.set({"berg-1"});
        NumberField& radius = f.number(u"icebergs.radius_m"_s);
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
        InspectorFixture f(scenario);
        f.selection.set({"uav-1"});
        NumberField& heading = f.number(u"uavs.heading_deg"_s);
        heading.stepUp();
        QCOMPARE(f.document.scenario().uavs.front().heading_deg, 2.0);
        QCOMPARE(heading.value(), 2.0);
        heading.stepDown();
        QCOMPARE(f.document.scenario().uavs.front().heading_deg, 357.0);
    }

    void lockedCanBeReadOnly()
    {
        InspectorFixture f;
        f.selection.set({"berg-1"});
        f.panel.setLocked(true);
        QVERIFY(f.label(u"inspectorLock"_s).isVisible());
        QVERIFY(f.label(u"inspectorLock"_s).text().contains(u"flight"_s));
        NumberField& east = f.number(u"icebergEast"_s);
        test::enter(east, u"1"_s);
        QTest::keyClick(&east, Qt::Key_Up);
        test::enter(f.line(u"icebergId"_s), u"x"_s);
        test::enter(f.line(u"icebergs.name"_s), u"x"_s);
        f.selection.clear();
        QVERIFY(!test::child<QCheckBox>(f.panel, u"noise"_s).isEnabled());
        QCOMPARE(f.undoSteps(), 0);
        QCOMPARE(f.document.scenario(), threeIcebergs());
        f.panel.setLocked(false);
        f.selection.set({"berg-1"});
        QVERIFY(!f.label(u"inspectorLock"_s).isVisible());
        test::enter(east, u"1"_s);
        QCOMPARE(f.iceberg(0).position_m.x(), 1.0);
    }

    /** Tab moves to a field that appeared because of the number just typed. */
    void tabGoesToTheFieldThatAnEditBrings()
    {
        InspectorFixture f;
        NumberField& speed = f.number(u"scenarioWindSpeed"_s);
        NumberField& direction = f.number(u"scenarioWindDirection"_s);
        QVERIFY(!direction.isVisible()); // there is no wind yet
        speed.setFocus();
        speed.selectAll();
        QTest::keyClicks(&speed, u"7.5"_s);
        QTest::keyClick(&speed, Qt::Key_Tab);
        QVERIFY(direction.isVisible());
        QCOMPARE(f.panel.window()->focusWidget(), static_cast<QWidget*>(&direction));
        direction.selectAll(); // as Tab does in a window that is active
        QTest::keyClicks(&direction, u"230"_s);
        QTest::keyClick(&direction, Qt::Key_Tab);
        COMPARE_NEAR(f.document.scenario().wind_mps.norm(), 7.5, 0.001); // of rounded components
        QCOMPARE(direction.value(), 230.0);
        QVERIFY(!f.document.scenario().weather.gust_mps);
    }

    /** Notices below the rows move none of them, neither at the top nor at the end. */
    void noticesMoveNoRow()
    {
        InspectorFixture f;
        f.panel.resize(300, 400);
        const auto& area = test::child<QScrollArea>(f.panel, u"inspectorScroll"_s);
        const auto& first = test::child<QWidget>(f.panel, u"name"_s);
        const auto topOf = [&](const QWidget& widget) {
            return widget.mapTo(&f.panel, QPoint()).y();
        };
        QCoreApplication::sendPostedEvents();
        QVERIFY(topOf(first) <
                topOf(f.label(u"inspectorSubtitle"_s)) + 3 * f.panel.fontMetrics().lineSpacing());
        for (const bool isAtEnd : {false, true}) {
            QScrollBar& bar = *area.verticalScrollBar();
            bar.setValue(isAtEnd ? bar.maximum() : 0);
            const int before_px = topOf(first);
            f.panel.setLocked(true);
            QCoreApplication::sendPostedEvents();
            QVERIFY(f.label(u"inspectorLock"_s).isVisible());
            QVERIFY(topOf(f.label(u"inspectorLock"_s)) >= area.geometry().bottom());
            QCOMPARE(topOf(first), before_px);
            f.panel.setLocked(false);
            QCoreApplication::sendPostedEvents();
            QCOMPARE(topOf(first), before_px);
        }
    }

    void anotherKindOfThingBeginsAtItsTop()
    {
        InspectorFixture f;
        f.panel.resize(300, 300);
        QScrollBar& bar =
            *test::child<QScrollArea>(f.panel, u"inspectorScroll"_s).verticalScrollBar();
        QCoreApplication::sendPostedEvents();
        bar.setValue(bar.maximum());
        f.selection.set({"uav-1"});
        QCOMPARE(bar.value(), 0);
        QCoreApplication::sendPostedEvents();
        bar.setValue(40);
        f.selection.clear();
        f.selection.set({"uav-1"});
        QCOMPARE(bar.value(), 0);
    }

    /** Characters shown as a space or a line end stay in the file unchanged. */
    void notesThatAreOnlyShownStay_data()
    {
        QTest::addColumn<QString>("notes");
        QTest::newRow("no-break space") << u"Zone\u00a0: 5 km"_s;
        QTest::newRow("line ends of Windows") << u"first\r\nsecond"_s;
        QTest::newRow("line separator") << u"first\u2028second"_s;
    }

    void notesThatAreOnlyShownStay()
    {
        QFETCH(QString, notes);
        InspectorFixture f;
        Scenario scenario = threeIcebergs();
        scenario.notes = notes.toStdString();
        f.document.reset(scenario);
        QVERIFY(f.document.isClean());
        QCOMPARE(f.document.scenario(), scenario);
        auto& page = test::child<QPlainTextEdit>(f.panel, u"notes"_s);
        page.setFocus();
        QTest::keyClicks(&page, u"x"_s);
        QCOMPARE(f.undoSteps(), 1);
        f.document.undo();
        QCOMPARE(f.document.scenario(), scenario);
        QVERIFY(f.document.isClean());
    }

    void scenarioTextsAndFlag()
    {
        InspectorFixture f;
        auto& notes = test::child<QPlainTextEdit>(f.panel, u"notes"_s);
        notes.setFocus();
        QTest::keyClicks(&notes, u"calm"_s);
        QCOMPARE(f.document.scenario().notes, "calm");
        QCOMPARE(f.undoSteps(), 1);
        auto& noise = test::child<QCheckBox>(f.panel, u"noise"_s);
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
        scenario.operation = Operation{};
        InspectorFixture f(scenario);
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

    void findingsOfTheSelectionAreShown()
    {
        Scenario scenario = threeIcebergs();
        scenario.icebergs[1].appears_s = 5000;
        InspectorFixture f(scenario);
        QLabel& issues = f.label(u"inspectorIssues"_s);
        f.selection.set({"berg-1"});
        QVERIFY(!issues.isVisible());
        f.selection.set({"berg-2"});
        QVERIFY(issues.isVisible());
        QCOMPARE(issues.text(),
                 u"Appears at: is after the end of the run, so the iceberg is never planned"_s);
        test::enter(f.number(u"icebergs.appears_s"_s), u"10"_s);
        QVERIFY(!issues.isVisible());
    }

    void findingsAreAboutTheirObject()
    {
        const Issue issue{.severity = Severity::Error,
                          .field = "icebergs[12].q_m2ps",
                          .reason = {IssueId::NotFinite}};
        QCOMPARE(issueIndex(issue, "icebergs").value(), std::size_t{12});
        QVERIFY(!issueIndex(issue, "uavs"));
        QVERIFY(!issueIndex({.field = "icebergs"}, "icebergs"));
        QCOMPARE(issueText(issue), u"Growth q: must be a finite number"_s);
    }

    void longTextsFitTheDock()
    {
        const test::LongerTexts longer;
        InspectorFixture f;
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
        const InspectorFixture f;
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
