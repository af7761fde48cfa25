#include "core/scenario/text_checks.h"

#include <QTest>

#include <limits>
#include <string>

using namespace berg;

class TestChecks : public QObject
{
    Q_OBJECT

private slots:
    void utcTimesAreRecognised_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<bool>("valid");
        QTest::newRow("seconds") << "2024-05-01T06:07:08Z" << true;
        QTest::newRow("minutes") << "2024-05-01T06:07Z" << true;
        QTest::newRow("fraction") << "2024-05-01T06:07:08.5Z" << true;
        QTest::newRow("leap day") << "2024-02-29T00:00:00Z" << true;
        QTest::newRow("leap day of a century") << "2000-02-29T00:00:00Z" << true;
        QTest::newRow("last second") << "2023-12-31T23:59:59.999999999Z" << true;
        QTest::newRow("empty") << "" << false;
        QTest::newRow("no zone") << "2024-05-01T06:07:08" << false;
        QTest::newRow("other zone") << "2024-05-01T06:07:08+00:00" << false;
        QTest::newRow("small letters") << "2024-05-01t06:07:08z" << false;
        QTest::newRow("blank for T") << "2024-05-01 06:07:08Z" << false;
        QTest::newRow("date only") << "2024-05-01Z" << false;
        QTest::newRow("no leap year") << "2023-02-29T00:00:00Z" << false;
        QTest::newRow("no leap century") << "1900-02-29T00:00:00Z" << false;
        QTest::newRow("31 April") << "2024-04-31T00:00:00Z" << false;
        QTest::newRow("month 0") << "2024-00-01T00:00:00Z" << false;
        QTest::newRow("month 13") << "2024-13-01T00:00:00Z" << false;
        QTest::newRow("day 0") << "2024-05-00T00:00:00Z" << false;
        QTest::newRow("hour 24") << "2024-05-01T24:00:00Z" << false;
        QTest::newRow("minute 60") << "2024-05-01T06:60:00Z" << false;
        QTest::newRow("second 60") << "2024-05-01T06:07:60Z" << false;
        QTest::newRow("letters") << "2024-05-0xT06:07:08Z" << false;
        QTest::newRow("minus") << "2024-05--1T06:07:08Z" << false;
        QTest::newRow("point alone") << "2024-05-01T06:07:08.Z" << false;
        QTest::newRow("fraction of letters") << "2024-05-01T06:07:08.5xZ" << false;
        QTest::newRow("trailing text") << "2024-05-01T06:07:08ZZ" << false;
        QTest::newRow("short year") << "24-05-01T06:07:08Z" << false;
    }
    void utcTimesAreRecognised()
    {
        QFETCH(const QString, text);
        QFETCH(const bool, valid);
        QCOMPARE(isUtcTime(text.toStdString()), valid);
    }

    void utf8IsRecognised_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<bool>("valid");
        QTest::newRow("empty") << QByteArray() << true;
        QTest::newRow("ASCII and NUL") << QByteArray("a\0b", 3) << true;
        QTest::newRow("two bytes") << QByteArray("\xC2\x80\xDF\xBF") << true;
        QTest::newRow("three bytes") << QByteArray("\xE0\xA0\x80\xEF\xBF\xBF") << true;
        QTest::newRow("four bytes") << QByteArray("\xF0\x90\x80\x80\xF4\x8F\xBF\xBF") << true;
        QTest::newRow("around surrogates") << QByteArray("\xED\x9F\xBF\xEE\x80\x80") << true;
        QTest::newRow("lone continuation") << QByteArray("a\x80") << false;
        QTest::newRow("cut after lead") << QByteArray("a\xC3") << false;
        QTest::newRow("cut in the middle") << QByteArray("\xE2\x82") << false;
        QTest::newRow("lead then letter") << QByteArray("\xC3q") << false;
        QTest::newRow("overlong slash") << QByteArray("\xC0\xAF") << false;
        QTest::newRow("overlong three") << QByteArray("\xE0\x9F\xBF") << false;
        QTest::newRow("overlong four") << QByteArray("\xF0\x8F\xBF\xBF") << false;
        QTest::newRow("surrogate") << QByteArray("\xED\xA0\x80") << false;
        QTest::newRow("above U+10FFFF") << QByteArray("\xF4\x90\x80\x80") << false;
        QTest::newRow("byte FF") << QByteArray("\xFF") << false;
        QTest::newRow("Latin-1") << QByteArray("Gr\xF8nland") << false;
    }
    void utf8IsRecognised()
    {
        QFETCH(const QByteArray, text);
        QFETCH(const bool, valid);
        QCOMPARE(isUtf8({text.data(), static_cast<std::size_t>(text.size())}), valid);
    }

    void numbersOutsideLimitsAreReported_data()
    {
        QTest::addColumn<double>("value");
        QTest::addColumn<bool>("above");
        QTest::addColumn<QString>("fault");
        constexpr double kInfinity = std::numeric_limits<double>::infinity();
        QTest::newRow("inside") << 1.0 << false << "";
        QTest::newRow("low end") << 0.0 << false << "";
        QTest::newRow("high end") << 2.5 << true << "";
        QTest::newRow("low end excluded")
            << 0.0 << true << "must be above 0 and at most 2.5, not 0";
        QTest::newRow("below") << -0.1 << false << "must be from 0 to 2.5, not -0.1";
        QTest::newRow("above") << 3.0 << false << "must be from 0 to 2.5, not 3";
        QTest::newRow("NaN") << std::numeric_limits<double>::quiet_NaN() << false
                             << "must be a finite number";
        QTest::newRow("infinite") << kInfinity << false << "must be a finite number";
        QTest::newRow("minus infinite") << -kInfinity << true << "must be a finite number";
    }
    void numbersOutsideLimitsAreReported()
    {
        QFETCH(const double, value);
        QFETCH(const bool, above);
        QFETCH(const QString, fault);
        const Limits range{.low = 0, .high = 2.5, .above = above};
        const std::optional<IssueReason> reason = outOfLimits(value, range);
        QCOMPARE(QString::fromStdString(reason ? englishText(*reason) : ""), fault);
    }

    void printableTexts_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("shown");
        QTest::newRow("short") << QByteArray("berg-1") << QByteArray("berg-1");
        QTest::newRow("control") << QByteArray("a\x1B[31mb\n\x7F") << QByteArray("a?[31mb??");
        QTest::newRow("just fits") << QByteArray(40, 'x') << QByteArray(40, 'x');
        QTest::newRow("too long") << QByteArray(41, 'x') << QByteArray(40, 'x') + "...";
        QTest::newRow("cut between characters")
            << QByteArray(39, 'x') + "\xC3\xB8 and more" << QByteArray(39, 'x') + "...";
    }
    void printableTexts()
    {
        QFETCH(const QByteArray, text);
        QFETCH(const QByteArray, shown);
        QCOMPARE(QByteArray::fromStdString(printable(text.toStdString())), shown);
    }
};

QTEST_APPLESS_MAIN(TestChecks)
#include "tst_text_checks.moc"
