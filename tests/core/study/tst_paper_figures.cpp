#include "core/presets/presets.h"
#include "core/study/paper_figures.h"
#include "tests/support/approx.h"

#include <algorithm>

using namespace berg;

class TestPaperFigures : public QObject
{
    Q_OBJECT

private slots:
    /** Figure 3 agrees with Table 1 and Table 2 of the paper. */
    void figure3AsPrinted()
    {
        const std::vector<BenchmarkSolver> solvers{{.backend = Backend::Exact}};
        const BenchmarkSpec spec = figure3(solvers);
        QCOMPARE(spec.sizes, (std::vector<int>{2, 6, 10, 12, 16, 20}));
        QCOMPARE(spec.repeat, 50);
        QCOMPARE(spec.tau, 0.5);
        QVERIFY(spec.solvers == solvers);
        QVERIFY(spec.budget_s > 0);
    }

    void figure3Runs()
    {
        const std::vector<BenchmarkRow> rows =
            runBenchmark(figure3({{.backend = Backend::Exact}}), {});
        QCOMPARE(rows.size(), std::size_t{6});
        for (const BenchmarkRow& row : rows)
            QCOMPARE(row.proven, 50);
    }

    void figure4AsPrinted()
    {
        const Scenario scenario = defaultScenario();
        const StudySpec spec = figure4(scenario);
        QVERIFY(spec.scenarios == std::vector<Scenario>{scenario});
        QCOMPARE(spec.random, 0);
        QCOMPARE(spec.runs, 1);
        QCOMPARE(spec.name, "Figure 4: " + scenario.name);
        const std::vector<StudySetting> settings = settingsOf(spec);
        QCOMPARE(settings.size(), std::size_t{42});
        QCOMPARE(settings.front(), (StudySetting{.tau = 0}));
        QCOMPARE(settings[3], (StudySetting{.tau = 0.3})); // 3 x 0.1 is not 0.3
        QCOMPARE(settings[15], (StudySetting{.tau = 1.5}));
        QCOMPARE(settings[40], (StudySetting{.tau = 4}));
        QCOMPARE(settings[41], (StudySetting{.policy = PolicyKind::Path}));
        QVERIFY(!hasErrors(validate(spec)));
        QVERIFY(settings[40].tau < 4.5); // the path is drawn beyond the curve
    }

    void figure4WithoutName()
    {
        Scenario scenario = defaultScenario();
        scenario.name.clear();
        QCOMPARE(figure4(scenario).name, std::string("Figure 4"));
    }

    /** Figure 5 shows two flights of Figure 4: the lowest of the curve, and the path. */
    void figure5OfAFlownFigure4()
    {
        Scenario scenario = randomScenario(1, {.icebergs = 5, .size_m = {3000, 2500}});
        scenario.duration_s = 200;
        Study study{.spec = figure4(scenario), .outcomes = {}};
        QVERIFY(!figure5(summarise(study, 0)));
        QVERIFY(fly(study));
        const std::optional<Figure5> figure = figure5(summarise(study, 0));
        QVERIFY(figure);
        QCOMPARE(figure->tsp, settingsOf(study.spec).back());
        const auto flown = [&](double tau) {
            return study.outcomes.at(static_cast<std::size_t>(std::lround(10 * tau)))
                ->metrics.zeta_m2s;
        };
        for (int tenth = 0; tenth <= 40; ++tenth) {
            const double tau = tenth / 10.0;
            QVERIFY(flown(tau) > flown(*figure->best.tau) ||
                    (flown(tau) == flown(*figure->best.tau) && tau >= figure->best.tau));
        }
        Mission mission(scenarioOf(study.spec, 0, figure->best));
        mission.advance(scenario.duration_s);
        COMPARE_NEAR(mission.metrics().zeta_m2s, flown(*figure->best.tau), 0);
    }

    void noFigure5WithoutTau()
    {
        Study study{.spec = {.random = 1, .policies = {PolicyKind::Path, PolicyKind::Tour}},
                    .outcomes = {MissionOutcome{}, MissionOutcome{}}};
        QCOMPARE(summarise(study, 0).cases.size(), std::size_t{1});
        QVERIFY(!figure5(summarise(study, 0)));
    }
};

QTEST_APPLESS_MAIN(TestPaperFigures)
#include "tst_paper_figures.moc"
