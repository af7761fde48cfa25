#include "core/base/angles.h"
#include "core/base/random.h"
#include "core/vehicle/tangent_turn.h"

#include <QTest>

using namespace berg;

namespace {

constexpr double kRadius_m = 100;
constexpr double kSpeed_mps = 20;

/** Steps the vehicle through the turn, finely enough to be exact to centimetres. */
DubinsState stepped(DubinsState state, double turn_rad)
{
    constexpr int kSteps = 2000;
    const double rate_radps = std::copysign(kSpeed_mps / kRadius_m, turn_rad);
    const double dt_s = turn_rad / rate_radps / kSteps;
    for (int i = 0; i < kSteps; ++i)
        state = step(state, kSpeed_mps, rate_radps, dt_s, Point::Zero());
    return state;
}

double lateral_m(const Pose& line, const Point& p_m)
{
    return line.left().dot(p_m - line.position_m);
}

} // namespace

class TestTangentTurn : public QObject
{
    Q_OBJECT

private slots:
    void lineLeavesTheTargetAtItsOffset()
    {
        Random random(1);
        for (int i = 0; i < 500; ++i) {
            const DubinsState start{
                .position_m = {random.uniform(-50, 50), random.uniform(-50, 50)},
                .psi_rad = random.uniform(-kPi, kPi)};
            const double bearing_rad = random.uniform(-kPi, kPi);
            const Point target_m =
                start.position_m +
                random.uniform(520, 3000) * Point(std::cos(bearing_rad), std::sin(bearing_rad));
            const double offset_m = random.uniform(-300, 300);
            const TangentTurn turn = turnOntoLine(
                poseOf(start), {.target_m = target_m, .offset_m = offset_m}, kRadius_m);
            const Pose flown = poseOf(stepped(start, turn.turn_rad));
            // The chords of 2000 steps fall short of the arc by micrometres.
            QVERIFY((flown.position_m - turn.end.position_m).norm() < 1e-3);
            QVERIFY((flown.ahead - turn.end.ahead).norm() < 1e-9);
            QVERIFY(std::abs(lateral_m(turn.end, target_m) - offset_m) < 1e-6);
            const double along_m = turn.end.ahead.dot(target_m - turn.end.position_m);
            QVERIFY(std::abs(along_m - turn.length_m) < 1e-6);
            QVERIFY(turn.length_m > 0);
        }
    }

    /** Far away, the side on which the line lies never takes half a circle. */
    void turnsToTheNearSide_data()
    {
        QTest::addColumn<double>("north_m");
        QTest::addColumn<double>("offset_m");
        QTest::addColumn<bool>("left");
        QTest::newRow("to the left") << 2000.0 << 0.0 << true;
        QTest::newRow("to the right") << -2000.0 << 0.0 << false;
        QTest::newRow("left of a line to the right") << 100.0 << 200.0 << false;
        QTest::newRow("right of a line to the left") << -100.0 << -200.0 << true;
    }
    void turnsToTheNearSide()
    {
        QFETCH(double, north_m);
        QFETCH(double, offset_m);
        QFETCH(bool, left);
        const TangentTurn turn =
            turnOntoLine(Pose{}, {.target_m = {3000, north_m}, .offset_m = offset_m}, kRadius_m);
        QVERIFY(std::abs(turn.turn_rad) < kPi);
        QCOMPARE(turn.turn_rad > 0, left);
    }

    void straightAheadIsNoTurn()
    {
        const TangentTurn turn = turnOntoLine(Pose{}, {.target_m = {1000, 0}}, kRadius_m);
        QVERIFY(std::abs(turn.turn_rad) < 1e-9);
        QCOMPARE(turn.length_m, 1000.0);
        // The UAV is on the line already, the target beside it.
        const TangentTurn beside =
            turnOntoLine(Pose{}, {.target_m = {1000, -250}, .offset_m = -250}, kRadius_m);
        QVERIFY(std::abs(beside.turn_rad) < 1e-9);
        QCOMPARE(beside.length_m, 1000.0);
    }

    /**
     * The target is inside the left circle: there is no tangent from there, so the turn goes in
     * the opposite direction.
     */
    void targetInsideTheCircleTurnsTheOtherWay()
    {
        const Point centre_m(0, kRadius_m);
        const TangentTurn turn = turnOntoLine(Pose{}, {.target_m = centre_m}, kRadius_m);
        QVERIFY(turn.turn_rad < -kPi);
        QVERIFY(std::abs(lateral_m(turn.end, centre_m)) < 1e-9);
    }

    /**
     * No tangent from either circle fits: the line passes as far off as possible, with a valid
     * pose.
     */
    void offsetOutOfReach()
    {
        const TangentTurn turn =
            turnOntoLine(Pose{}, {.target_m = {50, 0}, .offset_m = 300}, kRadius_m);
        QCOMPARE(turn.length_m, 0.0);
        QVERIFY(std::abs(turn.end.ahead.norm() - 1) < 1e-12);
        QVERIFY(turn.end.position_m.allFinite());
    }
};

QTEST_APPLESS_MAIN(TestTangentTurn)
#include "tst_tangent_turn.moc"
