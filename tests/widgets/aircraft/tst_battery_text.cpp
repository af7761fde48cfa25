#include "widgets/aircraft/battery_text.h"

#include <QtTest>

using namespace berg;
using namespace Qt::StringLiterals;

class TestBatteryText : public QObject
{
    Q_OBJECT

private slots:
    void oneLineTellsAll()
    {
        BatteryReadout readout{.battery = {.remaining = 0.72, .voltage_v = 15.84},
                               .left_s = 3500,
                               .wayHome_s = 730,
                               .endurance_s = 2640};
        QCOMPARE(batteryText(readout, QLocale::c()),
                 u"72 %, 15.8 V, 58:20 left, way home 12:10, planned endurance left 44:00"_s);
        readout.isComputed = true;
        QVERIFY(batteryText(readout, QLocale::c()).contains(u"about 58:20 left"_s));
        QCOMPARE(batteryText({.battery = {.remaining = 0.5}}, QLocale::c()), u"50 %"_s);
    }

    void shortBatteryWarns()
    {
        QVERIFY(isBatteryShort({.left_s = 300, .wayHome_s = 301}));
        QVERIFY(!isBatteryShort({.left_s = 300, .wayHome_s = 299}));
        QVERIFY(!isBatteryShort({.left_s = 300}));
        QVERIFY(!isBatteryShort({.wayHome_s = 300}));
        QCOMPARE(batteryWarning({.left_s = 300, .wayHome_s = 365}),
                 u"Battery for 05:00, way home 06:05"_s);
    }
};

QTEST_GUILESS_MAIN(TestBatteryText)
#include "tst_battery_text.moc"
