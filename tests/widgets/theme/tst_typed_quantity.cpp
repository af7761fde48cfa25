#include "tests/support/approx.h"
#include "widgets/theme/typed_quantity.h"

#include <QtTest>

using namespace berg;
using namespace Qt::StringLiterals;

class TestTypedQuantity : public QObject
{
    Q_OBJECT

private slots:
    void clockValues_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<double>("time_s"); // negative: no time
        QTest::newRow("seconds") << u"90"_s << 90.0;
        QTest::newRow("minutes") << u"3:20"_s << 200.0;
        QTest::newRow("hours") << u" 1:02:05 "_s << 3725.0;
        QTest::newRow("tenths") << u"0:01.5"_s << 1.5;
        QTest::newRow("decimal comma") << u"0:01,5"_s << 1.5;
        QTest::newRow("many minutes") << u"90:00"_s << 5400.0;
        QTest::newRow("sixty seconds") << u"1:60"_s << -1.0;
        QTest::newRow("negative") << u"-5"_s << -1.0;
        QTest::newRow("words") << u"soon"_s << -1.0;
        QTest::newRow("nothing") << QString() << -1.0;
        QTest::newRow("half") << u"3:"_s << -1.0;
        QTest::newRow("days") << u"1:1:1:1"_s << -1.0;
        QTest::newRow("infinite") << u"inf"_s << -1.0;
        QTest::newRow("min") << u"45 min"_s << 2700.0;
        QTest::newRow("touching") << u"45min"_s << 2700.0;
        QTest::newRow("hours by name") << u"2 h"_s << 7200.0;
        QTest::newRow("half an hour") << u"0,5 h"_s << 1800.0;
        QTest::newRow("mixed") << u"1 h 30 min"_s << 5400.0;
        QTest::newRow("no time") << u"15 kn"_s << -1.0;
    }

    void clockValues()
    {
        QFETCH(QString, text);
        QFETCH(double, time_s);
        QCOMPARE(clockValue(text).value_or(-1), time_s);
    }

    void typedDurationsAreRead_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<double>("duration_s"); // negative: none
        QTest::newRow("hours and minutes") << u"0:45"_s << 2700.0;
        QTest::newRow("with seconds") << u"1:02:05"_s << 3725.0;
        QTest::newRow("number") << u"2"_s << 120.0;
        QTest::newRow("unit") << u"90 s"_s << 90.0;
        QTest::newRow("sixty minutes") << u"0:60"_s << -1.0;
    }

    void typedDurationsAreRead()
    {
        QFETCH(QString, text);
        QFETCH(double, duration_s);
        QCOMPARE(durationValue(text, 60, QLocale::c()).value_or(-1), duration_s);
    }

    void otherUnits_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("unit");
        QTest::addColumn<double>("value"); // NaN: cannot be read
        QTest::newRow("own") << u"22 m/s"_s << u" m/s"_s << 22.0;
        QTest::newRow("none") << u"22"_s << u" m/s"_s << 22.0;
        QTest::newRow("knots") << u"15 kn"_s << u" m/s"_s << 15 * 1852.0 / 3600;
        QTest::newRow("kts") << u"15KTS"_s << u" m/s"_s << 15 * 1852.0 / 3600;
        QTest::newRow("knots in knots") << u"15 kt"_s << u" kn"_s << 15.0;
        QTest::newRow("nautical miles") << u"1.5 nmi"_s << u" m"_s << 2778.0;
        QTest::newRow("comma") << u"1,5 NM"_s << u" m"_s << 2778.0;
        QTest::newRow("feet") << u"120 ft"_s << u" m"_s << 36.576;
        QTest::newRow("thousands") << u"1 000 m"_s << u" km"_s << 1.0;
        QTest::newRow("narrow space") << u"1\u202f000 m"_s << u" km"_s << 1.0;
        QTest::newRow("minus sign") << u"\u22125 °C"_s << u" °C"_s << -5.0;
        QTest::newRow("clock in hours") << u"0:45:00"_s << u" h"_s << 0.75;
        QTest::newRow("percent") << u"20%"_s << u" %"_s << 20.0;
        QTest::newRow("degrees") << u"45 deg"_s << u"°"_s << 45.0;
        QTest::newRow("another quantity") << u"15 kn"_s << u" m"_s << qQNaN();
        QTest::newRow("two numbers") << u"15 16"_s << u" m"_s << qQNaN();
        QTest::newRow("words") << u"fast"_s << u" m/s"_s << qQNaN();
        QTest::newRow("unit alone") << u"kn"_s << u" m/s"_s << qQNaN();
        QTest::newRow("of no unit") << u"1.25"_s << QString() << 1.25;
    }

    void otherUnits()
    {
        QFETCH(QString, text);
        QFETCH(QString, unit);
        QFETCH(double, value);
        const std::optional<double> read = typedNumber(text, unit, QLocale::c());
        QCOMPARE(read.has_value(), !qIsNaN(value));
        if (read)
            COMPARE_NEAR(*read, value, 1e-9 * std::max(1.0, std::abs(value))); // rounding
    }
};

QTEST_APPLESS_MAIN(TestTypedQuantity)
#include "tst_typed_quantity.moc"
