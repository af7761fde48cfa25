#include "core/base/random.h"
#include "core/bound/remains_in_area.h"
#include "core/bound/zeta_bound.h"
#include "core/checks/validate.h"
#include "core/mission/mission.h"
#include "core/presets/presets.h"
#include "tests/support/flight/fleet_flight.h"
#include "tests/support/flight/ideal_flight.h"
#include "tests/support/flight/scenario_builder.h"

#include <QtTest>

#include <array>

using namespace berg;
using namespace Qt::StringLiterals;

namespace {

constexpr std::int64_t kLittleWork = 80'000'000;

double boundOf(const Scenario& scenario, std::int64_t work = kLittleWork)
{
    return zetaLowerBound(scenario, {.workLimit = work}).zeta_m2s;
}

/** Features that are added to the default scenario. */
enum Feature : unsigned
{
    kMoving = 1,
    kWind = 2,
    kCurrent = 4,
    kNorth = 8,
    kDisk = 16,
    kAppearing = 32,
    kRecorded = 64,
    kOddView = 128,
    kUnequal = 256, ///< q, and ages at the start
    kStorm = 512
};

Scenario drawn(std::uint64_t seed, int icebergs, unsigned features)
{
    Random random(seed, 99);
    Scenario s = randomScenario(static_cast<std::int64_t>(seed),
                                {.icebergs = icebergs,
                                 .size_m = Point(3500, 3000),
                                 .speedMax_mps = (features & kMoving) != 0 ? 1.0 : 0.0});
    s.duration_s = random.uniform(150, 600);
    s.noise = seed % 2 == 0;
    Uav& uav = s.uavs[0];
    uav.position_m = {random.uniform(-800, 2500), random.uniform(-800, 2000)};
    if ((features & kWind) != 0)
        s.wind_mps = {random.uniform(-9, 9), random.uniform(-9, 9)};
    if ((features & kStorm) != 0)
        s.wind_mps = {15, -15.5};
    if ((features & kCurrent) != 0)
        s.current_mps = {random.uniform(-2, 2), random.uniform(-2, 2)};
    if ((features & kNorth) != 0)
        s.fovShape = FovShape::North;
    if ((features & kDisk) != 0)
        s.fovShape = FovShape::Disk;
    if ((features & kOddView) != 0)
        uav.fov_m = {random.uniform(100, 300), random.uniform(400, 900)};
    for (Iceberg& iceberg : s.icebergs) {
        if ((features & kUnequal) != 0) {
            iceberg.q_m2ps = random.uniform(0, 0.1);
            iceberg.observed_s = random.uniform(0, 200);
        }
        if ((features & kAppearing) != 0 && random.below(2) == 0)
            iceberg.appears_s = random.uniform(0, s.duration_s);
        if ((features & kRecorded) != 0 && random.below(2) == 0)
            for (int k = 0; k < 4; ++k) {
                iceberg.track.time_s.push_back(130.0 * k - 50);
                iceberg.track.position_m.emplace_back(random.uniform(0, 3500),
                                                      random.uniform(0, 3000));
            }
    }
    return s;
}

void addFeatureRows()
{
    QTest::addColumn<unsigned>("features");
    QTest::newRow("standing") << 0U;
    QTest::newRow("moving") << unsigned{kMoving};
    QTest::newRow("wind") << unsigned{kWind};
    QTest::newRow("storm") << unsigned{kStorm | kMoving};
    QTest::newRow("current") << unsigned{kCurrent | kMoving};
    QTest::newRow("north-aligned view") << unsigned{kNorth | kOddView | kMoving};
    QTest::newRow("round view") << unsigned{kDisk | kUnequal};
    QTest::newRow("long and narrow view") << unsigned{kOddView | kUnequal};
    QTest::newRow("icebergs appear") << unsigned{kAppearing | kMoving};
    QTest::newRow("recorded tracks") << unsigned{kRecorded};
    QTest::newRow("everything") << unsigned{kMoving | kWind | kCurrent | kAppearing | kRecorded |
                                            kOddView | kUnequal};
}

/** Returns the scenario with two to four UAVs, alike or each of its own kind. */
Scenario fleetOf(Scenario s, std::uint64_t seed)
{
    Random random(seed, 98);
    const auto uavs = 2 + static_cast<int>(random.below(3));
    s = test::withUavs(std::move(s), uavs);
    for (Uav& uav : s.uavs) {
        uav.position_m = {random.uniform(-800, 3500), random.uniform(-800, 3000)};
        if (seed % 3 == 0)
            uav.fov_m = {random.uniform(100, 900), random.uniform(300, 900)};
        if (seed % 4 == 0)
            uav.spec.airspeed_mps = random.uniform(18, 30);
    }
    return s;
}

} // namespace

class TestZetaBound : public QObject
{
    Q_OBJECT
private slots:
    void idealFlights_data() { addFeatureRows(); }
    void idealFlights();
    void flownMissions_data() { addFeatureRows(); }
    void flownMissions();
    void policies_data();
    void policies();
    void nothingToSee();
    void allInView();
    void oneIceberg();
    void twoFarApart();
    void unevenGrowth();
    void standingFieldsAreWellBounded();
    void moreIcebergsThanOneProgramme();
    void manyMovingIcebergs();
    void moreWorkIsNoWorse();
    void sameAgain();
    void stopped();
    void stoppedBeforeTheArea();
    void stoppedOnTheWay();
    void idealFleets_data() { addFeatureRows(); }
    void idealFleets();
    void fleetsFly();
    void fleetsAreBoundedAsTheyShould();
    void longRun();
};

void TestZetaBound::idealFlights()
{
    QFETCH(unsigned, features);
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        Scenario s = drawn(seed, 1 + static_cast<int>(seed), features);
        s.duration_s = std::round(s.duration_s / 2);
        s.dt_s = 1;
        const ZetaBound bound = zetaLowerBound(s, {.workLimit = kLittleWork});
        test::IdealFlights flights(s);
        flights.search(seed, 1200, true);
        const double lowest_m2s = flights.search(seed, 1200, false);
        QVERIFY2(bound.zeta_m2s <= lowest_m2s, qPrintable(QString("seed %1: bound %2, flown %3")
                                                              .arg(seed)
                                                              .arg(bound.zeta_m2s)
                                                              .arg(lowest_m2s)));
        // The bound holds at every step, too, because each block is one step here.
        QCOMPARE(bound.curve.size(), flights.lowestSigma_m2().size());
        for (std::size_t k = 1; k < bound.curve.size(); ++k)
            QVERIFY2(bound.curve[k].sigma_m2 <= flights.lowestSigma_m2()[k],
                     qPrintable(QString("seed %1, step %2: bound %3, flown %4")
                                    .arg(seed)
                                    .arg(k)
                                    .arg(bound.curve[k].sigma_m2)
                                    .arg(flights.lowestSigma_m2()[k])));
    }
}

void TestZetaBound::flownMissions()
{
    QFETCH(unsigned, features);
    for (std::uint64_t seed = 101; seed <= 104; ++seed) {
        const Scenario s = drawn(seed, 4 + static_cast<int>(seed % 4), features);
        const ZetaBound bound = zetaLowerBound(s, {.workLimit = kLittleWork});
        QVERIFY(bound.zeta_m2s > 0);
        Mission mission(s, {.record = false});
        for (std::size_t k = 50; k < bound.curve.size(); k += 50) {
            mission.advance(bound.curve[k].time_s);
            QVERIFY(bound.curve[k].zeta_m2s <= mission.metrics().zeta_m2s);
            QVERIFY(bound.curve[k].sigma_m2 <= mission.simulation().state().sigmaSum_m2 + 1e-9);
        }
    }
}

void TestZetaBound::policies_data()
{
    QTest::addColumn<PolicyKind>("policy");
    QTest::newRow("visitation") << PolicyKind::Visitation;
    QTest::newRow("latency") << PolicyKind::Latency;
    QTest::newRow("coverage") << PolicyKind::Coverage;
    QTest::newRow("tour") << PolicyKind::Tour;
}

void TestZetaBound::policies()
{
    QFETCH(PolicyKind, policy);
    for (std::int64_t seed = 21; seed <= 22; ++seed) {
        Scenario s = randomScenario(seed, {.icebergs = 8});
        s.planner.policy = policy;
        Mission mission(s, {.record = false});
        mission.advance(s.duration_s);
        const double bound_m2s = boundOf(s);
        QVERIFY(bound_m2s <= mission.metrics().zeta_m2s);
        QVERIFY(bound_m2s > 0.3 * mission.metrics().zeta_m2s);
    }
}

void TestZetaBound::nothingToSee()
{
    const ZetaBound bound = zetaLowerBound(test::emptySea());
    QCOMPARE(bound.zeta_m2s, 0.0);
    QCOMPARE(bound.curve.back().time_s, 1000.0);
}

void TestZetaBound::allInView()
{
    Scenario s = test::emptySea();
    test::addIceberg(s, 100, 100);
    test::addIceberg(s, -100, 50);
    QCOMPARE(boundOf(s), 0.0);
}

void TestZetaBound::oneIceberg()
{
    // The iceberg comes into view at 300 m, after 4700 m of straight flight at 22 m/s. Until then
    // sigma is 5 + 0.025 t.
    Scenario s = test::emptySea();
    s.fovShape = FovShape::Disk;
    test::addIceberg(s, 5000, 0);
    const double reached_s = 4700.0 / 22;
    const double exact_m2s = 5 * reached_s + 0.025 * reached_s * reached_s / 2;
    const double bound_m2s = boundOf(s);
    QVERIFY(bound_m2s <= exact_m2s);
    QVERIFY(bound_m2s > 0.995 * exact_m2s); // The loss comes from blocks of 0.5 s.

    s.wind_mps = {-11, 0}; // The wind halves the ground speed.
    const double against_m2s = 10 * reached_s + 0.025 * 4 * reached_s * reached_s / 2;
    QVERIFY(boundOf(s) <= against_m2s);
    QVERIFY(boundOf(s) > 0.995 * against_m2s);
}

void TestZetaBound::twoFarApart()
{
    // The other iceberg was in view at least 4400 m of flight ago.
    Scenario s = test::emptySea(3000);
    s.fovShape = FovShape::Disk;
    test::addIceberg(s, 0, 0);
    test::addIceberg(s, 5000, 0);
    const double sigma_m2 = 0.025 * 4400 / 22;
    const double bound_m2 = zetaLowerBound(s).curve.back().sigma_m2;
    QVERIFY(bound_m2 <= sigma_m2);
    QVERIFY(bound_m2 > 0.99 * sigma_m2);
}

void TestZetaBound::unevenGrowth()
{
    // The least sigma at the end has the iceberg that grows fast visited last.
    Scenario s = test::emptySea(3000);
    s.fovShape = FovShape::Disk;
    test::addIceberg(s, 0, 0).q_m2ps = 0.5;
    test::addIceberg(s, 5000, 0).q_m2ps = 0.01;
    const double sigma_m2 = 0.01 * 4400 / 22;
    const double bound_m2 = zetaLowerBound(s).curve.back().sigma_m2;
    QVERIFY(bound_m2 <= sigma_m2);
    QVERIFY(bound_m2 > 0.99 * sigma_m2);
}

void TestZetaBound::standingFieldsAreWellBounded()
{
    for (std::int64_t seed = 1; seed <= 3; ++seed) {
        Scenario s = randomScenario(seed, {.speedMax_mps = 0});
        s.planner.policy = PolicyKind::Coverage;
        Mission mission(s, {.record = false});
        mission.advance(s.duration_s);
        QVERIFY(boundOf(s, 400'000'000) >= 0.55 * mission.metrics().zeta_m2s);
    }
}

void TestZetaBound::moreIcebergsThanOneProgramme()
{
    Scenario s = randomScenario(5, {.icebergs = 20, .speedMax_mps = 0});
    Mission mission(s, {.record = false});
    mission.advance(s.duration_s);
    const double bound_m2s = boundOf(s, 1'000'000'000);
    QVERIFY(bound_m2s <= mission.metrics().zeta_m2s);
    s.icebergs.resize(10);
    QVERIFY(bound_m2s > boundOf(s));
}

/** Many icebergs share little work. Most are never seen, and count. */
void TestZetaBound::manyMovingIcebergs()
{
    double last_m2s = 0;
    for (const int icebergs : {150, 300, 600}) {
        Scenario s = randomScenario(
            4, {.icebergs = icebergs, .size_m = Point(1e5, 1e5), .speedMax_mps = 0.3});
        s.duration_s = 500;
        double unseen_m2s = 0;
        for (const Iceberg& iceberg : s.icebergs)
            unseen_m2s +=
                s.duration_s * (initialSigma_m2(iceberg) + iceberg.q_m2ps * s.duration_s / 2);
        const double bound_m2s = boundOf(s);
        QVERIFY2(bound_m2s > 0.9 * unseen_m2s && bound_m2s <= unseen_m2s,
                 qPrintable(u"%1: %2 of %3"_s.arg(icebergs).arg(bound_m2s).arg(unseen_m2s)));
        QVERIFY(bound_m2s > last_m2s);
        last_m2s = bound_m2s;
    }
    // Dense icebergs are seen often; the bound is still no more than the flown zeta.
    Scenario dense = randomScenario(4, {.icebergs = 150, .size_m = Point(5000, 5000)});
    dense.duration_s = 500;
    Mission mission(dense, {.workLimit = 10'000, .record = false});
    mission.advance(dense.duration_s);
    const double bound_m2s = boundOf(dense);
    QVERIFY(0 < bound_m2s && bound_m2s <= mission.metrics().zeta_m2s);
}

void TestZetaBound::moreWorkIsNoWorse()
{
    const Scenario s = randomScenario(3, {.icebergs = 9});
    double last_m2s = 0;
    for (const std::int64_t work : {0LL, 1'000'000LL, 10'000'000LL, 30'000'000LL, 300'000'000LL}) {
        const ZetaBound bound = zetaLowerBound(s, {.workLimit = work});
        QVERIFY(bound.work <= work);
        QVERIFY(!bound.cancelled);
        QVERIFY(bound.zeta_m2s >= last_m2s);
        last_m2s = bound.zeta_m2s;
    }
    QVERIFY(last_m2s > 0);
    QCOMPARE(boundOf(s, 0), 0.0);
}

void TestZetaBound::sameAgain()
{
    const Scenario s = drawn(7, 6, kMoving | kWind | kAppearing);
    const ZetaBound first = zetaLowerBound(s, {.workLimit = kLittleWork});
    const ZetaBound second = zetaLowerBound(s, {.workLimit = kLittleWork});
    QVERIFY(first.curve == second.curve);
    QCOMPARE(first.work, second.work);
}

void TestZetaBound::stopped()
{
    std::stop_source source;
    source.request_stop();
    const ZetaBound bound = zetaLowerBound(randomScenario(1), {.stop = source.get_token()});
    QVERIFY(bound.cancelled);
    QCOMPARE(bound.zeta_m2s, 0.0);
}

/**
 * A stop prevents the noise of a week from being drawn to find the icebergs that stay in the area.
 */
void TestZetaBound::stoppedBeforeTheArea()
{
    Scenario s = randomScenario(1);
    s.duration_s = 1000;
    s.area_m = {{-1e6, -1e6}, {1e6, -1e6}, {1e6, 1e6}, {-1e6, 1e6}};
    std::stop_source source;
    QVERIFY(remainsInArea(s, s.icebergs[0], source.get_token()));
    source.request_stop();
    QVERIFY(!remainsInArea(s, s.icebergs[0], source.get_token()));
    s.duration_s = 604'800;
    const ZetaBound bound = zetaLowerBound(s, {.stop = source.get_token()});
    QVERIFY(bound.cancelled);
    QCOMPARE(bound.work, std::int64_t{0});
    QCOMPARE(bound.zeta_m2s, 0.0);
}

void TestZetaBound::stoppedOnTheWay()
{
    const Scenario s = randomScenario(1);
    std::stop_source source;
    std::vector<double> told_m2s;
    const ZetaBound bound =
        zetaLowerBound(s, {.stop = source.get_token(), .onProgress = [&](const BoundProgress& now) {
                               told_m2s.push_back(now.zeta_m2s);
                               if (told_m2s.size() == 2)
                                   source.request_stop();
                           }});
    QVERIFY(bound.cancelled);
    QCOMPARE(told_m2s.size(), std::size_t{2});
    QVERIFY(std::is_sorted(told_m2s.begin(), told_m2s.end()));
    QCOMPARE(bound.zeta_m2s, told_m2s.back());
    QVERIFY(bound.zeta_m2s > 0);
    QVERIFY(bound.zeta_m2s < boundOf(s, 400'000'000));
}

void TestZetaBound::idealFleets()
{
    QFETCH(unsigned, features);
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        const Scenario s = fleetOf(drawn(seed, 3 + static_cast<int>(seed % 3), features), seed);
        const ZetaBound bound = zetaLowerBound(s, {.workLimit = kLittleWork});
        test::IdealFlights flights(s);
        const double lowest_m2s = flights.search(seed, 800, seed % 2 == 0);
        QVERIFY2(bound.zeta_m2s <= lowest_m2s,
                 qPrintable(u"seed %1: %2 > %3"_s.arg(seed).arg(bound.zeta_m2s).arg(lowest_m2s)));
        for (std::size_t k = 1; k < bound.curve.size(); ++k) {
            const auto step =
                static_cast<std::size_t>(std::llround(bound.curve[k].time_s / s.dt_s));
            QVERIFY(bound.curve[k].sigma_m2 <= flights.lowestSigma_m2()[step] * (1 + 1e-9) + 1e-9);
        }
    }
}

/** No policy is below the bound for any of 104 random fleets. */
void TestZetaBound::fleetsFly()
{
    constexpr std::array kFeatures{0U, unsigned{kMoving}, unsigned{kWind | kUnequal},
                                   unsigned{kDisk | kMoving | kAppearing}};
    int positive = 0;
    for (std::uint64_t seed = 1; seed <= 104; ++seed) {
        Scenario s = fleetOf(
            drawn(seed, 3 + static_cast<int>(seed % 4), kFeatures[seed % kFeatures.size()]), seed);
        s.duration_s = 250;
        const double bound_m2s = boundOf(s, 5'000'000);
        positive += bound_m2s > 0 ? 1 : 0;
        for (const Named<PolicyKind>& policy : kPolicyNames) {
            s.planner.policy = policy.value;
            Mission mission(s, {.workLimit = 10'000, .record = false});
            mission.advance(s.duration_s);
            QVERIFY2(
                bound_m2s <= mission.metrics().zeta_m2s,
                qPrintable(QString::number(seed) + u' ' + QString::fromLatin1(policy.name.data())));
        }
    }
    QVERIFY2(positive > 90, qPrintable(QString::number(positive)));
}

/**
 * More UAVs only lower the bound; a second UAV that is too far away to see anything changes
 * nothing.
 */
void TestZetaBound::fleetsAreBoundedAsTheyShould()
{
    Scenario s = randomScenario(2, {.icebergs = 7});
    s.duration_s = 300;
    double before_m2s = boundOf(s);
    const double alone_m2s = before_m2s;
    for (int uavs = 2; uavs <= 4; ++uavs) {
        const double bound_m2s = boundOf(test::withUavs(s, uavs));
        QVERIFY(0 < bound_m2s && bound_m2s < before_m2s);
        before_m2s = bound_m2s;
    }
    Scenario apart = test::withUavs(s, 2);
    apart.uavs[1].position_m = {1e5, 1e5};
    QVERIFY(boundOf(apart) > 0.9 * alone_m2s);
}

void TestZetaBound::longRun()
{
    // The icebergs drift 17 km apart in a day: the bound over the whole run is useless, slices
    // help.
    Scenario s = randomScenario(2, {.icebergs = 6});
    s.duration_s = 86400;
    const ZetaBound bound = zetaLowerBound(s, {.workLimit = kLittleWork});
    QVERIFY(bound.curve.size() <= 2001);
    QVERIFY(bound.curve.back().sigma_m2 > 0);
    QCOMPARE(bound.by_m2s(0), 0.0);
    QCOMPARE(bound.by_m2s(86400), bound.zeta_m2s);
    QVERIFY(bound.by_m2s(40000) < bound.zeta_m2s);
}

QTEST_APPLESS_MAIN(TestZetaBound)

#include "tst_zeta_bound.moc"
