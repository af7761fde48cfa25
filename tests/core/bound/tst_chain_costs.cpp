#include "core/base/random.h"
#include "core/bound/chain_costs.h"

#include <QtTest>

#include <algorithm>
#include <limits>
#include <numeric>

using namespace berg;

namespace {

constexpr int kCells = 4;
constexpr std::int64_t kNoLimit = std::numeric_limits<std::int64_t>::max();

std::vector<ViewRegion> drawn(std::uint64_t seed, int count)
{
    Random random(seed);
    std::vector<ViewRegion> regions;
    for (int i = 0; i < count; ++i)
        regions.push_back({.centre_m = {random.uniform(0, 2000), random.uniform(0, 2000)},
                           .half_m = Point::Constant(random.uniform(100, 400))});
    return regions;
}

/** Calculates the costs over all orders of the set and all cells, one after the other. */
class BruteForce
{
public:
    BruteForce(const ViewCells& cells, const StageCost& price, std::span<const float> start_s)
        : m_cells(cells), m_price(price), m_start_s(start_s)
    {
    }
    double least(std::uint32_t set)
    {
        m_least = std::numeric_limits<double>::infinity();
        for (int j = 0; j < m_cells.regions(); ++j)
            for (int c = 0; (set >> j & 1U) != 0 && c < kCells; ++c) {
                const double begun =
                    m_start_s.empty()
                        ? 0
                        : m_price.always * static_cast<double>(
                                               m_start_s[static_cast<std::size_t>(j * kCells + c)]);
                extend(set, std::uint32_t{1} << j, j, c, begun);
            }
        return m_least;
    }

private:
    void extend(std::uint32_t set, std::uint32_t seen, int j, int c, double cost)
    {
        if (seen == set) {
            m_least = std::min(m_least, cost);
            return;
        }
        double perSecond = m_price.always;
        for (int i = 0; i < m_cells.regions(); ++i)
            if ((seen >> i & 1U) != 0)
                perSecond += m_price.perSeen[static_cast<std::size_t>(i)];
        for (int k = 0; k < m_cells.regions(); ++k) {
            const std::uint32_t bit = std::uint32_t{1} << k;
            if ((set & bit) == 0 || (seen & bit) != 0)
                continue;
            if ((m_cells.touching(j, c) & bit) != 0)
                extend(set, seen | bit, j, c, cost);
            for (int x = 0; x < kCells; ++x)
                extend(set, seen | bit, k, x,
                       cost + perSecond * static_cast<double>(m_cells.legs_s(j, c, k)[x]));
        }
    }

    const ViewCells& m_cells;
    const StageCost& m_price;
    std::span<const float> m_start_s;
    double m_least = 0;
};

} // namespace

class TestChainCosts : public QObject
{
    Q_OBJECT
private slots:
    void asBruteForce();
    void cut();
    void work();
};

void TestChainCosts::asBruteForce()
{
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        const int count = 1 + static_cast<int>(seed % 4);
        const ViewCells cells(drawn(seed, count), kCells, {});
        Random random(seed, 1);
        StageCost price;
        for (int i = 0; i < count; ++i)
            price.perSeen.push_back(random.uniform(0, 0.1));
        std::vector<float> start_s;
        if (seed % 2 == 0) {
            price.always = 0.05;
            start_s = cells.legsFrom_s({-500, 500});
        }
        WorkMeter meter{.limit = kNoLimit};
        const std::vector<double> costs = chainCosts(cells, price, start_s, meter);
        QCOMPARE(costs.size(), std::size_t{1} << count);
        QCOMPARE(costs[0], 0.0);
        BruteForce bruteForce(cells, price, start_s);
        for (std::uint32_t set = 1; set < costs.size(); ++set) {
            const double exact = bruteForce.least(set);
            QVERIFY(costs[set] <= exact);
            QVERIFY(costs[set] >= exact * (1 - 2e-5)); // The margin covers the rounding.
        }
    }
}

void TestChainCosts::cut()
{
    const ViewCells cells(drawn(1, 6), kCells, {});
    const StageCost price{.perSeen = std::vector<double>(6, 0.025)};
    WorkMeter little{.limit = 1000};
    QVERIFY(chainCosts(cells, price, {}, little).empty());
    std::stop_source source;
    source.request_stop();
    WorkMeter stopped{.limit = kNoLimit, .stop = source.get_token()};
    QVERIFY(chainCosts(cells, price, {}, stopped).empty());
}

void TestChainCosts::work()
{
    for (const int count : {1, 2, 5, 8}) {
        const ViewCells cells(drawn(2, count), kCells, {});
        WorkMeter meter{.limit = kNoLimit};
        const StageCost price{.perSeen = std::vector<double>(static_cast<std::size_t>(count), 1)};
        QVERIFY(!chainCosts(cells, price, {}, meter).empty());
        QCOMPARE(meter.used, chainWork(count, kCells));
    }
}

QTEST_APPLESS_MAIN(TestChainCosts)

#include "tst_chain_costs.moc"
