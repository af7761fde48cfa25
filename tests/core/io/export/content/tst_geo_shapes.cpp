#include "core/mission/visits.h"
#include "tests/support/files/geojson_rules.h"
#include "tests/support/files/geojson_view.h"

#include <QTest>

#include <cmath>

using namespace berg;
using namespace berg::test;

// The shapes are checked as a map program draws them, in the exported GeoJSON.

namespace {

double distanceToSegment_m(const Point& p, const Point& a, const Point& b)
{
    const Point along = b - a;
    const double part = along.squaredNorm() == 0
                            ? 0
                            : std::clamp((p - a).dot(along) / along.squaredNorm(), 0.0, 1.0);
    return (p - a - along * part).norm();
}

double distanceToRoute_m(const Point& p, const std::vector<Point>& route)
{
    double nearest_m = 1e300;
    for (std::size_t i = 1; i < route.size(); ++i)
        nearest_m = std::min(nearest_m, distanceToSegment_m(p, route[i - 1], route[i]));
    return nearest_m;
}

/**
 * Largest distance of the drawn lines from the flown route, at `samples` points of each line
 * segment, which is straight in longitude and latitude.
 */
double largestDeviation_m(const LocalFrame& frame, const QJsonObject& feature,
                          const std::vector<Point>& route, int samples = 8)
{
    double largest_m = 0;
    for (const QJsonArray& line : parts(feature))
        for (qsizetype i = 1; i < line.size(); ++i)
            for (int k = 0; k <= samples; ++k) {
                const LatLon a = placeOf(line[i - 1]);
                const LatLon b = placeOf(line[i]);
                const double part = static_cast<double>(k) / samples;
                const LatLon place{.latitude_deg = std::lerp(a.latitude_deg, b.latitude_deg, part),
                                   .longitude_deg =
                                       std::lerp(a.longitude_deg, b.longitude_deg, part)};
                largest_m = std::max(largest_m, distanceToRoute_m(frame.toPlane(place), route));
            }
    return largest_m;
}

std::vector<Point> plannedRoute(const Scenario& scenario)
{
    std::vector<Point> route{scenario.uavs[0].position_m};
    for (const Visit& visit : plannedVisits(scenario, fourIcebergPlan()))
        route.push_back(visit.position_m);
    return route;
}

/** Even-odd test in longitude and latitude, as a map program does it. */
bool drawnInside(const QList<QJsonArray>& rings, const LatLon& place)
{
    for (const QJsonArray& ring : rings) {
        std::vector<Point> corners;
        for (const QJsonValue& position : ring)
            corners.emplace_back(position[0].toDouble(), position[1].toDouble());
        if (insidePolygon(corners, Point(place.longitude_deg, place.latitude_deg)))
            return true;
    }
    return false;
}

} // namespace

class TestGeoShapes : public QObject
{
    Q_OBJECT

private slots:
    void init() { QTest::failOnWarning(QRegularExpression(u".*"_s)); }

    void linesFollowTheRoute_data()
    {
        QTest::addColumn<double>("latitude_deg");
        QTest::addColumn<double>("longitude_deg");
        QTest::addColumn<int>("lines");
        QTest::newRow("Grand Banks") << 47.0 << -48.0 << 1;
        QTest::newRow("Fiji") << -17.0 << 179.99 << 2;
        QTest::newRow("Wrangel Island") << 71.0 << -179.99 << 2;
        QTest::newRow("89 N") << 89.0 << 30.0 << 1;
        QTest::newRow("89 N, antimeridian") << 89.0 << 179.99 << 2;
        // The route goes around the pole at 1 km.
        QTest::newRow("beside the pole") << 89.99 << 100.0 << 0;
        QTest::newRow("the pole") << 90.0 << 0.0 << 0;
        QTest::newRow("the south pole") << -90.0 << 0.0 << 0;
    }

    void linesFollowTheRoute()
    {
        QFETCH(double, latitude_deg);
        QFETCH(double, longitude_deg);
        QFETCH(int, lines);
        Scenario scenario = at(latitude_deg, longitude_deg);
        const LocalFrame frame(scenario.origin);
        const QJsonObject plan = features(planText(scenario), u"plan"_s).value(0);
        if (lines > 0) // crossed once or not at all
            QCOMPARE(parts(plan).size() > 1, lines > 1);
        const std::vector<Point> route = plannedRoute(scenario);
        // The limit is a metre at the middle of a segment; elsewhere it may be slightly more.
        QVERIFY(largestDeviation_m(frame, plan, route) < 1.1);
        double length_m = 0;
        for (const QJsonArray& part : parts(plan)) {
            const std::vector<Point> points = planePoints(frame, part);
            for (std::size_t i = 1; i < points.size(); ++i)
                length_m += (points[i] - points[i - 1]).norm();
        }
        double expected_m = 0;
        for (std::size_t i = 1; i < route.size(); ++i)
            expected_m += (route[i] - route[i - 1]).norm();
        // Parts meet at the cuts, so no part of the route is missing.
        QVERIFY(std::abs(length_m - expected_m) < 1);
    }

    void partsMeetAtTheAntimeridian()
    {
        const Scenario scenario = at(52, 179.99);
        const LocalFrame frame(scenario.origin);
        const QJsonObject plan = features(planText(scenario), u"plan"_s).value(0);
        const QList<QJsonArray> lines = parts(plan);
        const QJsonArray times =
            plan["properties"_L1]["coordinateProperties"_L1]["times"_L1].toArray();
        QVERIFY(lines.size() >= 2);
        for (qsizetype i = 1; i < lines.size(); ++i) {
            const LatLon end = placeOf(lines[i - 1].last());
            const LatLon begin = placeOf(lines[i].first());
            QCOMPARE(std::abs(end.longitude_deg), 180.0);
            QCOMPARE(begin.longitude_deg, -end.longitude_deg);
            QCOMPARE(begin.latitude_deg, end.latitude_deg);
            QCOMPARE(times[i].toArray().first(), times[i - 1].toArray().last());
            // The UAV flies at constant speed, so the time is divided like the path.
            const QJsonArray before = times[i - 1].toArray();
            const QJsonArray after = times[i].toArray();
            const auto seconds = [](const QJsonValue& from, const QJsonValue& to) {
                return static_cast<double>(
                           QDateTime::fromString(from.toString(), Qt::ISODateWithMs)
                               .msecsTo(QDateTime::fromString(to.toString(), Qt::ISODateWithMs))) /
                       1e3;
            };
            const Point a_m = frame.toPlane(placeOf(lines[i - 1][before.size() - 2]));
            const Point cut_m = frame.toPlane(end);
            const Point b_m = frame.toPlane(placeOf(lines[i][1]));
            const double part =
                (cut_m - a_m).norm() / ((cut_m - a_m).norm() + (b_m - cut_m).norm());
            const double leg_s = seconds(before[before.size() - 2], after[1]);
            // Tolerance: milliseconds, and a metre at 22 m/s beside the straight leg.
            QVERIFY(std::abs(seconds(before[before.size() - 2], after[0]) - part * leg_s) < 0.05);
        }
    }

    void areaIsTheSameOnTheMap_data()
    {
        QTest::addColumn<double>("latitude_deg");
        QTest::addColumn<double>("longitude_deg");
        QTest::addColumn<std::vector<Point>>("area_m");
        QTest::addColumn<int>("polygons");
        const std::vector<Point> box{Point(-3000, -2000), Point(3000, -2000), Point(3000, 2000),
                                     Point(-3000, 2000)};
        // These arms cross the antimeridian three times.
        const std::vector<Point> comb{Point(-3000, -3000), Point(3000, -3000),  Point(3000, -2000),
                                      Point(-2000, -2000), Point(-2000, -1000), Point(3000, -1000),
                                      Point(3000, 0),      Point(-2000, 0),     Point(-2000, 1000),
                                      Point(3000, 1000),   Point(3000, 2000),   Point(-3000, 2000)};
        std::vector<Point> clockwise = comb;
        std::reverse(clockwise.begin(), clockwise.end());
        const std::vector<Point> west{Point(-3000, -2000), Point(0, -2000), Point(0, 2000),
                                      Point(-3000, 2000)};
        const std::vector<Point> east{Point(0, -2000), Point(3000, -2000), Point(3000, 2000),
                                      Point(0, 2000)};
        QTest::newRow("box") << 47.0 << -48.0 << box << 1;
        QTest::newRow("box across") << 52.0 << 179.99 << box << 2;
        QTest::newRow("box across from the east") << 52.0 << -179.99 << box << 2;
        QTest::newRow("comb") << -17.0 << 0.0 << comb << 1;
        QTest::newRow("comb across") << -17.0 << 179.99 << comb << 4;
        QTest::newRow("clockwise comb across") << -17.0 << 180.0 << clockwise << 4;
        QTest::newRow("touches from the west") << 0.0 << 180.0 << west << 1;
        QTest::newRow("touches from the east") << 0.0 << 180.0 << east << 1;
        QTest::newRow("89 N across") << 89.0 << 179.99 << box << 2;
        QTest::newRow("beside the pole") << 89.9 << 20.0 << box << 1;
        QTest::newRow("around the pole") << 89.99 << 20.0 << box << 1;
        QTest::newRow("around the pole, antimeridian") << 89.99 << 179.0 << box << 1;
        QTest::newRow("around the south pole") << -89.99 << 20.0 << box << 1;
        QTest::newRow("comb around the pole") << 89.995 << 20.0 << comb << 0;
    }

    void areaIsTheSameOnTheMap()
    {
        QFETCH(double, latitude_deg);
        QFETCH(double, longitude_deg);
        QFETCH(std::vector<Point>, area_m);
        QFETCH(int, polygons);
        const Scenario scenario = changed([&](Scenario& s) {
            s.origin = {.latitude_deg = latitude_deg, .longitude_deg = longitude_deg};
            s.area_m = area_m;
        });
        const QByteArray text = planText(scenario);
        QCOMPARE(geojsonFault(text), QString());
        const QList<QJsonArray> rings = parts(features(text, u"area"_s).value(0));
        if (polygons > 0)
            QCOMPARE(rings.size(), polygons);
        const LocalFrame frame(scenario.origin);
        double area_m2 = 0;
        for (const QJsonArray& ring : rings) {
            area_m2 += signedArea(planePoints(frame, ring));
            for (qsizetype i = 1; i < ring.size(); ++i)
                QVERIFY2(ring[i] != ring[i - 1], "a vertex twice");
        }
        // A metre along a perimeter of some 40 km.
        QVERIFY(std::abs(area_m2 - std::abs(signedArea(area_m))) < 4e4);
        Random random(3);
        for (int i = 0; i < 2000; ++i) {
            const Point p(random.uniform(-4000, 4000), random.uniform(-4000, 4000));
            std::vector<Point> closed = area_m;
            closed.push_back(area_m.front());
            if (distanceToRoute_m(p, closed) < 1.5)
                continue; // too near the edge to decide
            QCOMPARE(drawnInside(rings, frame.toGeographic(p)), insidePolygon(area_m, p));
        }
    }
};

QTEST_APPLESS_MAIN(TestGeoShapes)
#include "tst_geo_shapes.moc"
