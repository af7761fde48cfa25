#include "core/base/random.h"
#include "core/mission/mission.h"
#include "core/mission/recorder.h"
#include "tests/support/approx.h"
#include "tests/support/flight/scenario_builder.h"

#include <algorithm>
#include <functional>
#include <malloc.h>
#include <string>
#include <vector>

using namespace berg;
using test::addIceberg;
using test::emptySea;

namespace {

/** Two icebergs, one of them in view at the start. */
Scenario twoIcebergs(double duration_s)
{
    Scenario scenario = emptySea(duration_s);
    addIceberg(scenario, 4000, 300, 4).velocity_mps = {0.2, -0.1};
    addIceberg(scenario, 100, 50, 7);
    return scenario;
}

/** Flies to iceberg 0 until the end and records at time 0 and after every step. */
void recordAll(Simulation& simulation, Recorder& recorder,
               const std::function<void(Simulation&)>& afterStep = {})
{
    recorder.record(simulation);
    while (!simulation.finished()) {
        if (simulation.planReason() != PlanReason::None)
            simulation.setTarget(0, simulation.available(0, 0) ? std::optional(IcebergIndex(0))
                                                               : std::nullopt);
        simulation.advanceStep();
        if (afterStep)
            afterStep(simulation);
        recorder.record(simulation);
    }
}

} // namespace

class TestRecorder : public QObject
{
    Q_OBJECT

private slots:
    void nothingIsKeptUntilAsked()
    {
        const Recorder recorder(1, 60, 0.1);
        QVERIFY(recorder.samples().empty());
        QVERIFY(recorder.keyframes().empty());
    }

    void samplesWhenDue_data()
    {
        QTest::addColumn<double>("duration_s");
        QTest::addColumn<double>("dt_s");
        QTest::addColumn<double>("interval_s");
        QTest::addColumn<QList<int>>("steps");
        const auto row = [](const char* name, double duration_s, double dt_s, double interval_s,
                            const QList<int>& steps) {
            QTest::newRow(name) << duration_s << dt_s << interval_s << steps;
        };
        row("each second", 3, 0.1, 1, {0, 10, 20, 30});
        row("last step between samples", 2.5, 0.1, 1, {0, 10, 20, 25});
        row("rounded to steps", 1, 0.1, 0.28, {0, 3, 6, 9, 10});
        row("interval below a step: every step", 0.4, 0.1, 0.01, {0, 1, 2, 3, 4});
        row("interval above the run: first and last", 2, 0.1, 60, {0, 20});
        row("steps of a second", 4, 1, 2, {0, 2, 4});
    }

    void samplesWhenDue()
    {
        QFETCH(double, duration_s);
        QFETCH(double, dt_s);
        QFETCH(double, interval_s);
        QFETCH(QList<int>, steps);
        Scenario scenario = twoIcebergs(duration_s);
        scenario.dt_s = dt_s;
        Simulation simulation(scenario);
        Recorder recorder(interval_s, 1000, dt_s);
        recordAll(simulation, recorder);
        QCOMPARE(recorder.samples().size(), static_cast<std::size_t>(steps.size()));
        for (qsizetype i = 0; i < steps.size(); ++i)
            COMPARE_NEAR(recorder.samples()[static_cast<std::size_t>(i)].time_s, steps[i] * dt_s,
                         1e-12);
    }

    /** Compares each sample with the simulation at that instant in a second flight. */
    void samplesAreTheStates()
    {
        const Scenario scenario = twoIcebergs(120);
        Simulation simulation(scenario);
        Recorder recorder(0.7, 25, scenario.dt_s);
        std::vector<Simulation> history{Simulation(scenario)};
        history[0].setTarget(0, IcebergIndex(0));
        recordAll(simulation, recorder, [&](Simulation& s) { history.push_back(s); });

        std::size_t row = 0;
        for (const Sample& sample : recorder.samples()) {
            const Simulation& then =
                history[static_cast<std::size_t>(std::llround(sample.time_s * 10))];
            const WorldState& state = then.state();
            QCOMPARE(sample.time_s, then.time_s());
            QVERIFY(sample.uavs[0].pose == state.uavs[0].pose);
            QCOMPARE(sample.uavs[0].u_radps, state.uavs[0].u_radps);
            QCOMPARE(sample.uavs[0].crossTrack_m, state.uavs[0].crossTrack_m);
            QCOMPARE(sample.sigmaSum_m2, state.sigmaSum_m2);
            QCOMPARE(sample.zeta_m2s, state.zeta_m2s);
            QCOMPARE(sample.flown_m, state.flown_m());
            QCOMPARE(recorder.icebergs(row).size(), std::size_t{2});
            for (const IcebergIndex i : then.icebergs()) {
                const IcebergSample one = recorder.icebergs(row)[toIndex(i)];
                QCOMPARE(one.sigma_m2, then.track(i).sigma_m2);
                QVERIFY(one.truth_m == then.truth_m(i));
                QCOMPARE(one.inView, then.track(i).inView);
                QVERIFY(one.active);
            }
            ++row;
        }
        QVERIFY(row > 100);
        QVERIFY(!recorder.samples()[0].uavs[0].target); // no plan yet at time 0
        QCOMPARE(recorder.samples()[1].uavs[0].target, std::optional(IcebergIndex(0)));
        QVERIFY(recorder.icebergs(0)[1].inView);
        QVERIFY(!recorder.icebergs(row - 1)[1].inView); // left behind
    }

    /** Rows can be read in any order, whatever happens between them. */
    void rowsAreTheStates_data()
    {
        QTest::addColumn<ObserverModel>("model");
        QTest::newRow("simple") << ObserverModel::Simple;
        QTest::newRow("kalman") << ObserverModel::Kalman;
    }
    void rowsAreTheStates()
    {
        QFETCH(ObserverModel, model);
        Scenario scenario = twoIcebergs(120);
        scenario.observer = {.model = model, .interval_s = 2, .detection = 0.7};
        scenario.noise = true;
        scenario.area_m = {{-5000, -5000}, {5000, -5000}, {5000, 5000}, {-5000, 5000}};
        for (int i = 0; i < 20; ++i) {
            Iceberg& iceberg = addIceberg(scenario, 300.0 * i - 1000, 200.0 * (i % 5));
            iceberg.velocity_mps = {0.3, -0.1};
            iceberg.velocitySd_mps = 0.1;
            iceberg.velocitySpread_mps = 0.2;
            iceberg.velocityTime_s = i % 3 == 0 ? 0 : 200.0 * i;
            if (i % 4 == 0)
                iceberg.appears_s = 7.3 * i;
        }
        addIceberg(scenario, 4990, 0).velocity_mps = {5, 0};  // leaves
        addIceberg(scenario, -5060, 0).velocity_mps = {5, 0}; // comes
        Simulation simulation(scenario);
        Recorder recorder(0.7, 25, scenario.dt_s);
        std::vector<std::vector<IcebergSample>> states{icebergsOf(simulation)};
        recordAll(simulation, recorder, [&](Simulation& s) {
            if (s.step() == 300 || s.step() == 444)
                s.addIceberg({.id = "added" + std::to_string(s.step()), .position_m = {900, 900}});
            if (s.step() == 600)
                s.reportSighting(4);
            states.push_back(icebergsOf(s));
        });
        const auto isState = [&](std::size_t row, std::span<const IcebergSample> read) {
            const auto step = std::llround(recorder.samples()[row].time_s / scenario.dt_s);
            return std::ranges::equal(read, states[static_cast<std::size_t>(step)],
                                      [](const IcebergSample& a, const IcebergSample& b) {
                                          return a.sigma_m2 == b.sigma_m2 && a.inView == b.inView &&
                                                 a.active == b.active && a.truth_m == b.truth_m;
                                      });
        };
        const std::size_t rows = recorder.samples().size();
        IcebergReader reader = recorder.reader();
        IcebergReader jumping = recorder.reader();
        for (std::size_t row = 0; row < rows; ++row) {
            QVERIFY2(isState(row, reader.at(row)), qPrintable(QString::number(row)));
            QVERIFY(isState(row, recorder.icebergs(row)));
            const std::size_t other = 37 * row % rows;
            QVERIFY(isState(other, jumping.at(other)));
        }
        std::size_t row = 0;
        recorder.streamTo([&](const Sample&, std::span<const IcebergSample> icebergs) {
            QVERIFY(isState(row++, icebergs));
        });
    }

    /**
     * A search takes as much space as 70 tracks: a day with 40 lost icebergs made a file of 715 MB.
     */
    void keyframesOfSearchesAreFew()
    {
        Scenario scenario = emptySea(4 * 3600);
        scenario.noise = true;
        Random random(5);
        for (int i = 0; i < 40; ++i) {
            Iceberg& iceberg = addIceberg(scenario, random.uniform(-20'000, 20'000),
                                          random.uniform(-20'000, 20'000));
            iceberg.velocitySd_mps = iceberg.velocitySpread_mps = 0.3;
            iceberg.velocityTime_s = 36'000;
        }
        scenario.observer = {.model = ObserverModel::Kalman, .search = SearchPattern::Square};
        Mission mission(scenario);
        mission.advance(scenario.duration_s);
        QVERIFY(mission.simulation().observer().searches().count() > 10);
        std::size_t tracks = 0;
        for (const Simulation& keyframe : mission.recorder().keyframes())
            tracks += 42 + 70 * keyframe.observer().searches().count();
        QVERIFY2(tracks < Recorder::kMostKeyframeTracks + 10'000, std::to_string(tracks).c_str());
    }

    /** 32 bytes per iceberg and row were 830 MB for 300 icebergs and a day. */
    void rowsTakeLittleRoom()
    {
        Scenario scenario = twoIcebergs(300);
        for (int i = 0; i < 300; ++i)
            addIceberg(scenario, 100.0 * i, 4000);
        Simulation simulation(scenario);
        Recorder recorder(1, 1000, scenario.dt_s);
        recordAll(simulation, recorder);
        const auto inUse = [] {
            const struct mallinfo2 info = mallinfo2();
            return info.uordblks + info.hblkhd;
        };
        const std::size_t before = inUse();
        const Recorder copy = recorder;
        const std::size_t all = inUse() - before;
        const std::size_t keyframes = 2 * 302 * 600; // the two of them, generously
        QVERIFY2(all < keyframes + 300'000, qPrintable(QString::number(all))); // was 3.3 million
        QCOMPARE(copy.icebergs(300).size(), std::size_t{302});
    }

    void keyframesWhenDue()
    {
        const Scenario scenario = twoIcebergs(130);
        Simulation simulation(scenario);
        Recorder recorder(1, 60, scenario.dt_s);
        WorldState at60;
        recordAll(simulation, recorder, [&](Simulation& s) {
            if (s.step() == 600)
                at60 = s.state();
        });
        const std::vector<Simulation>& keyframes = recorder.keyframes();
        QCOMPARE(keyframes.size(), std::size_t{4});
        QCOMPARE(keyframes[0].state().step, 0);
        QVERIFY(keyframes[1].state() == at60);
        QCOMPARE(keyframes[2].state().step, 1200);
        QVERIFY(keyframes[3].state() == simulation.state()); // the end, between two keyframes
    }

    /**
     * A flight with 251 keyframes of 1000 icebergs, of which one in four stays, has the same end,
     * rows and positions.
     */
    void keyframesAreBounded()
    {
        Scenario scenario = twoIcebergs(250);
        for (int i = 2; i < 1000; ++i)
            addIceberg(scenario, 100.0 * i, 4000).velocity_mps = {0.1, 0.2};
        Simulation simulation(scenario);
        Recorder recorder(0.5, 1, scenario.dt_s);
        std::vector<std::vector<IcebergSample>> states;
        std::vector<std::size_t> counts;
        recordAll(simulation, recorder, [&](Simulation& s) {
            counts.push_back(recorder.keyframes().size() * toIndex(s.icebergCount()));
            if (s.step() == 1234)
                s.addIceberg({.id = "added", .position_m = {900, 900}});
            if (s.step() % 365 == 0)
                states.push_back(icebergsOf(s));
        });
        QVERIFY(std::ranges::max(counts) <= Recorder::kMostKeyframeTracks + 2 * 1001);
        const std::vector<Simulation>& keyframes = recorder.keyframes();
        QCOMPARE(keyframes.size(), std::size_t{64});
        for (std::size_t i = 0; i + 1 < keyframes.size(); ++i)
            QCOMPARE(keyframes[i].step(), static_cast<std::int64_t>(40 * i));
        QCOMPARE(keyframes.back().step(), std::int64_t{2500});
        IcebergReader reader = recorder.reader();
        for (std::size_t i = 0; i < states.size(); ++i) {
            const std::vector<IcebergSample> read = reader.at(73 * (i + 1));
            QVERIFY(std::ranges::equal(read, states[i], {}, &IcebergSample::truth_m,
                                       &IcebergSample::truth_m));
            QVERIFY(std::ranges::equal(read, states[i], {}, &IcebergSample::sigma_m2,
                                       &IcebergSample::sigma_m2));
        }
    }

    /** Every other one of 1101 keyframes with 50 UAVs stays. */
    void keyframesOfAFleetAreBounded()
    {
        Scenario scenario = emptySea(110);
        for (int i = 1; i < 50; ++i) {
            Uav uav = scenario.uavs.front();
            uav.id = "uav-" + std::to_string(i + 1);
            uav.position_m = {0, -500.0 * i};
            scenario.uavs.push_back(uav);
        }
        Simulation simulation(scenario);
        Recorder recorder(1, scenario.dt_s, scenario.dt_s);
        recorder.record(simulation);
        while (!simulation.finished()) {
            for (int i = 0; simulation.planReason() != PlanReason::None && i < 50; ++i)
                simulation.setTarget(i, std::nullopt);
            simulation.advanceStep();
            recorder.record(simulation);
        }
        const std::vector<Simulation>& keyframes = recorder.keyframes();
        QCOMPARE(keyframes.size(), std::size_t{551});
        QCOMPARE(keyframes[1].step(), std::int64_t{2});
        QCOMPARE(keyframes.back().step(), std::int64_t{1100});
    }

    /** An end that is also due is stored once. */
    void endIsKeptOnce()
    {
        const Scenario scenario = twoIcebergs(120);
        Simulation simulation(scenario);
        Recorder recorder(1, 60, scenario.dt_s);
        recordAll(simulation, recorder);
        QCOMPARE(recorder.keyframes().size(), std::size_t{3});
        QCOMPARE(recorder.samples().size(), std::size_t{121});
    }

    /** An iceberg added in flight is missing in earlier rows and present in every later one. */
    void addedIcebergHasNoPast()
    {
        const Scenario scenario = twoIcebergs(10);
        Simulation simulation(scenario);
        Recorder recorder(1, 60, scenario.dt_s);
        Iceberg late;
        late.id = "late";
        late.position_m = {2500, 2500};
        late.sigma0_m2 = 3;
        recordAll(simulation, recorder, [&](Simulation& s) {
            if (s.step() == 45)
                s.addIceberg(late);
        });
        QCOMPARE(recorder.samples().size(), std::size_t{11});
        for (std::size_t row = 0; row <= 10; ++row)
            QCOMPARE(recorder.icebergs(row).size(), std::size_t{row <= 4 ? 2U : 3U});
        // It was added at 4.5 s, so the row at 5 s is the first to contain it.
        COMPARE_NEAR(recorder.icebergs(5)[2].sigma_m2, 3 + 0.025 * 0.5, 1e-12);
        QVERIFY(recorder.icebergs(5)[2].truth_m == late.position_m);
    }

    /** An iceberg that appears later has marked rows from the start. */
    void notYetAppearedIsMarked()
    {
        Scenario scenario = twoIcebergs(10);
        addIceberg(scenario, 3000, 2000).appears_s = 6;
        Simulation simulation(scenario);
        Recorder recorder(1, 60, scenario.dt_s);
        recordAll(simulation, recorder);
        for (std::size_t row = 0; row <= 10; ++row) {
            QCOMPARE(recorder.icebergs(row).size(), std::size_t{3});
            QVERIFY(recorder.icebergs(row)[0].active);
            QCOMPARE(recorder.icebergs(row)[2].active, row >= 6);
        }
    }

    void rowsThatAreNotThere()
    {
        const Scenario scenario = twoIcebergs(2);
        Simulation simulation(scenario);
        Recorder recorder(1, 60, scenario.dt_s);
        recordAll(simulation, recorder);
        QCOMPARE(recorder.icebergs(2).size(), std::size_t{2});
        QVERIFY_THROWS_EXCEPTION(std::out_of_range, (void)recorder.icebergs(3));
    }

    void noIcebergsAtAll()
    {
        const Scenario scenario = emptySea(3);
        Simulation simulation(scenario);
        simulation.setTarget(0, std::nullopt);
        Recorder recorder(1, 60, scenario.dt_s);
        recorder.record(simulation);
        while (!simulation.finished()) {
            simulation.advanceStep();
            recorder.record(simulation);
        }
        QCOMPARE(recorder.samples().size(), std::size_t{4});
        QVERIFY(recorder.icebergs(3).empty());
    }
};

QTEST_APPLESS_MAIN(TestRecorder)
#include "tst_recorder.moc"
