#include "core/base/angles.h"
#include "core/scenario/fence.h"

#include <QTest>

#include <cmath>

using namespace berg;

namespace {

const std::vector<Point> kSquare_m{{0, 0}, {1000, 0}, {1000, 1000}, {0, 1000}};

} // namespace

class TestFence : public QObject
{
    Q_OBJECT

private slots:
    void heightsDecide_data()
    {
        QTest::addColumn<double>("floor_m");
        QTest::addColumn<double>("ceiling_m"); // 0 means no ceiling
        QTest::addColumn<bool>("isClosed");
        QTest::newRow("at every height") << 0.0 << 0.0 << true;
        QTest::newRow("up to its height") << 0.0 << 120.0 << true;
        QTest::newRow("below") << 0.0 << 119.0 << false;
        QTest::newRow("from its height on") << 120.0 << 0.0 << true;
        QTest::newRow("above") << 121.0 << 300.0 << false;
    }
    void heightsDecide()
    {
        QFETCH(double, floor_m);
        QFETCH(double, ceiling_m);
        QFETCH(bool, isClosed);
        NoFlyArea area{.corners_m = kSquare_m, .floor_m = floor_m};
        if (ceiling_m > 0)
            area.ceiling_m = ceiling_m;
        QCOMPARE(isClosedAt(area, 120), isClosed);
        Scenario s;
        s.noFly = {area};
        const std::shared_ptr<const Geofence> fence = fenceOf(s, 120, {});
        QCOMPARE(fence != nullptr, isClosed);
        QVERIFY(!fence || (!fence->contains({500, 500}) && fence->contains({1500, 500})));
    }

    void areaIsOneOfThemOnlyAsAGeofence()
    {
        Scenario s;
        s.area_m = kSquare_m;
        QVERIFY(!fenceOf(s, 120, {}));
        s.geofence = true;
        QVERIFY(!fenceOf(s, 120, {})->contains({1500, 500}));
        s.noFly = {{.corners_m = {{0, 0}, {200, 0}, {0, 200}}}};
        QCOMPARE(cornersAt(closedAreas(s), 120), std::size_t{3});
        QCOMPARE(closedAt(closedAreas(s), 120, {50, 50}), std::size_t{0});
        QCOMPARE(closedAt(closedAreas(s), 120, {500, 500}), std::size_t{1});
        QVERIFY(!fenceOf(s, 120, {})->contains({50, 50}));
    }

    void ringIsDrawnAboutTheCircle()
    {
        const Asset asset{.name = "rig", .position_m = {300, -200}, .standoff_m = 500};
        const std::optional<NoFlyArea> ring = standoffArea(asset, 3600);
        QVERIFY(ring);
        QCOMPARE(ring->corners_m.size(), std::size_t{kRingCorners});
        for (int i = 0; i < 360; ++i) {
            const double angle_rad = 2 * kPi * i / 360;
            const Point out(std::cos(angle_rad), std::sin(angle_rad));
            QVERIFY(insidePolygon(ring->corners_m, asset.position_m + 499.9 * out));
            QVERIFY(!insidePolygon(ring->corners_m, asset.position_m + 510 * out));
        }
        QVERIFY(!standoffArea({.position_m = {300, -200}}, 3600));
    }

    /** The ring sweeps up to the end of the run. */
    void ringOfAShipIsAllThatItSweeps()
    {
        Scenario s;
        s.duration_s = 1000;
        s.noFly = {{.name = "first", .corners_m = kSquare_m}};
        s.asset = Asset{.velocity_mps = {3, -4}, .standoff_m = 400, .standoffCeiling_m = 150};
        const std::vector<NoFlyArea> areas = closedAreas(s);
        QCOMPARE(areas.size(), std::size_t{2});
        const NoFlyArea& ring = areas.back();
        QVERIFY(ring.ceiling_m == 150.0);
        QVERIFY(isSimplePolygon(ring.corners_m));
        QVERIFY(ring.corners_m.size() <= kRingCorners + 2);
        for (double time_s = 0; time_s <= s.duration_s; time_s += 50)
            for (int i = 0; i < 16; ++i) {
                const double angle_rad = 2 * kPi * i / 16;
                QVERIFY(insidePolygon(ring.corners_m,
                                      time_s * s.asset->velocity_mps +
                                          399.9 * Point(std::cos(angle_rad), std::sin(angle_rad))));
            }
        const Point ahead = Point(3, -4) / 5;
        QVERIFY(!insidePolygon(ring.corners_m, -410 * ahead));
        QVERIFY(!insidePolygon(ring.corners_m, 5410 * ahead));
    }
};

QTEST_APPLESS_MAIN(TestFence)
#include "tst_fence.moc"
