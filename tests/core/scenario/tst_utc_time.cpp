#include "core/scenario/utc_time.h"

#include <QDateTime>
#include <QTest>

using namespace berg;

class TestUtcTime : public QObject
{
    Q_OBJECT

private slots:
    void textOfParsedTime_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<double>("after_s");
        QTest::addColumn<QByteArray>("expected");
        using Bytes = QByteArray;
        QTest::newRow("start") << Bytes("2026-05-01T12:00:00Z") << 0.0
                               << Bytes("2026-05-01T12:00:00Z");
        QTest::newRow("without seconds")
            << Bytes("2026-05-01T12:34Z") << 0.0 << Bytes("2026-05-01T12:34:00Z");
        QTest::newRow("fraction kept")
            << Bytes("2026-05-01T12:00:00.25Z") << 0.0 << Bytes("2026-05-01T12:00:00.250Z");
        QTest::newRow("nanoseconds cut")
            << Bytes("2026-05-01T12:00:00.123999999Z") << 0.0 << Bytes("2026-05-01T12:00:00.123Z");
        QTest::newRow("steps of 0.1 s rounded")
            << Bytes("2026-05-01T12:00:00Z") << 3 * 0.1 << Bytes("2026-05-01T12:00:00.300Z");
        QTest::newRow("new year") << Bytes("2025-12-31T23:59:59Z") << 1.0
                                  << Bytes("2026-01-01T00:00:00Z");
        QTest::newRow("leap day") << Bytes("2024-02-28T23:59:59Z") << 2.0
                                  << Bytes("2024-02-29T00:00:01Z");
        QTest::newRow("before 1970")
            << Bytes("1912-04-14T23:40:00Z") << 9600.0 << Bytes("1912-04-15T02:20:00Z");
    }

    void textOfParsedTime()
    {
        QFETCH(QByteArray, text);
        QFETCH(double, after_s);
        QFETCH(QByteArray, expected);
        const std::optional<UtcTime> start = parseUtc(text.toStdString());
        QVERIFY(start.has_value());
        QCOMPARE(QByteArray::fromStdString(utcText(*start, after_s)), expected);
        const qint64 ms =
            QDateTime::fromString(QString::fromLatin1(text), Qt::ISODateWithMs).toMSecsSinceEpoch();
        // Qt rounds a fraction of more than three digits.
        QVERIFY(qAbs(start->time_since_epoch().count() - ms) <= 1);
    }

    void otherTextsAreRejected_data()
    {
        QTest::addColumn<QByteArray>("text");
        for (const char* text :
             {"", "Z", "2026-05-01", "2026-05-01T12:00:00", "2026-05-01T12:00:00+01:00",
              "2026-02-30T12:00:00Z", "2026-05-01T24:00:00Z", "2026-05-01 12:00:00Z",
              "2026-05-01T12:00:00.Z", "tomorrow"})
            QTest::newRow(text) << QByteArray(text);
    }

    void otherTextsAreRejected()
    {
        QFETCH(QByteArray, text);
        QVERIFY(!parseUtc(text.toStdString()).has_value());
    }
};

QTEST_APPLESS_MAIN(TestUtcTime)
#include "tst_utc_time.moc"
