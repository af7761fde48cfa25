#include "core/base/angles.h"
#include "core/base/random.h"
#include "core/bound/view_cells.h"
#include "core/vehicle/dubins.h"

#include <QtTest>

using namespace berg;

namespace {

const ViewRegion kRound{.centre_m = {300, -200}, .half_m = {424, 424}};
const ViewRegion kOtherDisk{.centre_m = {1500, 400}, .half_m = {350, 350}};
const ViewRegion kRectangle{.centre_m = {-900, 700}, .half_m = {300, 150}, .disk = false};

/** A point of the edge and the cell it lies in. */
struct EdgePoint
{
    Point at_m = Point::Zero();
    int cell = 0;
};

EdgePoint pointOf(const ViewRegion& region, int cells, double share)
{
    if (region.disk) {
        const double angle_rad = 2 * kPi * share;
        // The first cell lies astride the east.
        const int cell = static_cast<int>(std::lround(share * cells)) % cells;
        return {.at_m = region.centre_m +
                        region.half_m.x() * Point(std::cos(angle_rad), std::sin(angle_rad)),
                .cell = cell};
    }
    const int side = std::min(3, static_cast<int>(share * 4));
    const double along = share * 4 - side; // 0 to 1
    const int cell =
        side * cells / 4 + std::min(cells / 4 - 1, static_cast<int>(along * cells / 4));
    const double s = 2 * along - 1;
    const Point corners[] = {{1, s}, {-s, 1}, {-1, -s}, {s, -1}};
    return {.at_m = region.centre_m + region.half_m.cwiseProduct(corners[side]), .cell = cell};
}

} // namespace

class TestViewCells : public QObject
{
    Q_OBJECT
private slots:
    void noFlightIsFaster_data();
    void noFlightIsFaster();
    void finerIsLonger();
    void touching();
    void inside();
};

void TestViewCells::noFlightIsFaster_data()
{
    QTest::addColumn<double>("east_mps");
    QTest::addColumn<int>("cells");
    QTest::newRow("calm") << 0.0 << 8;
    QTest::newRow("calm, fine") << 0.0 << 64;
    QTest::newRow("wind") << 12.0 << 16;
    QTest::newRow("storm") << -20.5 << 16;
}

void TestViewCells::noFlightIsFaster()
{
    QFETCH(double, east_mps);
    QFETCH(int, cells);
    const std::vector<ViewRegion> regions{kRound, kRectangle, kOtherDisk};
    const Travel travel{.airspeed_mps = 22, .wind_mps = {east_mps, 3}};
    const ViewCells cut(regions, cells, travel);
    const Point start_m(-400, 100);
    const std::vector<float> fromStart_s = cut.legsFrom_s(start_m);
    Random random(5);
    for (int i = 0; i < 20000; ++i) {
        const int a = static_cast<int>(random.below(3));
        const int b = static_cast<int>(random.below(3));
        const EdgePoint from =
            pointOf(regions[static_cast<std::size_t>(a)], cells, random.uniform());
        const EdgePoint to = pointOf(regions[static_cast<std::size_t>(b)], cells, random.uniform());
        QVERIFY(static_cast<double>(cut.legs_s(a, from.cell, b)[to.cell]) <=
                flightTime_s(to.at_m - from.at_m, 22, travel.wind_mps) + 1e-9);
        QVERIFY(static_cast<double>(fromStart_s[static_cast<std::size_t>(b * cells + to.cell)]) <=
                flightTime_s(to.at_m - start_m, 22, travel.wind_mps) + 1e-9);
    }
}

void TestViewCells::finerIsLonger()
{
    // The distance of the nearest points of the two disks is 1341.6 - 424 - 350 m.
    const std::vector<ViewRegion> regions{kRound, kOtherDisk};
    double last_s = 0;
    for (const int cells : {8, 32, 128}) {
        const ViewCells cut(regions, cells, {});
        double least_s = 1e9;
        for (int a = 0; a < cells; ++a)
            for (int b = 0; b < cells; ++b)
                least_s = std::min(least_s, static_cast<double>(cut.legs_s(0, a, 1)[b]));
        QVERIFY(least_s >= last_s);
        last_s = least_s;
    }
    const double exact_s = (std::sqrt(1200.0 * 1200 + 600 * 600) - 774) / 22;
    QVERIFY(last_s <= exact_s);
    QVERIFY(last_s > 0.97 * exact_s);
}

void TestViewCells::touching()
{
    const std::vector<ViewRegion> regions{
        kRound, kRectangle, {.centre_m = {-500, 400}, .half_m = {350, 350}}};
    const int cells = 16;
    const ViewCells cut(regions, cells, {});
    Random random(6);
    for (int i = 0; i < 5000; ++i) {
        const std::size_t a = random.below(3);
        const EdgePoint p = pointOf(regions[a], cells, random.uniform());
        for (std::size_t b = 0; b < 3; ++b)
            if (regions[b].contains(p.at_m))
                QVERIFY((cut.touching(static_cast<int>(a), p.cell) >> b & 1U) != 0);
    }
    QCOMPARE(cut.touching(0, 0), 1U); // The east of the first disk touches only that disk.
}

void TestViewCells::inside()
{
    QVERIFY(kRectangle.contains({-1200, 850}));
    QVERIFY(!kRectangle.contains({-1201, 700}));
    QVERIFY(kRound.contains({724, -200}));
    QVERIFY(!kRound.contains({300 + 310, -200 + 310}));
}

QTEST_APPLESS_MAIN(TestViewCells)

#include "tst_view_cells.moc"
