#include "core/io/import/forecast/grid_sampling.h"
#include "tests/support/approx.h"

#include <QTest>

#include <cmath>

using namespace berg;
using namespace berg::test;

namespace {

SourceGrid rectilinearGrid(std::vector<double> latitudes, std::vector<double> longitudes)
{
    return {.rows = latitudes.size(),
            .columns = longitudes.size(),
            .latitude_deg = std::move(latitudes),
            .longitude_deg = std::move(longitudes)};
}

/** A square grid of half degrees around 60 N 10 E, turned by `turn` counter-clockwise. */
SourceGrid turnedGrid(double turn_rad, std::size_t size)
{
    SourceGrid grid{.rows = size, .columns = size};
    for (std::size_t r = 0; r < size; ++r)
        for (std::size_t c = 0; c < size; ++c) {
            const double x = 0.5 * (static_cast<double>(c) - static_cast<double>(size - 1) / 2);
            const double y = 0.5 * (static_cast<double>(r) - static_cast<double>(size - 1) / 2);
            const double east = x * std::cos(turn_rad) - y * std::sin(turn_rad);
            const double north = x * std::sin(turn_rad) + y * std::cos(turn_rad);
            grid.latitude_deg.push_back(60 + north);
            grid.longitude_deg.push_back(10 + east / 0.5); // cos 60
        }
    return grid;
}

} // namespace

class TestGridSampling : public QObject
{
    Q_OBJECT

private slots:
    void nodesOfARectilinearGridAreKept()
    {
        // Latitudes fall and longitudes pass 0, as in many files.
        const SourceGrid grid = rectilinearGrid({62, 61, 60}, {358, 359, 0, 1});
        const TargetChoice all = chooseTarget(grid, {.mostPlaces = 100});
        QVERIFY(!all.fault);
        QCOMPARE(all.thinning, 1U);
        QCOMPARE(all.grid.latitude_deg, (std::vector<double>{60, 61, 62}));
        QCOMPARE(all.grid.longitude_deg.size(), 4U);
        COMPARE_NEAR(all.grid.longitude_deg.front(), -2, 1e-9);
        const GridSampling made = sampling(grid, all.grid, {});
        QCOMPARE(made.window.rows, 3U);
        QCOMPARE(made.window.columns, 4U);
        std::vector<double> values(12);
        for (std::size_t i = 0; i < 12; ++i)
            values[i] = static_cast<double>(i);
        // The south-west place is node (2, 0), the north-east one node (0, 3).
        QCOMPARE(sampled(made.shares.front(), values.data()), std::optional(8.0));
        QCOMPARE(sampled(made.shares.back(), values.data()), std::optional(3.0));
        QCOMPARE(made.alongX.front(), Point(1, 0));
    }

    void anAreaKeepsTheNodesAround()
    {
        const SourceGrid grid = rectilinearGrid({60, 61, 62, 63}, {5, 6, 7, 8});
        const TargetChoice part = chooseTarget(
            grid,
            {.area = GeoBox{.south_deg = 61.2, .west_deg = 6, .north_deg = 61.4, .east_deg = 6},
             .mostPlaces = 100});
        QCOMPARE(part.grid.latitude_deg, (std::vector<double>{61, 62}));
        QCOMPARE(part.grid.longitude_deg.size(), 1U);
        const TargetChoice outside = chooseTarget(
            grid, {.area = GeoBox{.south_deg = 10, .west_deg = 6, .north_deg = 20, .east_deg = 7},
                   .mostPlaces = 100});
        QCOMPARE(outside.fault, NoTarget::OutsideArea);
    }

    void globesNeedAnArea()
    {
        std::vector<double> longitudes;
        for (int i = 0; i < 360; ++i)
            longitudes.push_back(i);
        const SourceGrid globe = rectilinearGrid({-60, 0, 60}, longitudes);
        QCOMPARE(chooseTarget(globe, {.mostPlaces = 1000}).fault, NoTarget::TooWide);
        const TargetChoice part = chooseTarget(
            globe, {.area = GeoBox{.south_deg = 0, .west_deg = -3, .north_deg = 60, .east_deg = 3},
                    .mostPlaces = 1000});
        QVERIFY(!part.fault);
        QCOMPARE(part.grid.longitude_deg.size(), 7U);
        COMPARE_NEAR(part.grid.longitude_deg.front(), -3, 1e-9);
    }

    void largeGridsAreThinned()
    {
        const SourceGrid grid = rectilinearGrid({60, 61, 62, 63, 64}, {5, 6, 7, 8, 9});
        const TargetChoice thin = chooseTarget(grid, {.mostPlaces = 10});
        QCOMPARE(thin.thinning, 2U);
        QCOMPARE(thin.grid.latitude_deg, (std::vector<double>{60, 62, 64}));
    }

    void turnedGridsAreSampledBilinearly()
    {
        const double turn_rad = 0.5;
        const SourceGrid grid = turnedGrid(turn_rad, 9);
        const TargetChoice choice = chooseTarget(
            grid,
            {.area =
                 GeoBox{.south_deg = 59.7, .west_deg = 9.5, .north_deg = 60.3, .east_deg = 10.5},
             .mostPlaces = 1000});
        QVERIFY(!choice.fault);
        const GridSampling made = sampling(grid, choice.grid, {});
        // A bilinear map reproduces what is linear in latitude and longitude.
        std::vector<double> values;
        for (std::size_t r = 0; r < made.window.rows; ++r)
            for (std::size_t c = 0; c < made.window.columns; ++c) {
                const LatLon node = grid.at(made.window.firstRow + r, made.window.firstColumn + c);
                values.push_back(3 * node.latitude_deg - 2 * node.longitude_deg);
            }
        for (std::size_t i = 0; i < made.shares.size(); ++i) {
            const std::size_t columns = choice.grid.longitude_deg.size();
            const std::optional<double> value = sampled(made.shares[i], values.data());
            QVERIFY(value);
            COMPARE_NEAR(*value,
                         3 * choice.grid.latitude_deg[i / columns] -
                             2 * choice.grid.longitude_deg[i % columns],
                         1e-6);
            // cos 60 is exact in the middle only.
            COMPARE_NEAR(std::atan2(made.alongX[i].y(), made.alongX[i].x()), turn_rad, 0.01);
        }
    }

    void missingNodesGiveTheirWeightToTheOthers()
    {
        const double nan = std::numeric_limits<double>::quiet_NaN();
        const NodeShares shares{.nodes = {0, 1, 2, 3}, .weights = {0.5, 0.25, 0.25, 0}};
        const std::vector<double> some{4, nan, 8, 100};
        COMPARE_NEAR(*sampled(shares, some.data()), (0.5 * 4 + 0.25 * 8) / 0.75, 1e-12);
        const std::vector<double> none{nan, nan, nan, 1};
        QVERIFY(!sampled(shares, none.data()));
    }
};

QTEST_APPLESS_MAIN(TestGridSampling)
#include "tst_grid_sampling.moc"
