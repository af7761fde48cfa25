#include "core/base/random.h"
#include "core/bound/sigma_floor.h"
#include "core/bound/zeta_bound.h"
#include "core/mission/mission.h"
#include "core/presets/presets.h"
#include "tests/support/flight/fleet_flight.h"

#include <QtTest>

using namespace berg;
using namespace Qt::StringLiterals;

namespace {

/**
 * Makes a scenario with measured icebergs of every kind; their velocities are known or not, and
 * constant or not.
 */
Scenario measured(std::uint64_t seed)
{
    Random random(seed, 340);
    Scenario s =
        randomScenario(static_cast<std::int64_t>(seed),
                       {.icebergs = 2 + static_cast<int>(random.below(5)), .size_m = {3000, 2500}});
    s.duration_s = std::round(random.uniform(150, 500));
    s.observer = {.model = ObserverModel::Kalman,
                  .positionSd_m = random.below(4) == 0 ? 0.5 : random.uniform(2, 10),
                  .interval_s = random.below(2) == 0 ? 1.0 : 4.0,
                  .detection = random.below(2) == 0 ? 1 : 0.8};
    if (random.below(3) == 0)
        s.observer.search = SearchPattern::None;
    for (Iceberg& iceberg : s.icebergs) {
        if (random.below(3) != 0)
            iceberg.velocitySd_mps = random.uniform(0, 0.4);
        if (random.below(3) == 0) {
            iceberg.velocitySpread_mps = random.uniform(0.02, 0.3);
            iceberg.velocityTime_s = std::exp(random.uniform(3, 11));
        }
        if (random.below(4) == 0)
            iceberg.observed_s = random.uniform(0, 2000);
        if (random.below(5) == 0)
            iceberg.appears_s = random.uniform(0, s.duration_s / 2);
        iceberg.q_m2ps = std::exp(random.uniform(-6, -1));
    }
    if (random.below(3) == 0)
        s.wind_mps = {random.uniform(-8, 8), random.uniform(-8, 8)};
    return s;
}

/** Leaves one UAV with a limited endurance, which has to land at home. */
Scenario withEndurance(Scenario s, std::uint64_t seed)
{
    Random random(seed, 341);
    s.duration_s = 1500;
    Uav& uav = s.uavs.front();
    uav.spec.endurance_s = random.uniform(300, 900);
    uav.turnaround_s = random.uniform(20, 700);
    if (random.below(2) == 0)
        s.observer.model = ObserverModel::Simple;
    return s;
}

/** Compares the curve of a bound with a flight at each of its points. */
class Checked
{
public:
    explicit Checked(const Scenario& s) : m_bound(zetaLowerBound(s, {.workLimit = 15'000'000})) {}
    /** Returns an empty text if the flight is nowhere below the bound until now. */
    QString fault(const Simulation& now)
    {
        while (m_next < m_bound.curve.size() &&
               m_bound.curve[m_next].time_s <= now.time_s() + 1e-6) {
            const BoundPoint& point = m_bound.curve[m_next++];
            const bool isNow = std::abs(point.time_s - now.time_s()) < 1e-6;
            if (isNow && (point.zeta_m2s > now.zeta_m2s() ||
                          point.sigma_m2 > now.observer().sigmaSum_m2() + 1e-9))
                return u"at %1 s: %2 and %3 above %4 and %5"_s.arg(point.time_s)
                    .arg(point.zeta_m2s)
                    .arg(point.sigma_m2)
                    .arg(now.zeta_m2s())
                    .arg(now.observer().sigmaSum_m2());
        }
        return {};
    }
    [[nodiscard]] double zeta_m2s() const { return m_bound.zeta_m2s; }

private:
    ZetaBound m_bound;
    std::size_t m_next = 1;
};

/**
 * An observer that is better than any UAV: it turns on the spot, hovers over icebergs and knows
 * their true positions.
 */
class Hoverer
{
public:
    Hoverer(const Scenario& s, std::uint64_t seed) : m_scenario(s), m_random(seed, 342) {}

    DubinsState next(const Simulation& now)
    {
        if (now.time_s() >= m_until_s) {
            m_iceberg = IcebergIndex::of(m_random.below(m_scenario.icebergs.size()));
            const double angle_rad = m_random.uniform(-3, 3);
            m_beside_m = m_random.uniform(0, 290) * Point(std::cos(angle_rad), std::sin(angle_rad));
            const double stay_s = m_random.below(2) == 0 ? 3 : m_random.uniform(0, 200);
            m_until_s = now.time_s() + way_m(now).norm() / 22 + stay_s;
        }
        const double step_m = m_scenario.uavs[0].spec.airspeed_mps * m_scenario.dt_s;
        const Point blown_m = m_scenario.wind_mps * m_scenario.dt_s;
        const Point air_m = way_m(now) - blown_m;
        DubinsState pose = now.uav(0).pose;
        pose.position_m +=
            blown_m + (air_m.norm() <= step_m ? air_m : Point(air_m * (step_m / air_m.norm())));
        return pose;
    }

private:
    [[nodiscard]] Point way_m(const Simulation& now) const
    {
        return now.truth_m(m_iceberg) + m_beside_m - now.uav(0).pose.position_m;
    }

    const Scenario& m_scenario;
    Random m_random;
    IcebergIndex m_iceberg;
    Point m_beside_m = Point::Zero();
    double m_until_s = 0;
};

} // namespace

/** Tests the lower bound on sigma of measured icebergs, and on zeta with it. */
class TestSigmaFloor : public QObject
{
    Q_OBJECT

private slots:
    /**
     * The filters of 300 icebergs, seen in bursts, now and then, always or hardly ever, are never
     * below the floor.
     */
    void noFilterIsBelow()
    {
        int seen = 0;
        for (std::uint64_t seed = 1; seed <= 300; ++seed) {
            Random random(seed, 343);
            Scenario s = measured(seed);
            s.dt_s = 0.5;
            const Iceberg& iceberg = s.icebergs.front();
            const TrueMotion motion(s, {});
            const SigmaFloor floor(s, iceberg, motion);
            Track track = initialTrack(iceberg, ObserverModel::Kalman);
            const double variance_m2 = s.observer.positionSd_m * s.observer.positionSd_m;
            const auto perLook = static_cast<int>(s.observer.interval_s / s.dt_s);
            const auto appears = static_cast<int>(std::llround(iceberg.appears_s / s.dt_s));
            track.grow(appears * s.dt_s);
            const double often = random.below(3) == 0 ? 1 : random.uniform(0, 0.3);
            bool looks = random.uniform() < often;
            double last_s = -1;
            for (int step = appears; step <= motion.edgeStep(motion.blocks()); ++step) {
                const double time_s = step * s.dt_s;
                if (step > appears)
                    track.grow(s.dt_s);
                if (random.below(60) == 0)
                    looks = random.uniform() < often;
                if (looks && step % perLook == 0) {
                    track.measured(track.anchor_m, variance_m2, track.anchor_s);
                    last_s = time_s;
                    ++seen;
                }
                if (last_s < 0) {
                    QVERIFY(floor.unseen_m2(time_s) <= track.sigma_m2 * (1 + 1e-9));
                    continue;
                }
                // Each block is one step here.
                const int edge = std::min(motion.blocks(), step + 1);
                const int from =
                    static_cast<int>(random.below(static_cast<std::uint64_t>(step) + 1));
                const double age_s = time_s - std::max(last_s, motion.edge_s(from));
                const DriftVariances least = floor.least(from, edge);
                const double bound_m2 = floor.seen_m2(least, age_s);
                QVERIFY2(
                    bound_m2 <= track.sigma_m2 * (1 + 1e-9),
                    qPrintable(u"%1, %2 s: %3 above %4"_s.arg(seed).arg(time_s).arg(bound_m2).arg(
                        track.sigma_m2)));
                if (step % 40 == 0) {
                    const FloorLine line = floor.lineAt(least, random.uniform(0, 300), time_s + 1);
                    QVERIFY(line.slope_m2ps * age_s - line.offset_m2 <= bound_m2 * (1 + 1e-9));
                }
            }
        }
        QVERIFY2(seen > 10'000, qPrintable(QString::number(seen)));
    }

    /**
     * No flight is below the bound, for 1,000 flights of every policy with one UAV or several, a
     * third of them with an endurance.
     */
    void noFlightIsBelow()
    {
        int told = 0;
        for (std::uint64_t seed = 1; seed <= 1000; ++seed) {
            Random random(seed, 344);
            Scenario s = measured(seed);
            if (seed % 3 == 0)
                s = withEndurance(std::move(s), seed);
            else if (seed % 3 == 1)
                s = test::withUavs(std::move(s), 1 + static_cast<int>(random.below(3)));
            s.planner.policy = static_cast<PolicyKind>(random.below(kPolicyTable.size()));
            Checked checked(s);
            Mission mission(s, {.workLimit = 2000, .record = false});
            for (double time_s = 5; time_s <= s.duration_s; time_s += 5) {
                mission.advance(time_s);
                const QString fault = checked.fault(mission.simulation());
                QVERIFY2(fault.isEmpty(), qPrintable(u"seed %1 "_s.arg(seed) + fault));
            }
            told += isUsefulBound(checked.zeta_m2s(), mission.metrics().zeta_m2s) ? 1 : 0;
        }
        QVERIFY2(told > 300, qPrintable(QString::number(told)));
    }

    /**
     * None of 200 flights that no UAV can fly, which hover over the icebergs they learn most from,
     * is below the bound.
     */
    void noHovererIsBelow()
    {
        for (std::uint64_t seed = 1; seed <= 200; ++seed) {
            const Scenario s = measured(seed);
            Checked checked(s);
            Hoverer hoverer(s, seed);
            Simulation world(s);
            while (!world.finished()) {
                if (world.planReason() != PlanReason::None)
                    world.setTarget(0, std::nullopt);
                world.advanceStep(
                    std::array{std::optional(ExternalPose{.pose = hoverer.next(world)})});
                const QString fault = checked.fault(world);
                QVERIFY2(fault.isEmpty(), qPrintable(u"seed %1 "_s.arg(seed) + fault));
            }
        }
    }

    /**
     * The bound must be useful. It once reached only 0.03, 0.004 and 0.15 of the flown zeta with
     * unknown velocities and an endurance, for as much work.
     */
    void saysSomething_data()
    {
        QTest::addColumn<double>("velocitySd_mps");
        QTest::addColumn<double>("endurance_s");
        QTest::newRow("unknown by 0.1 m/s") << 0.1 << 0.0;
        QTest::newRow("unknown by 0.3 m/s") << 0.3 << 0.0;
        QTest::newRow("endurance") << 0.0 << 1800.0;
    }
    void saysSomething()
    {
        QFETCH(double, velocitySd_mps);
        QFETCH(double, endurance_s);
        Scenario s = randomScenario(1);
        s.planner.policy = PolicyKind::Coverage;
        if (velocitySd_mps > 0)
            s.observer.model = ObserverModel::Kalman;
        for (Iceberg& iceberg : s.icebergs)
            iceberg.velocitySd_mps = velocitySd_mps;
        if (endurance_s > 0) {
            s.duration_s = 7200;
            s.uavs[0].spec.endurance_s = endurance_s;
            s.uavs[0].turnaround_s = 1200;
        }
        Mission mission(s, {.workLimit = 100'000, .record = false});
        mission.advance(s.duration_s);
        const double bound_m2s = zetaLowerBound(s, {.workLimit = 1'500'000'000}).zeta_m2s;
        const double flown_m2s = mission.metrics().zeta_m2s;
        QVERIFY2(isUsefulBound(bound_m2s, flown_m2s) && bound_m2s < flown_m2s,
                 qPrintable(QString::number(bound_m2s / flown_m2s)));
    }
};

QTEST_APPLESS_MAIN(TestSigmaFloor)
#include "tst_sigma_floor.moc"
