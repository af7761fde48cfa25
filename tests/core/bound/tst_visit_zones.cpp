#include "core/base/random.h"
#include "core/bound/visit_zones.h"
#include "core/presets/presets.h"
#include "core/tracking/drift.h"
#include "core/vehicle/dubins.h"
#include "tests/support/flight/scenario_builder.h"

#include <QtTest>

#include <algorithm>
#include <cmath>
#include <numeric>

using namespace berg;

namespace {

std::vector<int> all(const Scenario& scenario)
{
    std::vector<int> icebergs(scenario.icebergs.size());
    std::iota(icebergs.begin(), icebergs.end(), 0);
    return icebergs;
}

LegTimes legsOf(const Scenario& scenario)
{
    const TrueMotion motion(scenario, {});
    return {scenario, motion, all(scenario), {.from = 0, .to = motion.blocks()}};
}

/** Makes standing icebergs at equal distances on a circle. */
Scenario ring(int icebergs, double radius_m)
{
    Scenario s = test::emptySea();
    s.fovShape = FovShape::Disk; // The view reaches 300 m.
    for (int i = 0; i < icebergs; ++i) {
        const double angle_rad = 2 * 3.14159265358979 * i / icebergs;
        test::addIceberg(s, radius_m * std::cos(angle_rad), radius_m * std::sin(angle_rad));
    }
    return s;
}

} // namespace

class TestVisitZones : public QObject
{
    Q_OBJECT
private slots:
    void legsAreNoLongerThanFlights_data();
    void legsAreNoLongerThanFlights();
    void standingLegsAreExact();
    void zonesFitTheLegs();
    void equalDistances();
    void overlappingViewsAreOneGroup();
    void nearPairsAreMerged();
};

void TestVisitZones::legsAreNoLongerThanFlights_data()
{
    QTest::addColumn<FovShape>("shape");
    QTest::addColumn<Point>("wind_mps");
    QTest::newRow("body") << FovShape::Body << Point(0, 0);
    QTest::newRow("body, wind") << FovShape::Body << Point(6, -9);
    QTest::newRow("north, wind") << FovShape::North << Point(-11, 3);
    QTest::newRow("disk, storm") << FovShape::Disk << Point(17, -16);
}

/**
 * No flight from a view of one iceberg to a view of another, at any instants, is shorter than the
 * leg.
 */
void TestVisitZones::legsAreNoLongerThanFlights()
{
    QFETCH(FovShape, shape);
    QFETCH(Point, wind_mps);
    Random random(3);
    for (int seed = 1; seed <= 4; ++seed) {
        Scenario s =
            randomScenario(seed, {.icebergs = 5, .size_m = Point(5000, 4000), .speedMax_mps = 1.5});
        s.duration_s = 800;
        s.fovShape = shape;
        s.wind_mps = wind_mps;
        s.uavs[0].fov_m = {400, 700};
        s.uavs.push_back(s.uavs[0]);
        s.uavs[1].fov_m = {600, 300};
        s.uavs[1].spec.airspeed_mps = 25;
        const LegTimes legs = legsOf(s);
        std::vector<std::vector<Point>> truth_m; // True positions, by iceberg and second.
        for (const Iceberg& iceberg : s.icebergs) {
            DriftModel drift({.position_m = iceberg.position_m,
                              .velocity_mps = iceberg.velocity_mps,
                              .q_m2ps = iceberg.q_m2ps},
                             static_cast<std::uint64_t>(s.seed), iceberg.id, s.noise);
            truth_m.emplace_back();
            for (int k = 0; k <= 800; ++k)
                truth_m.back().push_back(drift.position_m(k));
        }
        const auto place_m = [&](const Uav& uav, std::size_t iceberg, double time_s) -> Point {
            const double angle_rad = random.uniform(0, 6.2832);
            const Point unit(std::cos(angle_rad), std::sin(angle_rad));
            const Point off_m = shape == FovShape::Body ? Point(unit * (uav.fov_m.norm() / 2))
                                : shape == FovShape::Disk
                                    ? Point(unit * (uav.fov_m.x() / 2))
                                    : Point(std::copysign(uav.fov_m.y() / 2, unit.x()),
                                            std::copysign(uav.fov_m.x() / 2, unit.y()));
            return truth_m[iceberg][static_cast<std::size_t>(time_s)] + off_m;
        };
        for (int draw = 0; draw < 3000; ++draw) {
            const Uav& uav = s.uavs[random.below(2)];
            const std::size_t a = random.below(5);
            const std::size_t b = (a + 1 + random.below(4)) % 5;
            const double leave_s = std::floor(random.uniform(0, 799));
            const double arrive_s = std::floor(random.uniform(leave_s, 800.99));
            const Point air_m = place_m(uav, b, arrive_s) - place_m(uav, a, leave_s) -
                                wind_mps * (arrive_s - leave_s);
            if (air_m.norm() > uav.spec.airspeed_mps * (arrive_s - leave_s))
                continue; // The UAV cannot be there by then.
            const double leg_s = legs.between_s(static_cast<int>(a), static_cast<int>(b));
            QVERIFY2(leg_s <= arrive_s - leave_s,
                     qPrintable(QString("%1 > %2").arg(leg_s).arg(arrive_s - leave_s)));
        }
    }
}

void TestVisitZones::standingLegsAreExact()
{
    Scenario s = ring(2, 2500);
    const double leg_s = (5000 - 600) / 22.0;
    QVERIFY(std::abs(legsOf(s).between_s(0, 1) - leg_s) < 0.01);
    QCOMPARE(legsOf(s).between_s(1, 0), legsOf(s).between_s(0, 1));
    s.wind_mps = {10, 0}; // The UAV flies with the wind in one direction.
    const double with_s = legsOf(s).between_s(0, 1);
    QVERIFY(with_s <= (5000 - 600) / 32.0);
    QVERIFY(with_s > 0.99 * (5000 - 600) / 32.0);
    const TrueMotion motion(s, {});
    const double first_s = firstLeg_s(s, motion, s.uavs[0], 0, motion.blocks());
    QVERIFY(std::abs(first_s - (2500 - 300) / 32.0) < 0.01);
}

void TestVisitZones::zonesFitTheLegs()
{
    Random random(8);
    for (int seed = 1; seed <= 12; ++seed) {
        const int n = 2 + static_cast<int>(random.below(30));
        const Scenario s = randomScenario(seed, {.icebergs = n,
                                                 .size_m = Point(9000, 9000),
                                                 .speedMax_mps = seed % 2 == 0 ? 0.3 : 0.0});
        std::vector<double> growth;
        for (int i = 0; i < n; ++i)
            growth.push_back(random.uniform(0.001, 0.1));
        const LegTimes legs = legsOf(s);
        const VisitZones zones = visitZones(legs, growth);
        QCOMPARE(zones.groupOf.size(), growth.size());
        double sum = 0;
        std::vector<double> sumOfGroup(zones.radius_s.size(), 0.0);
        for (int i = 0; i < n; ++i) {
            const auto groupOfI =
                static_cast<std::size_t>(zones.groupOf[static_cast<std::size_t>(i)]);
            sumOfGroup[groupOfI] += growth[static_cast<std::size_t>(i)];
            for (int j = 0; j < n; ++j) {
                const auto groupOfJ =
                    static_cast<std::size_t>(zones.groupOf[static_cast<std::size_t>(j)]);
                if (groupOfI != groupOfJ)
                    QVERIFY(zones.radius_s[groupOfI] + zones.radius_s[groupOfJ] <=
                            legs.between_s(i, j));
            }
        }
        for (std::size_t g = 0; g < zones.radius_s.size(); ++g) {
            QVERIFY(zones.radius_s[g] >= 0);
            QVERIFY(std::abs(sumOfGroup[g] - zones.growth_m2ps[g]) < 1e-12);
            sum += std::sqrt(zones.growth_m2ps[g] * zones.radius_s[g]);
        }
        QVERIFY(std::abs(sum - zones.rootSum) < 1e-9);
    }
}

void TestVisitZones::equalDistances()
{
    const Scenario s = ring(3, 3000);
    const std::vector<double> growth(3, 0.025);
    const double leg_s = (3000 * std::sqrt(3.0) - 600) / 22;
    const VisitZones zones = visitZones(legsOf(s), growth);
    QCOMPARE(zones.groups(), 3);
    for (const double radius_s : zones.radius_s)
        QVERIFY(std::abs(radius_s - leg_s / 2) < 1e-3 * leg_s);
}

void TestVisitZones::overlappingViewsAreOneGroup()
{
    Scenario s = ring(3, 3000);
    const Point beside_m = s.icebergs[0].position_m;
    test::addIceberg(s, beside_m.x() + 200, beside_m.y());
    const VisitZones zones = visitZones(legsOf(s), std::vector<double>(4, 0.025));
    QCOMPARE(zones.groups(), 3);
    QCOMPARE(zones.groupOf[3], zones.groupOf[0]);
    QVERIFY(*std::ranges::min_element(zones.radius_s) > 0);
    const VisitZones one = visitZones(legsOf(ring(4, 200)), std::vector<double>(4, 0.025));
    QCOMPARE(one.rootSum, 0.0);
}

/** Two near icebergs get one zone, two far apart get two. */
void TestVisitZones::nearPairsAreMerged()
{
    Scenario s = ring(3, 6000);
    const Point beside_m = s.icebergs[0].position_m;
    test::addIceberg(s, beside_m.x() + 700, beside_m.y()); // The leg is 100 m.
    QCOMPARE(visitZones(legsOf(s), std::vector<double>(4, 0.025)).groups(), 3);
}

QTEST_APPLESS_MAIN(TestVisitZones)

#include "tst_visit_zones.moc"
