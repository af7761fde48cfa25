#include "core/base/angles.h"
#include "core/base/random.h"
#include "core/io/export/content/geo_shapes.h"
#include "core/io/import/fields/area_outline.h"
#include "core/io/text/export_numbers.h"

#include <QtTest>

#include <algorithm>

using namespace berg;
using namespace Qt::StringLiterals;

namespace {

/** Returns a star-shaped polygon around a place. */
std::vector<Point> star(std::uint64_t seed, const Point& middle_m, double radius_m, int corners)
{
    Random random(seed, 3);
    std::vector<Point> polygon_m;
    for (int i = 0; i < corners; ++i) {
        const double angle_rad = 2 * kPi * (i + 0.5 * random.uniform()) / corners;
        const double length_m = radius_m * (0.3 + 0.7 * random.uniform());
        polygon_m.push_back(middle_m + length_m * Point(std::cos(angle_rad), std::sin(angle_rad)));
    }
    return polygon_m;
}

/** Returns fingers from south to north, so that a meridian is crossed many times. */
std::vector<Point> comb(int fingers, double size_m)
{
    std::vector<Point> polygon_m{Point(-size_m, -size_m)};
    for (int i = 0; i < fingers; ++i) {
        const double y_m = size_m * (2.0 * i / fingers - 1);
        polygon_m.push_back(Point(size_m, y_m));
        polygon_m.push_back(Point(size_m, y_m + size_m / fingers));
        polygon_m.push_back(Point(-size_m / 2, y_m + size_m / fingers));
        polygon_m.push_back(Point(-size_m / 2, y_m + 2 * size_m / fingers));
    }
    polygon_m.push_back(Point(-size_m, size_m));
    return polygon_m;
}

/** Rings in the form of files. */
std::vector<std::vector<LatLon>> exported(const LocalFrame& frame, const std::vector<Point>& area_m)
{
    std::vector<std::vector<LatLon>> rings = geographicPolygon(frame, area_m);
    for (std::vector<LatLon>& ring : rings)
        for (LatLon& place : ring)
            place = {.latitude_deg = roundedDegrees(place.latitude_deg),
                     .longitude_deg = roundedDegrees(place.longitude_deg)};
    return rings;
}

/** Returns an empty text if the corners are the same, from any start and in either sense. */
QString difference(std::vector<Point> found_m, std::vector<Point> expected_m)
{
    constexpr double kNear_m = 0.001; // the rounding to nine decimals
    if (found_m.size() != expected_m.size())
        return u"%1 corners, not %2"_s.arg(found_m.size()).arg(expected_m.size());
    if (signedArea(expected_m) < 0)
        std::reverse(expected_m.begin(), expected_m.end());
    const auto first = std::find_if(expected_m.begin(), expected_m.end(), [&](const Point& corner) {
        return (corner - found_m.front()).norm() < kNear_m;
    });
    std::rotate(expected_m.begin(), first, expected_m.end());
    for (std::size_t i = 0; i < found_m.size(); ++i)
        if (!((found_m[i] - expected_m[i]).norm() < kNear_m))
            return u"corner %1"_s.arg(i);
    return {};
}

} // namespace

/** Tests that the corners of an area are recovered from the rings of a map. */
class TestAreaOutline : public QObject
{
    Q_OBJECT

private slots:
    void cornersAreRecovered_data()
    {
        QTest::addColumn<double>("latitude_deg");
        QTest::addColumn<double>("longitude_deg");
        QTest::newRow("Grand Banks") << 47.0 << -48.0;
        QTest::newRow("equator, across 180") << 0.0 << 179.99;
        QTest::newRow("on 180") << 65.0 << 180.0;
        QTest::newRow("across 180, south") << -75.0 << -179.9;
        QTest::newRow("near the North Pole") << 89.5 << 20.0;
        QTest::newRow("North Pole") << 90.0 << 0.0;
        QTest::newRow("South Pole") << -89.99 << 180.0;
    }

    void cornersAreRecovered()
    {
        QFETCH(double, latitude_deg);
        QFETCH(double, longitude_deg);
        const LocalFrame frame({.latitude_deg = latitude_deg, .longitude_deg = longitude_deg});
        for (std::uint64_t seed = 1; seed <= 30; ++seed)
            for (const double size_m : {500.0, 2e4, 4e5}) {
                const Point middle_m = seed % 2 == 0 ? Point(0, 0) : Point(size_m, -size_m / 3);
                std::vector<Point> area_m =
                    star(seed, middle_m, size_m, 3 + static_cast<int>(seed % 9));
                if (seed % 3 == 0)
                    std::reverse(area_m.begin(), area_m.end());
                const QString fault =
                    difference(areaOutline(exported(frame, area_m), frame), area_m);
                QVERIFY2(fault.isEmpty(),
                         qPrintable(u"seed %1, %2 m: %3"_s.arg(seed).arg(size_m).arg(fault)));
            }
    }

    void outlineWithManyCutsIsJoined()
    {
        for (const double latitude_deg : {0.0, 70.0, -80.0}) {
            const LocalFrame frame({.latitude_deg = latitude_deg, .longitude_deg = 180});
            const std::vector<Point> area_m = comb(7, 3e4);
            const std::vector<std::vector<LatLon>> rings = exported(frame, area_m);
            QVERIFY(rings.size() > 3);
            const QString fault = difference(areaOutline(rings, frame), area_m);
            QVERIFY2(fault.isEmpty(), qPrintable(fault));
        }
    }

    /** Rings may come in any order and begin anywhere. */
    void ringsMayComeInAnyOrder()
    {
        const LocalFrame frame({.latitude_deg = 60, .longitude_deg = 180});
        const std::vector<Point> area_m = comb(5, 1e4);
        std::vector<std::vector<LatLon>> rings = exported(frame, area_m);
        std::reverse(rings.begin(), rings.end());
        for (std::vector<LatLon>& ring : rings) {
            ring.pop_back();
            std::rotate(ring.begin(), ring.begin() + 2, ring.end());
        }
        const QString fault = difference(areaOutline(rings, frame), area_m);
        QVERIFY2(fault.isEmpty(), qPrintable(fault));
    }

    /** The area is the same in the plane of another origin. */
    void outlineIsTheSameFromAnotherOrigin()
    {
        const LocalFrame from({.latitude_deg = 72, .longitude_deg = 179});
        const LocalFrame to({.latitude_deg = 70, .longitude_deg = -175});
        const std::vector<Point> area_m = star(5, Point(1e4, 0), 3e4, 8);
        const std::vector<Point> outline_m = areaOutline(exported(from, area_m), to);
        std::vector<Point> expected_m;
        for (const Point& corner_m : area_m)
            expected_m.push_back(to.toPlane(from.toGeographic(corner_m)));
        for (const Point& corner_m : expected_m)
            QVERIFY(std::any_of(outline_m.begin(), outline_m.end(), [&](const Point& found_m) {
                return (found_m - corner_m).norm() < 0.001;
            }));
        for (const Point& corner_m : outline_m)
            QVERIFY(distanceToEdges(expected_m, corner_m) < 30);
    }

    /** An edge along the antimeridian is a real edge if there is nothing on its other side. */
    void edgeOnTheAntimeridianIsKept()
    {
        const LocalFrame frame({.latitude_deg = 10, .longitude_deg = 179.9});
        const std::vector<std::vector<LatLon>> rings{
            {{10, 179.9}, {10, 180}, {10.1, 180}, {10.1, 179.9}, {10, 179.9}}};
        QCOMPARE(areaOutline(rings, frame).size(), std::size_t{4});
        QVERIFY((areaOutline(rings, frame)[1] - frame.toPlane({10, 180})).norm() < 0.001);
    }

    void severalPartsAreNoOutline()
    {
        const LocalFrame frame({.latitude_deg = 10, .longitude_deg = 20});
        const std::vector<LatLon> here{{10, 20}, {10, 20.1}, {10.1, 20.1}};
        const std::vector<LatLon> there{{11, 20}, {11, 20.1}, {11.1, 20.1}};
        QVERIFY(areaOutline(std::vector{here, there}, frame).empty());
        const std::vector<LatLon> cut{{10, 179.9}, {10, 180}, {10.1, 180}};
        QVERIFY(areaOutline(std::vector{here, cut}, frame).empty());
        QVERIFY(areaOutline({}, frame).empty());
    }

    void tooFewCornersAreReturned()
    {
        const LocalFrame frame({.latitude_deg = 10, .longitude_deg = 20});
        using Rings = std::vector<std::vector<LatLon>>;
        for (const std::size_t count : {std::size_t{1}, std::size_t{2}, std::size_t{5}})
            QCOMPARE(areaOutline(Rings(1, std::vector(count, LatLon{10, 20})), frame).size(),
                     std::size_t{1});
        const std::vector<LatLon> line{{10, 20}, {10, 20.01}, {10, 20.02}, {10, 20}};
        QVERIFY(areaOutline(Rings(1, line), frame).size() < 3);
    }
};

QTEST_APPLESS_MAIN(TestAreaOutline)
#include "tst_area_outline.moc"
