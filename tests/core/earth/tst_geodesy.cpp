#include "core/base/angles.h"
#include "core/earth/geodesy.h"
#include "tests/support/approx.h"

#include <GeographicLib/Geodesic.hpp>
#include <limits>
#include <vector>

using namespace berg;

namespace {

/** WGS 84 geodesic from `a` to `b`: length and azimuth at `a` clockwise from north. */
struct GeodesicLine
{
    double length_m = 0;
    double azimuth_deg = 0;
};

GeodesicLine geodesic(LatLon a, LatLon b)
{
    GeodesicLine line;
    double endAzimuth_deg = 0;
    GeographicLib::Geodesic::WGS84().Inverse(a.latitude_deg, a.longitude_deg, b.latitude_deg,
                                             b.longitude_deg, line.length_m, line.azimuth_deg,
                                             endAzimuth_deg);
    return line;
}

/** Square of points around the origin of the plane, the origin included. */
std::vector<Point> grid(double half_m)
{
    std::vector<Point> points;
    for (int i = -4; i <= 4; ++i)
        for (int j = -4; j <= 4; ++j)
            points.emplace_back(half_m * i / 4, half_m * j / 4);
    return points;
}

constexpr double kTolerance_m = 1e-6; // rounding: 180 degrees in a double are 3 nm

} // namespace

class TestGeodesy : public QObject
{
    Q_OBJECT

private:
    static void addOrigins()
    {
        QTest::addColumn<double>("latitude_deg");
        QTest::addColumn<double>("longitude_deg");
        const auto row = [](const char* name, double latitude_deg, double longitude_deg) {
            QTest::newRow(name) << latitude_deg << longitude_deg;
        };
        row("equator", 0, 0);
        row("Grand Banks", 47, -48);
        row("80 north", 80, 20);
        row("89.9 north", 89.9, 100);
        row("89.9 south", -89.9, -30);
        row("north pole", 90, 0);
        row("south pole", -90, 0);
        row("antimeridian, east side", 70, 179.95);
        row("antimeridian, west side", -65, -179.95);
        row("on the antimeridian", 10, 180);
        row("on the antimeridian, other sign", 10, -180);
    }

private slots:
    void planeAndPlaceRoundTrip_data() { addOrigins(); }

    void planeAndPlaceRoundTrip()
    {
        QFETCH(double, latitude_deg);
        QFETCH(double, longitude_deg);
        const LocalFrame frame({latitude_deg, longitude_deg});
        for (const double half_m : {1.0, 5000.0, 300000.0})
            for (const Point& p_m : grid(half_m)) {
                const LatLon place = frame.toGeographic(p_m);
                QVERIFY(std::abs(place.latitude_deg) <= 90);
                QVERIFY(place.longitude_deg >= -180 && place.longitude_deg < 180);
                COMPARE_NEAR((frame.toPlane(place) - p_m).norm(), 0, kTolerance_m);
            }
    }

    void distanceIsTheGeodesic_data() { addOrigins(); }

    void distanceIsTheGeodesic()
    {
        QFETCH(double, latitude_deg);
        QFETCH(double, longitude_deg);
        const LatLon origin{latitude_deg, longitude_deg};
        const LocalFrame frame(origin);
        for (const Point& p_m : grid(300000)) {
            const LatLon place = frame.toGeographic(p_m);
            const GeodesicLine line = geodesic(origin, place);
            COMPARE_NEAR(p_m.norm(), line.length_m, 1e-3);
            // From a pole every direction is south; elsewhere x is east and y north.
            if (std::abs(latitude_deg) == 90)
                continue;
            const double azimuth_rad = radFromDeg(line.azimuth_deg);
            const Point expected_m =
                line.length_m * Point(std::sin(azimuth_rad), std::cos(azimuth_rad));
            COMPARE_NEAR((frame.toPlane(place) - expected_m).norm(), 0, 1e-3);
        }
    }

    /** Lengths of WGS 84 itself: a = 6378137 m, quarter meridian 10,001,965.729 m. */
    void lengthsFromTheEllipsoid()
    {
        const LocalFrame equator({0, 0});
        const Point east_m = equator.toPlane({0, 1});
        COMPARE_NEAR(east_m.x(), 6378137 * kPi / 180, 1e-6);
        COMPARE_NEAR(east_m.y(), 0, 1e-6);
        const Point north_m = equator.toPlane({1, 0});
        COMPARE_NEAR(north_m.x(), 0, 1e-6);
        COMPARE_NEAR(north_m.y(), 110574.389, 1e-3); // first degree of the meridian
        COMPARE_NEAR(equator.toPlane({90, 0}).y(), 10001965.729, 1e-3);
    }

    /** One degree of longitude at 47 degrees: N cos(lat), less the sagitta a geodesic saves. */
    void eastIsEastOnTheGrandBanks()
    {
        const LocalFrame frame({47, -48});
        const double e2 = 0.00669437999014;
        const double s = std::sin(radFromDeg(47.0));
        const double primeVertical_m = 6378137 / std::sqrt(1 - e2 * s * s);
        const double smallArc_m = primeVertical_m * std::cos(radFromDeg(47.0)) * radFromDeg(0.01);
        const Point p_m = frame.toPlane({47, -47.99});
        COMPARE_NEAR(p_m.x(), smallArc_m, 1e-3); // 760 m: the sagitta shortens by micrometres
        QVERIFY(p_m.y() > 0 && p_m.y() < 0.1);   // the parallel bends north of the geodesic
        QVERIFY(frame.toPlane({47, -48.01}).x() < 0);
        QVERIFY(frame.toPlane({47.01, -48}).y() > 0);
    }

    /** Snyder 1987, Map Projections: rho of the polar stereographic with k0 = 0.994. */
    void polarChartMatchesSnyder()
    {
        const PolarFrame north(Pole::North, -45);
        QVERIFY(north.toPlane({90, 0}).norm() < 1e-6);
        const double e = std::sqrt(0.00669437999014);
        const double s = std::sin(radFromDeg(70.0));
        const double t =
            std::tan(kPi / 4 - radFromDeg(35.0)) / std::pow((1 - e * s) / (1 + e * s), e / 2);
        const double rho_m =
            2 * 6378137 * 0.994 * t / std::sqrt(std::pow(1 + e, 1 + e) * std::pow(1 - e, 1 - e));
        const Point down_m = north.toPlane({70, -45});
        COMPARE_NEAR(down_m.x(), 0, 1e-6);
        COMPARE_NEAR(down_m.y(), -rho_m, 1e-3);
        COMPARE_NEAR(north.toPlane({70, 45}).x(), rho_m, 1e-3);
        const PolarFrame south(Pole::South, 0);
        COMPARE_NEAR(south.toPlane({-70, 0}).y(), rho_m, 1e-3);
        COMPARE_NEAR(south.toPlane({-70, 90}).x(), rho_m, 1e-3);
        for (const PolarFrame& frame : {north, south})
            for (const Point& p_m : grid(4e6)) {
                const LatLon place = frame.toGeographic(p_m);
                QVERIFY(place.longitude_deg >= -180 && place.longitude_deg < 180);
                COMPARE_NEAR((frame.toPlane(place) - p_m).norm(), 0, 1e-6);
            }
    }

    void placesAcrossTheAntimeridian()
    {
        const LocalFrame west({70, 179.95});
        const Point p_m = west.toPlane({70, -179.95});
        const GeodesicLine line = geodesic({70, 179.95}, {70, -179.95});
        QVERIFY(p_m.x() > 0); // not around the far side
        COMPARE_NEAR(p_m.norm(), line.length_m, 1e-3);
        QVERIFY(p_m.norm() < 4000); // 0.1 degrees at 70 north are 3.8 km
        const LatLon back = west.toGeographic(p_m);
        COMPARE_NEAR(back.longitude_deg, -179.95, 1e-10);
        const LocalFrame same({70, 179.95 - 360});
        COMPARE_NEAR((same.toPlane({70, -179.95}) - p_m).norm(), 0, kTolerance_m);
    }

    /** Files and GPX allow [-180, 180), so places at the line must not become +180. */
    void longitudeIsBelow180()
    {
        for (const double origin_deg : {180.0, -180.0, 179.0, -179.0}) {
            const LocalFrame frame({0, origin_deg});
            QVERIFY(frame.toGeographic(Point::Zero()).longitude_deg < 180);
            const double line_m = frame.toPlane({0, 180}).x();
            double x_m = std::nextafter(line_m, -std::numeric_limits<double>::infinity());
            for (int i = 0; i < 3; ++i) {
                const double longitude_deg = frame.toGeographic({x_m, 0}).longitude_deg;
                QVERIFY(longitude_deg >= -180 && longitude_deg < 180);
                COMPARE_NEAR(std::abs(longitude_deg), 180, 1e-9);
                x_m = std::nextafter(x_m, std::numeric_limits<double>::infinity());
            }
        }
    }

    void poleSeenFromNearby()
    {
        const LocalFrame frame({89.9, 100});
        const Point pole_m = frame.toPlane({90, -20});
        COMPARE_NEAR(pole_m.x(), 0, kTolerance_m);
        COMPARE_NEAR(pole_m.y(), geodesic({89.9, 100}, {90, 100}).length_m, 1e-3);
        // Across the pole: the same meridian's other half.
        const Point beyond_m = frame.toPlane({89.9, -80});
        COMPARE_NEAR(beyond_m.x(), 0, kTolerance_m);
        COMPARE_NEAR(beyond_m.y(), 2 * pole_m.y(), 1e-3);
    }

    void trueNorthAtTheOrigin()
    {
        for (const double latitude_deg : {0.0, 47.0, -65.0, 89.9, -89.9})
            for (const double longitude_deg : {-180.0, -48.0, 0.0, 179.95}) {
                const LatLon origin{latitude_deg, longitude_deg};
                COMPARE_NEAR(LocalFrame(origin).trueNorth_rad(origin), 0, 1e-8);
            }
    }

    /**
     * Meridians converge by the sine of the latitude: north turns counter-clockwise of y in the
     * east and clockwise in the south; on the meridian of the origin it is y.
     */
    void trueNorthConverges()
    {
        for (const double latitude_deg : {0.0, 30.0, 47.0, 78.0, -30.0, -78.0})
            for (const double east_deg : {-0.2, -0.05, 0.0, 0.05, 0.2}) {
                const LocalFrame frame({latitude_deg, 179.9});
                const LatLon place{latitude_deg, 179.9 + east_deg};
                const double first_rad = radFromDeg(east_deg) * std::sin(radFromDeg(latitude_deg));
                COMPARE_NEAR(frame.trueNorth_rad(place), first_rad, 3e-6);
            }
        COMPARE_NEAR(LocalFrame({47, -48}).trueNorth_rad({52, -48}), 0, 1e-8);
    }

    /** From a pole every meridian is a ray, and places at the pole differ by longitude only. */
    void trueNorthAtThePoles()
    {
        for (const double sign : {1.0, -1.0}) {
            const LocalFrame frame({sign * 90, 0});
            for (const double longitude_deg : {-170.0, -90.0, 0.0, 45.0, 90.0, 179.0})
                for (const double latitude_deg : {90.0, 89.9995, 89.0, 82.0}) {
                    const LatLon place{sign * latitude_deg, longitude_deg};
                    const double turned_deg =
                        degFromRad(frame.trueNorth_rad(place)) - sign * longitude_deg;
                    COMPARE_NEAR(std::remainder(turned_deg, 360.0), 0, 1e-7);
                }
        }
    }

    void trueNorthFromAzimuths_data() { addOrigins(); }

    /**
     * The geodesic from the origin is a ray of the plane; across it the plane is stretched by its
     * length over its reduced length. The azimuth at its end therefore gives north there.
     */
    void trueNorthFromAzimuths()
    {
        QFETCH(double, latitude_deg);
        QFETCH(double, longitude_deg);
        const LocalFrame frame({latitude_deg, longitude_deg});
        for (const Point& p_m : grid(300000)) {
            const LatLon place = frame.toGeographic(p_m);
            if (p_m.norm() < 1 || std::abs(place.latitude_deg) > 89.9)
                continue; // the finite step to the north crosses the pole
            double length_m = 0;
            double start_deg = 0;
            double end_deg = 0;
            double reduced_m = 0;
            GeographicLib::Geodesic::WGS84().Inverse(latitude_deg, longitude_deg,
                                                     place.latitude_deg, place.longitude_deg,
                                                     length_m, start_deg, end_deg, reduced_m);
            const Point along = p_m.normalized();
            const Point across(along.y(), -along.x()); // to the right
            const double end_rad = radFromDeg(end_deg);
            const Point north =
                std::cos(end_rad) * along - std::sin(end_rad) * length_m / reduced_m * across;
            const double expected_rad = std::atan2(-north.x(), north.y());
            // The step of 111 m turns by at most half of that over the distance to the pole.
            const double toPole_m = (90 - std::abs(place.latitude_deg)) * 111e3;
            COMPARE_NEAR(std::remainder(frame.trueNorth_rad(place) - expected_rad, 2 * kPi), 0,
                         1e-6 + 60 / toPole_m);
        }
    }

    void originIsKeptAndIsZero_data() { addOrigins(); }

    void originIsKeptAndIsZero()
    {
        QFETCH(double, latitude_deg);
        QFETCH(double, longitude_deg);
        const LatLon origin{latitude_deg, longitude_deg};
        const LocalFrame frame(origin);
        QVERIFY(frame.origin() == origin);
        COMPARE_NEAR(frame.toPlane(origin).norm(), 0, kTolerance_m);
        COMPARE_NEAR(geodesic(frame.toGeographic(Point::Zero()), origin).length_m, 0, kTolerance_m);
    }
};

QTEST_APPLESS_MAIN(TestGeodesy)
#include "tst_geodesy.moc"
