#include "tests/support/flight/scenario_builder.h"
#include "tests/support/window/panel_test.h"
#include "widgets/panels/inspector/check_panel.h"
#include "widgets/words/issue_text.h"

#include <QListWidget>
#include <QSignalSpy>

using namespace berg;
using namespace Qt::StringLiterals;

namespace {

/** A panel over two icebergs without findings. */
struct CheckPanelFixture
{
    CheckPanelFixture()
    {
        Scenario scenario = test::emptySea();
        test::addIceberg(scenario, 1000, 0).name = "Big";
        test::addIceberg(scenario, 2000, 0);
        document.reset(scenario);
        panel.resize(test::kDock_px, 300);
        panel.show();
    }
    void change(const std::function<void(Scenario&)>& how)
    {
        document.edit(u"Change"_s, how, u"test"_s);
    }
    [[nodiscard]] QListWidget& list() { return test::child<QListWidget>(panel, u"checkList"_s); }
    [[nodiscard]] QString line(int row) { return list().item(row)->text(); }

    ScenarioDocument document;
    CheckPanel panel{document};
};

} // namespace

class TestCheckPanel : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnWarnings(); }

    void noFindingsAreShown()
    {
        CheckPanelFixture f;
        QVERIFY(test::child<QWidget>(f.panel, u"checksEmpty"_s).isVisible());
        QVERIFY(!f.list().isVisible());
        f.change([](Scenario& s) { s.icebergs[0].velocity_mps = {3, 0}; });
        QVERIFY(f.list().isVisible());
        f.change([](Scenario& s) { s.icebergs[0].velocity_mps = {0, 0}; });
        QVERIFY(!f.list().isVisible());
    }

    /** Plan findings follow scenario findings of the same severity, until the next plan. */
    void findingsAboutThePlanAreListed()
    {
        CheckPanelFixture f;
        QSignalSpy changed(&f.panel, &CheckPanel::changed);
        f.change([](Scenario& s) { s.icebergs[0].velocity_mps = {3, 0}; }); // hint
        f.panel.setPlanIssues(
            {Issue{Severity::Warning,
                   "uavs[0]",
                   {.id = IssueId::NoContact, .arguments = {Amount{90, Quantity::Seconds}}}}});
        QCOMPARE(f.list().count(), 2);
        QCOMPARE(f.line(0), u"uav-1: the plan leads out of the range of the ground station "
                            "for 01:30"_s);
        QCOMPARE(f.panel.issues().size(), std::size_t{2});
        QCOMPARE(changed.count(), 2);
        f.panel.setPlanIssues({});
        QCOMPARE(f.list().count(), 1);
    }

    void worstComesFirst()
    {
        CheckPanelFixture f;
        f.change([](Scenario& s) {
            s.icebergs[0].velocity_mps = {3, 0};     // hint
            s.icebergs[1].position_m = {100'000, 0}; // warning
        });
        QCOMPARE(f.list().count(), 2);
        QCOMPARE(f.line(0), u"berg-2: is too far away to reach before the run ends"_s);
        QCOMPARE(f.line(1), u"Big: drifts faster than icebergs do: is the unit right?"_s);
        QVERIFY(f.list().item(0)->toolTip().startsWith(u"Warning"));
        QVERIFY(f.list().item(1)->toolTip().startsWith(u"Hint"));
        f.change([](Scenario& s) { s.wind_mps = {30, 0}; });
        QCOMPARE(f.list().count(), 1);
        QCOMPARE(
            f.line(0),
            u"The wind must be slower than the UAV flies: wind of 30 m/s, airspeed of uav-1 22 m/s"_s);
        QVERIFY(f.list().item(0)->toolTip().startsWith(u"Error"));
    }

    void namesAreKeptUpToDate()
    {
        CheckPanelFixture f;
        f.change([](Scenario& s) { s.icebergs[0].velocity_mps = {3, 0}; });
        f.change([](Scenario& s) { s.icebergs[0].name = "Bigger"; });
        QVERIFY(f.line(0).startsWith(u"Bigger: "));
    }

    void choosesByMouseAndKey()
    {
        CheckPanelFixture f;
        f.change([](Scenario& s) {
            s.icebergs[0].velocity_mps = {3, 0};
            s.icebergs[1].velocity_mps = {3, 0};
        });
        QSignalSpy chosen(&f.panel, &CheckPanel::chosen);
        const QRect second = f.list().visualItemRect(f.list().item(1));
        QTest::mouseClick(f.list().viewport(), Qt::LeftButton, {}, second.center());
        QVERIFY(!chosen.isEmpty());
        QCOMPARE(chosen.last().front().value<Issue>().field,
                 std::string("icebergs[1].velocity_mps"));
        chosen.clear();
        QTest::keyClick(&f.list(), Qt::Key_Up);
        QTest::keyClick(&f.list(), Qt::Key_Return);
        QCOMPARE(chosen.count(), 1);
        QCOMPARE(chosen.last().front().value<Issue>().field,
                 std::string("icebergs[0].velocity_mps"));
    }

    /** A list that is unchanged by an edit keeps its current line. */
    void unchangedListKeepsItsCurrentLine()
    {
        CheckPanelFixture f;
        f.change([](Scenario& s) {
            s.icebergs[0].velocity_mps = {3, 0};
            s.icebergs[1].velocity_mps = {3, 0};
        });
        f.list().setCurrentRow(1);
        const QListWidgetItem* item = f.list().item(1);
        f.change([](Scenario& s) { s.icebergs[0].position_m = {1100, 0}; });
        QCOMPARE(f.list().item(1), item);
        QCOMPARE(f.list().currentRow(), 1);
    }

    void linesWrapInANarrowDock()
    {
        CheckPanelFixture f;
        f.change([](Scenario& s) { s.icebergs[1].position_m = {100'000, 0}; });
        const QRect line = f.list().visualItemRect(f.list().item(0));
        QVERIFY(line.width() <= f.list().viewport()->width());
        QVERIFY(line.height() >= 2 * f.list().fontMetrics().height());
    }

    void findingsAreCountedBySeverity()
    {
        QCOMPARE(countsText({.errors = 1, .warnings = 1}), u"1 error, 1 warning"_s);
        QCOMPARE(countsText({.hints = 1}), u"1 hint"_s);
        QCOMPARE(countsText({}), QString());
        QCOMPARE(countsText({.hints = 2}), u"2 hints"_s);
        QCOMPARE(countsText({.errors = 2, .warnings = 3, .hints = 4}), u"2 errors, 3 warnings"_s);
        const IssueCounts counted = countIssues({{.severity = Severity::Hint},
                                                 {.severity = Severity::Error},
                                                 {.severity = Severity::Error}});
        QCOMPARE(counted.errors, 2);
        QCOMPARE(counted.warnings, 0);
        QCOMPARE(counted.hints, 1);
    }
};

QTEST_MAIN(TestCheckPanel)
#include "tst_check_panel.moc"
