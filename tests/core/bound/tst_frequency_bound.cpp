#include "core/base/random.h"
#include "core/bound/frequency_bound.h"
#include "core/bound/zeta_bound.h"
#include "core/mission/mission.h"
#include "core/presets/presets.h"
#include "tests/support/flight/ideal_flight.h"
#include "tests/support/flight/scenario_builder.h"

#include <QtTest>

#include <algorithm>
#include <cmath>

using namespace berg;
using namespace Qt::StringLiterals;

namespace {

std::optional<FrequencyBound> boundOf(const Scenario& scenario)
{
    const TrueMotion motion(scenario, {});
    return frequencyBound(scenario, motion);
}

double endOf(const Scenario& scenario)
{
    const std::optional<FrequencyBound> bound = boundOf(scenario);
    return bound ? bound->zeta_m2s.back() : 0;
}

/**
 * Makes a field of few icebergs, kilometres apart, for many rounds. Steps of 2 s keep the search of
 * flights fast.
 */
Scenario sparse(std::uint64_t seed, int icebergs, double speedMax_mps)
{
    Random random(seed, 77);
    Scenario s = randomScenario(
        static_cast<std::int64_t>(seed),
        {.icebergs = icebergs, .size_m = Point(7000, 6000), .speedMax_mps = speedMax_mps});
    s.duration_s = 2 * std::round(random.uniform(1800, 3600));
    s.dt_s = 2;
    s.noise = seed % 2 == 0;
    s.uavs[0].position_m = {random.uniform(0, 7000), random.uniform(0, 6000)};
    return s;
}

/** Features that are added to a sparse field. */
enum class Feature
{
    Standing,
    Moving,
    Fast, ///< icebergs meet and part
    Wind,
    Storm,
    Current,
    North,
    Disk,
    Appearing,
    Recorded,
    Unequal,
    Pairs, ///< two in one view, or just not
    Fleet
};

Scenario drawn(Feature feature, std::uint64_t seed)
{
    Random random(seed, 78);
    const bool moves = feature != Feature::Standing && feature != Feature::Pairs;
    Scenario s = sparse(seed, 2 + static_cast<int>(seed % 3),
                        feature == Feature::Fast ? 4.0 : (moves ? 0.5 : 0.0));
    switch (feature) {
    case Feature::Wind:
        s.wind_mps = {random.uniform(-10, 10), random.uniform(-10, 10)};
        break;
    case Feature::Storm:
        s.wind_mps = {14, -16};
        break;
    case Feature::Current:
        s.current_mps = {random.uniform(-2, 2), random.uniform(-2, 2)};
        break;
    case Feature::North:
        s.fovShape = FovShape::North;
        s.uavs[0].fov_m = {900, 300};
        break;
    case Feature::Disk:
        s.fovShape = FovShape::Disk;
        break;
    case Feature::Fleet:
        s.uavs.push_back(s.uavs[0]);
        s.uavs[1].id = "uav-2";
        s.uavs[1].position_m = {6000, 1000};
        s.uavs[1].fov_m = {random.uniform(200, 900), 500};
        s.uavs[1].spec.airspeed_mps = random.uniform(18, 28);
        break;
    default:
        break;
    }
    for (std::size_t i = 0; i < s.icebergs.size(); ++i) {
        Iceberg& iceberg = s.icebergs[i];
        if (feature == Feature::Appearing && i > 0)
            iceberg.appears_s = random.uniform(0, 0.7 * s.duration_s);
        if (feature == Feature::Unequal) {
            iceberg.q_m2ps = random.uniform(0, 0.2);
            iceberg.observed_s = random.uniform(0, 500);
        }
        if (feature == Feature::Recorded)
            for (int k = 0; k < 5; ++k) {
                iceberg.track.time_s.push_back(s.duration_s * k / 4);
                iceberg.track.position_m.emplace_back(random.uniform(0, 7000),
                                                      random.uniform(0, 6000));
            }
        if (feature == Feature::Pairs && i % 2 == 1)
            iceberg.position_m = s.icebergs[i - 1].position_m + Point(random.uniform(500, 1300), 0);
    }
    return s;
}

} // namespace

class TestFrequencyBound : public QObject
{
    Q_OBJECT
private slots:
    void idealFlights_data();
    void idealFlights();
    void missions_data();
    void missions();
    void toAndFro();
    void tourOfEqualDistances();
    void oneViewOfAll();
    void nearPairAndAnother();
    void meetingIcebergs();
    void longerRunsCostMore();
    void moreUavsCostLess();
    void greaterOfTheTwo();
    void standsOnTheGround();
    void refused();
    void stopped();
    void sameAgain();
};

void TestFrequencyBound::idealFlights_data()
{
    QTest::addColumn<Feature>("feature");
    QTest::newRow("standing") << Feature::Standing;
    QTest::newRow("moving") << Feature::Moving;
    QTest::newRow("fast") << Feature::Fast;
    QTest::newRow("wind") << Feature::Wind;
    QTest::newRow("storm") << Feature::Storm;
    QTest::newRow("current") << Feature::Current;
    QTest::newRow("north-aligned view") << Feature::North;
    QTest::newRow("round view") << Feature::Disk;
    QTest::newRow("icebergs appear") << Feature::Appearing;
    QTest::newRow("recorded tracks") << Feature::Recorded;
    QTest::newRow("unequal growth") << Feature::Unequal;
    QTest::newRow("pairs") << Feature::Pairs;
    QTest::newRow("two UAVs") << Feature::Fleet;
}

/** No flight that turns on the spot and hovers, optimised for each scenario, is below the bound. */
void TestFrequencyBound::idealFlights()
{
    QFETCH(Feature, feature);
    double closest = 0;
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        const Scenario s = drawn(feature, seed);
        const double bound_m2s = endOf(s);
        test::IdealFlights flights(s);
        const double lowest_m2s = flights.search(seed, 500, false);
        QVERIFY2(bound_m2s <= lowest_m2s,
                 qPrintable(u"seed %1: %2 > %3"_s.arg(seed).arg(bound_m2s).arg(lowest_m2s)));
        closest = std::max(closest, bound_m2s / lowest_m2s);
    }
    if (feature != Feature::Storm && feature != Feature::Recorded && feature != Feature::Fast)
        QVERIFY2(closest > 0.3, qPrintable(QString::number(closest)));
}

void TestFrequencyBound::missions_data()
{
    QTest::addColumn<PolicyKind>("policy");
    QTest::newRow("coverage") << PolicyKind::Coverage;
    QTest::newRow("latency") << PolicyKind::Latency;
    QTest::newRow("tour") << PolicyKind::Tour;
}

/** The bound holds at every minute, not only at the end. */
void TestFrequencyBound::missions()
{
    QFETCH(PolicyKind, policy);
    for (std::uint64_t seed = 31; seed <= 36; ++seed) {
        Scenario s = sparse(seed, 4 + static_cast<int>(seed % 5), seed % 3 == 0 ? 0.0 : 0.4);
        s.dt_s = 0.5;
        s.planner.policy = policy;
        const FrequencyBound bound = boundOf(s).value();
        QVERIFY(std::ranges::is_sorted(bound.zeta_m2s));
        QVERIFY(bound.zeta_m2s.back() > 0);
        Mission mission(s, {.workLimit = 10'000, .record = false});
        for (double time_s = 60; time_s <= s.duration_s; time_s += 60) {
            mission.advance(time_s);
            QVERIFY(bound.by_m2s(time_s) <= mission.metrics().zeta_m2s);
        }
    }
}

/** The flight from one view to the other is 4400 m, so no gap is shorter than 400 s. */
void TestFrequencyBound::toAndFro()
{
    Scenario s = test::emptySea(40'000);
    s.fovShape = FovShape::Disk;
    s.dt_s = 1;
    test::addIceberg(s, 0, 0);
    test::addIceberg(s, 5000, 0);
    // The UAV flies to and fro all the time.
    const double best_m2s = s.duration_s * 2 * 0.025 * 400 / 2;
    const double bound_m2s = endOf(s);
    QVERIFY(bound_m2s <= best_m2s);
    QVERIFY2(bound_m2s > 0.97 * best_m2s, qPrintable(QString::number(bound_m2s / best_m2s)));
}

void TestFrequencyBound::tourOfEqualDistances()
{
    Scenario s = test::emptySea(60'000);
    s.fovShape = FovShape::Disk;
    test::addIceberg(s, 0, 0);
    test::addIceberg(s, 5000, 0);
    test::addIceberg(s, 2500, 2500 * std::sqrt(3.0));
    const double leg_s = (5000 - 600) / 22.0;
    const double rounds_m2s = s.duration_s * 3 * 0.025 * 3 * leg_s / 2;
    QVERIFY(endOf(s) <= rounds_m2s);
    QVERIFY(endOf(s) > 0.97 * rounds_m2s);
}

void TestFrequencyBound::oneViewOfAll()
{
    Scenario s = test::emptySea(20'000);
    test::addIceberg(s, 100, 0);
    test::addIceberg(s, -100, 50);
    test::addIceberg(s, 0, 200);
    // The iceberg is in view from the first instant on.
    QVERIFY(endOf(s) <= 1e-6);
}

/**
 * A UAV that circles between two near icebergs sees both all the time, and never sees the third
 * one.
 */
void TestFrequencyBound::nearPairAndAnother()
{
    Scenario s = test::emptySea(6000);
    s.dt_s = 1;
    test::addIceberg(s, 350, 0);
    test::addIceberg(s, -350, 0);
    test::addIceberg(s, 0, 6000).q_m2ps = 0.0005;
    const double third_m2s = 5 * 6000 + 0.0005 * 6000.0 * 6000 / 2;
    const double bound_m2s = endOf(s);
    QVERIFY2(bound_m2s > 0 && bound_m2s <= third_m2s, qPrintable(QString::number(bound_m2s)));
}

/** The icebergs pass through one view at half time. */
void TestFrequencyBound::meetingIcebergs()
{
    Scenario s = test::emptySea(8000);
    s.dt_s = 2;
    test::addIceberg(s, -6000, 0).velocity_mps = {1.5, 0};
    test::addIceberg(s, 6000, 100).velocity_mps = {-1.5, 0};
    const double bound_m2s = endOf(s);
    test::IdealFlights flights(s);
    const double lowest_m2s = flights.search(3, 3000, false);
    QVERIFY(bound_m2s <= lowest_m2s);
    QVERIFY(bound_m2s > 0);
}

void TestFrequencyBound::longerRunsCostMore()
{
    for (int seed = 1; seed <= 3; ++seed) {
        Scenario s = randomScenario(seed, {.icebergs = 15, .size_m = Point(15'000, 15'000)});
        s.dt_s = 1;
        double last_m2s = 0;
        for (const double hours : {1.0, 2.0, 4.0, 8.0}) {
            s.duration_s = 3600 * hours;
            const double bound_m2s = endOf(s);
            QVERIFY(bound_m2s > 1.5 * last_m2s);
            last_m2s = bound_m2s;
        }
    }
}

void TestFrequencyBound::moreUavsCostLess()
{
    Scenario s = randomScenario(4, {.icebergs = 20, .size_m = Point(18'000, 18'000)});
    s.duration_s = 14'400;
    s.dt_s = 1;
    double last_m2s = endOf(s);
    QVERIFY(last_m2s > 0);
    for (const char* id : {"uav-2", "uav-3"}) {
        s.uavs.push_back(s.uavs[0]);
        s.uavs.back().id = id;
        const double bound_m2s = endOf(s);
        QVERIFY(0 < bound_m2s && bound_m2s < last_m2s);
        last_m2s = bound_m2s;
    }
}

/**
 * The bound of frequencies is the greater one for a day over many drifting icebergs, for which
 * chains prove almost nothing.
 */
void TestFrequencyBound::greaterOfTheTwo()
{
    Scenario s = randomScenario(9, {.icebergs = 40, .size_m = Point(40'000, 40'000)});
    s.duration_s = 86'400;
    const ZetaBound bound = zetaLowerBound(s, {.workLimit = 20'000'000});
    QCOMPARE(bound.frequency_m2s.value(), endOf(s));
    QVERIFY(bound.zeta_m2s >= *bound.frequency_m2s);
    QCOMPARE(bound.by_m2s(s.duration_s), bound.zeta_m2s);
    const ZetaBound without = zetaLowerBound(s, {.workLimit = 900'000});
    QVERIFY(!without.frequency_m2s);
    QVERIFY(bound.zeta_m2s > 2 * without.zeta_m2s);
    QVERIFY(bound.by(s.duration_s).isFromRates);
    QVERIFY(!without.by(s.duration_s).isFromRates);
    for (std::size_t k = 1; k < bound.curve.size(); ++k)
        QVERIFY(bound.curve[k].zeta_m2s >= bound.curve[k - 1].zeta_m2s);
}

/** With sorties the UAV flies less, so the bound holds. */
void TestFrequencyBound::standsOnTheGround()
{
    for (std::uint64_t seed = 41; seed <= 43; ++seed) {
        Scenario s = sparse(seed, 6, 0.3);
        s.dt_s = 0.5;
        s.uavs[0].spec.endurance_s = 1800;
        s.planner.policy = PolicyKind::Latency;
        const double bound_m2s = endOf(s);
        Mission mission(s, {.workLimit = 10'000, .record = false});
        mission.advance(s.duration_s);
        QVERIFY(0 < bound_m2s && bound_m2s <= mission.metrics().zeta_m2s);
    }
}

void TestFrequencyBound::refused()
{
    Scenario s = sparse(1, 4, 0);
    s.observer.model = ObserverModel::Kalman;
    QVERIFY(!boundOf(s));
    s.observer.model = ObserverModel::Simple;
    QVERIFY(boundOf(s));
    for (std::size_t i = 1; i < s.icebergs.size(); ++i)
        s.icebergs[i].q_m2ps = 0;
    QVERIFY(!boundOf(s)); // A single iceberg that grows can be in view all the time.
    QVERIFY(!boundOf(test::emptySea()));
}

void TestFrequencyBound::stopped()
{
    const Scenario s = sparse(2, 4, 0);
    const TrueMotion motion(s, {});
    std::stop_source source;
    QVERIFY(frequencyBound(s, motion, source.get_token()));
    source.request_stop();
    QVERIFY(!frequencyBound(s, motion, source.get_token()));
}

void TestFrequencyBound::sameAgain()
{
    const Scenario s = sparse(6, 4, 0.4);
    const std::optional<FrequencyBound> first = boundOf(s);
    const std::optional<FrequencyBound> second = boundOf(s);
    QVERIFY(first->zeta_m2s == second->zeta_m2s);
    QVERIFY(first->times_s == second->times_s);
}

QTEST_APPLESS_MAIN(TestFrequencyBound)

#include "tst_frequency_bound.moc"
