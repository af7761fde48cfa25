#include "core/base/angles.h"
#include "core/presets/move_origin.h"
#include "tests/support/approx.h"
#include "tests/support/expect_error.h"

#include <GeographicLib/Geodesic.hpp>

using namespace berg;
using namespace berg::test;

namespace {

/** A point moving over the Earth: its position now and a moment later. */
struct Path
{
    double length_m = 0;
    double azimuth_deg = 0;
};

/** Path over the Earth of `path_m` at a place of the plane around an origin. */
Path pathOverEarth(const LatLon& origin, const Point& from_m, const Point& path_m)
{
    const LocalFrame frame(origin);
    const LatLon a = frame.toGeographic(from_m);
    const LatLon b = frame.toGeographic(from_m + path_m);
    Path path;
    double end_deg = 0;
    GeographicLib::Geodesic::WGS84().Inverse(a.latitude_deg, a.longitude_deg, b.latitude_deg,
                                             b.longitude_deg, path.length_m, path.azimuth_deg,
                                             end_deg);
    return path;
}

Scenario scene(const LatLon& origin)
{
    Scenario s;
    s.origin = origin;
    s.current_mps = {0.2, -0.1};
    s.wind_mps = {3, 4};
    s.area_m = {{-9000, -9000}, {9000, -9000}, {0, 12000}};
    s.uavs = {
        {.id = "uav", .position_m = {-2000, 500}, .heading_deg = 10, .home_m = Point(-2500, 900)}};
    s.icebergs = {{.id = "a", .position_m = {8000, 7000}, .velocity_mps = {0.3, 0.1}},
                  {.id = "b", .position_m = {-6000, 2000}}};
    s.icebergs[1].track = {.time_s = {0, 600}, .position_m = {{-6000, 2000}, {-5900, 2100}}};
    s.asset = Asset{.name = "rig", .position_m = {100, -3000}, .velocity_mps = {5, -2}};
    return s;
}

void comparePaths(const Path& after, const Path& before)
{
    COMPARE_NEAR(std::remainder(after.azimuth_deg - before.azimuth_deg, 360.0), 0, 0.02);
    COMPARE_NEAR(after.length_m / before.length_m, 1, 1e-3); // no plane keeps all lengths
}

} // namespace

class TestMoveOrigin : public QObject
{
    Q_OBJECT

private slots:
    void keepsLayout()
    {
        const Scenario before = scene({47, -48});
        Scenario expected = before;
        expected.origin = {-70, 170};
        QVERIFY(movedTo(before, {-70, 170}, MoveMode::KeepLayout) == expected);
    }

    void keepsPlaces_data()
    {
        QTest::addColumn<double>("fromLatitude_deg");
        QTest::addColumn<double>("fromLongitude_deg");
        QTest::addColumn<double>("toLatitude_deg");
        QTest::addColumn<double>("toLongitude_deg");
        QTest::newRow("nearby") << 47.0 << -48.0 << 47.5 << -47.0;
        QTest::newRow("across the antimeridian") << 72.0 << 179.9 << 72.3 << -178.5;
        QTest::newRow("beside the pole") << 89.9 << 20.0 << 89.9 << -160.0;
        QTest::newRow("onto the pole") << 89.9 << 20.0 << 90.0 << 0.0;
        QTest::newRow("south") << -66.0 << -58.0 << -68.0 << -50.0;
    }

    void keepsPlaces()
    {
        QFETCH(double, fromLatitude_deg);
        QFETCH(double, fromLongitude_deg);
        QFETCH(double, toLatitude_deg);
        QFETCH(double, toLongitude_deg);
        const Scenario before = scene({fromLatitude_deg, fromLongitude_deg});
        const Scenario after =
            movedTo(before, {toLatitude_deg, toLongitude_deg}, MoveMode::KeepPlaces);
        const LocalFrame from(before.origin);
        const LocalFrame to(after.origin);
        const auto stays = [&](const Point& now_m, const Point& then_m) {
            COMPARE_NEAR((to.toPlane(from.toGeographic(then_m)) - now_m).norm(), 0, 1e-6);
        };
        stays(after.uavs[0].position_m, before.uavs[0].position_m);
        stays(*after.uavs[0].home_m, *before.uavs[0].home_m);
        stays(after.asset->position_m, before.asset->position_m);
        for (std::size_t i = 0; i < 3; ++i)
            stays(after.area_m[i], before.area_m[i]);
        for (std::size_t i = 0; i < 2; ++i) {
            const Iceberg& then = before.icebergs[i];
            const Iceberg& now = after.icebergs[i];
            stays(now.position_m, then.position_m);
            comparePaths(pathOverEarth(after.origin, now.position_m,
                                       1000 * (now.velocity_mps + after.current_mps)),
                         pathOverEarth(before.origin, then.position_m,
                                       1000 * (then.velocity_mps + before.current_mps)));
            COMPARE_NEAR((now.velocity_mps + after.current_mps).norm(),
                         (then.velocity_mps + before.current_mps).norm(), 1e-12);
        }
        for (std::size_t i = 0; i < 2; ++i)
            stays(after.icebergs[1].track.position_m[i], before.icebergs[1].track.position_m[i]);
        comparePaths(
            pathOverEarth(after.origin, after.asset->position_m, 100 * after.asset->velocity_mps),
            pathOverEarth(before.origin, before.asset->position_m,
                          100 * before.asset->velocity_mps));
        const auto ahead = [](const Uav& uav) {
            const double heading_rad = radFromDeg(uav.heading_deg);
            return Point(500 * std::sin(heading_rad), 500 * std::cos(heading_rad));
        };
        comparePaths(
            pathOverEarth(after.origin, after.uavs[0].position_m, ahead(after.uavs[0])),
            pathOverEarth(before.origin, before.uavs[0].position_m, ahead(before.uavs[0])));
        COMPARE_NEAR(after.wind_mps.norm(), before.wind_mps.norm(), 1e-12);
        QVERIFY(after.uavs[0].heading_deg >= 0 && after.uavs[0].heading_deg < 360);
    }

    void thereAndBack()
    {
        const Scenario before = scene({72, 179.9});
        const Scenario away = movedTo(before, {73, -179}, MoveMode::KeepPlaces);
        const Scenario back = movedTo(away, before.origin, MoveMode::KeepPlaces);
        for (std::size_t i = 0; i < 2; ++i) {
            COMPARE_NEAR((back.icebergs[i].position_m - before.icebergs[i].position_m).norm(), 0,
                         1e-6);
            COMPARE_NEAR((back.icebergs[i].velocity_mps - before.icebergs[i].velocity_mps).norm(),
                         0, 1e-6);
        }
        COMPARE_NEAR(back.uavs[0].heading_deg, before.uavs[0].heading_deg, 1e-5);
        COMPARE_NEAR((back.wind_mps - before.wind_mps).norm(), 0, 1e-6);
    }

    void nothingMovesInPlace()
    {
        const Scenario before = scene({47, -48});
        QVERIFY(movedTo(before, before.origin, MoveMode::KeepPlaces) == before);
    }

    void refusesTooFar()
    {
        const Scenario before = scene({47, -48});
        const auto error = errorOf([&] { return movedTo(before, {78, 15}, MoveMode::KeepPlaces); });
        QVERIFY(error.has_value());
        QCOMPARE(error->code(), ErrorCode::InvalidInput);
        QCOMPARE(error->subject(), std::string("origin"));
        QVERIFY(!error->issues().empty());
        QVERIFY(error->issues().front().field.find("area_m") != std::string::npos);
    }

    void refusesNoPlace()
    {
        const Scenario before = scene({47, -48});
        QVERIFY(errorOf([&] { return movedTo(before, {91, 0}, MoveMode::KeepLayout); }));
        QVERIFY(errorOf([&] { return movedTo(before, {std::nan(""), 0}, MoveMode::KeepPlaces); }));
    }
};

QTEST_APPLESS_MAIN(TestMoveOrigin)
#include "tst_move_origin.moc"
