#include "widgets/map/land/land_layer.h"

#include <QImage>
#include <QPainter>
#include <QtTest>

using namespace berg;

namespace {

constexpr QSize kSize(200, 200);
const LandStyle kSea{.sea = Qt::blue, .land = Qt::green, .coast = Qt::black, .beyond = Qt::red};

std::vector<LatLon> square(double middle_deg, double half_deg)
{
    return {{middle_deg - half_deg, -half_deg},
            {middle_deg - half_deg, half_deg},
            {middle_deg + half_deg, half_deg},
            {middle_deg + half_deg, -half_deg}};
}

/** Over the open Atlantic, a pixel for each kilometre. */
LandRequest request(const MapShape& shape, double opacity = 1)
{
    return {.plane = LocalFrame({0, 0}),
            .view = MapViewTransform(Point::Zero(), QRectF(QPointF(), kSize).center(), 1e-3),
            .rect = QRectF(QPointF(), kSize),
            .style = kSea,
            .backdrop = std::make_shared<const BackdropShapes>(BackdropShapes{shape}),
            .backdropOpacity = opacity,
            .backdropStyle = {.ink = Qt::white, .ground = Qt::black, .font = {}}};
}

QImage drawn(const LandRequest& wanted)
{
    QImage image(kSize, QImage::Format_RGB32);
    QPainter painter(&image);
    paintGroundOf(painter, wanted);
    return image;
}

MapShape polygon(std::vector<std::vector<LatLon>> rings)
{
    return {.kind = MapShape::Kind::Polygon, .parts = std::move(rings), .fill = 0xFFFFFF00U};
}

} // namespace

class TestBackdrop : public QObject
{
    Q_OBJECT

private slots:
    /** A polygon has its own colour inside, and the sea outside and in its hole. */
    void polygonsAreFilled()
    {
        const QImage image = drawn(request(polygon({square(0, 0.6), square(0, 0.2)})));
        QCOMPARE(image.pixelColor(100, 100), QColor(Qt::blue));
        QCOMPARE(image.pixelColor(140, 100), QColor(Qt::yellow));
        QCOMPARE(image.pixelColor(180, 100), QColor(Qt::blue));
        bool hasEdge = false; // white at least in part: of yellow and blue alone the sum is 255
        for (int x = 150; x < 180; ++x)
            hasEdge =
                hasEdge || image.pixelColor(x, 100).red() + image.pixelColor(x, 100).blue() > 300;
        QVERIFY(hasEdge);
    }

    /** A polygon far larger than the map covers the whole map. */
    void polygonsAreCutAtTheMap()
    {
        const QImage image = drawn(request(polygon({square(0, 40)})));
        for (const QPoint& at : {QPoint(1, 1), QPoint(100, 100), QPoint(198, 198)})
            QCOMPARE(image.pixelColor(at), QColor(Qt::yellow));
    }

    void opacityIsThatOfTheLayer()
    {
        const MapShape shape = polygon({square(0, 0.6)});
        const QColor half = drawn(request(shape, 0.5)).pixelColor(100, 100);
        QVERIFY(std::abs(half.red() - 128) < 3 && std::abs(half.blue() - 127) < 3);
        QCOMPARE(drawn(request(shape, 0)).pixelColor(100, 100), QColor(Qt::blue));
    }

    /** A parallel is bent in the plane of the map: at 80 N it is not the chord of its ends. */
    void linesFollowParallels()
    {
        LandRequest wanted = request({.parts = {{{80, -15}, {80, 15}}}});
        wanted.plane = LocalFrame({80, 0});
        wanted.view = MapViewTransform(Point::Zero(), {100, 100}, 1e-3);
        const QImage image = drawn(wanted);
        bool isThere = false;
        for (int y = 98; y < 103; ++y)
            isThere = isThere || image.pixelColor(100, y).red() > 100;
        QVERIFY(isThere);
    }

    /** A line across the antimeridian takes the shorter direction rather than around the Earth. */
    void linesTakeTheShorterDirection()
    {
        LandRequest wanted = request({.parts = {{{0, 179.5}, {0, -179.5}}}});
        wanted.plane = LocalFrame({0, 180});
        const QImage image = drawn(wanted);
        QVERIFY(image.pixelColor(100, 100).red() > 100);
        QVERIFY(image.pixelColor(20, 100).red() < 10);
    }

    void placesAreNamed()
    {
        const MapShape place{
            .kind = MapShape::Kind::Place, .parts = {{{0, 0}}}, .name = "Hibernia"};
        const QImage image = drawn(request(place));
        QCOMPARE(image.pixelColor(100, 100), QColor(Qt::white));
        MapShape nameless = place;
        nameless.name.clear();
        QVERIFY(drawn(request(nameless)) != image);
    }

    /** The layer with its thread shows the same, and no backdrop after it was removed. */
    void layerDrawsIt()
    {
        LandLayer layer;
        LandRequest wanted = request(polygon({square(0, 0.6)}));
        const auto shown = [&] {
            QImage image(kSize, QImage::Format_RGB32);
            QPainter painter(&image);
            layer.paint(painter, wanted);
            painter.end();
            layer.finish();
            QPainter again(&image);
            layer.paint(again, wanted);
            return image;
        };
        QCOMPARE(shown(), drawn(wanted));
        wanted.backdrop = nullptr;
        QCOMPARE(shown().pixelColor(100, 100), QColor(Qt::blue));
    }
};

QTEST_MAIN(TestBackdrop)
#include "tst_backdrop.moc"
