#include "core/base/angles.h"
#include "tests/support/approx.h"
#include "tests/support/window/map_builder.h"
#include "tests/support/window/map_layouts.h"
#include "widgets/flight/sigma_end.h"
#include "widgets/map/paint/map_legs.h"
#include "widgets/map/paint/map_painter.h"
#include "widgets/map/paint/map_sprites.h"
#include "widgets/map/paint/map_symbols.h"
#include "widgets/map/picture/footprint.h"

#include <QFontMetricsF>
#include <QtTest>

#include <cmath>
#include <set>

using namespace berg;
using namespace berg::test;
using namespace Qt::StringLiterals;

namespace {

/** Number of different colours in the image, counted up to `most`. */
std::size_t colourCount(const QImage& image, std::size_t most)
{
    std::set<QRgb> colours;
    for (int y = 0; y < image.height() && colours.size() < most; ++y)
        for (int x = 0; x < image.width(); ++x)
            colours.insert(image.pixel(x, y));
    return colours.size();
}

/** Whether a pixel within `reach_px` of the place has the colour. */
bool hasColourNear(const QImage& image, const QPointF& at, int reach_px, const QColor& colour)
{
    for (int dy = -reach_px; dy <= reach_px; ++dy)
        for (int dx = -reach_px; dx <= reach_px; ++dx) {
            const QPoint p = at.toPoint() + QPoint(dx, dy);
            if (image.rect().contains(p) && image.pixelColor(p).rgb() == colour.rgb())
                return true;
        }
    return false;
}

} // namespace

/** All parts are painted at their places in the layout. */
class TestMapPainter : public QObject
{
    Q_OBJECT

private slots:
    void everySizePaints_data()
    {
        QTest::addColumn<QSize>("size");
        QTest::addColumn<int>("icebergs");
        for (const QSize& size : {QSize(200, 150), QSize(640, 480), QSize(1280, 800),
                                  QSize(300, 1200), QSize(3840, 2160)})
            for (const int icebergs : {0, 1, 12, 40})
                QTest::addRow("%dx%d, %d icebergs", size.width(), size.height(), icebergs)
                    << size << icebergs;
    }

    void everySizePaints()
    {
        QFETCH(QSize, size);
        QFETCH(int, icebergs);
        const MapPicture picture = test::randomPicture(icebergs);
        for (const Theme& theme : {Theme::light(), Theme::dark()}) {
            const QImage image = mapImage(picture, {.theme = theme, .locale = kLocale}, size, 1);
            QCOMPARE(image.size(), size);
            QVERIFY(colourCount(image, 20) >= 20);
        }
    }

    /** Painting into a part of a larger image leaves the rest as it was. */
    void nothingIsPaintedOutside()
    {
        const Theme theme = Theme::light();
        const MapStyle style{.theme = theme, .locale = kLocale};
        const QRect part(150, 90, 640, 420);
        QImage image(1000, 700, QImage::Format_RGB32);
        const QColor untouched(0xff00ff);
        image.fill(untouched);
        {
            QPainter painter(&image);
            const MapPicture picture = test::randomPicture(20);
            // A view that puts much of the content outside.
            const MapViewTransform view({2500, 2000}, QRectF(part).center(), 0.4);
            paintMap(painter, picture, style, arrangeMap(picture, style, part, view));
        }
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x)
                if (!part.contains(x, y) && image.pixelColor(x, y) != untouched)
                    QFAIL(qPrintable(u"painted at %1, %2"_s.arg(x).arg(y)));
        QVERIFY(image.pixelColor(part.center()) != untouched);
        QVERIFY(image.pixelColor(part.topLeft()) != untouched);
        QVERIFY(image.pixelColor(part.bottomRight()) != untouched);
    }

    void samePictureSamePixels()
    {
        const Theme theme = Theme::dark();
        const MapStyle style{.theme = theme, .locale = kLocale};
        const MapPicture picture = test::randomPicture(12);
        QCOMPARE(mapImage(picture, style, {800, 500}, 1), mapImage(picture, style, {800, 500}, 1));
    }

    /** A cached drawing that was elided is not used for a label with more room. */
    void keptLabelsHaveTheirOwnSize()
    {
        const Theme theme = Theme::light();
        const MapStyle style{.theme = theme, .locale = kLocale};
        MapPicture picture = test::randomPicture(0);
        picture.icebergs = {{.id = u"berg-168"_s, .position_m = {4000, 3000}, .sigma_m2 = 18}};
        const QSize size(640, 480);
        MapLayout layout = layoutOf(picture, size);
        const auto painted = [&](MapSprites* sprites) {
            QImage image(size, QImage::Format_RGB32);
            image.fill(theme.sea);
            QPainter painter(&image);
            const Graticule none;
            paintMapLabels(painter, {.picture = picture,
                                     .style = style,
                                     .layout = layout,
                                     .graticule = none,
                                     .sprites = sprites});
            return image;
        };
        MapSprites other;
        const QImage whole = painted(&other);
        MapSprites sprites;
        const double width_px = layout.labels[0].rect.width();
        layout.labels[0].rect.setWidth(width_px - 22);
        QVERIFY(painted(&sprites) != whole);
        layout.labels[0].rect.setWidth(width_px);
        QCOMPARE(painted(&sprites), whole);
    }

    void icebergShowsItsColourOfSigma()
    {
        const Theme theme = Theme::light();
        const MapStyle style{.theme = theme, .locale = kLocale};
        MapPicture picture = test::randomPicture(0);
        picture.icebergs = {{.id = u"B01"_s, .position_m = {4000, 3000}, .sigma_m2 = 18}};
        const QSize size(1280, 800);
        const QImage image = mapImage(picture, style, size, 1);
        const MapLayout layout = layoutOf(picture, size);
        const QColor colour = theme.sigma.colour(18, picture.sigmaFull_m2);
        QVERIFY(hasColourNear(image, layout.icebergs[0].centre_px, 12, colour));
        QVERIFY(
            hasColourNear(image, layout.view.toPixel(picture.uavs[0].position_m), 12, theme.uav));
    }

    /** Another run's track: seen, in the legend, taken into account, below the flown one. */
    void comparisonTrackIsDrawn()
    {
        const Theme theme = Theme::light();
        const MapStyle style{.theme = theme, .locale = kLocale};
        const QSize size(1280, 800);
        MapPicture picture = test::randomPicture(0);
        picture.icebergs = {{.id = u"B01"_s, .position_m = {4000, 3000}, .sigma_m2 = 18}};
        const MapLayout before = layoutOf(picture, size);
        picture.comparisonName = u"Tour"_s;
        QCOMPARE(layoutOf(picture, size).legend, before.legend); // a name alone is no track
        picture.comparisonTracks.resize(1);
        for (int k = 0; k <= 100; ++k)
            picture.comparisonTracks[0].push_back(
                {.position_m = {500.0 + 60.0 * k, 600}, .time_s = 1.0 * k});
        const MapLayout layout = layoutOf(picture, size);
        QVERIFY(layout.legend.height() > before.legend.height());
        const QRectF inside = layout.rect;
        QVERIFY(
            inside.contains(layout.view.toPixel(picture.comparisonTracks[0].back().position_m)));
        const QImage image = mapImage(picture, style, size, 1);
        const QPointF at = layout.view.toPixel({5300, 600});
        QVERIFY(hasColourNear(image, at, 90, theme.comparison)); // an arrow head is near
        QVERIFY(hasColourNear(image, layout.legend.center(), 130, theme.comparison));
        // A track over all of it hides all but the arrow heads.
        picture.routes[0].track = picture.comparisonTracks[0];
        const QImage both = mapImage(picture, style, size, 1);
        const MapViewTransform view = layoutOf(picture, size).view;
        int red = 0;
        for (int east_m = 600; east_m < 6400; east_m += 20) {
            const QColor colour = both.pixelColor(view.toPixel({1.0 * east_m, 600}).toPoint());
            red += colour.red() - colour.blue() > 60 ? 1 : 0;
        }
        QVERIFY2(red < 90, QByteArray::number(red).constData()); // 290 pixels are compared
    }

    /** Dashed below the plan, with a row in the legend. */
    void formerPlanIsDrawn()
    {
        const Theme theme = Theme::light();
        const MapStyle style{.theme = theme, .locale = kLocale};
        const QSize size(1280, 800);
        MapPicture picture = test::randomPicture(4);
        picture.routes[0].track.clear();
        const QSizeF legend = layoutOf(picture, size).legend.size();
        QVERIFY(formerLegs(picture, layoutOf(picture, size), 0).empty());
        picture.routes[0].formerPlan = {3, 1};
        picture.routes[0].formerFrom_m = Point(500, 600);
        const MapLayout layout = layoutOf(picture, size);
        QVERIFY(layout.legend.height() > legend.height());
        const std::vector<QLineF> legs = linesOf(formerLegs(picture, layout, 0));
        QCOMPARE(legs.size(), std::size_t{2});
        COMPARE_NEAR(QLineF(legs[0].p1(), layout.view.toPixel({500, 600})).length(), 0, 1e-6);
        COMPARE_NEAR(QLineF(legs[1].p2(), layout.icebergs[1].centre_px).length(),
                     layout.icebergs[1].radius_px, 1e-6);
        const QImage image = mapImage(picture, style, size, 1);
        int drawn = 0;
        int probes = 0;
        for (double at = 2; at < legs[0].length(); at += 1, ++probes) {
            const QPointF place = legs[0].pointAt(at / legs[0].length());
            drawn += hasColourNear(image, place, 1, theme.formerPlan) ? 1 : 0;
        }
        QVERIFY2(drawn > probes / 4 && drawn < 0.95 * probes, QByteArray::number(drawn)); // dashes
        picture.routes[0].formerFrom_m.reset();
        const QPointF uav = layout.view.toPixel(picture.uavs[0].position_m);
        COMPARE_NEAR(QLineF(formerLegs(picture, layout, 0)[0].front(), uav).length(), 0, 1e-6);
    }

    /** Turns and lines in place of lines from symbol to symbol; the aims are marked. */
    void pathsAreDrawnAsTheyAreFlown()
    {
        const Theme theme = Theme::light();
        const MapStyle style{.theme = theme, .locale = kLocale};
        const QSize size(1280, 800);
        MapPicture picture = test::randomPicture(4);
        picture.routes[0].track.clear();
        picture.routes[0].plan = {0, 2};
        QVERIFY(planLegs(picture, layoutOf(picture, size), 0)[0].size() == 2);
        const double legend_px = layoutOf(picture, size).legend.height();
        picture.routes[0].planPaths = twoPaths(picture.uavs[0].position_m);
        const MapLayout layout = layoutOf(picture, size);
        QVERIFY(layout.legend.height() > legend_px); // a row for the aims
        const std::vector<QPolygonF> legs = planLegs(picture, layout, 0);
        QCOMPARE(legs.size(), std::size_t{2});
        QCOMPARE(legs[0].size(), qsizetype{12});
        QCOMPARE(legs[0].back(), legs[1].front());
        const QImage image = mapImage(picture, style, size, 1);
        const auto isDrawn = [&](const Point& at_m) {
            return hasColourNear(image, layout.view.toPixel(at_m), 4, theme.plan);
        };
        for (const MapPath& path : picture.routes[0].planPaths)
            QVERIFY(isDrawn(*path.aim_m));
        const Point from_m = picture.uavs[0].position_m;
        QVERIFY(isDrawn(from_m + Point(1000, 1700)));
        QVERIFY(isDrawn(from_m + Point(2000, 2000)));
        QVERIFY(isDrawn(from_m + 1000 * Point(std::sin(1.2), 1 - std::cos(1.2))));

        picture.routes[0].formerPlan = {2, 0};
        picture.routes[0].formerPaths = twoPaths(picture.uavs[0].position_m - Point(300, 0));
        QCOMPARE(formerLegs(picture, layout, 0)[0].size(), qsizetype{12});
    }

    /** The water passed is tinted once, below everything; the rest of the sea is not. */
    void waterSeenIsTinted()
    {
        const Theme theme = Theme::light();
        const MapStyle style{.theme = theme, .locale = kLocale};
        const QRectF rect(0, 0, 1280, 800);
        const MapViewTransform view({2500, 3000}, rect.center(), 0.2);
        MapPicture picture = test::randomPicture(1);
        picture.routes[0].plan.clear();
        picture.routes[0].track.clear();
        const auto layout = [&] { return arrangeMap(picture, style, rect, view); };
        const auto drawn = [&] {
            QImage image(rect.size().toSize(), QImage::Format_RGB32);
            QPainter painter(&image);
            paintMap(painter, picture, style, layout());
            return image;
        };
        const auto swept = std::make_shared<std::vector<MapPose>>();
        picture.routes[0].swept = swept;
        const auto fly = [&](double from_m, double to_m) {
            for (double east_m = from_m; east_m != to_m; east_m += from_m < to_m ? 100 : -100)
                swept->push_back({.position_m = {east_m, 3500},
                                  .psi_rad = from_m < to_m ? 0 : kPi,
                                  .time_s = 5.0 * double(swept->size())});
        };
        const QSizeF legend = layout().legend.size();
        fly(1000, 4000);
        QVERIFY(layout().legend.height() > legend.height());
        const QPoint passed = view.toPixel({2612, 3690}).toPoint();
        const QPoint beside = view.toPixel({2612, 3910}).toPoint();
        const QImage once = drawn();
        QColor tint = theme.swept;
        tint.setAlpha(255);
        const QColor seen = mixed(theme.sea, tint, double{theme.swept.alphaF()});
        const QColor shown = once.pixelColor(passed);
        QVERIFY2(std::abs(shown.red() - seen.red()) <= 2 &&
                     std::abs(shown.green() - seen.green()) <= 2 &&
                     std::abs(shown.blue() - seen.blue()) <= 2,
                 qPrintable(shown.name() + u" for "_s + seen.name())); // blended in 8 bits
        QCOMPARE(once.pixelColor(beside), theme.sea);
        fly(4000, 1000); // back over the same water
        QCOMPARE(drawn().pixelColor(passed), shown);
        picture.routes.clear();
        QVERIFY(!picture.showsSwept());
    }

    void seenIcebergHasNoRing()
    {
        const SymbolScale scale;
        COMPARE_NEAR(scale.ringRadius_px(10, 0), 0, 1e-12);
        QVERIFY(scale.ringRadius_px(10, 4) > 10);
        // The ring grows with the root of sigma.
        const double one = scale.ringRadius_px(10, 1);
        const double four = scale.ringRadius_px(10, 4);
        const double nine = scale.ringRadius_px(10, 9);
        COMPARE_NEAR(nine - four, four - one, 1e-9);
    }

    void fieldOfViewHasItsSize_data()
    {
        QTest::addColumn<int>("shape");
        QTest::addColumn<QSizeF>("size_m"); ///< size of its bounding box on the screen
        // Heading east: along is to the right.
        QTest::newRow("turning with the heading") << int(FovShape::Body) << QSizeF(800, 400);
        QTest::newRow("north up") << int(FovShape::North) << QSizeF(400, 800);
        QTest::newRow("disk") << int(FovShape::Disk) << QSizeF(800, 800);
    }

    void fieldOfViewHasItsSize()
    {
        QFETCH(int, shape);
        QFETCH(QSizeF, size_m);
        const MapUav uav{.position_m = {100, 200},
                         .psi_rad = 0,
                         .sensor = {.fov_m = {800, 400}, .shape = static_cast<FovShape>(shape)}};
        const MapViewTransform view({100, 200}, {500, 400}, 0.5);
        const QRectF box = fieldOutline(uav, view).boundingRect();
        // A disk is drawn with 72 corners: its box is at most 0.1 % smaller.
        COMPARE_NEAR(box.width(), 0.5 * size_m.width(), 0.5);
        COMPARE_NEAR(box.height(), 0.5 * size_m.height(), 0.5);
        COMPARE_NEAR(box.center().x(), 500, 0.5);
    }

    void sigmaScalesAreRound_data()
    {
        QTest::addColumn<double>("largest");
        QTest::addColumn<double>("full");
        QTest::newRow("nothing known") << 0.0 << 1.0;
        QTest::newRow("exactly round") << 30.0 << 30.0;
        QTest::newRow("between") << 20.4 << 30.0;
        QTest::newRow("tens") << 9.1 << 10.0;
        QTest::newRow("small") << 0.07 << 0.08;
        QTest::newRow("thousands") << 5500.0 << 6000.0;
    }

    void sigmaScalesAreRound()
    {
        QFETCH(double, largest);
        QFETCH(double, full);
        COMPARE_NEAR(roundSigmaScale(largest), full, 1e-9 * full);
        const std::vector<double> ticks = sigmaTicks(full);
        QVERIFY(ticks.size() >= 2 && ticks.size() <= 4);
        COMPARE_NEAR(ticks.back(), full, 1e-9 * full);
        COMPARE_NEAR(ticks[1], 2 * ticks[0], 1e-9 * full);
    }

    void tabularDigitsShareOneWidth()
    {
        const QFontMetricsF metrics(Theme::light().figure());
        COMPARE_NEAR(tabularWidth(metrics, u"11:11"_s), tabularWidth(metrics, u"08:48"_s), 1e-9);
    }

    void longTitleIsShortenedNotClipped()
    {
        MapPicture picture = test::randomPicture(4);
        picture.title = QString(400, QChar(u'W'));
        const MapLayout layout = layoutOf(picture, {1280, 800});
        QVERIFY(layout.title.width() <= 0.6 * 1280);
        QVERIFY(layout.rect.contains(layout.title));
    }

    /** Numbers of up to three digits do not touch the rim. */
    void numbersFitTheirDisks()
    {
        const Theme theme = Theme::light();
        const auto drawn = [&theme](int number) {
            QImage image(40, 40, QImage::Format_RGB32);
            image.fill(theme.sea);
            QPainter painter(&image);
            painter.setRenderHint(QPainter::Antialiasing);
            drawOrderDisk(painter, {20, 20}, kOrderDisk_px, number, theme, QColor(Qt::black));
            return image;
        };
        const QImage plain = drawn(1);
        for (const int number : {8, 42, 188, 500}) {
            const QImage image = drawn(number);
            for (int y = 0; y < 40; ++y)
                for (int x = 0; x < 40; ++x)
                    if (std::hypot(x + 0.5 - 20, y + 0.5 - 20) > kOrderDisk_px - 0.8)
                        QVERIFY2(image.pixel(x, y) == plain.pixel(x, y),
                                 QByteArray::number(number));
        }
    }
};

QTEST_MAIN(TestMapPainter)
#include "tst_map_painter.moc"
