#include "core/tracking/iceberg_size.h"
#include "tests/support/approx.h"

#include <QTest>

using namespace berg;

class TestIcebergSize : public QObject
{
    Q_OBJECT

private slots:
    void classesAreInOrder()
    {
        for (std::size_t i = 1; i < kIcebergSizes.size(); ++i)
            QVERIFY(kIcebergSizes[i].length_m > kIcebergSizes[i - 1].length_m);
        QVERIFY(kIcebergSizes[1].length_m < kShortestIceberg_m);
        QVERIFY(kIcebergSizes[2].length_m > kShortestIceberg_m);
    }

    void classesByLength()
    {
        const std::vector<std::pair<double, std::string_view>> limits{
            {0, "gr"},   {4.9, "gr"},  {5, "bb"},   {14.9, "bb"}, {15, "sm"},   {60, "sm"},
            {61, "med"}, {120, "med"}, {121, "lg"}, {199, "lg"},  {200, "vlg"}, {5000, "vlg"}};
        for (const auto& [length_m, code] : limits)
            QCOMPARE(sizeOfLength(length_m).code, code);
        for (const IcebergSize& size : kIcebergSizes)
            QCOMPARE(sizeOfLength(size.length_m).code, size.code);
    }

    void dimensionsByHand()
    {
        // 100^0.71 = 10^1.42 = 26.3027; 1.78 x 26.3027 = 46.819.
        const IcebergDimensions dimensions = dimensionsOfLength(100);
        QCOMPARE(dimensions.length_m, 100.0);
        COMPARE_NEAR(dimensions.draft_m, 46.819, 1e-3);
        COMPARE_NEAR(dimensions.sail_m2, 770, 1e-9);
        COMPARE_NEAR(dimensions.keel_m2, 4681.9, 0.1);
    }
};

QTEST_APPLESS_MAIN(TestIcebergSize)
#include "tst_iceberg_size.moc"
