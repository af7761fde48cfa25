#include "core/io/import/fields/import_time.h"

#include <QtTest>

using namespace berg;

class TestImportTime : public QObject
{
    Q_OBJECT

private slots:
    void timesAreReadAsWritten_data()
    {
        QTest::addColumn<QByteArray>("utc"); ///< empty if it cannot be read
        const auto row = [](const char* text, const char* utc) {
            QTest::newRow(text) << QByteArray(utc);
        };
        row("1997-08-16 07:07:00+00:00", "1997-08-16T07:07:00Z");
        row("1997-08-16T07:07:00Z", "1997-08-16T07:07:00Z");
        row("1997-08-16T07:07:00.25Z", "1997-08-16T07:07:00.250Z");
        row("1997-08-16 07:07:00,5", "1997-08-16T07:07:00.500Z");
        row("1997-08-16 01:07+02:00", "1997-08-15T23:07:00Z");
        row("1997-08-16 23:07-0330", "1997-08-17T02:37:00Z");
        row("1997-08-16 23:07 +02", "1997-08-16T21:07:00Z");
        row("1997-08-16 07:07 UTC", "1997-08-16T07:07:00Z");
        row(" 1997-08-16 ", "1997-08-16T00:00:00Z");
        row("1997/8/6 7:07", "1997-08-06T07:07:00Z");
        row("19970816", "1997-08-16T00:00:00Z");
        row("19970816T0707Z", "1997-08-16T07:07:00Z");
        row("1997228", "1997-08-16T00:00:00Z");
        row("2020366", "2020-12-31T00:00:00Z");
        row("06/02/2021 1641", "2021-06-02T16:41:00Z");
        row("6/2/21 5", "2021-06-02T00:05:00Z");
        row("6/2/99 905", "1999-06-02T09:05:00Z");
        row("06-02-2021 0", "2021-06-02T00:00:00Z");
        row("02.06.2021 16:41", "2021-06-02T16:41:00Z");
        row("2-Jun-21", "2021-06-02T00:00:00Z");
        row("29 Nov 2026 12:00", "2026-11-29T12:00:00Z");
        row("2 june 2021 1200Z", "2021-06-02T12:00:00Z");
        row("02-JUNE-2021 4:05 PM", "2021-06-02T16:05:00Z");
        row("6/2/2021 12:05 AM", "2021-06-02T00:05:00Z");
        row("6/2/2021 12:05 pm", "2021-06-02T12:05:00Z");
        row("2024-02-29", "2024-02-29T00:00:00Z");
        row("2021-06-02 24:00", "2021-06-03T00:00:00Z");
        row("2021-06-02 12:00:60", "2021-06-02T12:01:00Z");
        row("20080909T133622Z", "2008-09-09T13:36:22Z");
        row("2008-09-09T133622.5+0230", "2008-09-09T11:06:22.500Z");
        row("2008-09-09T13:36:22.123456789-00:00", "2008-09-09T13:36:22.123Z");

        for (const char* bad : {"",
                                "yesterday",
                                "2023-02-29",
                                "04/31/2021 900",
                                "13/13/2021",
                                "2021-06",
                                "2021-06-02 24:01",
                                "2021-06-02 12:00:61",
                                "0000-00-00T00:00:00Z",
                                "2021-06-02 2460",
                                "2021-06-02 12:60",
                                "2021-06-02 12:00 xyz",
                                "2021-06-02 12:00Zjunk",
                                "2021-06-02 13:05 PM",
                                "2021-06-02 12:00+99",
                                "2021366",
                                "2021000",
                                "1/2/123",
                                "0001-01-01",
                                "9999-01-01",
                                "99999999999999999999",
                                "1-2-3-4",
                                "2021-06-02 12:00+",
                                "NaN",
                                "-1",
                                "2021-06-02 12345"})
            row(bad, "");
    }

    void timesAreReadAsWritten()
    {
        QFETCH(QByteArray, utc);
        const std::optional<UtcTime> time =
            parseSightingTime(QTest::currentDataTag(), DateOrder::MonthFirst);
        QCOMPARE(time.has_value(), !utc.isEmpty());
        if (time)
            QCOMPARE(QByteArray::fromStdString(utcText(*time, 0)), utc);
    }

    void datesMayHaveTheDayFirst()
    {
        const std::optional<UtcTime> time = parseSightingTime("03/04/2021", DateOrder::DayFirst);
        QVERIFY(time);
        QCOMPARE(utcText(*time, 0), std::string("2021-04-03T00:00:00Z"));
        QVERIFY(!parseSightingTime("04/31/2021", DateOrder::DayFirst));
        QVERIFY(!parseTypedTime("03/04/2021"));
        QVERIFY(parseTypedTime("13/04/2021") == parseTypedTime("2021-04-13"));
    }

    void timesOfDayAreRead()
    {
        QVERIFY(parseTimeOfDay("1200Z") == std::chrono::hours(12));
        QVERIFY(parseTimeOfDay("12:30 UTC") == std::chrono::minutes(750));
        QVERIFY(!parseTimeOfDay("2026-11-29"));
        QVERIFY(!parseTimeOfDay("noon"));
        QVERIFY(!parseTimeOfDay(""));
    }

    void zonesAreRead_data()
    {
        QTest::addColumn<int>("minutes"); // ahead of UTC; −9999 means no offset
        QTest::newRow("UTC") << 0;
        QTest::newRow("z") << 0;
        QTest::newRow("GMT+1") << 60;
        QTest::newRow("UTC-03:30") << -210;
        QTest::newRow("+0545") << 345;
        QTest::newRow(" -3 ") << -180;
        QTest::newRow("EST") << -9999;
        QTest::newRow("America/St_Johns") << -9999;
        QTest::newRow("2") << -9999;
        QTest::newRow("+15") << -9999;
        QTest::newRow("") << -9999;
    }

    void zonesAreRead()
    {
        QFETCH(int, minutes);
        const auto zone = parseZone(QTest::currentDataTag());
        QCOMPARE(zone ? static_cast<int>(zone->count()) : -9999, minutes);
    }

    void orderIsThatOfAnUnambiguousDate()
    {
        QVERIFY(dateOrderOf("31/12/2015 23:59") == DateOrder::DayFirst);
        QVERIFY(dateOrderOf("12/31/2015") == DateOrder::MonthFirst);
        QVERIFY(!dateOrderOf("06/02/2021"));
        QVERIFY(!dateOrderOf("31/31/2015"));
        QVERIFY(!dateOrderOf("2015-12-31"));
        QVERIFY(!dateOrderOf(""));
    }
};

QTEST_APPLESS_MAIN(TestImportTime)
#include "tst_import_time.moc"
