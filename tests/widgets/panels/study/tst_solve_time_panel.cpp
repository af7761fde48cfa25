#include "tests/support/window/panel_test.h"
#include "tests/support/window/patience.h"
#include "widgets/charts/solve_time_chart.h"
#include "widgets/panels/fields/number_field.h"
#include "widgets/panels/study/solve_time_panel.h"

#include <QCheckBox>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalSpy>

using namespace berg;
using namespace Qt::StringLiterals;
using test::kPatience_ms;

namespace {

struct SolveTimePanelFixture
{
    BenchmarkRunner runner;
    SolveTimePanel panel{runner};
    NumberField& largest = test::child<NumberField>(panel, u"largestSize"_s);
    NumberField& repeat = test::child<NumberField>(panel, u"repeat"_s);
    NumberField& budget = test::child<NumberField>(panel, u"budget"_s);
    QPushButton& start = test::child<QPushButton>(panel, u"startBenchmark"_s);
    QPushButton& save = test::child<QPushButton>(panel, u"saveBenchmark"_s);
    QProgressBar& bar = test::child<QProgressBar>(panel, u"benchmarkProgress"_s);
    QLabel& state = test::child<QLabel>(panel, u"benchmarkState"_s);
    SolveTimeChart& chart = test::child<SolveTimeChart>(panel, u"solveTimeChart"_s);
    QSignalSpy finished{&runner, &BenchmarkRunner::finished};
    QSignalSpy saved{&panel, &SolveTimePanel::saveRequested};

    SolveTimePanelFixture()
    {
        QObject::connect(&panel, &SolveTimePanel::startRequested, &panel, &SolveTimePanel::start);
        panel.resize(820, 560);
        panel.show();
    }
    void choose(const QString& only)
    {
        for (QCheckBox* box : panel.findChildren<QCheckBox*>())
            box->setChecked(box->objectName() == only);
    }
    /** Starts a measurement from milliseconds to minutes: rows come soon, but it does not end. */
    void startForLong()
    {
        choose(u"exact"_s);
        largest.setValue(100);
        repeat.setValue(100);
        budget.setValue(3600);
        start.click();
    }
};

} // namespace

class TestSolveTimePanel : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnWarnings(); }

    void settingsBecomeTheSpec()
    {
        SolveTimePanelFixture f;
        f.choose(u"heuristic"_s);
        f.largest.setValue(15);
        f.repeat.setValue(7);
        f.budget.setValue(12);
        const BenchmarkSpec spec = f.panel.spec();
        QVERIFY((spec.sizes == std::vector<int>{2, 6, 10, 12, 15}));
        QCOMPARE(spec.repeat, 7);
        QCOMPARE(spec.budget_s, 12.0);
        QCOMPARE(spec.solvers.size(), std::size_t{1});
        QCOMPARE(spec.solvers.front().backend, Backend::Heuristic);
        QCOMPARE(spec.tau, 0.5); // that of the paper's table
    }

    /** The panel is recreated, as for another language or other units. */
    void panelOfAnotherWindowShowsTheMeasurement()
    {
        SolveTimePanelFixture f;
        f.startForLong();
        QTest::qWait(1100); // long enough for a time to be shown
        SolveTimePanel next(f.runner);
        next.showSpec(f.panel.spec());
        QCOMPARE(next.spec().budget_s, 3600.0);
        QVERIFY(f.runner.elapsed_s() >= 1);
        const QString state = test::child<QLabel>(next, u"benchmarkState"_s).text();
        QVERIFY2(state.contains(u"59:5"_s), qPrintable(state)); // of an hour
        f.runner.cancel();
        QVERIFY(QTest::qWaitFor([&] { return !f.runner.isRunning(); }, kPatience_ms));
    }

    void everySolverOfThisBuildIsOffered()
    {
        const SolveTimePanelFixture f;
        for (const BenchmarkSolver& solver : benchmarkSolvers()) {
            const auto& box = test::child<QCheckBox>(
                f.panel, QString::fromStdString(nameOf(kBenchmarkSolverNames, solver)));
            QCOMPARE(box.text(), benchmarkSolverName(solver));
            QVERIFY(!box.toolTip().isEmpty() && !box.icon().isNull());
        }
    }

    void measuresAndShows()
    {
        SolveTimePanelFixture f;
        f.choose(u"exact"_s);
        f.largest.setValue(8);
        f.repeat.setValue(2);
        QVERIFY(!f.save.isEnabled());
        f.start.click();
        QVERIFY(f.runner.isRunning());
        QTRY_COMPARE_WITH_TIMEOUT(f.finished.count(), 1, kPatience_ms);
        QCOMPARE(f.chart.drawing().labels.size(), std::size_t{3}); // the paper's two and ours
        QCOMPARE(f.bar.value(), f.bar.maximum());
        QVERIFY(f.state.text().startsWith(u"Measured in"_s));
        QVERIFY(f.start.isEnabled() && f.start.text() == u"Start"_s);

        QVERIFY(f.save.isEnabled());
        f.save.click();
        QCOMPARE(f.saved.count(), 1);
        QCOMPARE(f.runner.rows().size(), std::size_t{3}); // sizes 2, 6 and 8
    }

    void settingsAreLockedWhileItRuns()
    {
        SolveTimePanelFixture f;
        f.startForLong();
        QVERIFY(!f.largest.isEnabled() && !f.repeat.isEnabled() && !f.budget.isEnabled());
        QVERIFY(!f.save.isEnabled());
        QCOMPARE(f.start.text(), u"Stop"_s);
        QVERIFY(f.state.text().contains(u"left"_s));
    }

    void cancelKeepsTheTable()
    {
        SolveTimePanelFixture f;
        f.startForLong();
        QTRY_VERIFY_WITH_TIMEOUT(!f.runner.rows().empty(), kPatience_ms);
        f.start.click();
        QVERIFY(!f.start.isEnabled() || f.finished.count() == 1);
        QTRY_COMPARE_WITH_TIMEOUT(f.finished.count(), 1, kPatience_ms);
        QVERIFY(f.start.isEnabled() && f.largest.isEnabled());
        QCOMPARE(f.start.text(), u"Start"_s);
        QVERIFY(f.save.isEnabled());
        QVERIFY(!f.runner.rows().empty());
        QVERIFY(f.state.text().contains(u"kept"_s));
    }

    void withoutSolverThereIsNothingToStart()
    {
        SolveTimePanelFixture f;
        f.choose(u"none"_s);
        QVERIFY(!f.start.isEnabled());
        QVERIFY(!f.start.toolTip().isEmpty());
        f.choose(u"exact"_s);
        QVERIFY(f.start.isEnabled());
    }

    void themeReachesTheChart()
    {
        SolveTimePanelFixture f;
        const Theme dark = Theme::dark();
        f.panel.setTheme(dark);
        QCOMPARE(f.chart.grab().toImage().pixelColor(0, 0).rgb(), dark.chart.rgb());
    }

    void longTextsFitASmallWindow()
    {
        const test::LongerTexts longer;
        SolveTimePanelFixture f;
        constexpr int kNarrow_px = 900;
        QVERIFY2(f.panel.minimumSizeHint().width() <= kNarrow_px,
                 QByteArray::number(f.panel.minimumSizeHint().width()).constData());
    }
};

QTEST_MAIN(TestSolveTimePanel)
#include "tst_solve_time_panel.moc"
