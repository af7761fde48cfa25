#include "core/base/index.h"

#include <QtTest>

#include <algorithm>
#include <type_traits>

using namespace berg;

namespace {

// One kind of number never stands for another, nor for a plain number.
static_assert(!std::is_convertible_v<IcebergIndex, int>);
static_assert(!std::is_convertible_v<IcebergIndex, std::size_t>);
static_assert(!std::is_constructible_v<int, IcebergIndex>);
static_assert(!std::is_constructible_v<IcebergIndex, NodeIndex>);
static_assert(!std::is_constructible_v<NodeIndex, IcebergIndex>);
static_assert(!std::is_convertible_v<NodeIndex, int>);
static_assert(!std::is_constructible_v<int, NodeIndex>);
static_assert(!std::is_assignable_v<IcebergIndex&, NodeIndex>);
static_assert(sizeof(IcebergIndex) == sizeof(int));
static_assert(std::is_trivially_copyable_v<IcebergIndex>);

} // namespace

class TestIndex : public QObject
{
    Q_OBJECT

private slots:
    void rangeHoldsEachOnceInOrder()
    {
        IcebergList icebergs;
        for (const IcebergIndex iceberg : IcebergRange(3))
            icebergs.push_back(iceberg);
        QVERIFY((icebergs == IcebergList{0, 1, 2}));
        for (const IcebergIndex iceberg : IcebergRange(0))
            QFAIL(qPrintable(QString::number(iceberg.number())));

        std::vector<NodeIndex> nodes;
        for (const NodeIndex node : NodeRange(2, 4))
            nodes.push_back(node);
        QVERIFY((nodes == std::vector<NodeIndex>{2, 3}));
    }

    void numbersAreKept()
    {
        QCOMPARE(IcebergIndex::of(std::size_t{7}).number(), 7);
        QCOMPARE(toIndex(IcebergIndex(7)), std::size_t{7});
        IcebergIndex next = 7;
        QCOMPARE((++next).number(), 8);
        QCOMPARE(IcebergIndex().number(), 0);
    }

    void icebergsAreSortedByNumber()
    {
        IcebergList icebergs{2, 0, 1};
        std::ranges::sort(icebergs);
        QVERIFY((icebergs == IcebergList{0, 1, 2}));
        QVERIFY(IcebergIndex(1) < IcebergIndex(2));
    }
};

QTEST_APPLESS_MAIN(TestIndex)
#include "tst_index.moc"
