#include "core/io/import/forecast/cf_time.h"
#include "core/scenario/utc_time.h"

#include <QTest>

using namespace berg;

class TestCfTime : public QObject
{
    Q_OBJECT

private slots:
    void timesAreRead_data()
    {
        QTest::addColumn<QString>("unit");
        QTest::addColumn<QString>("calendar");
        QTest::addColumn<double>("value");
        QTest::addColumn<QString>("time");
        const auto row = [](const char* unit, const char* calendar, double value,
                            const char* time) {
            QTest::addRow("%s %s", unit, calendar)
                << QString(unit) << QString(calendar) << value << QString(time);
        };
        row("hours since 2026-05-01 00:00:00", "", 6, "2026-05-01T06:00:00Z");
        row("hours since 1950-01-01", "standard", 669144, "2026-05-03T00:00:00Z");
        row("seconds since 1970-01-01T00:00:00Z", "gregorian", 1777593600, "2026-05-01T00:00:00Z");
        row("Days since 2026-05-01 12:00", "proleptic_gregorian", 0.5, "2026-05-02T00:00:00Z");
        row("minutes since 2026-05-01 00:00:00.0 UTC", "", 90, "2026-05-01T01:30:00Z");
        row("hours since 2026-05-01 00:00:00 +02:00", "", 0, "2026-04-30T22:00:00Z");
        row("hours since 2026-5-1 00:00:00 -0130", "", 0, "2026-05-01T01:30:00Z");
        // The Julian 0001-01-01 is the Gregorian 0000-12-30.
        row("days since 0001-01-01 00:00:00", "standard", 739738, "2026-05-01T00:00:00Z");
        row("days since 0001-01-01 00:00:00", "proleptic_gregorian", 739738,
            "2026-05-03T00:00:00Z");
    }
    void timesAreRead()
    {
        QFETCH(QString, unit);
        QFETCH(QString, calendar);
        QFETCH(double, value);
        QFETCH(QString, time);
        const auto read = cfTimeUnit(unit.toStdString(), calendar.toStdString());
        QVERIFY(read);
        const auto instant = cfTime(*read, value);
        QVERIFY(instant);
        QCOMPARE(QString::fromStdString(utcText(*instant, 0)), time);
    }

    void otherTextsAreRejected()
    {
        for (const char* const unit :
             {"", "hours", "hours since", "hours since now", "months since 2026-01-01",
              "hours since 2026-13-01", "hours since 2026-02-30", "hours since 2026-05-01 25:61",
              "hours since 2026-05-01 00:00:00 EST", "m s-1",
              "hours since 99999999999999999999-01-01"})
            QVERIFY2(!cfTimeUnit(unit, ""), unit);
        for (const char* const calendar : {"360_day", "noleap", "julian", "none", "x"})
            QVERIFY2(!cfTimeUnit("hours since 2026-05-01", calendar), calendar);
        const auto unit = cfTimeUnit("days since 2026-05-01", "");
        QVERIFY(!cfTime(*unit, std::numeric_limits<double>::quiet_NaN()));
        QVERIFY(!cfTime(*unit, 1e300));
        QVERIFY(!cfTime(*unit, 1e6));
    }
};

QTEST_APPLESS_MAIN(TestCfTime)
#include "tst_cf_time.moc"
