#include "core/base/angles.h"
#include "core/earth/magnetic_field.h"
#include "tests/support/approx.h"

#include <QFile>

#include <array>

using namespace berg;
using namespace Qt::StringLiterals;

/** Compares the World Magnetic Model with the test values published by NOAA. */
class TestMagneticField : public QObject
{
    Q_OBJECT

private slots:
    void publishedValues()
    {
        QFile file(QStringLiteral(BERG_TEST_DATA "/magnetic/wmm2025_test_values.csv"));
        QVERIFY(file.open(QIODevice::ReadOnly));
        file.readLine(); // header line
        int values = 0;
        while (!file.atEnd()) {
            std::array<double, 8> row{};
            const QByteArrayList cells = file.readLine().trimmed().split(',');
            QCOMPARE(cells.size(), qsizetype(row.size()));
            for (qsizetype i = 0; i < cells.size(); ++i)
                row[static_cast<std::size_t>(i)] = cells[i].toDouble();
            const auto [year, height_km, latitude, longitude, north, east, down, declination] = row;
            const LatLon place{.latitude_deg = latitude, .longitude_deg = longitude};
            const auto field = magneticField(place, 1000 * height_km, year);
            QVERIFY(field);
            // NOAA uses other recurrences, which agree to 0.001 nT of 60,000.
            COMPARE_NEAR(field->north_nanotesla, north, 1e-3);
            COMPARE_NEAR(field->east_nanotesla, east, 1e-3);
            COMPARE_NEAR(-field->up_nanotesla, down, 1e-3);
            // Printed with two decimals.
            const double angle_deg =
                degFromRad(std::atan2(field->east_nanotesla, field->north_nanotesla));
            COMPARE_NEAR(std::remainder(angle_deg - declination, 360), 0, 0.00501);
            ++values;
        }
        QCOMPARE(values, 100);
    }

    void onlyInItsYears()
    {
        const LatLon bonavista{.latitude_deg = 48.65, .longitude_deg = -53.1};
        QVERIFY(!magneticDeclination_deg(bonavista, 2024.999));
        QVERIFY(magneticDeclination_deg(bonavista, 2025));
        QVERIFY(!magneticDeclination_deg(bonavista, 2030));
        QVERIFY(!magneticDeclination_deg(bonavista, std::nan("")));
        COMPARE_NEAR(*magneticDeclination_deg(bonavista, 2026.9), -16.7, 0.05); // west of north
    }

    /** Near the magnetic pole of 2025, 85.76 N, 139.3 E, a compass points nowhere. */
    void notInTheBlackoutZone()
    {
        QVERIFY(!magneticDeclination_deg({.latitude_deg = 85.76, .longitude_deg = 139.3}, 2025));
        QVERIFY(magneticDeclination_deg({.latitude_deg = 78, .longitude_deg = 5}, 2026));
    }
};

QTEST_APPLESS_MAIN(TestMagneticField)
#include "tst_magnetic_field.moc"
