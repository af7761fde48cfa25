#include "core/base/number_text.h"
#include "core/base/random.h"

#include <QtTest>

#include <bit>
#include <clocale>
#include <cmath>
#include <limits>

using namespace berg;

class TestNumberText : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase()
    {
        std::setlocale(LC_ALL, "nb_NO.UTF-8"); // where available: it must have no effect
    }

    void numbersHaveTheirShortestText_data()
    {
        QTest::addColumn<double>("value");
        QTest::addColumn<QByteArray>("text");
        QTest::newRow("zero") << 0.0 << QByteArray("0");
        QTest::newRow("integer") << 22.0 << QByteArray("22");
        QTest::newRow("not 1e+05") << 100000.0 << QByteArray("100000");
        QTest::newRow("a tenth") << 0.1 << QByteArray("0.1");
        QTest::newRow("step count times dt") << 3 * 0.1 << QByteArray("0.30000000000000004");
        QTest::newRow("negative") << -47.5 << QByteArray("-47.5");
        QTest::newRow("small") << 0.000125 << QByteArray("0.000125");
        QTest::newRow("digits") << 2.5e-5 << QByteArray("0.000025");
        QTest::newRow("an exponent") << 2.5e-6 << QByteArray("2.5e-06");
        QTest::newRow("fifteen digits") << 1e14 << QByteArray("100000000000000");
        QTest::newRow("sixteen") << 1e15 << QByteArray("1e+15");
        QTest::newRow("tiny") << 1e-17 << QByteArray("1e-17");
        QTest::newRow("huge") << 1.5e300 << QByteArray("1.5e+300");
    }

    void numbersHaveTheirShortestText()
    {
        QFETCH(double, value);
        QFETCH(QByteArray, text);
        QCOMPARE(QByteArray::fromStdString(numberText(value)), text);
    }

    void numbersReadBackExactly()
    {
        Random random(5);
        for (int i = 0; i < 20000; ++i) {
            // Any finite bit pattern, and numbers of everyday size.
            const double patterns[] = {std::bit_cast<double>(random.bits()), random.normal() * 1e4,
                                       random.uniform() * 1e-5};
            for (const double value : patterns) {
                if (!std::isfinite(value))
                    continue;
                bool ok = false;
                const QByteArray text = QByteArray::fromStdString(numberText(value));
                const double back = text.toDouble(&ok);
                QVERIFY2(ok && std::bit_cast<std::uint64_t>(back) ==
                                   std::bit_cast<std::uint64_t>(value),
                         text.constData());
            }
        }
    }

    void decimalsWithoutExponent()
    {
        QCOMPARE(decimalText(2.5e-6), std::string("0.0000025"));
        QCOMPARE(decimalText(1e20), std::string("100000000000000000000"));
        QCOMPARE(decimalText(-0.1), std::string("-0.1"));
    }

    void fixedNumbers()
    {
        QCOMPARE(fixedText(1.25, 1), std::string("1.2")); // ties to even, as printf
        QCOMPARE(fixedText(-12.345, 2), std::string("-12.35"));
        QCOMPARE(fixedText(-0.04, 1), std::string("0.0"));
        QCOMPARE(fixedText(84213.4, 0), std::string("84213"));
        QCOMPARE(fixedText(std::numeric_limits<double>::max(), 9).size(), std::size_t{309 + 10});
        QCOMPARE(fixedText(std::nan(""), 1), std::string("nan"));
    }

    void groupedNumbers()
    {
        QCOMPARE(groupedText(84213.4, 0, " "), std::string("84 213"));
        QCOMPARE(groupedText(-1234567.891, 2, " "), std::string("-1 234 567.89"));
        QCOMPARE(groupedText(999, 0, " "), std::string("999"));
        QCOMPARE(groupedText(-999, 0, " "), std::string("-999"));
        QCOMPARE(groupedText(1000, 0, " "), std::string("1 000"));
        QCOMPARE(groupedText(-std::numeric_limits<double>::infinity(), 0, " "),
                 std::string("-inf"));
    }

    void printedNumbers()
    {
        QCOMPARE(printedNumber(-18420, 0), std::string("\u221218\u202f420"));
        QCOMPARE(printedNumber(0.5, 2), std::string("0.50"));
        QCOMPARE(signedNumber(2.94, 1), std::string("+2.9"));
        QCOMPARE(signedNumber(0.04, 1), std::string("0.0"));
        QCOMPARE(signedNumber(-0.04, 1), std::string("0.0"));
        QCOMPARE(signedNumber(-2.94, 1), std::string("\u22122.9"));
    }

    void decimalsShowTheDigitsAskedFor()
    {
        QCOMPARE(decimalsFor(18420, 4), 0);
        QCOMPARE(decimalsFor(-842.1, 4), 1);
        QCOMPARE(decimalsFor(1, 4), 3);
        QCOMPARE(decimalsFor(0.0123, 3), 4);
        QCOMPARE(decimalsFor(1e-30, 3), 9);
        QCOMPARE(decimalsFor(0, 4), 0);
    }
};

QTEST_APPLESS_MAIN(TestNumberText)
#include "tst_number_text.moc"
