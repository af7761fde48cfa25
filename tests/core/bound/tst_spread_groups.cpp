#include "core/bound/spread_groups.h"

#include <QtTest>

#include <set>

using namespace berg;

class TestSpreadGroups : public QObject
{
    Q_OBJECT
private slots:
    void eachPointOnce_data();
    void eachPointOnce();
    void neighboursPart();
};

void TestSpreadGroups::eachPointOnce_data()
{
    QTest::addColumn<int>("points");
    QTest::addColumn<std::vector<std::size_t>>("sizes");
    QTest::newRow("none") << 0 << std::vector<std::size_t>{};
    QTest::newRow("one") << 1 << std::vector<std::size_t>{1};
    QTest::newRow("full") << 14 << std::vector<std::size_t>{14};
    QTest::newRow("two") << 20 << std::vector<std::size_t>{14, 6};
    QTest::newRow("many") << 500 << [] {
        std::vector<std::size_t> sizes(35, 14);
        sizes.push_back(10);
        return sizes;
    }();
}

void TestSpreadGroups::eachPointOnce()
{
    QFETCH(int, points);
    QFETCH(std::vector<std::size_t>, sizes);
    std::vector<Point> points_m;
    for (int i = 0; i < points; ++i)
        points_m.emplace_back(i * 37 % 101, i * 53 % 97);
    const std::vector<std::vector<int>> groups = spreadGroups(points_m, 14);
    QCOMPARE(groups.size(), sizes.size());
    std::set<int> seen;
    for (std::size_t g = 0; g < groups.size(); ++g) {
        QCOMPARE(groups[g].size(), sizes[g]);
        seen.insert(groups[g].begin(), groups[g].end());
    }
    QCOMPARE(seen.size(), points_m.size());
}

void TestSpreadGroups::neighboursPart()
{
    // Eight pairs are far from each other, and no group holds both points of a pair.
    std::vector<Point> points_m;
    for (int i = 0; i < 16; ++i)
        points_m.emplace_back(1000 * (i / 2), i % 2);
    for (const std::vector<int>& group : spreadGroups(points_m, 8)) {
        std::set<int> pairs;
        for (const int i : group)
            pairs.insert(i / 2);
        QCOMPARE(pairs.size(), std::size_t{8});
    }
}

QTEST_APPLESS_MAIN(TestSpreadGroups)

#include "tst_spread_groups.moc"
