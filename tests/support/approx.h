#pragma once

#include <QtTest>

#include <cmath>

namespace berg::test {

/** Result of `COMPARE_NEAR`, a type of its own so that the macro evaluates its arguments once. */
struct Near
{
    double actual = 0;
    double expected = 0;
    double tolerance = 0;

    /** Returns false if either value is NaN. */
    [[nodiscard]] bool ok() const { return std::abs(actual - expected) <= tolerance; }
    [[nodiscard]] QByteArray text() const
    {
        return "got " + QByteArray::number(actual, 'g', 17) + ", expected " +
               QByteArray::number(expected, 'g', 17) + " +- " + QByteArray::number(tolerance);
    }
};

} // namespace berg::test

/** Ends the test function as failed unless |actual - expected| <= tolerance; prints all three. */
#define COMPARE_NEAR(ACTUAL, EXPECTED, TOLERANCE)                                                  \
    do {                                                                                           \
        const berg::test::Near near_{(ACTUAL), (EXPECTED), (TOLERANCE)};                           \
        if (!QTest::qVerify(near_.ok(), #ACTUAL " near " #EXPECTED, near_.text().constData(),      \
                            __FILE__, __LINE__))                                                   \
            return;                                                                                \
    } while (false)
