#include "core/presets/presets.h"
#include "tests/support/flight/fleet_flight.h"
#include "tests/support/window/panel_test.h"
#include "tests/support/window/patience.h"
#include "widgets/forecast/bound_runner.h"

#include <QSignalSpy>

#include <algorithm>
#include <array>
#include <functional>

using namespace berg;
using test::kPatience_ms;

namespace {

constexpr std::int64_t kLittleWork = 50'000'000;

Scenario smallField()
{
    Scenario scenario = randomScenario(2, {.icebergs = 5});
    scenario.duration_s = 300;
    return scenario;
}

/** Returns a scenario whose bound takes seconds. */
Scenario largeField()
{
    Scenario scenario = randomScenario(1, {.icebergs = 60, .size_m = {30000, 30000}});
    scenario.duration_s = 7200;
    return scenario;
}

/** Some icebergs are outside the area: zeta then depends on the others only. */
std::vector<Point> westernHalf(const Scenario& scenario)
{
    double middle_m = 0;
    for (const Iceberg& iceberg : scenario.icebergs)
        middle_m += iceberg.position_m.x() / static_cast<double>(scenario.icebergs.size());
    return {{-20000, -20000}, {middle_m, -20000}, {middle_m, 20000}, {-20000, 20000}};
}

bool completes(const BoundRunner& runner)
{
    return QTest::qWaitFor([&] { return runner.isComplete(); }, kPatience_ms);
}

bool isBoundOf(const BoundRunner& runner, const Scenario& scenario)
{
    const ZetaBound expected = zetaLowerBound(scenario, {.workLimit = kLittleWork});
    const KnownBound& known = runner.known();
    return known.whole && known.zeta_m2s == expected.zeta_m2s &&
           known.whole->curve == expected.curve && expected.zeta_m2s > 0;
}

} // namespace

class TestBoundRunner : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnWarnings(); }

    void findsWhatTheCoreFinds()
    {
        BoundRunner runner(nullptr, kLittleWork);
        QVERIFY(runner.isComplete() && runner.known().whole == nullptr);
        runner.setScenario(smallField());
        QVERIFY(!runner.isComplete());
        QVERIFY(completes(runner));
        QVERIFY(isBoundOf(runner, smallField()));
    }

    void whatDoesNotMatterKeepsIt()
    {
        Scenario scenario = smallField();
        BoundRunner runner(nullptr, kLittleWork);
        runner.setScenario(scenario);
        QVERIFY(completes(runner));
        const auto before = runner.known().whole;
        const QSignalSpy updated(&runner, &BoundRunner::updated);
        scenario.name = "another";
        scenario.notes = "noted";
        scenario.planner.tau = 0.1;
        scenario.planner.policy = PolicyKind::Coverage;
        scenario.planningTime_s = 5;
        scenario.asset = Asset{.name = "Platform"};
        scenario.origin = {.latitude_deg = 60, .longitude_deg = 5};
        scenario.startUtc = "2026-06-01T00:00:00Z";
        scenario.separation_m = 0;
        scenario.groundStation = GroundStation{};
        scenario.clusters = true;
        scenario.reachRadius_m = 100;
        scenario.extraJson = R"({"later":1})";
        scenario.icebergs[0].uav = scenario.uavs[0].id;
        scenario.icebergs[0].name = "Big one";
        scenario.uavs[0].name = "Osprey";
        runner.setScenario(scenario);
        QVERIFY(runner.isComplete() && runner.known().whole == before);
        QCOMPARE(updated.count(), 0);
    }

    void relevantChangesDropTheBound_data()
    {
        QTest::addColumn<int>("change");
        QTest::newRow("iceberg") << 0;
        QTest::newRow("wind") << 1;
        QTest::newRow("seed") << 2;
        QTest::newRow("airspeed") << 3;
        QTest::newRow("shape of the view") << 4;
        QTest::newRow("area that some leave") << 5;
        QTest::newRow("measurements") << 6;
    }

    void relevantChangesDropTheBound()
    {
        QFETCH(int, change);
        Scenario scenario = smallField();
        BoundRunner runner(nullptr, kLittleWork);
        runner.setScenario(scenario);
        QVERIFY(completes(runner));
        const std::array<std::function<void()>, 7> changes{
            [&] { scenario.icebergs[0].position_m.x() += 500; },
            [&] { scenario.wind_mps = Point(5, 0); },
            [&] { scenario.seed += 1; },
            [&] { scenario.uavs[0].spec.airspeed_mps *= 2; },
            [&] { scenario.fovShape = FovShape::North; },
            [&] { scenario.area_m = westernHalf(scenario); },
            [&] {
                scenario.observer.model = ObserverModel::Kalman;
                scenario.icebergs[0].velocitySd_mps = 2;
            }};
        changes.at(static_cast<std::size_t>(change))();
        runner.setScenario(scenario);
        QVERIFY(!runner.isComplete());
        QVERIFY(runner.known().whole == nullptr && !runner.known().zeta_m2s);
        QVERIFY(completes(runner));
        QVERIFY(isBoundOf(runner, scenario));
    }

    /** Progress is reported, and a change ends the search for the scenario before. */
    void editsCancel()
    {
        BoundRunner runner;
        runner.setScenario(largeField());
        QVERIFY(QTest::qWaitFor([&] { return runner.known().share > 0; }, kPatience_ms));
        QVERIFY(!runner.isComplete() && runner.known().whole == nullptr);
        Scenario next = smallField();
        next.icebergs.resize(1);
        runner.setScenario(next);
        QVERIFY(completes(runner));
        QCOMPARE(runner.known().whole->zeta_m2s, zetaLowerBound(next).zeta_m2s);
    }

    void errorsHaveNone()
    {
        Scenario scenario = smallField();
        scenario.duration_s = -1;
        BoundRunner runner(nullptr, kLittleWork);
        runner.setScenario(scenario);
        QVERIFY(completes(runner));
        QVERIFY(runner.known().whole == nullptr);
    }

    void severalUavsHaveOne()
    {
        const Scenario fleet = test::withUavs(smallField(), 2);
        BoundRunner runner(nullptr, kLittleWork);
        runner.setScenario(fleet);
        QVERIFY(completes(runner));
        QVERIFY(isBoundOf(runner, fleet));
    }

    /** Every reported bound holds, so the largest one does. */
    void boundNeverFalls()
    {
        Scenario scenario = largeField();
        scenario.duration_s = 1800;
        BoundRunner runner(nullptr, 20 * kLittleWork);
        std::vector<double> reported_m2s;
        connect(&runner, &BoundRunner::updated, &runner,
                [&] { reported_m2s.push_back(runner.known().zeta_m2s.value_or(0)); });
        runner.setScenario(scenario);
        QVERIFY(completes(runner));
        QVERIFY(reported_m2s.size() > 2);
        QVERIFY(std::ranges::is_sorted(reported_m2s));
    }

    void endsWhileSearching()
    {
        auto runner = std::make_unique<BoundRunner>();
        runner->setScenario(largeField());
        QVERIFY(QTest::qWaitFor([&] { return runner->known().share > 0; }, kPatience_ms));
        runner.reset();
        QVERIFY(runner == nullptr);
    }
};

QTEST_MAIN(TestBoundRunner)
#include "tst_bound_runner.moc"
