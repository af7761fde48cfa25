#include "core/io/text/number_text.h"

#include <QtTest>

#include <clocale>
#include <limits>

using namespace berg;

class TestNumberText : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase()
    {
        std::setlocale(LC_ALL, "nb_NO.UTF-8"); // where there is one: it must not matter
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

    void decimals()
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
