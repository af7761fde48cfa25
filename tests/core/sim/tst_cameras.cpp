#include "core/sim/cameras.h"

#include <QTest>

using namespace berg;

/** What the UAVs can see from where they are. */
class TestCameras : public QObject
{
    Q_OBJECT

private slots:
    /** Nothing is in view of a UAV on the ground, and so nothing should be: it loses no iceberg. */
    void seesNothingOnTheGround()
    {
        Cameras cameras(std::nullopt, {0, 0});
        cameras.add({});
        const Point place_m(20, 10);
        cameras.point(0, {}, FlightMode::Leg);
        QCOMPARE(cameras.viewer(place_m), 0);
        QCOMPARE(firstWith(cameras.views(), place_m), 0);
        QCOMPARE(firstWith(cameras.middles(), place_m), 0);
        cameras.point(0, {}, FlightMode::Ground);
        QCOMPARE(cameras.viewer(place_m), -1);
        QCOMPARE(firstWith(cameras.views(), place_m), -1);
        QCOMPARE(firstWith(cameras.middles(), place_m), -1);
    }
};

QTEST_APPLESS_MAIN(TestCameras)
#include "tst_cameras.moc"
