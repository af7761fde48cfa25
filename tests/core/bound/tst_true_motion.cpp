#include "core/bound/true_motion.h"
#include "core/mission/mission.h"
#include "core/presets/presets.h"
#include "tests/support/flight/scenario_builder.h"

#include <QtTest>

using namespace berg;

class TestTrueMotion : public QObject
{
    Q_OBJECT
private slots:
    void blocksOfSteps();
    void holdsWhatIsFlown_data();
    void holdsWhatIsFlown();
    void standingIsAPoint();
};

void TestTrueMotion::blocksOfSteps()
{
    Scenario s = randomScenario(1);
    const TrueMotion motion(s, {});
    QCOMPARE(motion.blocks(), 2000);
    QCOMPARE(motion.edgeStep(2000), std::int64_t{10000});
    s.duration_s = 7;
    QCOMPARE(TrueMotion(s, {}).blocks(), 70);
}

void TestTrueMotion::holdsWhatIsFlown_data()
{
    QTest::addColumn<double>("duration_s");
    QTest::addColumn<double>("q_m2ps");
    QTest::newRow("blocks of less than a second") << 300.0 << 0.025;
    QTest::newRow("blocks of seconds, much noise") << 5000.0 << 100.0;
}

void TestTrueMotion::holdsWhatIsFlown()
{
    QFETCH(double, duration_s);
    QFETCH(double, q_m2ps);
    Scenario s = randomScenario(4, {.icebergs = 3, .q_m2ps = q_m2ps});
    s.duration_s = duration_s;
    s.dt_s = 0.5;
    s.current_mps = {0.7, -0.3};
    for (int k = 0; k < 6; ++k) {
        s.icebergs[1].track.time_s.push_back(57.3 * k + 10);
        s.icebergs[1].track.position_m.emplace_back(100.0 * k * k, -300.0 * k);
    }
    const TrueMotion motion(s, {});
    Mission mission(s, {.record = false});
    const Point velocity_mps(0.5, 0.2);
    for (int edge = 0; edge + 100 <= motion.blocks(); edge += 100)
        while (mission.simulation().time_s() < motion.edge_s(edge + 100)) {
            mission.advance(mission.simulation().time_s() + 4 * s.dt_s);
            if (mission.simulation().time_s() > motion.edge_s(edge + 100))
                break;
            const double since_s = mission.simulation().time_s() - motion.edge_s(edge);
            for (int i = 0; i < 3; ++i) {
                const Circle e = motion.enclosure(i, edge, edge + 100, velocity_mps);
                const Point inFrame_m =
                    mission.simulation().truth_m(IcebergIndex::of(i)) - velocity_mps * since_s;
                QVERIFY((inFrame_m - e.centre_m).norm() <= e.radius_m + 1e-6);
            }
        }
}

void TestTrueMotion::standingIsAPoint()
{
    Scenario s = test::emptySea();
    test::addIceberg(s, 100, 200);
    s.current_mps = {1, 2};
    const Circle e = TrueMotion(s, {}).enclosure(0, 0, 2000, s.current_mps);
    QVERIFY(e.radius_m < 1e-9);
    QVERIFY((e.centre_m - Point(100, 200)).norm() < 1e-9);
}

QTEST_APPLESS_MAIN(TestTrueMotion)

#include "tst_true_motion.moc"
