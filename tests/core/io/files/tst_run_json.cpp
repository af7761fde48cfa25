#include "core/io/files/run_json.h"
#include "core/presets/presets.h"
#include "tests/support/expect_error.h"
#include "tests/support/files/file_texts.h"
#include "tests/support/flight/flown_plans.h"

#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <limits>

using namespace berg;
using namespace berg::test;

namespace {

Iceberg newcomer()
{
    Iceberg iceberg;
    iceberg.id = "late";
    iceberg.position_m = {2000, -1500};
    iceberg.sigma0_m2 = 9;
    iceberg.extraJson = R"({"reported_by":"ship"})";
    return iceberg;
}

/** A run of 200 s in a random field with three interventions; 12 icebergs are solved exactly. */
RunFile flownRun()
{
    Scenario scenario = randomScenario(3);
    scenario.duration_s = 200;
    Mission mission(scenario, {.gap = 0, .keyframeInterval_s = 20});
    mission.advance(60);
    mission.intervene({.time_s = 0, .tau = 2.5, .policy = {}, .appears = {}});
    mission.advance(90.05); // between two steps; it is rounded to one
    mission.intervene({.time_s = 0, .tau = {}, .policy = {}, .appears = newcomer()});
    mission.advance(120);
    mission.intervene({.time_s = 0, .tau = 0.5, .policy = PolicyKind::Nearest, .appears = {}});
    mission.advance(200);
    return runOf(mission);
}

/** A run with aim points whose last keyframe is on such a leg. */
RunFile coverageRun()
{
    Scenario scenario = randomScenario(4);
    scenario.planner.policy = PolicyKind::Coverage;
    Mission mission(scenario, {.workLimit = 20'000, .keyframeInterval_s = 20});
    mission.advance(100);
    mission.intervene({.appears = newcomer()});
    mission.advance(200);
    mission.intervene({.policy = PolicyKind::Nearest});
    mission.advance(240);
    mission.intervene({.policy = PolicyKind::Coverage});
    mission.advance(300);
    return runOf(mission);
}

/** A run with holds, which measurements make worthwhile. */
RunFile holdRun()
{
    Scenario scenario = randomScenario(4);
    scenario.planner.policy = PolicyKind::Coverage;
    scenario.observer.model = ObserverModel::Kalman;
    for (Iceberg& iceberg : scenario.icebergs)
        iceberg.velocitySd_mps = 0.1;
    Mission mission(scenario, {.workLimit = 50'000, .keyframeInterval_s = 20});
    mission.advance(400);
    return runOf(mission);
}

/** The run that most tests use. */
const RunFile& recorded()
{
    static const RunFile run = flownRun();
    return run;
}

RunFile again(const RunFile& run)
{
    return runFromJson(runToJson(run), "text");
}

} // namespace

class TestRunJson : public QObject
{
    Q_OBJECT

private slots:
    void runHoldsWhatWasFlown()
    {
        const RunFile& run = recorded();
        QVERIFY(run.scenario.icebergs.size() == 12);
        QCOMPARE(run.scenario.planner.tau, 1.0); // as at the start, not as changed in flight
        QCOMPARE(run.flownUntil_s, 200.0);
        QCOMPARE(run.interventions.size(), std::size_t{3});
        QCOMPARE(run.interventions[0].time_s, 60.0);
        QCOMPARE(run.keyframes.size(), std::size_t{11});
        QCOMPARE(run.keyframes.front().tracks.size(), std::size_t{12});
        QCOMPARE(run.keyframes.back().tracks.size(), std::size_t{13});
        QVERIFY(run.plans.size() >= 4);
        QCOMPARE(run.metrics.replans, static_cast<int>(run.plans.size()));
        QCOMPARE(run.metrics.zeta_m2s, run.keyframes.back().zeta_m2s);
    }

    void roundTripIsExact()
    {
        const std::string text = runToJson(recorded());
        const RunFile read = runFromJson(text, "text");
        QVERIFY(read == recorded());
        QCOMPARE(runToJson(read), text);
    }

    void aimPointsReplay()
    {
        const RunFile run = coverageRun();
        QVERIFY(!run.plans.front()->uavs[0].legs.empty());
        QVERIFY(run.keyframes.back().uavs[0].aim.has_value());
        const std::string text = runToJson(run);
        const RunFile read = runFromJson(text, "text");
        QVERIFY(read == run);
        QCOMPARE(runToJson(read), text);
        const RunFile flown = runOf(replay(read));
        QVERIFY(flown == run);
        QVERIFY(compareRun(read, flown).empty());
    }

    void holdsReplay()
    {
        const RunFile run = holdRun();
        const auto holds = [](const UavPlan& plan) {
            return std::ranges::any_of(plan.legs,
                                       [](const AimedLeg& leg) { return leg.end_s.has_value(); });
        };
        QVERIFY(std::ranges::any_of(test::flownPlans(run.plans), holds));
        const RunFile read = again(run);
        QVERIFY(read == run);
        const RunFile flown = runOf(replay(read));
        QVERIFY(flown == run);
        RunFile other = run;
        const auto frame = std::ranges::find_if(
            other.keyframes, [](const WorldState& state) { return state.uavs[0].aim.has_value(); });
        QVERIFY(frame != other.keyframes.end());
        frame->uavs[0].aim->end_s = 1;
        QCOMPARE(compareRun(run, other).size(), std::size_t{1});
    }

    void aimPointsAreCompared()
    {
        const RunFile run = coverageRun();
        RunFile other = run;
        test::changePlan(other.plans[2], [](UavPlan& own) { own.legs.back().abeam_m.x() += 1; });
        std::vector<Issue> issues = compareRun(run, other);
        QCOMPARE(issues.size(), std::size_t{1});
        QCOMPARE(issues[0].field, std::string("plans[2].legs"));
        std::vector<AimedLeg> changed(7, *run.keyframes.back().uavs[0].aim);
        ++changed[0].iceberg;
        changed[1].turn_rad += 1;
        changed[2].from_m.x() += 1;
        changed[3].from_m.y() += 1;
        changed[4].abeam_m.x() += 1;
        changed[5].abeam_m.y() += 1;
        changed[6].sighting_s += 1;
        const std::string path = "keyframes[" + std::to_string(run.keyframes.size() - 1) + "].aim";
        for (std::size_t i = 0; i < changed.size(); ++i) {
            other = run;
            other.keyframes.back().uavs[0].aim = changed[i];
            issues = compareRun(run, other);
            QCOMPARE(issues.size(), std::size_t{1});
            QCOMPARE(issues[0].field, path + '[' + std::to_string(i) + ']');
        }
        other.keyframes.back().uavs[0].aim.reset();
        QCOMPARE(compareRun(run, other)[0].field, path);
    }

    /** Interventions that name an iceberg by its id. */
    void namedIcebergsReplay_data()
    {
        QTest::addColumn<QByteArray>("field");
        QTest::newRow("seen") << QByteArray("seen");
        QTest::newRow("removed") << QByteArray("removed");
    }
    void namedIcebergsReplay()
    {
        QFETCH(QByteArray, field);
        const auto named = [&](Intervention& change) -> std::optional<std::string>& {
            return field == "seen" ? change.seen : change.removed;
        };
        Mission mission(randomScenario(5));
        mission.advance(80);
        Intervention change;
        named(change) = mission.icebergs()[4].id;
        mission.intervene(change);
        mission.advance(200);
        RunFile run = runFromJson(runToJson(runOf(mission)), "text");
        QCOMPARE(*named(run.interventions.at(0)), mission.icebergs()[4].id);
        QVERIFY(compareRun(run, runOf(replay(run))).empty());

        named(run.interventions[0]) = "nobody";
        try {
            static_cast<void>(runFromJson(runToJson(run), "text"));
            QFAIL("read");
        } catch (const Error& error) {
            QCOMPARE(error.issues().size(), std::size_t{1});
            QCOMPARE(error.issues()[0].field, "interventions[0]." + field.toStdString());
        }
    }

    void optionsRoundTrip()
    {
        RunFile run = recorded();
        run.options = {.workLimit = 12345,
                       .timeLimit_s = 0.1,
                       .gap = 1.0 / 3,
                       .warmStart = false,
                       .record = false,
                       .sampleInterval_s = 0.7,
                       .keyframeInterval_s = 7};
        QVERIFY(again(run) == run);
    }

    void statesRoundTrip()
    {
        RunFile run = recorded();
        WorldState& state = run.keyframes[3];
        state.uavs[0].mode = FlightMode::RunOut;
        state.uavs[0].target = IcebergIndex(12);
        state.uavs[0].lastReached = IcebergIndex(0);
        state.uavs[0].runOut_m = 211.6;
        state.uavs[0].misses = 3;
        state.uavs[0].u_radps = -std::numeric_limits<double>::denorm_min();
        state.uavs[0].guidance.gains.lookahead_m = std::nextafter(150.0, 0);
        state.tracks[5].inView = !state.tracks[5].inView;
        state.uavs[0].pose.psi_rad = -0.0;
        run.keyframes[4].uavs[0].mode = FlightMode::Idle;
        run.keyframes[5].uavs[0].mode = FlightMode::Circle;
        const RunFile read = again(run);
        QVERIFY(read == run);
        QVERIFY(std::signbit(read.keyframes[3].uavs[0].pose.psi_rad));
    }

    void savedRunIsLoadedUnchanged()
    {
        const QTemporaryDir dir;
        const std::string path = dir.filePath("a.bergrun").toStdString();
        saveRun(recorded(), path);
        QVERIFY(loadRun(path) == recorded());
        QVERIFY(loadRun(BERG_TEST_DATA "/scenarios/small.bergrun").keyframes.size() == 3);
    }

    void replayRepeatsBitForBit()
    {
        const QTemporaryDir dir;
        const std::string path = dir.filePath("a.bergrun").toStdString();
        saveRun(recorded(), path);
        const RunFile file = loadRun(path);
        double progress_s = 0;
        const Mission mission = replay(file, {}, [&](double time_s) { progress_s = time_s; });
        const RunFile flown = runOf(mission);
        QVERIFY(flown == recorded());
        QVERIFY(compareRun(file, flown).empty());
        QCOMPARE(progress_s, 200.0);
    }

    void partOfARunReplaysToItsEnd()
    {
        // A run that was stopped in flight is replayed up to its end.
        Mission mission(recorded().scenario, recorded().options);
        mission.advance(33.3);
        const RunFile part = runOf(mission);
        QVERIFY(std::abs(part.flownUntil_s - 33.3) < 1e-9); // 333 steps of 0.1 s
        const RunFile flown = runOf(replay(again(part)));
        QVERIFY(flown == part);
        QVERIFY(compareRun(part, flown).empty());
    }

    void replayStopsWhenCancelled()
    {
        std::stop_source source;
        const Mission mission = replay(recorded(), source.get_token(), [&](double time_s) {
            if (time_s >= 30)
                source.request_stop();
        });
        QCOMPARE(mission.simulation().time_s(), 30.0);
    }

    void firstDifferencesAreReported_data()
    {
        QTest::addColumn<int>("change");
        QTest::addColumn<QString>("field");
        QTest::addColumn<QString>("text");
        QTest::newRow("position") << 0 << "keyframes[4].position_m[1]"
                                  << "at 80 s: recorded ";
        QTest::newRow("sigma") << 1 << "keyframes[2].tracks[7][5]"
                               << "at 40 s: recorded ";
        QTest::newRow("target") << 2 << "keyframes[6].target"
                                << "at 120 s: recorded ";
        QTest::newRow("tracks") << 3 << "keyframes[9].tracks"
                                << "recorded 12, replayed 13";
        QTest::newRow("no keyframe") << 4 << "keyframes[3]"
                                     << "at 60.1 s: not reached";
        QTest::newRow("plan time") << 5 << "plans[1].time_s"
                                   << "recorded ";
        QTest::newRow("plan target") << 6 << "plans[0].target"
                                     << "at 0 s: recorded ";
        QTest::newRow("plan order") << 7 << "plans[0].order"
                                    << "at 0 s";
        QTest::newRow("plan missing") << 8 << "plans"
                                      << "recorded ";
        QTest::newRow("zeta") << 9 << "metrics.zeta_m2s"
                              << "recorded ";
        QTest::newRow("visits") << 10 << "metrics.visits"
                                << "recorded ";
        QTest::newRow("flown") << 11 << "metrics.flown_m"
                               << "recorded ";
        QTest::newRow("end") << 12 << "flown_until_s"
                             << "recorded 199, replayed 200";
    }
    void firstDifferencesAreReported()
    {
        QFETCH(const int, change);
        QFETCH(const QString, field);
        QFETCH(const QString, text);
        RunFile run = recorded();
        WorldState& state = run.keyframes[4];
        switch (change) {
        case 0: // changes the last bit
            state.uavs[0].pose.position_m.y() =
                std::nextafter(state.uavs[0].pose.position_m.y(), 1e9);
            run.keyframes[8].zeta_m2s += 1; // later differences are not reported
            break;
        case 1:
            run.keyframes[2].tracks[7].sigma_m2 += 1e-12;
            break;
        case 2:
            run.keyframes[6].uavs[0].target.reset();
            break;
        case 3:
            run.keyframes[9].tracks.pop_back();
            break;
        case 4:
            run.keyframes[3].step += 1;
            break;
        case 5:
            test::changePlan(
                run.plans[1], [](UavPlan&) {}, 0.1);
            break;
        case 6:
            test::changePlan(run.plans[0], [](UavPlan& own) { own.order.clear(); });
            break;
        case 7:
            test::changePlan(run.plans[0],
                             [](UavPlan& own) { std::swap(own.order[1], own.order[2]); });
            break;
        case 8:
            run.plans.pop_back();
            break;
        case 9:
            run.metrics.zeta_m2s = std::nextafter(run.metrics.zeta_m2s, 0);
            break;
        case 10:
            ++run.metrics.visits;
            break;
        case 11:
            run.metrics.flown_m += 1;
            break;
        default:
            run.flownUntil_s = 199;
            break;
        }
        const std::vector<Issue> issues = compareRun(run, recorded());
        QCOMPARE(issues.size(), std::size_t{1});
        QCOMPARE(QString::fromStdString(issues[0].field), field);
        QVERIFY2(QString::fromStdString(issues[0].message()).contains(text),
                 issues[0].message().c_str());
        QVERIFY(issues[0].severity == Severity::Error);
    }

    void everyNumberOfAKeyframeIsCompared()
    {
        // Whatever field of the text is changed, the comparison names a field.
        const WorldState& state = recorded().keyframes[1];
        std::vector<WorldState> changed(32, state);
        changed[0].uavs[0].pose.position_m.x() += 1;
        changed[1].uavs[0].pose.position_m.y() += 1;
        changed[2].uavs[0].pose.psi_rad += 1;
        changed[3].uavs[0].u_radps += 1;
        changed[4].uavs[0].crossTrack_m += 1;
        changed[5].sigmaSum_m2 += 1;
        changed[6].zeta_m2s += 1;
        changed[7].uavs[0].flown_m += 1;
        changed[8].uavs[0].mode = FlightMode::Circle;
        changed[9].uavs[0].target = IcebergIndex(99);
        changed[10].uavs[0].lastReached = IcebergIndex(99);
        changed[11].uavs[0].guidance.gains.lookahead_m += 1;
        changed[12].uavs[0].guidance.gains.integral_mps += 1;
        changed[13].uavs[0].guidance.gains.turn_1ps += 1;
        changed[14].uavs[0].guidance.start_m.x() += 1;
        changed[15].uavs[0].guidance.integral_s += 1;
        changed[16].uavs[0].runOut_m += 1;
        changed[17].uavs[0].misses += 1;
        changed[18].tracks[0].anchor_m.x() += 1;
        changed[19].tracks[1].anchor_s += 1;
        changed[20].tracks[2].velocity_mps.y() += 1;
        changed[21].tracks[3].sigma_m2 += 1;
        changed[22].tracks[4].q_m2ps += 1;
        changed[23].tracks[5].inView = !state.tracks[5].inView;
        changed[24].tracks[6].mixed_m2ps += 1;
        changed[25].tracks[6].presence = 0.5;
        changed[26].tracks[6].status = TrackStatus::Lost;
        changed[27].tracks[6].left = true;
        changed[28].uavs[0].aloft_s += 1;
        changed[29].uavs[0].ground_s += 1;
        changed[30].closest_m = 5;
        changed[31].uavs[0].via_m = Point(1, 2);
        for (const WorldState& other : changed) {
            RunFile run = recorded();
            run.keyframes[1] = other;
            const std::vector<Issue> issues = compareRun(run, recorded());
            QCOMPARE(issues.size(), std::size_t{1});
            QVERIFY(issues[0].field.starts_with("keyframes[1]."));
        }
    }

    void timeLimitAddsAWarning()
    {
        RunFile run = recorded();
        run.options.timeLimit_s = 1;
        QVERIFY(compareRun(run, recorded()).empty());
        run.metrics.visits += 1;
        const std::vector<Issue> issues = compareRun(run, recorded());
        QCOMPARE(issues.size(), std::size_t{2});
        QVERIFY(issues[1].severity == Severity::Warning);
        QCOMPARE(issues[1].field, std::string("options.time_limit_s"));
    }

    void longRunsAreThinned()
    {
        // 50 icebergs and a keyframe at each of 4000 steps: 200,000 tracks.
        Scenario scenario = randomScenario(5, {.icebergs = 50});
        scenario.planner.policy = PolicyKind::Nearest;
        scenario.duration_s = 400;
        Mission mission(scenario, {.keyframeInterval_s = 0.1});
        mission.advance(400);
        const RunFile run = runOf(mission);
        QCOMPARE(run.keyframes.size(), std::size_t{1001}); // of 4001
        QCOMPARE(run.keyframes.front().step, std::int64_t{0});
        QCOMPARE(run.keyframes.back().step, std::int64_t{4000});
        QVERIFY(again(run) == run);
        QVERIFY(compareRun(run, runOf(replay(run))).empty());
        // Earlier versions recorded every third keyframe.
        RunFile other = run;
        std::erase_if(other.keyframes, [](const WorldState& state) { return state.step % 3 != 0; });
        other.keyframes.push_back(run.keyframes.back());
        for (std::size_t i = 1; i + 1 < other.keyframes.size(); i += 2)
            other.keyframes[i].step += 3;
        QVERIFY(compareRun(other, run).empty());
        other.keyframes.back().zeta_m2s += 1;
        QCOMPARE(compareRun(other, run).size(), std::size_t{1});
    }

    void formatIsThatOfTheMember_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QString>("format");
        QTest::addColumn<QString>("code");
        QTest::newRow("scenario") << QByteArray(R"({"x": 1, "format": "bergwatch-scenario"})")
                                  << "bergwatch-scenario"
                                  << "nothing";
        QTest::newRow("problem") << QByteArray(R"({"format": "bergwatch-problem"})")
                                 << "bergwatch-problem"
                                 << "nothing";
        QTest::newRow("run") << QByteArray(R"({"format": "bergwatch-run"})") << "bergwatch-run"
                             << "nothing";
        QTest::newRow("another") << QByteArray(R"({"format": "geojson"})") << ""
                                 << "WrongFormat";
        QTest::newRow("none") << QByteArray("{}") << ""
                              << "WrongFormat";
        QTest::newRow("number") << QByteArray(R"({"format": 1})") << ""
                                << "WrongFormat";
        QTest::newRow("array") << QByteArray("[]") << ""
                               << "WrongFormat";
        QTest::newRow("no JSON") << QByteArray("{") << ""
                                 << "SyntaxError";
    }
    void formatIsThatOfTheMember()
    {
        QFETCH(const QByteArray, text);
        QFETCH(const QString, format);
        QFETCH(const QString, code);
        std::string found;
        QCOMPARE(codeOf([&] { found = formatOf(text.toStdString(), "text"); }), code.toStdString());
        QCOMPARE(QString::fromStdString(found), format);
    }
};

QTEST_APPLESS_MAIN(TestRunJson)
#include "tst_run_json.moc"
