#include "core/link/battery_trend.h"

#include <QtTest>

#include <cmath>

using namespace berg;

namespace {

/** A charge in whole per cent, as autopilots report it. */
AircraftBattery charge(double time_s, double remaining)
{
    return {.remaining = std::round(100 * remaining) / 100, .received_s = time_s};
}

} // namespace

class TestBatteryTrend : public QObject
{
    Q_OBJECT

private slots:
    void reportedTimeRunsOn()
    {
        BatteryTrend trend;
        QVERIFY(!trend.left_s(0));
        trend.add({.remaining = 0.5, .timeRemaining_s = 600.0, .received_s = 10});
        QCOMPARE(trend.left_s(10).value(), 600.0);
        QCOMPARE(trend.left_s(40).value(), 570.0); // contact is lost
        QCOMPARE(trend.left_s(4000).value(), 0.0);
        QVERIFY(!trend.isComputed());
    }

    void timeFollowsFromTheCharge()
    {
        BatteryTrend trend;
        double time_s = 0;
        for (; time_s <= 30; ++time_s)
            trend.add(charge(time_s, 0.9 - time_s / 2000));
        QVERIFY(!trend.left_s(time_s)); // too early to say
        for (; time_s <= 900; ++time_s)
            trend.add(charge(time_s, 0.9 - time_s / 2000));
        // Empty after 1800 s; charges are rounded to 1 % of 2000 s.
        QVERIFY(std::abs(trend.left_s(900).value() - 900) < 20);
        QVERIFY(std::abs(trend.left_s(1000).value() - 800) < 20);
        QVERIFY(trend.isComputed());
    }

    /** Ten minutes count, so that a headwind leg shows soon. */
    void theLastMinutesCount()
    {
        BatteryTrend trend;
        for (double time_s = 0; time_s <= 1000; ++time_s)
            trend.add(charge(time_s, 1 - time_s / 10'000));
        for (double time_s = 1000; time_s <= 1700; ++time_s)
            trend.add(charge(time_s, 0.9 - (time_s - 1000) / 1000));
        QVERIFY(std::abs(trend.left_s(1700).value() - 200) < 20);
    }

    void anotherBatteryBeginsAnew()
    {
        BatteryTrend trend;
        for (double time_s = 0; time_s <= 500; ++time_s)
            trend.add(charge(time_s, 0.5 - time_s / 2000));
        QVERIFY(trend.left_s(500));
        trend.add(charge(560, 1));
        QVERIFY(!trend.left_s(560));
    }

    void steadyChargeSaysNothing()
    {
        BatteryTrend trend;
        for (double time_s = 0; time_s <= 500; ++time_s)
            trend.add(charge(time_s, 0.8));
        QVERIFY(!trend.left_s(500));
    }
};

QTEST_APPLESS_MAIN(TestBatteryTrend)
#include "tst_battery_trend.moc"
