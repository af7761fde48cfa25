#include "tests/support/window/patience.h"
#include "widgets/map/land/land_layer.h"

#include <QImage>
#include <QPainter>
#include <QSignalSpy>
#include <QtTest>

using namespace berg;

namespace {

const LandStyle kLandStyle{
    .sea = Qt::blue, .land = Qt::green, .coast = Qt::black, .beyond = Qt::red};
constexpr QSize kSize(320, 200);

/** Disko Bay, an area full of islands and fjords. */
LandRequest request(double scale_pxpm = 2e-3)
{
    return {.plane = LocalFrame({69, -52}),
            .view = MapViewTransform(Point::Zero(), QRectF(QPointF(), kSize).center(), scale_pxpm),
            .rect = QRectF(QPointF(), kSize),
            .ratio = 1,
            .style = kLandStyle};
}

QImage shown(LandLayer& layer, const LandRequest& wanted)
{
    QImage image(kSize, QImage::Format_RGB32);
    QPainter painter(&image);
    layer.paint(painter, wanted);
    return image;
}

/** Shows the layer once its image is complete. */
QImage settled(LandLayer& layer, const LandRequest& wanted)
{
    (void)shown(layer, wanted);
    layer.finish();
    return shown(layer, wanted);
}

QImage drawnNow(const LandRequest& wanted)
{
    QImage image(kSize, QImage::Format_RGB32);
    QPainter painter(&image);
    paintLand(painter, wanted.plane, wanted.view, wanted.rect, wanted.style);
    return image;
}

/** Share of pixels whose colours differ by more than antialiasing may. */
double difference(const QImage& a, const QImage& b)
{
    int differing = 0;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x)
            differing += std::abs(a.pixelColor(x, y).green() - b.pixelColor(x, y).green()) > 8;
    return static_cast<double>(differing) / (a.width() * a.height());
}

} // namespace

class TestLandLayer : public QObject
{
    Q_OBJECT

private slots:
    void emitsUpdatedWhenTheImageIsReady()
    {
        LandLayer layer;
        const QSignalSpy updated(&layer, &LandLayer::updated);
        const LandRequest wanted = request();
        const QImage first = shown(layer, wanted);
        QCOMPARE(first.pixelColor(10, 10), kLandStyle.sea);
        QTRY_COMPARE(updated.size(), 1);
        QCOMPARE(difference(shown(layer, wanted), drawnNow(wanted)), 0.0);
    }

    void finishWaits()
    {
        LandLayer layer;
        const QImage image = settled(layer, request());
        QCOMPARE(difference(image, drawnNow(request())), 0.0);
        QCOMPARE(image, settled(layer, request()));
    }

    /** Until the new image is ready, the old one is shown at its correct place. */
    void oldImageFollowsTheView()
    {
        LandLayer layer;
        (void)settled(layer, request());
        LandRequest moved = request();
        moved.view = moved.view.moved({40, -25});
        QVERIFY(difference(shown(layer, moved), drawnNow(moved)) < 0.01);
        LandRequest zoomed = request();
        zoomed.view = zoomed.view.zoomed(1.25, {100, 80});
        QVERIFY(difference(shown(layer, zoomed), drawnNow(zoomed)) < 0.25); // coarser, in place
    }

    void movedViewIsDrawnWhenItRests()
    {
        LandLayer layer;
        (void)settled(layer, request());
        const QSignalSpy updated(&layer, &LandLayer::updated);
        LandRequest moved = request();
        moved.view = moved.view.moved({40.5, -25.25});
        (void)shown(layer, moved);
        QTRY_COMPARE(updated.size(), 1);
        QCOMPARE(difference(shown(layer, moved), drawnNow(moved)), 0.0);
    }

    void newestOfManyIsShown()
    {
        LandLayer layer;
        LandRequest wanted = request();
        for (int i = 0; i < 20; ++i) {
            wanted.view = wanted.view.zoomed(0.95, {160, 100});
            (void)shown(layer, wanted);
        }
        layer.finish();
        QCOMPARE(difference(shown(layer, wanted), drawnNow(wanted)), 0.0);
    }

    void otherPlaneOrThemeShowsNothingOld()
    {
        LandLayer layer;
        (void)settled(layer, request());
        LandRequest other = request();
        other.plane = LocalFrame({47, -48});
        QCOMPARE(shown(layer, other).pixelColor(100, 100), kLandStyle.sea);
        layer.finish();
        LandRequest dark = request();
        dark.style.land = Qt::darkGreen;
        const QImage image = settled(layer, dark);
        QCOMPARE(difference(image, drawnNow(dark)), 0.0);
    }

    void finerPixelsForFinerScreens()
    {
        LandLayer layer;
        LandRequest wanted = request();
        wanted.ratio = 2;
        QImage image(2 * kSize, QImage::Format_RGB32);
        image.setDevicePixelRatio(2);
        const auto paint = [&] {
            QPainter painter(&image);
            layer.paint(painter, wanted);
        };
        paint();
        layer.finish();
        paint();
        QImage expected(2 * kSize, QImage::Format_RGB32);
        expected.setDevicePixelRatio(2);
        QPainter painter(&expected);
        paintLand(painter, wanted.plane, wanted.view, wanted.rect, wanted.style);
        painter.end();
        QCOMPARE(difference(image, expected), 0.0);
    }

    void endsWhileBusy()
    {
        for (int i = 0; i < 3; ++i) {
            LandLayer layer;
            (void)shown(layer, request(5e-4));
        }
    }
};

QTEST_MAIN(TestLandLayer)
#include "tst_land_layer.moc"
