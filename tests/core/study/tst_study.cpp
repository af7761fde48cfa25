#include "core/study/study.h"
#include "tests/support/approx.h"
#include "tests/support/expect_error.h"
#include "tests/support/flight/flown_plans.h"
#include "tests/support/flight/flown_study.h"
#include "tests/support/flight/scenario_builder.h"

#include <algorithm>
#include <set>

using namespace berg;
using namespace berg::test;

namespace {

/** Three scenarios, two of them random, twice each; four settings: 24 missions. */
StudySpec smallSpec()
{
    return {.name = "small",
            .scenarios = {smallField(1)},
            .random = 2,
            .firstSeed = 7,
            .field = {.icebergs = 4, .size_m = {2500, 2000}},
            .taus = {0.5, 2},
            .policies = {PolicyKind::Nearest, PolicyKind::Visitation, PolicyKind::Path},
            .runs = 2};
}

bool isStuck(const Scenario& scenario, PolicyKind policy)
{
    return flown({.scenarios = {scenario}, .taus = {1}, .policies = {policy}})
        .outcomes.at(0)
        ->stuck;
}

/** Returns options that stop a flight after `missions` missions. */
StudyOptions stoppingAfter(std::size_t missions, std::stop_source& source, int threads = 1)
{
    return {.threads = threads,
            .stop = source.get_token(),
            .onProgress = [missions, &source](const Study&, std::size_t done, std::size_t) {
                if (done >= missions)
                    source.request_stop();
            }};
}

} // namespace

class TestStudy : public QObject
{
    Q_OBJECT

private slots:
    /** Settings beyond the limit are rejected before they take memory. */
    void settingsBeyondAllLimits()
    {
        StudySpec spec{.random = 1};
        spec.taus.assign(100'000, 1);
        spec.policies.assign(100'000, PolicyKind::Visitation);
        const std::vector<Issue> issues = validate(spec);
        QVERIFY(hasErrors(issues));
        QCOMPARE(issues[0].field, std::string("taus"));
        spec.taus.assign(3'000'000, -1);
        QVERIFY(validate(spec).size() <= 1000);
    }

    void settingsInOrder()
    {
        // Visitation with each tau in the given order precedes the other policies.
        const std::vector<StudySetting> expected{{PolicyKind::Visitation, 0.5},
                                                 {PolicyKind::Visitation, 2},
                                                 {PolicyKind::Nearest, std::nullopt},
                                                 {PolicyKind::Path, std::nullopt}};
        QVERIFY(settingsOf(smallSpec()) == expected);
    }

    void missionsAreCounted()
    {
        StudySpec spec = smallSpec();
        QCOMPARE(caseCount(spec), std::size_t{6});
        QCOMPARE(missionCount(spec), std::size_t{24});
        spec.policies = {PolicyKind::Nearest};
        QCOMPARE(missionCount(spec), std::size_t{6});
        spec.policies = {PolicyKind::Visitation};
        spec.runs = 5;
        QCOMPARE(missionCount(spec), std::size_t{30});
        spec.scenarios.clear();
        spec.random = 0;
        QCOMPARE(missionCount(spec), std::size_t{0});
        QCOMPARE(missionCount({}), std::size_t{0});
    }

    /** Cases are ordered by scenario, then run, and each outcome equals a separate mission. */
    void casesArePaired()
    {
        const StudySpec spec = smallSpec();
        const Study study = flown(spec);
        const std::vector<StudySetting> settings = settingsOf(spec);
        std::set<double> different;
        for (std::size_t c = 0; c < caseCount(spec); ++c)
            for (std::size_t s = 0; s < settings.size(); ++s) {
                Scenario scenario =
                    c / 2 == 0 ? spec.scenarios[0] : randomScenario(c / 2 == 1 ? 7 : 8, spec.field);
                scenario.seed = seedOfRun(scenario.seed, static_cast<int>(c % 2));
                scenario.planner.policy = settings[s].policy;
                scenario.planner.tau = settings[s].tau.value_or(scenario.planner.tau);
                QVERIFY(scenarioOf(spec, c, settings[s]) == scenario);
                Mission mission(scenario);
                mission.advance(scenario.duration_s);
                const auto& outcome = study.outcomes.at(c * settings.size() + s);
                QVERIFY(outcome);
                QVERIFY(outcome->metrics == mission.metrics());
                different.insert(outcome->metrics.zeta_m2s);
            }
        // Settings, scenarios and noise all matter, so hardly any two are equal.
        QVERIFY(different.size() >= 20);
    }

    void sameForAnyNumberOfThreads()
    {
        const Study one = flown(smallSpec(), {.threads = 1});
        QVERIFY(one == flown(smallSpec(), {.threads = 2}));
        QVERIFY(one == flown(smallSpec(), {.threads = 7}));
    }

    /** With a single case its settings are spread over the threads. */
    void oneCaseOnManyThreads()
    {
        StudySpec spec = smallSpec();
        spec.random = 0;
        spec.runs = 1;
        QVERIFY(flown(spec, {.threads = 1}) == flown(spec, {.threads = 3}));
    }

    void withoutNoiseRunsAreEqual()
    {
        Scenario scenario = smallField(1);
        scenario.noise = false;
        const Study study =
            flown({.scenarios = {scenario}, .policies = {PolicyKind::Nearest}, .runs = 3});
        QCOMPARE(study.outcomes.size(), std::size_t{3});
        QVERIFY(study.outcomes[0] == study.outcomes[1]);
        QVERIFY(study.outcomes[0] == study.outcomes[2]);
    }

    void tauOfTheScenarioIsNotUsed()
    {
        StudySpec spec = smallSpec();
        spec.policies = {PolicyKind::Visitation};
        const Study before = flown(spec);
        for (Scenario& scenario : spec.scenarios)
            scenario.planner.tau = 77;
        QVERIFY(before.outcomes == flown(spec).outcomes);
    }

    void progressCountsMissions()
    {
        std::vector<std::size_t> progress;
        const auto onProgress = [&](const Study& study, std::size_t done, std::size_t count) {
            QCOMPARE(count, std::size_t{24});
            QCOMPARE(flownCount(study), done);
            progress.push_back(done);
        };
        flown(smallSpec(), {.threads = 3, .onProgress = onProgress});
        QCOMPARE(progress.size(), std::size_t{25}); // including the call at the start
        for (std::size_t i = 0; i < progress.size(); ++i)
            QCOMPARE(progress[i], i);
    }

    void stoppedAndCarriedOn_data()
    {
        QTest::addColumn<int>("threads");
        QTest::newRow("one thread") << 1;
        QTest::newRow("three threads") << 3;
    }
    void stoppedAndCarriedOn()
    {
        QFETCH(const int, threads);
        const Study whole = flown(smallSpec());
        Study study{.spec = smallSpec()};
        for (std::size_t last = 0; flownCount(study) < 24; last = flownCount(study)) {
            std::stop_source source;
            const bool complete = fly(study, stoppingAfter(last + 5, source, threads));
            QCOMPARE(complete, flownCount(study) == 24);
            QVERIFY(flownCount(study) > last);
        }
        QVERIFY(study == whole);
        QVERIFY(fly(study)); // nothing left
        QVERIFY(study == whole);
    }

    void stoppedBeforeTheStart()
    {
        std::stop_source source;
        source.request_stop();
        Study study{.spec = smallSpec()};
        QVERIFY(!fly(study, {.stop = source.get_token()}));
        QCOMPARE(flownCount(study), std::size_t{0});
    }

    /** Outcomes so far are retained when the caller's own work fails. */
    void keptWhenSomethingThrows()
    {
        const auto onProgress = [](const Study&, std::size_t done, std::size_t) {
            if (done == 9)
                throw Error(ErrorCode::FileUnwritable, "disk", "full");
        };
        Study study{.spec = smallSpec()};
        QCOMPARE(codeOf([&] { fly(study, {.threads = 1, .onProgress = onProgress}); }),
                 std::string("FileUnwritable"));
        QCOMPARE(flownCount(study), std::size_t{9});
        QVERIFY(fly(study));
        QVERIFY(study == flown(smallSpec()));
    }

    void shardsAreTheWhole_data()
    {
        QTest::addColumn<QList<int>>("order");
        QTest::newRow("in order") << QList<int>{1, 2, 3};
        QTest::newRow("turned round") << QList<int>{3, 2, 1};
        QTest::newRow("one twice") << QList<int>{2, 3, 1, 2};
    }
    void shardsAreTheWhole()
    {
        QFETCH(const QList<int>, order);
        std::vector<Study> parts;
        for (const int index : order) {
            parts.push_back({.spec = smallSpec()});
            QVERIFY(fly(parts.back(), {.shard = {.index = index, .count = 3}}));
            QCOMPARE(flownCount(parts.back()), std::size_t{8});
            // Cases c with c mod 3 = index - 1, whole.
            QVERIFY(parts.back().outcomes.at(4 * static_cast<std::size_t>(index - 1)));
        }
        QVERIFY(merge(parts) == flown(smallSpec()));
    }

    /** With more shards than cases some have no work. */
    void shardWithoutCasesIsComplete()
    {
        Study study{.spec = smallSpec()};
        QVERIFY(fly(study, {.shard = {.index = 9, .count = 9}}));
        QCOMPARE(flownCount(study), std::size_t{0});
        QVERIFY(merge({study, flown(smallSpec())}) == flown(smallSpec()));
    }

    void shardThatIsNone_data()
    {
        QTest::addColumn<int>("index");
        QTest::addColumn<int>("count");
        QTest::newRow("0 of 3") << 0 << 3;
        QTest::newRow("4 of 3") << 4 << 3;
        QTest::newRow("1 of 0") << 1 << 0;
    }
    void shardThatIsNone()
    {
        QFETCH(const int, index);
        QFETCH(const int, count);
        Study study{.spec = smallSpec()};
        QCOMPARE(codeOf([&] {
                     fly(study, {.shard = {index, count}});
                 }),
                 std::string("InvalidInput"));
    }

    void mergeRefusesOtherStudies()
    {
        Study other{.spec = smallSpec()};
        other.spec.taus.push_back(3);
        const auto error = errorOf([&] { (void)merge({{.spec = smallSpec()}, other}); });
        QVERIFY(error);
        QCOMPARE(error->code(), ErrorCode::InvalidInput);
        QCOMPARE(error->issues().at(0).field, std::string("taus"));
    }

    void mergeRefusesContradictions()
    {
        const Study study = flown(smallSpec());
        Study other = study;
        other.outcomes[5]->metrics.zeta_m2s += 1;
        const auto error = errorOf([&] { (void)merge({study, other}); });
        QVERIFY(error);
        QCOMPARE(error->code(), ErrorCode::InvalidInput);
        QVERIFY(std::string(error->what()).find("setting 2 of case 2") != std::string::npos);
    }

    void differingMembers()
    {
        const StudySpec spec = smallSpec();
        QCOMPARE(differingMember(spec, spec), std::string());
        const auto changed = [&](const auto& change) {
            StudySpec other = spec;
            change(other);
            return differingMember(spec, other);
        };
        QCOMPARE(changed([](StudySpec& s) { s.name = "x"; }), std::string("name"));
        QCOMPARE(changed([](StudySpec& s) { s.taus[0] = 0; }), std::string("taus"));
        QCOMPARE(changed([](StudySpec& s) { s.policies.pop_back(); }), std::string("policies"));
        QCOMPARE(changed([](StudySpec& s) { s.runs = 1; }), std::string("runs"));
        QCOMPARE(changed([](StudySpec& s) { s.random = 1; }), std::string("random"));
        QCOMPARE(changed([](StudySpec& s) { s.firstSeed = 1; }), std::string("first_seed"));
        QCOMPARE(changed([](StudySpec& s) { s.field.icebergs = 1; }), std::string("field"));
        QCOMPARE(changed([](StudySpec& s) { s.scenarios[0].seed = 9; }), std::string("scenarios"));
    }

    /** The last of many scenarios is faulty, which is reported before anything is flown. */
    void badScenarioIsReportedFirst()
    {
        Study study{.spec = smallSpec()};
        study.spec.scenarios.push_back(smallField(2));
        study.spec.scenarios.back().wind_mps = {30, 0}; // faster than the UAV
        QCOMPARE(codeOf([&] { fly(study); }), std::string("InvalidInput"));
        QCOMPARE(flownCount(study), std::size_t{0});
    }

    void unsupportedPolicyIsReportedFirst()
    {
        Study study{.spec = smallSpec()};
        study.spec.scenarios[0].planner.backend = Backend::Cbc;
        study.spec.policies.push_back(PolicyKind::Latency); // no MILP supports it
        QCOMPARE(codeOf([&] { fly(study); }), std::string("Unsupported"));
        QCOMPARE(flownCount(study), std::size_t{0});
    }

    void faultsOfTheNumbers_data()
    {
        QTest::addColumn<QString>("field");
        const auto row = [](const char* field) { QTest::newRow(field) << field; };
        row("random");
        row("runs");
        row("first_seed");
        row("field.icebergs");
        row("field.size_m[1]");
        row("field.speed_max_mps");
        row("field.sigma_max_m2");
        row("field.q_m2ps");
        row("taus[1]");
        row("policies");
        row("scenarios");
        row("");
    }
    void faultsOfTheNumbers()
    {
        QFETCH(const QString, field);
        const std::map<QString, std::function<void(StudySpec&)>> changes{
            {"random", [](StudySpec& s) { s.random = -1; }},
            {"runs", [](StudySpec& s) { s.runs = 0; }},
            {"first_seed", [](StudySpec& s) { s.firstSeed = std::int64_t{1} << 53; }},
            {"field.icebergs", [](StudySpec& s) { s.field.icebergs = 1001; }},
            {"field.size_m[1]", [](StudySpec& s) { s.field.size_m.y() = -1; }},
            {"field.speed_max_mps", [](StudySpec& s) { s.field.speedMax_mps = 6; }},
            {"field.sigma_max_m2", [](StudySpec& s) { s.field.sigmaMax_m2 = 0.5; }},
            {"field.q_m2ps", [](StudySpec& s) { s.field.q_m2ps = -0.1; }},
            {"taus[1]", [](StudySpec& s) { s.taus[1] = 101; }},
            {"policies", [](StudySpec& s) { s.policies.clear(); }},
            {"scenarios",
             [](StudySpec& s) {
                 s.scenarios.clear();
                 s.random = 0;
             }},
            {"", [](StudySpec& s) { s.runs = 1'000'000; }}}; // too many missions
        QVERIFY(validate(smallSpec()).empty());
        Study study{.spec = smallSpec()};
        changes.at(field)(study.spec);
        const std::vector<Issue> issues = validate(study.spec);
        QCOMPARE(issues.size(), std::size_t{1});
        QCOMPARE(QString::fromStdString(issues[0].field), field);
        QCOMPARE(codeOf([&] { fly(study); }), std::string("InvalidInput"));
    }

    void outcomesThatDoNotFit()
    {
        Study study{.spec = smallSpec()};
        study.outcomes.resize(23);
        const auto error = errorOf([&] { fly(study); });
        QVERIFY(error);
        QCOMPARE(error->issues().at(0).field, std::string("outcomes"));
    }

    void runsHaveSeedsOfTheirOwn()
    {
        QCOMPARE(seedOfRun(42, 0), 42);
        std::set<std::int64_t> seeds;
        for (std::int64_t seed = 0; seed < 30; ++seed)
            for (int run = 0; run < 30; ++run) {
                const std::int64_t value = seedOfRun(seed, run);
                QVERIFY(value >= 0 && value <= (std::int64_t{1} << 53));
                QCOMPARE(seedOfRun(seed, run), value);
                seeds.insert(value);
            }
        QCOMPARE(seeds.size(), std::size_t{900});
        // From the stream named by seed and run, as the header of Random describes it.
        QCOMPARE(seedOfRun(42, 3), static_cast<std::int64_t>(Random(42, 3).bits() >> 11U));
    }

    /** The UAV alternates between two of three icebergs; nearest-first never goes to the third. */
    void twoTargetsAreStuck()
    {
        Scenario scenario = emptySea(1000);
        addIceberg(scenario, 1500, 0);
        addIceberg(scenario, 2600, 0);
        addIceberg(scenario, 2000, 9000);
        QCOMPARE(isStuck(scenario, PolicyKind::Nearest), true);
        scenario.icebergs[2].position_m = {2000, 1000};
        QCOMPARE(isStuck(scenario, PolicyKind::Path), false);
    }

    /** Circling while both are in view is not a third iceberg. */
    void stuckOnTwoThatAreSeenTogether()
    {
        Scenario scenario = emptySea(1000);
        addIceberg(scenario, 2000, 0);
        addIceberg(scenario, 2500, 0);
        Mission mission(scenario);
        mission.advance(1000);
        std::set<std::optional<IcebergIndex>> targets;
        for (const test::FlownPlan& plan : test::flownPlans(mission))
            if (plan.time_s >= 500)
                targets.insert(plan.target());
        QVERIFY((targets ==
                 std::set<std::optional<IcebergIndex>>{std::nullopt, IcebergIndex(0),
                                                       IcebergIndex(1)})); // the intended case
        QCOMPARE(isStuck(scenario, PolicyKind::Visitation), true);
    }
};

QTEST_APPLESS_MAIN(TestStudy)
#include "tst_study.moc"
