#include "widgets/theme/quantity_text.h"

#include <QtTest>

#include <cmath>
#include <limits>

using namespace berg;
using namespace Qt::StringLiterals;

namespace {

const QLocale kEnglish(QLocale::English, QLocale::UnitedStates);
const QLocale kNorwegian(QLocale::NorwegianBokmal, QLocale::Norway);

} // namespace

class TestQuantityText : public QObject
{
    Q_OBJECT

private slots:
    void fixedTextHasDecimalsAndGroups_data()
    {
        QTest::addColumn<double>("value");
        QTest::addColumn<int>("decimals");
        QTest::addColumn<QString>("english");
        QTest::addColumn<QString>("norwegian");
        QTest::newRow("small") << 0.25 << 2 << u"0.25"_s << u"0,25"_s;
        QTest::newRow("no group") << 999.0 << 0 << u"999"_s << u"999"_s;
        QTest::newRow("group") << 1000.0 << 0 << u"1\u202f000"_s << u"1\u202f000"_s;
        QTest::newRow("groups and decimals")
            << 1234567.25 << 1 << u"1\u202f234\u202f567.3"_s << u"1\u202f234\u202f567,3"_s;
        QTest::newRow("zero") << 0.0 << 0 << u"0"_s << u"0"_s;
        QTest::newRow("negative without group") << -123.0 << 0 << u"-123"_s << u"\u2212123"_s;
        QTest::newRow("negative with group")
            << -1234.0 << 0 << u"-1\u202f234"_s << u"\u22121\u202f234"_s;
    }

    void fixedTextHasDecimalsAndGroups()
    {
        QFETCH(double, value);
        QFETCH(int, decimals);
        QFETCH(QString, english);
        QFETCH(QString, norwegian);
        QCOMPARE(fixedText(value, decimals, kEnglish), english);
        QCOMPARE(fixedText(value, decimals, kNorwegian), norwegian);
    }

    void significantTextRoundsToDigits_data()
    {
        QTest::addColumn<double>("value");
        QTest::addColumn<int>("digits");
        QTest::addColumn<QString>("text");
        QTest::newRow("rounds whole numbers") << 84423.0 << 4 << u"84\u202f420"_s;
        QTest::newRow("keeps digits") << 1.8532 << 3 << u"1.85"_s;
        QTest::newRow("trailing zero means something") << 2.0 << 3 << u"2.00"_s;
        QTest::newRow("carries over") << 9.996 << 3 << u"10.0"_s;
        QTest::newRow("carries over to a group") << 999.96 << 4 << u"1\u202f000"_s;
        QTest::newRow("small") << 0.01234 << 2 << u"0.012"_s;
        QTest::newRow("zero") << 0.0 << 3 << u"0"_s;
        QTest::newRow("not a number") << std::nan("") << 3 << u"0"_s;
    }

    void significantTextRoundsToDigits()
    {
        QFETCH(double, value);
        QFETCH(int, digits);
        QFETCH(QString, text);
        QCOMPARE(significantText(value, digits, kEnglish), text);
    }

    void clockTextHasMinutesAndHours_data()
    {
        QTest::addColumn<double>("time_s");
        QTest::addColumn<QString>("text");
        QTest::newRow("zero") << 0.0 << u"00:00"_s;
        QTest::newRow("rounded up") << 59.6 << u"01:00"_s;
        QTest::newRow("run of the paper") << 1000.0 << u"16:40"_s;
        QTest::newRow("just under an hour") << 3599.4 << u"59:59"_s;
        QTest::newRow("hours") << 3600.0 << u"1:00:00"_s;
        QTest::newRow("a day") << 90061.0 << u"25:01:01"_s;
        QTest::newRow("negative") << -3.0 << u"00:00"_s;
        QTest::newRow("never") << std::numeric_limits<double>::infinity() << u"∞"_s;
    }

    void clockTextHasMinutesAndHours()
    {
        QFETCH(double, time_s);
        QFETCH(QString, text);
        QCOMPARE(clockText(time_s), text);
    }

    void marginTextHasASignBelowTheReserve()
    {
        QCOMPARE(marginText(750), u"12:30"_s);
        QCOMPARE(marginText(-750), u"−12:30"_s);
        QCOMPARE(marginText(-std::numeric_limits<double>::infinity()), u"not home"_s);
    }

    void lengthsAndTimes()
    {
        QCOMPARE(distanceText(500, kEnglish, 1), u"500 m"_s);
        QCOMPARE(distanceText(999.6, kEnglish), u"1.00 km"_s);
        QCOMPARE(heightsText(0, 2895.6, kEnglish), u"0 m to 2.90 km (0 to 9\u202F500 ft)"_s);
        QCOMPARE(heightsText(120, std::nullopt, kEnglish), u"from 120 m (394 ft)"_s);
        QCOMPARE(distanceText(14230, kNorwegian), u"14,2 km"_s);
        QCOMPARE(sigmaText(8.123, kEnglish), u"8.12 m²"_s);
        QCOMPARE(durationText(30, kEnglish), u"30 s"_s);
        QCOMPARE(durationText(600, kEnglish), u"10 min"_s);
        QCOMPARE(durationText(7200, kEnglish), u"2 h"_s);
    }

    void placeTextHasHemispheres_data()
    {
        QTest::addColumn<double>("angle_deg");
        QTest::addColumn<std::optional<int>>("decimals");
        QTest::addColumn<QString>("latitude");
        QTest::addColumn<QString>("longitude");
        QTest::newRow("minutes") << 47.0533 << std::optional<int>(1) << u"47° 03.2′ N"_s
                                 << u"47° 03.2′ E"_s;
        QTest::newRow("never sixty minutes")
            << 46.99999 << std::optional<int>(1) << u"47° 00.0′ N"_s << u"47° 00.0′ E"_s;
        QTest::newRow("whole minutes")
            << -12.5 << std::optional<int>(0) << u"12° 30′ S"_s << u"12° 30′ W"_s;
        QTest::newRow("whole degrees") << -80.0 << std::optional<int>() << u"80° S"_s << u"80° W"_s;
        QTest::newRow("two decimals")
            << 0.0125 << std::optional<int>(2) << u"0° 00.75′ N"_s << u"0° 00.75′ E"_s;
    }

    void placeTextHasHemispheres()
    {
        QFETCH(double, angle_deg);
        QFETCH(std::optional<int>, decimals);
        QFETCH(QString, latitude);
        QFETCH(QString, longitude);
        QCOMPARE(latitudeText(angle_deg, decimals, kEnglish), latitude);
        QCOMPARE(longitudeText(angle_deg, decimals, kEnglish), longitude);
    }

    void wholeDegreesOfAPlace()
    {
        QCOMPARE(placeText({.latitude_deg = 47.1, .longitude_deg = -48.2}, std::nullopt, kEnglish),
                 u"47° N  48° W"_s);
    }

    void linesBetweenHemispheres()
    {
        QCOMPARE(latitudeText(0, 0, kEnglish), u"0° 00′"_s);
        QCOMPARE(longitudeText(0, std::nullopt, kEnglish), u"0°"_s);
        QCOMPARE(longitudeText(180, std::nullopt, kEnglish), u"180°"_s);
        QCOMPARE(longitudeText(-180, 1, kEnglish), u"180° 00.0′"_s);
        QCOMPARE(longitudeText(179.99, 1, kEnglish), u"179° 59.4′ E"_s);
    }

    void durationsOfFields()
    {
        QCOMPARE(fieldDurationText(0, 2, kEnglish), u"0 s"_s);
        QCOMPARE(fieldDurationText(0.25, 2, kEnglish), u"0.25 s"_s);
        QCOMPARE(fieldDurationText(45, 1, kEnglish), u"45 s"_s);
        QCOMPARE(fieldDurationText(2700, 1, kEnglish), u"45 min"_s);
        QCOMPARE(fieldDurationText(7200, 0, kEnglish), u"120 min"_s);
        QCOMPARE(fieldDurationText(1000, 1, kEnglish), u"0:16:40"_s);
        QCOMPARE(fieldDurationText(3605.5, 1, kEnglish), u"1:00:05.5"_s);
    }
};

QTEST_MAIN(TestQuantityText)
#include "tst_quantity_text.moc"
