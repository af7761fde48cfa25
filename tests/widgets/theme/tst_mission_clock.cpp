#include "core/scenario/scenario.h"
#include "tests/support/approx.h"
#include "tests/support/window/panel_test.h"
#include "widgets/theme/mission_clock.h"
#include "widgets/theme/unit_settings.h"
#include "widgets/words/time_entry.h"

#include <QtTest>

using namespace berg;
using namespace Qt::StringLiterals;

namespace {

MissionClock startingAt(const char* utc)
{
    Scenario scenario;
    scenario.startUtc = utc;
    return clockOf(scenario);
}

constexpr const char* kEvening = "2026-11-29T23:50:00Z";

} // namespace

class TestMissionClock : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase()
    {
        qputenv("TZ", "UTC-3"); // three hours ahead of UTC
        QLocale::setDefault(QLocale::c());
    }
    void init()
    {
        test::failOnWarnings();
        setShownUnits({});
    }
    void cleanup() { setShownUnits({}); }

    void timesAreInUtcOrElapsed_data()
    {
        QTest::addColumn<QString>("start");
        QTest::addColumn<double>("time_s");
        QTest::addColumn<QString>("utc");
        QTest::addColumn<QString>("elapsed");
        const QString evening = QString::fromLatin1(kEvening);
        QTest::newRow("start") << evening << 0.0 << u"23:50:00Z"_s << u"00:00"_s;
        QTest::newRow("rounded") << evening << 59.6 << u"23:51:00Z"_s << u"01:00"_s;
        QTest::newRow("midnight") << evening << 600.0 << u"00:00:00Z +1"_s << u"10:00"_s;
        QTest::newRow("two days") << evening << 90000.0 << u"00:50:00Z +2"_s << u"25:00:00"_s;
        QTest::newRow("never") << evening << double(INFINITY) << u"∞"_s << u"∞"_s;
        QTest::newRow("no start") << QString() << 200.0 << u"03:20"_s << u"03:20"_s;
    }

    void timesAreInUtcOrElapsed()
    {
        QFETCH(QString, start);
        QFETCH(double, time_s);
        const MissionClock clock = startingAt(start.toUtf8().constData());
        QTEST(clock.text(time_s), "utc");
        setShownUnits({.times = TimeForm::Elapsed});
        QTEST(clock.text(time_s), "elapsed");
    }

    /** Other representations of the same time. */
    void detailsHaveUtcLocalAndElapsedTime()
    {
        const MissionClock clock = startingAt(kEvening);
        QCOMPARE(clock.columnText(660), u"00:01:00 +1"_s);
        QCOMPARE(clock.dateText(660), u"2026-11-30 00:01:00 UTC"_s);
        const QString details = clock.details(660);
        QVERIFY2(details.startsWith(u"2026-11-30 00:01:00 UTC\n2026-11-30 03:01:00 local time"_s),
                 qPrintable(details));
        QVERIFY2(details.endsWith(u"11:00 after the start"_s), qPrintable(details));
        QCOMPARE(MissionClock().details(660), QString());
        QCOMPARE(MissionClock().toolTip(660), u"11:00"_s);
        setShownUnits({.times = TimeForm::Elapsed});
        QCOMPARE(clock.details(660), details); // it is beside either of them
        QCOMPARE(clock.dateText(660), u"11:00"_s);
    }

    void timesAheadFollowTheClock()
    {
        const TimesAhead times{.clock = startingAt(kEvening), .now_s = 500};
        QCOMPARE(times.text(86), u"23:59:46Z"_s);
        QCOMPARE(times.minuteInBrackets(86), u" (00:00Z +1)"_s);
        QVERIFY(times.toolTip(86).startsWith(u"in 01:26\n2026-11-29 23:59:46 UTC"_s));
        QCOMPARE(TimesAhead{.now_s = 500}.text(86), u"in 01:26"_s);
        QCOMPARE(TimesAhead{.now_s = 500}.minuteInBrackets(86), QString());
        setShownUnits({.times = TimeForm::Elapsed});
        QCOMPARE(times.text(86), u"in 01:26"_s);
        QCOMPARE(times.minuteInBrackets(86), QString());
    }

    void typedTimesAreRead_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<double>("time_s"); ///< below zero if the text is not a time
        QTest::newRow("elapsed") << u"3:20"_s << 200.0;
        QTest::newRow("minutes") << u"45 min"_s << 2700.0;
        QTest::newRow("four digits") << u"2355Z"_s << 300.0;
        QTest::newRow("colon") << u"23:55Z"_s << 300.0;
        QTest::newRow("small z") << u"2355z"_s << 300.0;
        QTest::newRow("word") << u"23:55 UTC"_s << 300.0;
        QTest::newRow("seconds") << u" 23:55:30Z "_s << 330.0;
        QTest::newRow("next day, nearest") << u"0010Z"_s << 1200.0;
        QTest::newRow("next day, said") << u"00:10:00Z +1"_s << 1200.0;
        QTest::newRow("second day") << u"00:10:00Z +2"_s << 87600.0;
        QTest::newRow("with a date") << u"2026-11-30 00:10"_s << 1200.0;
        QTest::newRow("before the start") << u"2345Z"_s << -1.0;
        QTest::newRow("no time") << u"soon"_s << -1.0;
        QTest::newRow("no such hour") << u"2561Z"_s << -1.0;
    }

    void typedTimesAreRead()
    {
        QFETCH(QString, text);
        QFETCH(double, time_s);
        const std::optional<double> read_s = readInstant(text, startingAt(kEvening), 100);
        QCOMPARE(read_s.has_value(), time_s >= 0);
        if (read_s)
            COMPARE_NEAR(*read_s, time_s, 1e-6); // texts have milliseconds
    }

    /** A displayed time is parsed as the same time. */
    void whatIsShownIsRead()
    {
        for (const MissionClock& clock : {startingAt(kEvening), MissionClock()})
            for (const double time_s : {0.0, 599.0, 600.0, 90000.0, 200000.0})
                QCOMPARE(readInstant(clock.text(time_s), clock, 0), std::optional(time_s));
    }

    /** Without a start there is no UTC to be read. */
    void noStart()
    {
        QVERIFY(!readInstant(u"1215Z"_s, {}, 0));
        QCOMPARE(readInstant(u"3:20"_s, {}, 0), std::optional(200.0));
    }
};

QTEST_MAIN(TestMissionClock)
#include "tst_mission_clock.moc"
