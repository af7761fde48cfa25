#include "core/world/cameras.h"

#include <QTest>

using namespace berg;

/** Fields of view of the UAVs. */
class TestCameras : public QObject
{
    Q_OBJECT

private slots:
    /** A UAV on the ground has nothing in view and so loses no iceberg. */
    void seesNothingOnTheGround()
    {
        Cameras cameras(std::nullopt, {0, 0});
        cameras.add({});
        const Point place_m(20, 10);
        cameras.setPose(0, {}, FlightMode::Leg);
        QCOMPARE(cameras.viewer(place_m), std::optional(0));
        QCOMPARE(firstWith(cameras.views(), place_m), std::optional(0));
        QCOMPARE(firstWith(cameras.middles(), place_m), std::optional(0));
        cameras.setPose(0, {}, FlightMode::Ground);
        QVERIFY(!cameras.viewer(place_m));
        QVERIFY(!firstWith(cameras.views(), place_m));
        QVERIFY(!firstWith(cameras.middles(), place_m));
    }

    /**
     * An iceberg near the edge of the view is tested in the next step, one far away when they may
     * have met.
     */
    void stepsUntilAnIcebergMayComeIntoView()
    {
        Cameras cameras(std::nullopt, {3, 4});
        cameras.add({.airspeed_mps = 20});
        constexpr double kIcebergSpeed_mps = 5;
        constexpr double kStep_s = 0.1;
        const Camera& camera = cameras.of(0);
        const auto steps = [&](double away_m) {
            return static_cast<int>(
                cameras.stepsOutOfReach({away_m, 0}, kIcebergSpeed_mps, kStep_s));
        };
        QCOMPARE(steps(camera.reach_m - 1), 1);
        QCOMPARE(steps(camera.reach_m + 2), 1);
        QCOMPARE(steps(camera.reach_m + 301.5), 100); // 300 m and the margin, 30 m/s together
        cameras.add({.airspeed_mps = 20, .pose = {.position_m = {camera.reach_m + 301.5, 0}}});
        QCOMPARE(steps(camera.reach_m + 301.5), 1);
    }
};

QTEST_APPLESS_MAIN(TestCameras)
#include "tst_cameras.moc"
