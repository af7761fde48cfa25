#include "core/scenario/ice_chart.h"

#include <QtTest>

using namespace berg;

/** Tests of concentrations, classes and ages of ice charts. */
class TestIceChart : public QObject
{
    Q_OBJECT

private slots:
    void codesOfSigridAreTenths_data()
    {
        QTest::addColumn<int>("code");
        QTest::addColumn<double>("tenths"); // −1 means no value
        const auto row = [](int code, double tenths) {
            QTest::addRow("%d", code) << code << tenths;
        };
        row(0, 0);
        row(55, 0);
        row(1, 0.5);
        row(2, 0.5);
        row(10, 1);
        row(12, 1.5);
        row(13, 2);
        row(46, 5);
        row(78, 7.5);
        row(79, 8);
        row(81, 9);
        row(89, 8.5);
        row(90, 9);
        row(91, 9.5);
        row(92, 10);
        for (const int code : {-9, 3, 9, 11, 43, 93, 98, 99, 100})
            row(code, -1);
    }

    void codesOfSigridAreTenths()
    {
        QFETCH(int, code);
        QFETCH(double, tenths);
        QCOMPARE(tenthsOfSigrid(code).value_or(-1), tenths);
    }

    void everyCodeHasTheClassOfItsLegend()
    {
        const auto classAt = [](std::optional<double> tenths, bool isFast = false) {
            return classOf({.concentration_tenths = tenths, .isFast = isFast});
        };
        QCOMPARE(classAt(0), IceClass::IceFree);
        QCOMPARE(classAt(0.5), IceClass::OpenWater);
        QCOMPARE(classAt(1), IceClass::VeryOpen);
        QCOMPARE(classAt(3.5), IceClass::VeryOpen);
        QCOMPARE(classAt(4), IceClass::Open);
        QCOMPARE(classAt(6.5), IceClass::Open);
        QCOMPARE(classAt(7), IceClass::Close);
        QCOMPARE(classAt(8.5), IceClass::Close);
        QCOMPARE(classAt(9), IceClass::VeryClose);
        QCOMPARE(classAt(10), IceClass::VeryClose);
        QCOMPARE(classAt(10, true), IceClass::Fast);
        QCOMPARE(classAt({}), IceClass::Unknown);
        QCOMPARE(wmoColour(IceClass::VeryClose), 0xFF0000U);
    }

    void ageNeedsBothTimes()
    {
        const IceChart chart{.dateUtc = "2021-01-18T18:00:00Z"};
        QCOMPARE(ageOf_s(chart, "2021-01-19T18:00:30Z"), std::optional(86430.0));
        QCOMPARE(ageOf_s(chart, "2021-01-18T17:00Z"), std::optional(-3600.0));
        QVERIFY(!ageOf_s(chart, ""));
        QVERIFY(!ageOf_s({}, "2021-01-18T17:00Z"));
    }
};

QTEST_APPLESS_MAIN(TestIceChart)
#include "tst_ice_chart.moc"
