#include "core/base/random.h"
#include "tests/support/approx.h"
#include "tests/support/reference_random.h"

#include <algorithm>
#include <numbers>
#include <set>
#include <vector>

using namespace berg;
using namespace berg::test;

namespace {

struct Moments
{
    double mean = 0;
    double variance = 0; ///< about the mean
    double skewness = 0;
    double kurtosis = 0;
};

Moments momentsOf(const std::vector<double>& values)
{
    const auto n = static_cast<double>(values.size());
    Moments m;
    for (const double x : values)
        m.mean += x / n;
    double third = 0;
    double fourth = 0;
    for (const double x : values) {
        const double d = x - m.mean;
        m.variance += d * d / n;
        third += d * d * d / n;
        fourth += d * d * d * d / n;
    }
    m.skewness = third / std::pow(m.variance, 1.5);
    m.kurtosis = fourth / (m.variance * m.variance);
    return m;
}

double correlation(const std::vector<double>& a, const std::vector<double>& b)
{
    const Moments ma = momentsOf(a);
    const Moments mb = momentsOf(b);
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        sum += (a[i] - ma.mean) * (b[i] - mb.mean);
    return sum / static_cast<double>(a.size()) / std::sqrt(ma.variance * mb.variance);
}

std::vector<double> uniforms(Random random, int count)
{
    std::vector<double> values(static_cast<std::size_t>(count));
    std::generate(values.begin(), values.end(), [&] { return random.uniform(); });
    return values;
}

std::vector<double> normals(Random random, int count)
{
    std::vector<double> values(static_cast<std::size_t>(count));
    std::generate(values.begin(), values.end(), [&] { return random.normal(); });
    return values;
}

/**
 * Kolmogorov's statistic sqrt(n) sup |F_n - F|; above 2.6 with a probability of
 * 2 exp(-2 2.6^2) = 3e-6.
 */
template <class Distribution>
double kolmogorov(std::vector<double> values, const Distribution& distribution)
{
    std::sort(values.begin(), values.end());
    const auto n = static_cast<double>(values.size());
    double largest = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double f = distribution(values[i]);
        largest = std::max({largest, std::abs(f - static_cast<double>(i) / n),
                            std::abs(f - static_cast<double>(i + 1) / n)});
    }
    return largest * std::sqrt(n);
}

constexpr double kKolmogorovLimit = 2.6;
constexpr int kMany = 400000;

} // namespace

class TestRandom : public QObject
{
    Q_OBJECT

private slots:
    /** Test vectors of Fowler, Noll and Vo. */
    void hashIsFnv1a_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<quint64>("expected");
        QTest::newRow("empty") << QByteArray("") << quint64(0xcbf29ce484222325U);
        QTest::newRow("a") << QByteArray("a") << quint64(0xaf63dc4c8601ec8cU);
        QTest::newRow("b") << QByteArray("b") << quint64(0xaf63df4c8601f1a5U);
        QTest::newRow("foobar") << QByteArray("foobar") << quint64(0x85944171f73967e8U);
        // Above 127, where a signed char would go wrong.
        const QByteArray latin("Isbjerg \xC3\x85");
        QTest::newRow("not ASCII") << latin << quint64(referenceFnv1a(latin.toStdString()));
    }

    void hashIsFnv1a()
    {
        QFETCH(QByteArray, text);
        QFETCH(quint64, expected);
        QCOMPARE(quint64(stableHash(text.toStdString())), expected);
    }

    /** Checks the references of these tests against the published vectors. */
    void referencesAreRight()
    {
        ReferenceSplitMix mix(1234567);
        for (const std::uint64_t expected : std::initializer_list<std::uint64_t>{
                 6457827717110365317U, 3203168211198807973U, 9817491932198370423U,
                 4593380528125082431U, 16408922859458223821U})
            QCOMPARE(mix.next(), expected);
        ReferenceXoshiro xoshiro({1, 2, 3, 4});
        for (const std::uint64_t expected : std::initializer_list<std::uint64_t>{
                 41943041U, 58720359U, 3588806011781223U, 3591011842654386U, 9228616714210784205U,
                 9973669472204895162U, 14011001112246962877U, 12406186145184390807U,
                 15849039046786891736U, 10450023813501588000U})
            QCOMPARE(xoshiro.next(), expected);
        QCOMPARE(referenceFnv1a("foobar"), 0x85944171f73967e8U);
    }

    void bitsAreXoshiro_data()
    {
        QTest::addColumn<quint64>("seed");
        QTest::addColumn<quint64>("stream");
        QTest::newRow("zeros") << quint64(0) << quint64(0);
        QTest::newRow("seed 1") << quint64(1) << quint64(0);
        QTest::newRow("seed 1, stream 2") << quint64(1) << quint64(2);
        QTest::newRow("seed 2, stream 1") << quint64(2) << quint64(1);
        QTest::newRow("largest seed in a file") << quint64(1ULL << 53U) << quint64(3);
        QTest::newRow("stream from an id") << quint64(42) << quint64(stableHash("berg-1"));
        QTest::newRow("all ones") << ~quint64(0) << ~quint64(0);
    }

    void bitsAreXoshiro()
    {
        QFETCH(quint64, seed);
        QFETCH(quint64, stream);
        Random random(seed, stream);
        ReferenceXoshiro reference = referenceStream(seed, stream);
        for (int i = 0; i < 1000; ++i)
            QCOMPARE(random.bits(), reference.next());
    }

    void uniformIsTheUpper53Bits()
    {
        Random random(7, 11);
        ReferenceXoshiro reference = referenceStream(7, 11);
        for (int i = 0; i < 1000; ++i)
            QCOMPARE(random.uniform(),
                     std::ldexp(static_cast<double>(reference.next() >> 11U), -53));
    }

    void uniformIsUniform()
    {
        const std::vector<double> values = uniforms(Random(3), kMany);
        QVERIFY(*std::min_element(values.begin(), values.end()) >= 0);
        QVERIFY(*std::max_element(values.begin(), values.end()) < 1);
        const Moments m = momentsOf(values);
        const double root = std::sqrt(static_cast<double>(kMany));
        // 5 sigma: Var(x) = 1/12, Var((x - 1/2)^2) = 1/80 - 1/144 = 1/180.
        COMPARE_NEAR(m.mean, 0.5, 5 * std::sqrt(1.0 / 12) / root);
        COMPARE_NEAR(m.variance, 1.0 / 12, 5 * std::sqrt(1.0 / 180) / root);
        QVERIFY(kolmogorov(values, [](double x) { return x; }) < kKolmogorovLimit);
    }

    void uniformBetweenBounds()
    {
        Random random(4);
        Random same(4);
        double sum = 0;
        for (int i = 0; i < kMany; ++i) {
            const double x = random.uniform(-3, 5);
            QVERIFY(x >= -3 && x < 5);
            sum += x;
            if (i < 100)
                COMPARE_NEAR(x, -3 + 8 * same.uniform(), 1e-15);
        }
        // 5 sigma of a mean of values with variance 8^2/12.
        COMPARE_NEAR(sum / kMany, 1, 5 * 8 / std::sqrt(12.0 * kMany));
    }

    void belowIsFair_data()
    {
        QTest::addColumn<int>("count");
        for (const int count : {2, 3, 7, 10, 64, 1000})
            QTest::addRow("%d", count) << count;
    }

    void belowIsFair()
    {
        QFETCH(int, count);
        Random random(5, static_cast<std::uint64_t>(count));
        std::vector<int> seen(static_cast<std::size_t>(count), 0);
        for (int i = 0; i < kMany; ++i) {
            const std::uint64_t x = random.below(static_cast<std::uint64_t>(count));
            QVERIFY(x < static_cast<std::uint64_t>(count));
            ++seen[x];
        }
        const double expected = static_cast<double>(kMany) / count;
        double chiSquare = 0;
        for (const int s : seen)
            chiSquare += (s - expected) * (s - expected) / expected;
        // Chi-square of k degrees of freedom: mean k, variance 2k. The skewed small ones reach
        // 5 sigma more often than a normal, but not beyond 8.
        const double k = count - 1;
        QVERIFY2(chiSquare < k + 8 * std::sqrt(2 * k), qPrintable(QString::number(chiSquare)));
        QVERIFY2(chiSquare > k - 5 * std::sqrt(2 * k), qPrintable(QString::number(chiSquare)));
    }

    /** A plain remainder would return the lowest quarter of all words twice: 1/2 instead of 1/3. */
    void belowIsFairForHugeCounts()
    {
        Random random(6);
        constexpr std::uint64_t kQuarter = std::uint64_t{1} << 62U;
        int low = 0;
        for (int i = 0; i < kMany; ++i)
            low += random.below(3 * kQuarter) < kQuarter ? 1 : 0;
        const double share = static_cast<double>(low) / kMany;
        COMPARE_NEAR(share, 1.0 / 3, 5 * std::sqrt(2.0 / 9 / kMany)); // 5 sigma, binomial
    }

    void belowAtItsEnds()
    {
        Random random(7);
        for (int i = 0; i < 100; ++i)
            QCOMPARE(random.below(1), std::uint64_t{0});
        QVERIFY_THROWS_EXCEPTION(std::logic_error, (void)random.below(0));
    }

    void normalIsThePolarMethod()
    {
        Random random(8, 9);
        ReferenceXoshiro reference = referenceStream(8, 9);
        const auto draw = [&] {
            return 2 * std::ldexp(static_cast<double>(reference.next() >> 11U), -53) - 1;
        };
        for (int pair = 0; pair < 1000; ++pair) {
            double u = 0;
            double v = 0;
            do {
                u = draw();
                v = draw();
            } while (u * u + v * v >= 1);
            const double r2 = u * u + v * v;
            // The point on the unit circle, times a Rayleigh radius; rounding only.
            const double radius = std::sqrt(-2 * std::log(r2));
            COMPARE_NEAR(random.normal(), u / std::sqrt(r2) * radius, 1e-13);
            COMPARE_NEAR(random.normal(), v / std::sqrt(r2) * radius, 1e-13);
        }
    }

    void normalIsNormal()
    {
        const std::vector<double> values = normals(Random(10), kMany);
        const Moments m = momentsOf(values);
        const double n = kMany;
        // 5 sigma of the moments of a normal sample: 1/n, 2/n, 6/n, 24/n.
        COMPARE_NEAR(m.mean, 0, 5 * std::sqrt(1 / n));
        COMPARE_NEAR(m.variance, 1, 5 * std::sqrt(2 / n));
        COMPARE_NEAR(m.skewness, 0, 5 * std::sqrt(6 / n));
        COMPARE_NEAR(m.kurtosis, 3, 5 * std::sqrt(24 / n));
        const auto normalCdf = [](double x) { return std::erfc(-x / std::numbers::sqrt2) / 2; };
        QVERIFY(kolmogorov(values, normalCdf) < kKolmogorovLimit);
        const auto beyond3 =
            std::count_if(values.begin(), values.end(), [](double x) { return std::abs(x) > 3; });
        const double p = 0.0026997960632602; // P(|x| > 3)
        COMPARE_NEAR(static_cast<double>(beyond3), n * p, 5 * std::sqrt(n * p));
    }

    /** Both members of a pair come from one point of the disk but must be independent. */
    void neighboursAreIndependent()
    {
        const double limit = 5 / std::sqrt(static_cast<double>(kMany)); // 5 sigma of r
        for (const std::vector<double>& values :
             {normals(Random(11), kMany + 1), uniforms(Random(12), kMany + 1)}) {
            const std::vector<double> first(values.begin(), values.end() - 1);
            const std::vector<double> next(values.begin() + 1, values.end());
            COMPARE_NEAR(correlation(first, next), 0, limit);
        }
        std::vector<double> even;
        std::vector<double> odd;
        for (const double x : normals(Random(13), 2 * kMany))
            (even.size() == odd.size() ? even : odd).push_back(x * x);
        COMPARE_NEAR(correlation(even, odd), 0, limit);
    }

    void streamsAreIndependent_data()
    {
        QTest::addColumn<quint64>("seedA");
        QTest::addColumn<quint64>("streamA");
        QTest::addColumn<quint64>("seedB");
        QTest::addColumn<quint64>("streamB");
        const auto row = [](const char* name, quint64 sa, quint64 ta, quint64 sb, quint64 tb) {
            QTest::newRow(name) << sa << ta << sb << tb;
        };
        row("next stream", 1, 0, 1, 1);
        row("next seed", 1, 1, 2, 1);
        row("exchanged", 1, 2, 2, 1);
        row("both next", 1, 1, 2, 2);
        row("ids", 1, stableHash("berg-1"), 1, stableHash("berg-2"));
        row("last bit of the seed", 0, 5, 1ULL << 63U, 5);
    }

    void streamsAreIndependent()
    {
        QFETCH(quint64, seedA);
        QFETCH(quint64, streamA);
        QFETCH(quint64, seedB);
        QFETCH(quint64, streamB);
        Random a(seedA, streamA);
        Random b(seedB, streamB);
        for (int i = 0; i < 10; ++i)
            QVERIFY(a.bits() != b.bits());
        const double limit = 5 / std::sqrt(static_cast<double>(kMany)); // 5 sigma of r
        COMPARE_NEAR(correlation(uniforms(a, kMany), uniforms(b, kMany)), 0, limit);
        COMPARE_NEAR(correlation(normals(a, kMany), normals(b, kMany)), 0, limit);
    }

    /** First numbers of neighbouring streams, as icebergs 1, 2, 3 ... of a field would draw. */
    void firstNumbersOfManyStreams()
    {
        constexpr int kSide = 300;
        std::vector<double> values;
        std::set<std::uint64_t> words;
        for (std::uint64_t seed = 0; seed < kSide; ++seed)
            for (std::uint64_t stream = 0; stream < kSide; ++stream) {
                values.push_back(Random(seed, stream).uniform());
                words.insert(Random(seed, stream).bits());
            }
        QCOMPARE(words.size(), values.size()); // a collision of 90,000 in 2^64 has odds of 2e-10
        QVERIFY(kolmogorov(values, [](double x) { return x; }) < kKolmogorovLimit);
        const std::vector<double> first(values.begin(), values.end() - kSide);
        const std::vector<double> nextSeed(values.begin() + kSide, values.end());
        COMPARE_NEAR(correlation(first, nextSeed), 0,
                     5 / std::sqrt(static_cast<double>(first.size())));
    }

    void aCopyContinuesTheSame()
    {
        Random random(14, 3);
        (void)random.normal(); // leaves the second number of the pair
        Random copy = random;
        for (int i = 0; i < 5; ++i) {
            QCOMPARE(copy.normal(), random.normal());
            QCOMPARE(copy.uniform(), random.uniform());
        }
    }
};

QTEST_APPLESS_MAIN(TestRandom)
#include "tst_random.moc"
