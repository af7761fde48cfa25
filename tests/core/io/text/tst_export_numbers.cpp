#include "core/io/text/export_numbers.h"

#include <QTest>

#include <cmath>

using namespace berg;

class TestExportNumbers : public QObject
{
    Q_OBJECT

private slots:
    void longitudeStaysBelow180_data()
    {
        QTest::addColumn<double>("longitude_deg");
        QTest::addColumn<double>("expected_deg");
        QTest::newRow("nine decimals") << -48.0065746551516 << -48.006574655;
        QTest::newRow("rounded to the antimeridian") << 179.9999999999 << -180.0;
        QTest::newRow("west of it") << 179.999999999 << 179.999999999;
        QTest::newRow("the antimeridian") << 180.0 << -180.0;
        QTest::newRow("east of it") << -179.9999999999 << -180.0;
    }

    void longitudeStaysBelow180()
    {
        QFETCH(double, longitude_deg);
        QFETCH(double, expected_deg);
        const LatLon place = roundedPlace({.latitude_deg = 90, .longitude_deg = longitude_deg});
        QVERIFY(place.longitude_deg == expected_deg);
        QVERIFY(place.latitude_deg == 90);
    }

    void zeroIsNeverNegative()
    {
        QVERIFY(!std::signbit(roundedDegrees(-1e-12)));
        QVERIFY(!std::signbit(roundedDegrees(-0.0)));
        QVERIFY(!std::signbit(roundedSeconds(-0.0)));
    }

    void secondsHideTheRoundingOfSteps()
    {
        QVERIFY(roundedSeconds(3 * 0.1) == 0.3);
        QVERIFY(roundedSeconds(604800.0001) == 604800);
    }
};

QTEST_APPLESS_MAIN(TestExportNumbers)
#include "tst_export_numbers.moc"
