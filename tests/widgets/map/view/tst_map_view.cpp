#include "core/base/angles.h"
#include "tests/support/approx.h"
#include "widgets/map/paint/graticule.h"
#include "widgets/map/picture/map_view_transform.h"

#include <QtTest>

#include <algorithm>
#include <set>

using namespace berg;

namespace {

const QRectF kRect(0, 0, 1280, 800);

/** A view of `width_m` about the origin of the plane. */
MapViewTransform viewOf(double width_m)
{
    return {Point::Zero(), kRect.center(), kRect.width() / width_m};
}

/** Distinct sorted differences of neighbours, rounded to 1e-9 degrees. */
std::set<long long> steps(std::vector<double> values_deg)
{
    std::sort(values_deg.begin(), values_deg.end());
    std::set<long long> found;
    for (std::size_t i = 0; i + 1 < values_deg.size(); ++i)
        found.insert(std::llround((values_deg[i + 1] - values_deg[i]) * 1e9));
    return found;
}

} // namespace

class TestMapView : public QObject
{
    Q_OBJECT

private slots:
    void roundTrip_data()
    {
        QTest::addColumn<double>("scale_pxpm");
        QTest::newRow("close") << 10.0;
        QTest::newRow("field") << 0.2;
        QTest::newRow("region") << 1e-3;
    }

    void roundTrip()
    {
        QFETCH(double, scale_pxpm);
        const MapViewTransform view({1200, -300}, {640, 400}, scale_pxpm);
        for (const Point& p_m : {Point(0, 0), Point(-500, 500), Point(1e6, -1e6)}) {
            const Point back_m = view.toWorld(view.toPixel(p_m));
            // Rounding of doubles only.
            COMPARE_NEAR((back_m - p_m).norm(), 0, 1e-9 * std::max(1.0, p_m.norm()));
        }
    }

    void northIsUpAndEastIsRight()
    {
        const MapViewTransform view = viewOf(5000);
        const QPointF origin = view.toPixel({0, 0});
        QCOMPARE(origin, kRect.center());
        QVERIFY(view.toPixel({0, 100}).y() < origin.y());
        QVERIFY(view.toPixel({100, 0}).x() > origin.x());
    }

    void fitShowsEverything_data()
    {
        QTest::addColumn<QPointF>("align");
        for (const double x : {0.0, 0.5, 1.0})
            for (const double y : {0.0, 0.5, 1.0})
                QTest::addRow("aligned %g, %g", x, y) << QPointF(x, y);
    }

    void fitShowsEverything()
    {
        QFETCH(QPointF, align);
        const WorldBounds bounds{.min_m = {-500, 200}, .max_m = {5200, 4100}};
        const QRectF target(40, 30, 900, 700);
        const auto view = MapViewTransform::fitted(bounds, target, align);
        const QRectF shown(view.toPixel({-500, 4100}), view.toPixel({5200, 200}));
        QVERIFY(target.adjusted(-1e-6, -1e-6, 1e-6, 1e-6).contains(shown));
        COMPARE_NEAR(std::max(shown.width() / target.width(), shown.height() / target.height()), 1,
                     1e-9);
        COMPARE_NEAR(shown.left() - target.left(), align.x() * (target.width() - shown.width()),
                     1e-6);
        COMPARE_NEAR(shown.top() - target.top(), align.y() * (target.height() - shown.height()),
                     1e-6);
    }

    void fitOfOnePointIsNotInfinite()
    {
        const WorldBounds bounds{.min_m = {10, 10}, .max_m = {10, 10}};
        const auto view = MapViewTransform::fitted(bounds, kRect, {0.5, 0.5}, 1000);
        COMPARE_NEAR(view.scale_pxpm(), 0.8, 1e-12); // 800 px for 1000 m
        COMPARE_NEAR(view.toPixel({10, 10}).x(), kRect.center().x(), 1e-9);
    }

    void boundsGrow()
    {
        QVERIFY(boundsOf({}).size_m() == Point::Zero());
        const std::vector<Point> points_m = {{1, 5}, {-2, 7}, {0, 6}};
        const WorldBounds bounds = boundsOf(points_m);
        QVERIFY(bounds.min_m == Point(-2, 5));
        QVERIFY(bounds.max_m == Point(1, 7));
    }

    void graticuleHasRoundEvenSteps_data()
    {
        QTest::addColumn<double>("latitude_deg");
        QTest::addColumn<double>("longitude_deg");
        QTest::addColumn<double>("width_m");
        QTest::newRow("Grand Banks, field") << 47.0 << -48.0 << 6000.0;
        QTest::newRow("Grand Banks, region") << 47.0 << -48.0 << 400000.0;
        QTest::newRow("close") << 47.0 << -48.0 << 300.0;
        QTest::newRow("Svalbard") << 79.0 << 15.0 << 20000.0;
        QTest::newRow("southern, across the antimeridian") << -65.0 << 179.99 << 20000.0;
    }

    void graticuleHasRoundEvenSteps()
    {
        QFETCH(double, latitude_deg);
        QFETCH(double, longitude_deg);
        QFETCH(double, width_m);
        const LocalFrame frame({latitude_deg, longitude_deg});
        const Graticule graticule = graticuleOf(frame, viewOf(width_m), kRect);
        std::vector<double> meridians_deg;
        std::vector<double> parallels_deg;
        for (const GraticuleLine& line : graticule.lines) {
            QVERIFY(line.value_deg >= -180 && line.value_deg <= 180);
            if (line.isMeridian) // unwrapped about the middle of the view
                meridians_deg.push_back(std::remainder(line.value_deg - longitude_deg, 360.0));
            else
                parallels_deg.push_back(line.value_deg);
        }
        QVERIFY(meridians_deg.size() >= 2 && meridians_deg.size() <= 14);
        QVERIFY(parallels_deg.size() >= 2 && parallels_deg.size() <= 10);
        QVERIFY(steps(meridians_deg).size() <= 1 ||
                *steps(meridians_deg).rbegin() - *steps(meridians_deg).begin() <= 1);
        QVERIFY(steps(parallels_deg).size() <= 1 ||
                *steps(parallels_deg).rbegin() - *steps(parallels_deg).begin() <= 1);
    }

    /** A line of the graticule runs through the pixels whose place it names. */
    void graticuleLinesAreWhereTheySay()
    {
        const LocalFrame frame({79, 15});
        const MapViewTransform view = viewOf(20000);
        for (const GraticuleLine& line : graticuleOf(frame, view, kRect).lines) {
            for (const QPointF& p_px : line.path_px) {
                const LatLon place = frame.toGeographic(view.toWorld(p_px));
                const double value_deg = line.isMeridian ? place.longitude_deg : place.latitude_deg;
                COMPARE_NEAR(std::remainder(value_deg - line.value_deg, 360.0), 0, 1e-7);
            }
        }
    }

    void graticuleAtThePoleGoesAllRound()
    {
        const LocalFrame frame({89.9, 0});
        const Graticule graticule = graticuleOf(frame, viewOf(60000), kRect);
        std::set<int> quadrants;
        for (const GraticuleLine& line : graticule.lines)
            if (line.isMeridian)
                quadrants.insert(static_cast<int>(std::floor(line.value_deg / 90)));
        QVERIFY(quadrants.size() >= 4);
    }

    void northLeansAwayFromTheOrigin()
    {
        const LocalFrame frame({80, 0});
        COMPARE_NEAR(northAngle_rad(frame, {0, 0}), 0, 1e-6);
        // East of the origin the meridians converge to the left: about the difference of
        // longitude times the sine of the latitude.
        const Point east_m = frame.toPlane({80, 5});
        COMPARE_NEAR(northAngle_rad(frame, east_m), -radFromDeg(5) * std::sin(radFromDeg(80)),
                     radFromDeg(0.05));
        COMPARE_NEAR(northAngle_rad(LocalFrame({90, 0}), {0, 0}), 0, 1e-12);
    }
};

QTEST_APPLESS_MAIN(TestMapView)
#include "tst_map_view.moc"
