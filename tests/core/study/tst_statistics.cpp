#include "core/base/random.h"
#include "core/study/statistics.h"
#include "tests/support/approx.h"

#include <algorithm>
#include <vector>

using namespace berg;

using Values = std::vector<double>;
Q_DECLARE_METATYPE(Values)

class TestStatistics : public QObject
{
    Q_OBJECT

private slots:
    /** Type 7 of Hyndman and Fan: h = (n - 1) p, between the values floor(h) and floor(h) + 1. */
    void quantileByHand_data()
    {
        QTest::addColumn<Values>("sorted");
        QTest::addColumn<double>("p");
        QTest::addColumn<double>("expected");
        const Values four{1, 2, 3, 4};
        QTest::newRow("four, first quartile") << four << 0.25 << 1.75;
        QTest::newRow("four, median") << four << 0.5 << 2.5;
        QTest::newRow("four, third quartile") << four << 0.75 << 3.25;
        QTest::newRow("four, 10 %") << four << 0.1 << 1.3;
        QTest::newRow("four, 90 %") << four << 0.9 << 3.7;
        const Values uneven{1, 3, 4, 8, 15}; // h = 0.4, 1, 2, 3.6
        QTest::newRow("five, 10 %") << uneven << 0.1 << 1.8;
        QTest::newRow("five, first quartile") << uneven << 0.25 << 3.0;
        QTest::newRow("five, median") << uneven << 0.5 << 4.0;
        QTest::newRow("five, 90 %") << uneven << 0.9 << 12.2;
        QTest::newRow("smallest") << uneven << 0.0 << 1.0;
        QTest::newRow("largest") << uneven << 1.0 << 15.0;
        QTest::newRow("one value") << Values{7} << 0.3 << 7.0;
        QTest::newRow("one value, largest") << Values{7} << 1.0 << 7.0;
    }

    void quantileByHand()
    {
        QFETCH(Values, sorted);
        QFETCH(double, p);
        QFETCH(double, expected);
        COMPARE_NEAR(quantile(sorted, p), expected, 1e-14);
    }

    void quantileRefusesNonsense()
    {
        const Values some{1, 2};
        QVERIFY_THROWS_EXCEPTION(std::logic_error, (void)quantile({}, 0.5));
        QVERIFY_THROWS_EXCEPTION(std::logic_error, (void)quantile(some, -0.01));
        QVERIFY_THROWS_EXCEPTION(std::logic_error, (void)quantile(some, 1.01));
        QVERIFY_THROWS_EXCEPTION(std::logic_error, (void)quantile(some, std::nan("")));
    }

    /** Mean 5, squares about it 32: s^2 = 32/7, standard error sqrt(32/7/8). */
    void summaryByHand()
    {
        const Summary s = summarise(Values{9, 4, 2, 7, 4, 5, 4, 5}); // not sorted on purpose
        QCOMPARE(s.n, 8);
        COMPARE_NEAR(s.mean, 5, 1e-15);
        COMPARE_NEAR(s.standardError, 0.75592894601845445, 1e-15);
        COMPARE_NEAR(s.median, 4.5, 1e-15);    // 2 4 4 4 5 5 7 9, h = 3.5
        COMPARE_NEAR(s.quartile1, 4, 1e-15);   // h = 1.75
        COMPARE_NEAR(s.quartile3, 5.5, 1e-15); // h = 5.25
        COMPARE_NEAR(s.decile1, 3.4, 1e-14);   // h = 0.7
        COMPARE_NEAR(s.decile9, 7.6, 1e-14);   // h = 6.3
    }

    void summaryOfOneAndOfNone()
    {
        const Summary one = summarise(Values{3.5});
        QCOMPARE(one.n, 1);
        QCOMPARE(one.mean, 3.5);
        QCOMPARE(one.standardError, 0.0);
        for (const double q : {one.median, one.quartile1, one.quartile3, one.decile1, one.decile9})
            QCOMPARE(q, 3.5);
        const Summary none = summarise({});
        QCOMPARE(none.n, 0);
        QCOMPARE(none.mean, 0.0);
        QCOMPARE(none.standardError, 0.0);
        QCOMPARE(none.median, 0.0);
    }

    void orderDoesNotMatterToQuantiles()
    {
        Random random(1);
        Values values;
        for (int i = 0; i < 101; ++i)
            values.push_back(random.uniform(-5, 5));
        const Summary a = summarise(values);
        std::sort(values.begin(), values.end());
        const Summary b = summarise(values);
        QCOMPARE(b.median, a.median);
        QCOMPARE(b.quartile1, a.quartile1);
        // With 101 values the quantiles are members: numbers 10, 25, 50, 75, 90 from 0.
        COMPARE_NEAR(b.decile1, values[10], 1e-14);
        COMPARE_NEAR(b.quartile1, values[25], 1e-14);
        COMPARE_NEAR(b.median, values[50], 1e-14);
        COMPARE_NEAR(b.quartile3, values[75], 1e-14);
        COMPARE_NEAR(b.decile9, values[90], 1e-14);
    }

    /** The standard error is the distance of a sample mean from the truth. */
    void standardErrorIsWhatItSays()
    {
        Random random(2);
        double ratio2 = 0;
        constexpr int kSamples = 2000;
        for (int k = 0; k < kSamples; ++k) {
            Values values;
            for (int i = 0; i < 50; ++i)
                values.push_back(10 + 3 * random.normal());
            const Summary s = summarise(values);
            ratio2 += (s.mean - 10) * (s.mean - 10) / (s.standardError * s.standardError);
        }
        // Square of Student's t with 49 degrees of freedom: mean 49/47, variance about 2.3.
        COMPARE_NEAR(ratio2 / kSamples, 49.0 / 47, 5 * std::sqrt(2.3 / kSamples));
    }

    /** To 12 digits by the regularized incomplete beta function with 30 digits. */
    void studentFactors_data()
    {
        QTest::addColumn<int>("degrees");
        QTest::addColumn<double>("expected");
        QTest::newRow("1") << 1 << 12.7062047361747;
        QTest::newRow("2") << 2 << 4.30265272974946;
        QTest::newRow("3") << 3 << 3.18244630528371;
        QTest::newRow("5") << 5 << 2.57058183563632;
        QTest::newRow("10") << 10 << 2.22813885198627;
        QTest::newRow("30") << 30 << 2.04227245630124;
        QTest::newRow("99") << 99 << 1.98421695158642;
        QTest::newRow("100") << 100 << 1.98397151852355;
        QTest::newRow("101, by expansion") << 101 << 1.98373100295561;
        QTest::newRow("199") << 199 << 1.97195654425175;
        QTest::newRow("1000") << 1000 << 1.96233908082641;
        QTest::newRow("40000") << 40000 << 1.96002329308491;
    }

    void studentFactors()
    {
        QFETCH(int, degrees);
        QFETCH(double, expected);
        COMPARE_NEAR(studentFactor(degrees), expected, 1e-9);
    }

    void noDegreesOfFreedom()
    {
        QVERIFY_THROWS_EXCEPTION(std::logic_error, (void)studentFactor(0));
    }

    /** Mean 5, standard error 0.7559 (see above), 7 degrees of freedom: t = 2.3646243. */
    void intervalByHand()
    {
        const MeanInterval interval = meanInterval(Values{9, 4, 2, 7, 4, 5, 4, 5});
        COMPARE_NEAR(interval.mean, 5, 1e-15);
        COMPARE_NEAR(interval.high - 5, 2.364624251592785 * 0.75592894601845445, 1e-9);
        COMPARE_NEAR(interval.low, 10 - interval.high, 1e-14);
    }

    void intervalOfOneAndOfNone()
    {
        const MeanInterval one = meanInterval(Values{-2});
        QCOMPARE(one.mean, -2.0);
        QCOMPARE(one.low, -2.0);
        QCOMPARE(one.high, -2.0);
        const MeanInterval none = meanInterval({});
        QCOMPARE(none.low, 0.0);
        QCOMPARE(none.high, 0.0);
    }

    /** -20, -10 and -30 %: t(2) = 4.303, so the interval ends at -20 + 24.8 %. */
    void lowerIsSureWhenTheIntervalIs()
    {
        const Values reference{100, 200, 400};
        QVERIFY(!isSurelyLower(Values{80, 180, 280}, reference));
        QVERIFY(isSurelyLower(Values{80, 162, 320}, reference));
        QVERIFY(!isSurelyLower(reference, Values{80, 162, 320}));
        QVERIFY(!isSurelyLower(Values{80}, Values{100})); // one pair proves nothing
        QVERIFY(!isSurelyLower(reference, reference));
    }

    void lowestIsSureAgainstEveryOther()
    {
        const Values best{80, 162, 320};
        const std::vector<std::vector<double>> all{best, {100, 200, 400}, {90, 181, 362}};
        QVERIFY(isSurelyLowest(best, all));
        QVERIFY(!isSurelyLowest(all[2], all));
        QVERIFY(!isSurelyLowest(best, std::vector<std::vector<double>>{best, best}));
        QVERIFY(!isSurelyLowest(best, std::vector<std::vector<double>>{best, {70, 200, 400}}));
    }

    /** 19 of 20 intervals of normal samples contain the true mean, also for few values. */
    void intervalCoversTheTruth()
    {
        Random random(3);
        constexpr int kSamples = 4000;
        int covered = 0;
        for (int k = 0; k < kSamples; ++k) {
            Values values;
            for (int i = 0; i < 4; ++i)
                values.push_back(10 + 3 * random.normal());
            const MeanInterval interval = meanInterval(values);
            covered += interval.low <= 10 && 10 <= interval.high ? 1 : 0;
        }
        COMPARE_NEAR(covered / double(kSamples), 0.95, 4 * std::sqrt(0.95 * 0.05 / kSamples));
    }
};

QTEST_APPLESS_MAIN(TestStatistics)
#include "tst_statistics.moc"
