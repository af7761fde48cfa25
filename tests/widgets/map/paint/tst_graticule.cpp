#include "core/base/angles.h"
#include "tests/support/approx.h"
#include "widgets/map/paint/graticule.h"
#include "widgets/map/picture/map_plane.h"
#include "widgets/theme/theme.h"

#include <QtTest>

#include <algorithm>
#include <cmath>
#include <set>

using namespace berg;

namespace {

const QRectF kRect(0, 0, 1280, 800);
constexpr double kWidths_m[] = {150, 5'000, 60'000, 600'000, 6'400'000};

MapViewTransform viewOf(double width_m)
{
    return {Point::Zero(), kRect.center(), kRect.width() / width_m};
}

std::vector<GraticuleLabel> labelsOf(const Graticule& graticule,
                                     const std::vector<QRectF>& taken = {})
{
    return graticuleLabels(graticule, kRect, QFontMetricsF(Theme::light().small()),
                           QLocale(QLocale::English), taken);
}

/** Whether the line shows in the map. */
bool isSeen(const GraticuleLine& line)
{
    return std::any_of(line.path_px.begin(), line.path_px.end(),
                       [](const QPointF& p) { return kRect.contains(p); });
}

} // namespace

class TestGraticule : public QObject
{
    Q_OBJECT

    /** Every origin that is not easy, with every width. */
    static void addViews()
    {
        QTest::addColumn<double>("latitude_deg");
        QTest::addColumn<double>("longitude_deg");
        QTest::addColumn<double>("width_m");
        for (const double latitude_deg : {0.0, 47.0, 80.0, 85.0, 89.0, 89.9, 90.0})
            for (const double sign : {1.0, -1.0})
                for (const double longitude_deg : {15.0, 179.99, -179.99, 180.0})
                    for (const double width_m : kWidths_m)
                        QTest::addRow("%g %g, %g m", sign * latitude_deg, longitude_deg, width_m)
                            << sign * latitude_deg << longitude_deg << width_m;
    }

private slots:
    void linesAreFewAndSpaced_data() { addViews(); }

    void linesAreFewAndSpaced()
    {
        QFETCH(double, latitude_deg);
        QFETCH(double, longitude_deg);
        QFETCH(double, width_m);
        const Graticule graticule =
            graticuleOf(LocalFrame({latitude_deg, longitude_deg}), viewOf(width_m), kRect);
        std::size_t points = 0;
        int meridians = 0;
        int parallels = 0;
        std::set<double> values_deg[2];
        for (const GraticuleLine& line : graticule.lines) {
            QVERIFY(line.value_deg > -180 && line.value_deg <= 180);
            QVERIFY(values_deg[line.isMeridian ? 1 : 0].insert(line.value_deg).second);
            points += static_cast<std::size_t>(line.path_px.size());
            (line.isMeridian ? meridians : parallels) += isSeen(line) ? 1 : 0;
        }
        QVERIFY(graticule.lines.size() <= 80);
        QVERIFY(points <= 5000);
        QVERIFY2(meridians + parallels >= 3, "too empty");
        QVERIFY2(meridians <= 40, "too many meridians");
        QVERIFY2(parallels <= 16, "too many parallels");
    }

    /** The remaining meridians keep their distance where meridians converge. */
    void meridiansKeepTheirDistance()
    {
        const LocalFrame frame({85, 20});
        const MapViewTransform view = viewOf(2'000'000);
        const Graticule graticule = graticuleOf(frame, view, kRect);
        const Point pole_m = frame.toPlane({90, 0});
        int reaching = 0;
        std::vector<QPointF> ends;
        for (const GraticuleLine& line : graticule.lines) {
            if (!line.isMeridian)
                continue;
            const double end_px = QLineF(line.path_px.back(), view.toPixel(pole_m)).length();
            reaching += end_px < 1;
            if (end_px >= 1)
                ends.push_back(line.path_px.back());
        }
        QCOMPARE(reaching, 4); // 0, 90, 180, 90 W
        for (std::size_t i = 0; i < ends.size(); ++i)
            for (std::size_t j = 0; j < i; ++j)
                QVERIFY(QLineF(ends[i], ends[j]).length() > 30);
    }

    void labelsAreInTheMapWithoutOverlap_data() { addViews(); }

    void labelsAreInTheMapWithoutOverlap()
    {
        QFETCH(double, latitude_deg);
        QFETCH(double, longitude_deg);
        QFETCH(double, width_m);
        const std::vector<QRectF> taken = {QRectF(0, 0, 300, 120), QRectF(1220, 10, 50, 60)};
        const std::vector<GraticuleLabel> labels = labelsOf(
            graticuleOf(LocalFrame({latitude_deg, longitude_deg}), viewOf(width_m), kRect), taken);
        QVERIFY(labels.size() >= 3);
        QSet<QString> texts;
        for (std::size_t i = 0; i < labels.size(); ++i) {
            QVERIFY(kRect.contains(labels[i].rect));
            const bool isZero = labels[i].text == u"0°"; // equator and Greenwich
            QVERIFY2(isZero || !texts.contains(labels[i].text), qPrintable(labels[i].text));
            texts.insert(labels[i].text);
            for (const QRectF& other : taken)
                QVERIFY(!other.intersects(labels[i].rect));
            for (std::size_t j = 0; j < i; ++j)
                QVERIFY(!labels[j].rect.intersects(labels[i].rect));
        }
    }

    void labelsNameTheirLine()
    {
        const LocalFrame frame({70, 180});
        const MapViewTransform view = viewOf(600'000);
        int named = 0;
        for (const GraticuleLabel& label : labelsOf(graticuleOf(frame, view, kRect))) {
            const LatLon place = frame.toGeographic(view.toWorld(label.rect.center()));
            if (label.text.endsWith(u'N')) {
                const double latitude_deg = label.text.left(2).toDouble();
                COMPARE_NEAR(place.latitude_deg, latitude_deg, 1);
            } else {
                const double side = label.text.endsWith(u'E') ? 1 : -1;
                const double longitude_deg = side * label.text.left(3).toDouble();
                COMPARE_NEAR(std::remainder(place.longitude_deg - longitude_deg, 360.0), 0, 1.1);
            }
            ++named;
        }
        QVERIFY(named >= 8);
    }

    void nothingIsLabelledBeyondReach()
    {
        const LocalFrame frame({69, -52});
        const QRectF large(0, 0, 3840, 2160);
        const MapViewTransform view({0, 0}, large.center(), 2e-4);
        const std::vector<GraticuleLabel> labels =
            graticuleLabels(graticuleOf(frame, view, large), large,
                            QFontMetricsF(Theme::light().small()), QLocale(QLocale::English), {});
        QVERIFY(labels.size() > 10);
        for (const GraticuleLabel& label : labels)
            QVERIFY(view.toWorld(label.rect.center()).norm() < mapReach_m(frame));
    }

    void longitudesGoOnAcrossTheAntimeridian()
    {
        std::set<double> values_deg;
        for (const GraticuleLine& line :
             graticuleOf(LocalFrame({70, 179.99}), viewOf(600'000), kRect).lines)
            if (line.isMeridian)
                values_deg.insert(line.value_deg);
        QVERIFY(values_deg.contains(180));
        QVERIFY(!values_deg.contains(-180));
        QVERIFY(*values_deg.begin() < -170);
    }

    void parallelsAreSmooth()
    {
        // No corner of more than a few degrees in the circles round the pole.
        for (const GraticuleLine& line :
             graticuleOf(LocalFrame({90, 0}), viewOf(6'400'000), kRect).lines)
            for (qsizetype i = 2; i < line.path_px.size(); ++i) {
                const QLineF before(line.path_px[i - 2], line.path_px[i - 1]);
                const QLineF after(line.path_px[i - 1], line.path_px[i]);
                const double turn_deg = std::abs(std::remainder(before.angleTo(after), 360.0));
                QVERIFY(turn_deg < 30 && turn_deg * after.length() < 600);
            }
    }

    void northIsTowardsThePole_data() { addViews(); }

    void northIsTowardsThePole()
    {
        QFETCH(double, latitude_deg);
        QFETCH(double, longitude_deg);
        QFETCH(double, width_m);
        const LocalFrame frame({latitude_deg, longitude_deg});
        const Point at_m(0.4 * width_m, -0.2 * width_m);
        const double angle_rad = northAngle_rad(frame, at_m);
        // The latitude increases along the arrow.
        const LatLon here = frame.toGeographic(at_m);
        const double step_m = std::min(1000.0, 0.1 * width_m);
        const LatLon there =
            frame.toGeographic(at_m + step_m * Point(std::sin(angle_rad), std::cos(angle_rad)));
        QVERIFY(there.latitude_deg > here.latitude_deg);
        COMPARE_NEAR((there.latitude_deg - here.latitude_deg) * 111'200 / step_m, 1, 0.25);
    }
};

QTEST_MAIN(TestGraticule)
#include "tst_graticule.moc"
