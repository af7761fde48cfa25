#include "widgets/map/land/land_drawing.h"

#include <QImage>
#include <QPainter>
#include <QtTest>

#include <cmath>

using namespace berg;

namespace {

const LandStyle kLandStyle{
    .sea = Qt::blue, .land = Qt::green, .coast = Qt::black, .beyond = Qt::red};

struct KnownPlace
{
    const char* name;
    LatLon at;
    bool isLand;
};

const std::vector<KnownPlace> kPlaces = {
    {"Greenland, interior", {72, -40}, true},
    {"Greenland, far north", {82, -35}, true},
    {"Newfoundland", {48.5, -56}, true},
    {"Spitsbergen", {79.1, 17}, true},
    {"Ellesmere Island", {81, -75}, true},
    {"Chukotka on the antimeridian", {67.5, 180}, true},
    {"Chukotka in the west", {67, -178}, true},
    {"Wrangel Island on the antimeridian", {71.2, 179.99}, true},
    {"Wrangel Island in the west", {71.2, -179.5}, true},
    {"Fiji, Vanua Levu", {-16.6, 179.3}, true},
    {"South Pole", {-90, 0}, true},
    {"beside the South Pole", {-89.9, 77}, true},
    {"Marie Byrd Land", {-79, -120}, true},
    {"Queen Maud Land", {-75, 10}, true},
    {"Victoria Land", {-73, 160}, true},
    {"Norway", {61, 9}, true},
    {"Congo", {0, 22}, true},
    {"North Pole", {90, 0}, false},
    {"Arctic Ocean", {85, 0}, false},
    {"Grand Banks", {47, -48}, false},
    {"Baffin Bay", {74, -68}, false},
    {"Bering Sea on the antimeridian", {60, 180}, false},
    {"Chukchi Sea on the antimeridian", {70, -180}, false},
    {"Ross Sea", {-75, -175}, false},
    {"Weddell Sea", {-70, -40}, false},
    {"Southern Ocean on the antimeridian", {-60, 180}, false},
    {"Pacific off Fiji", {-20, -179}, false},
    {"Gulf of Guinea", {0, 0}, false}, // some data sets have an island here,
    {"Caspian Sea", {42, 50}, false},
};

/** Renders `side_px` square pixels about a place. */
QImage around(const MapPlane& plane, LatLon place, double scale_pxpm, int side_px)
{
    QImage image(side_px, side_px, QImage::Format_RGB32);
    QPainter painter(&image);
    const QRectF rect(0, 0, side_px, side_px);
    paintLand(painter, plane, MapViewTransform(toPlane(plane, place), rect.center(), scale_pxpm),
              rect, kLandStyle);
    return image;
}

/** Whether every pixel has this colour. */
bool isAll(const QImage& image, const QColor& colour)
{
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            if (image.pixelColor(x, y) != colour)
                return false;
    return true;
}

/** A place that the plane shows. */
bool isWithinReach(const MapPlane& plane, LatLon place)
{
    return toPlane(plane, place).norm() < 0.95 * mapReach_m(plane);
}

} // namespace

class TestLandDrawing : public QObject
{
    Q_OBJECT

private slots:
    void landIsLandAndSeaIsSea_data()
    {
        QTest::addColumn<MapPlane>("plane");
        const auto about = [](const char* name, double latitude_deg, double longitude_deg) {
            QTest::newRow(name) << MapPlane(LocalFrame({latitude_deg, longitude_deg}));
        };
        about("Grand Banks", 47, -48);
        about("West Greenland", 69, -52);
        about("Svalbard", 78, 15);
        about("80 N on the antimeridian", 80, 180);
        about("80 N on the antimeridian from the west", 80, -180);
        about("89.9 N", 89.9, 0);
        about("North Pole", 90, 0);
        about("South Pole", -90, 0);
        about("89.9 S", -89.9, 120);
        about("Ross Sea", -75, -179.99);
        about("Chukotka", 68, -179.99);
        about("Fiji", -17, 179.99);
        about("equator", 0, 0);
        QTest::newRow("northern chart") << MapPlane(PolarFrame(Pole::North, -45));
        QTest::newRow("southern chart") << MapPlane(PolarFrame(Pole::South, 0));
    }

    void landIsLandAndSeaIsSea()
    {
        QFETCH(MapPlane, plane);
        int seen = 0;
        for (const KnownPlace& place : kPlaces) {
            if (!isWithinReach(plane, place.at))
                continue;
            for (const double scale_pxpm : {1e-4, 1e-3, 0.1}) {
                const QImage image = around(plane, place.at, scale_pxpm, 5);
                QVERIFY2(image.pixelColor(2, 2) ==
                             (place.isLand ? kLandStyle.land : kLandStyle.sea),
                         place.name);
            }
            ++seen;
        }
        QVERIFY(seen >= 2);
    }

    /** Cells of the data join without a trace. */
    void noSeams_data()
    {
        QTest::addColumn<MapPlane>("plane");
        QTest::addColumn<double>("latitude_deg");
        QTest::addColumn<double>("longitude_deg");
        QTest::addColumn<double>("scale_pxpm");
        const auto row = [](const char* name, const MapPlane& plane, LatLon place,
                            double scale_pxpm) {
            QTest::newRow(name) << plane << place.latitude_deg << place.longitude_deg << scale_pxpm;
        };
        row("Greenland, four cells", LocalFrame({69, -52}), {75, -40}, 8e-4);
        row("Greenland, coarse", LocalFrame({69, -52}), {75, -40}, 2.5e-4);
        row("Greenland, a corner of cells", LocalFrame({69, -52}), {75, -40}, 1);
        row("Chukotka", LocalFrame({68, 179}), {67.4, 180}, 4e-3);
        row("South Pole", LocalFrame({-90, 0}), {-90, 0}, 4e-4);
        row("beside the South Pole", LocalFrame({-89.9, 120}), {-88, -60}, 4e-4);
        row("East Antarctica", LocalFrame({-75, 160}), {-80, 90}, 4e-4);
        row("Siberia", LocalFrame({80, 100}), {65, 110}, 4e-4);
        row("on the chart", PolarFrame(Pole::South, 0), {-82, 90}, 2e-4);
    }

    void noSeams()
    {
        QFETCH(MapPlane, plane);
        QFETCH(double, latitude_deg);
        QFETCH(double, longitude_deg);
        QFETCH(double, scale_pxpm);
        QVERIFY(
            isAll(around(plane, {latitude_deg, longitude_deg}, scale_pxpm, 160), kLandStyle.land));
    }

    void coastIsDrawnWhereLandMeetsSea()
    {
        // Cape Farewell has land, sea and coast within 60 km.
        const MapPlane plane = LocalFrame({59, -44});
        const QImage image = around(plane, {60, -44}, 1e-3, 120);
        int coast = 0;
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x)
                coast +=
                    image.pixelColor(x, y).green() < 120 && image.pixelColor(x, y).blue() < 120;
        QVERIFY(coast > 50);
        QVERIFY(!isAll(image, kLandStyle.land));
    }

    void nothingIsShownBeyondReach()
    {
        const MapPlane plane = LocalFrame({72, -50});
        const double scale_pxpm = 1e-4;
        const double reach_px = mapReach_m(plane) * scale_pxpm;
        const int side_px = 2 * static_cast<int>(reach_px) + 100;
        const QImage image = around(plane, {72, -50}, scale_pxpm, side_px);
        const int middle = side_px / 2;
        QCOMPARE(image.pixelColor(1, 1), kLandStyle.beyond);
        QCOMPARE(image.pixelColor(middle, middle + static_cast<int>(reach_px) + 4),
                 kLandStyle.beyond);
        QVERIFY(image.pixelColor(middle, middle + static_cast<int>(reach_px) - 4) !=
                kLandStyle.beyond);
        QVERIFY(image.pixelColor(middle, middle) != kLandStyle.beyond);
    }

    /** A part of the map is the same whether it is drawn by itself or in a larger rectangle. */
    void clippingChangesNothing()
    {
        const MapPlane plane = LocalFrame({78, 15});
        const MapViewTransform view({30'000, 20'000}, {200, 150}, 2e-3);
        const QRect part(120, 90, 80, 60);
        QImage whole(400, 300, QImage::Format_RGB32);
        QImage alone(400, 300, QImage::Format_RGB32);
        {
            QPainter painter(&whole);
            paintLand(painter, plane, view, whole.rect(), kLandStyle);
        }
        {
            QPainter painter(&alone);
            paintLand(painter, plane, view, part, kLandStyle);
        }
        const QImage a = whole.copy(part);
        const QImage b = alone.copy(part);
        int differing = 0;
        for (int y = 0; y < a.height(); ++y)
            for (int x = 0; x < a.width(); ++x)
                differing += std::abs(a.pixelColor(x, y).green() - b.pixelColor(x, y).green()) > 8;
        QCOMPARE(differing, 0); // rounding of clipped ends may change a shade
    }
};

QTEST_MAIN(TestLandDrawing)
#include "tst_land_drawing.moc"
