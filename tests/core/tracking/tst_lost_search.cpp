#include "core/base/angles.h"
#include "core/base/random.h"
#include "core/geometry/geometry.h"
#include "core/tracking/lost_search.h"
#include "tests/support/approx.h"

#include <QTest>

#include <algorithm>
#include <cmath>

using namespace berg;

namespace {

double distanceToPath(const Point& p, const std::vector<Point>& corners_m)
{
    double least_m = (p - corners_m[0]).norm();
    for (std::size_t i = 1; i < corners_m.size(); ++i)
        least_m = std::min(least_m, distanceToSegment(corners_m[i - 1], corners_m[i], p));
    return least_m;
}

const SensorSpec kSensor{.fov_m = Point(600, 600)};

LostSearch squareSearch(double sd_m)
{
    return LostSearch({.search = SearchPattern::Square}, kSensor, sd_m, 0);
}

FieldOfView viewAt(const Point& centre_m)
{
    return {kSensor, centre_m, 0};
}

} // namespace

class TestLostSearch : public QObject
{
    Q_OBJECT

private slots:
    /** Legs of S, S, 2S, 2S, 3S, right turns: IAMSAR's picture for a first leg to the north. */
    void expandingSquareByHand()
    {
        const std::vector<Point> corners_m = expandingSquare(100, 100, kPi / 2);
        const std::vector<Point> expected_m{{0, 0},      {0, 100},     {100, 100},
                                            {100, -100}, {-100, -100}, {-100, 200}};
        QCOMPARE(corners_m.size(), expected_m.size());
        for (std::size_t i = 0; i < corners_m.size(); ++i)
            COMPARE_NEAR((corners_m[i] - expected_m[i]).norm(), 0, 1e-9);
    }

    /** Every point of the square is passed within half a track spacing and a little more. */
    void expandingSquareCovers()
    {
        Random random(2, 0);
        for (const double reach_m : {90.0, 540.0, 1700.0}) {
            const double heading_rad = random.uniform(-kPi, kPi);
            const std::vector<Point> corners_m = expandingSquare(540, reach_m, heading_rad);
            const Point along(std::cos(heading_rad), std::sin(heading_rad));
            const Point left(-along.y(), along.x());
            for (int k = 0; k < 2000; ++k) {
                const Point p_m = random.uniform(-reach_m, reach_m) * along +
                                  random.uniform(-reach_m, reach_m) * left;
                QVERIFY(distanceToPath(p_m, corners_m) <= 540 / std::sqrt(2.0) + 1e-6);
                // A camera 600 m across, 0.9 of which is the spacing, sees every point except in
                // corners.
            }
        }
        QCOMPARE(expandingSquare(540, 0, 0).size(), 1U);
    }

    /**
     * A position uncertain by 5,000 km and a view of a metre would make a gigabyte of useless
     * corners.
     */
    void expandingSquareIsBounded()
    {
        const std::vector<Point> corners_m = expandingSquare(0.9, 15e6, 0);
        QCOMPARE(corners_m.size(), 4U * kMostSquareRounds + 2);
        const double outermost_m = 0.9 * kMostSquareRounds;
        QVERIFY(corners_m.back().norm() >= outermost_m);
        QVERIFY(distanceToPath(Point(0.999 * outermost_m, -0.999 * outermost_m), corners_m) < 1);
        QCOMPARE(expandingSquare(1e-300, 1e300, 0).size(), corners_m.size());
    }

    void sectorSearchByHand()
    {
        const std::vector<Point> corners_m = sectorSearch(1000, kPi / 2);
        QCOMPARE(corners_m.size(), 10U);
        for (std::size_t i = 1; i < corners_m.size(); ++i)
            COMPARE_NEAR((corners_m[i] - corners_m[i - 1]).norm(), 1000, 1e-9);
        for (const std::size_t home : {0U, 3U, 6U, 9U})
            COMPARE_NEAR(corners_m[home].norm(), 0, 1e-9);
        // Each triangle starts straight on where the last one ended.
        for (const std::size_t home : {3U, 6U}) {
            const Point in_m = corners_m[home] - corners_m[home - 1];
            const Point out_m = corners_m[home + 1] - corners_m[home];
            COMPARE_NEAR((in_m - out_m).norm(), 0, 1e-9);
        }
        // Six directions, 60 degrees apart.
        for (const std::size_t i : {1U, 2U, 4U, 5U, 7U, 8U})
            for (const std::size_t j : {1U, 2U, 4U, 5U, 7U, 8U})
                if (i != j)
                    QVERIFY((corners_m[i] - corners_m[j]).norm() > 999);
    }

    void bayesByHand()
    {
        COMPARE_NEAR(afterMiss(0.5, 0.8), 0.1 / 0.6, 1e-12);
        QCOMPARE(afterMiss(1, 0.9), 1.0);
        QCOMPARE(afterMiss(0, 0.9), 0.0);
        QCOMPARE(afterMiss(1, 1), 0.0);
        QCOMPARE(afterMiss(0.3, 0), 0.3);
    }

    /** The normal distribution cut at 3.2 standard deviations keeps 0.99 of its variance. */
    void gridKeepsTheVariance()
    {
        const LostSearch search = squareSearch(400);
        COMPARE_NEAR(search.variance_m2() / (400.0 * 400.0), 1.0, 0.03);
    }

    /**
     * After a sample at the middle the remaining probability is farther out, by the formula of
     * Bayes.
     */
    void aSampleMovesTheChancesOutwards()
    {
        // 21 cells over +- 3.2: the view ends midway between two of them.
        constexpr double kInside_sd = 1.12;
        LostSearch search = squareSearch(300 / kInside_sd);
        const double before_m2 = search.variance_m2();
        search.miss(viewAt({5000, 0}), {0, 0}, 1); // a view elsewhere
        COMPARE_NEAR(search.variance_m2() / before_m2, 1, 1e-12);
        search.miss(viewAt({0, 0}), {0, 0}, 1);
        double left = 0;
        for (const double chance : search.chances())
            left += chance;
        COMPARE_NEAR(left, 1, 1e-12);
        // E[r^2 / 2 | outside] = (1 - p m) / (1 - p), m the variance along an axis inside.
        const double along = std::erf(kInside_sd / std::sqrt(2.0));
        const double p = along * along;
        const double density = std::exp(-kInside_sd * kInside_sd / 2) / std::sqrt(2 * kPi);
        const double inside = 1 - 2 * kInside_sd * density / along;
        COMPARE_NEAR(search.variance_m2() / before_m2, (1 - p * inside) / (1 - p), 0.05);
    }

    void missedDetectionsLeaveAChance()
    {
        LostSearch sure = squareSearch(200);
        LostSearch unsure = squareSearch(200);
        sure.miss(viewAt({0, 0}), {0, 0}, 1);
        unsure.miss(viewAt({0, 0}), {0, 0}, 0.5);
        QVERIFY(unsure.variance_m2() < sure.variance_m2());
        const auto middle = sure.chances().size() / 2;
        QCOMPARE(sure.chances()[middle], 0.0);
        QVERIFY(unsure.chances()[middle] > 0);
    }

    /**
     * If all cells were seen without a sighting, nothing follows, and nothing is divided by zero.
     */
    void sampleOfAllCellsChangesNothing()
    {
        LostSearch search = squareSearch(10);
        const SensorSpec wide{.fov_m = Point(1e5, 1e5)};
        search.miss(FieldOfView(wide, {0, 0}, 0), {0, 0}, 1);
        for (const double chance : search.chances())
            QVERIFY(std::isfinite(chance));
    }

    /** A leg that sees all cells has probability 1 over its time. */
    void chancePerSecondByHand()
    {
        const LostSearch search = squareSearch(150);
        // The reach is so wide that the first leg of 540 m sweeps every cell at once.
        COMPARE_NEAR(search.chancePerSecond({0, 0}, 20, 5000, 1),
                     (1 - LostSearch::kElsewhere) * 20 / 540, 1e-9);
        COMPARE_NEAR(search.chancePerSecond({0, 0}, 20, 5000, 0.5),
                     (1 - LostSearch::kElsewhere) * 10 / 540, 1e-9);
        QCOMPARE(search.chancePerSecond({0, 0}, 20, 0, 1) < (1 - LostSearch::kElsewhere) * 20 / 540,
                 true);
    }

    /** The likeliest place is the datum, until a view of it has shown nothing. */
    /** From the estimate outwards the UAV would fly over what it has just seen empty. */
    void beginsAtTheBestCorner()
    {
        const Point uav_m(-2000, 500);
        LostSearch search = squareSearch(1000);
        search.startAtBestCorner(uav_m, 25, 300, 0.9);
        const std::size_t fresh = search.next();
        for (double x_m = -1200; x_m <= 1200; x_m += 300)
            for (double y_m = -1200; y_m <= 1200; y_m += 300)
                for (int sample = 0; sample < 5; ++sample)
                    search.miss(viewAt({x_m, y_m}), Point::Zero(), 0.9);
        search.startAtBestCorner(uav_m, 25, 300, 0.9);
        const double chance = search.chancePerSecond(uav_m, 25, 300, 0.9);
        QVERIFY(search.next() > fresh);
        QVERIFY(search.corner_m().cwiseAbs().maxCoeff() > 1200);
        double fromDatum = 0;
        for (std::size_t next = 0; next < search.corners_m().size(); ++next) {
            const LostSearch other = LostSearch::restored(
                search.corners_m(), next, search.spread_m(), search.chances(), search.presence());
            const double its = other.chancePerSecond(uav_m, 25, 300, 0.9);
            QVERIFY(its <= chance);
            fromDatum = next == 0 ? its : fromDatum;
        }
        QVERIFY(chance > 2 * fromDatum);
    }

    /** An iceberg that is in no cell must not keep a UAV for ever. */
    void aSearchInVainIsWorthLess()
    {
        LostSearch search = squareSearch(1000);
        double before = search.chancePerSecond(Point::Zero(), 25, 300, 0.9);
        for (int round = 0; round < 4; ++round) {
            for (double x_m = -3300; x_m <= 3300; x_m += 600)
                for (double y_m = -3300; y_m <= 3300; y_m += 600)
                    search.miss(viewAt({x_m, y_m}), Point::Zero(), 0.9);
            search.startAtBestCorner(Point::Zero(), 25, 300, 0.9);
            const double after = search.chancePerSecond(Point::Zero(), 25, 300, 0.9);
            QVERIFY2(round == 0 || after < before / 2, qPrintable(QString::number(after / before)));
            before = after;
        }
    }

    void patternWithoutCornersHasNoBest()
    {
        LostSearch search({.search = SearchPattern::None}, kSensor, 500, 0);
        search.startAtBestCorner(Point::Zero(), 25, 300, 1);
        QVERIFY(!search.hasCorner());
    }

    void likeliestPlacesAreApart()
    {
        constexpr double kHalf_m = 150;
        constexpr std::size_t kMost = 4;
        LostSearch search = squareSearch(200);
        const SearchPlace first = search.likeliestPlaces(kHalf_m, kMost).front();
        QVERIFY(first.offset_m.norm() < 1e-9);
        const double inside = std::erf(kHalf_m / (std::sqrt(2.0) * 200));
        COMPARE_NEAR(first.chance, inside * inside, 0.06); // in cells of 64 m
        search.miss(FieldOfView({.fov_m = {320, 320}}, {0, 0}, 0), {0, 0}, 1);
        const std::vector<SearchPlace> places = search.likeliestPlaces(kHalf_m, kMost);
        QCOMPARE(places.size(), kMost);
        double sum = 0;
        for (std::size_t k = 0; k < places.size(); ++k) {
            sum += places[k].chance;
            QVERIFY(places[k].offset_m.norm() > 100);
            QVERIFY(k == 0 || places[k].chance <= places[k - 1].chance + 1e-12);
        }
        QVERIFY(sum > 0.5 && sum <= 1);
        QVERIFY(search.likeliestPlaces(kHalf_m, 1).size() == 1);
    }

    void endsWithThePattern()
    {
        LostSearch search = squareSearch(300);
        std::size_t legs = 0;
        for (; search.hasCorner(); ++legs)
            search.nextCorner();
        QCOMPARE(legs, search.corners_m().size() - 1);
        QCOMPARE(search.chancePerSecond({0, 0}, 20, 300, 1), 0.0);
        QVERIFY(!LostSearch({.search = SearchPattern::None}, kSensor, 300, 0).hasCorner());
    }

    void restoredSearchIsEqual()
    {
        LostSearch search = squareSearch(250);
        search.miss(viewAt({100, 50}), {0, 0}, 0.7);
        search.nextCorner();
        search.grow(400);
        QCOMPARE(LostSearch::restored(search.corners_m(), search.next(), search.spread_m(),
                                      search.chances(), search.presence()),
                 search);
    }
};

QTEST_APPLESS_MAIN(TestLostSearch)
#include "tst_lost_search.moc"
