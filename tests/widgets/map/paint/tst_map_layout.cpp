#include "tests/support/approx.h"
#include "tests/support/window/map_builder.h"
#include "tests/support/window/map_layouts.h"
#include "widgets/map/paint/map_drift.h"
#include "widgets/map/paint/map_legend_rows.h"
#include "widgets/map/paint/map_legs.h"
#include "widgets/map/paint/map_painter.h"
#include "widgets/map/paint/map_symbols.h"
#include "widgets/map/picture/footprint.h"

#include <QtTest>

#include <cmath>

using namespace berg;
using namespace berg::test;
using namespace Qt::StringLiterals;

/** Positions of the parts of the map. */
class TestMapLayout : public QObject
{
    Q_OBJECT

private slots:
    void labelsOverlapNothing_data()
    {
        QTest::addColumn<int>("icebergs");
        QTest::addColumn<int>("seed");
        for (const int icebergs : {4, 12, 20, 40})
            for (int seed = 1; seed <= 8; ++seed)
                QTest::addRow("%d icebergs, seed %d", icebergs, seed) << icebergs << seed;
    }

    void labelsOverlapNothing()
    {
        QFETCH(int, icebergs);
        QFETCH(int, seed);
        const MapPicture picture = test::randomPicture(icebergs, static_cast<std::uint64_t>(seed));
        const MapLayout layout = layoutOf(picture, {1280, 800});
        QCOMPARE(layout.labels.size(), picture.icebergs.size());
        for (std::size_t i = 0; i < layout.labels.size(); ++i) {
            const QRectF& rect = layout.labels[i].rect;
            QVERIFY(!rect.isNull());
            QVERIFY(layout.rect.contains(rect));
            for (const QRectF& overlay : layout.overlays())
                QVERIFY(!rect.intersects(overlay));
            for (const LabelDisk& disk : layout.icebergs)
                QVERIFY(!overlaps(rect, disk));
            for (std::size_t j = 0; j < i; ++j)
                QVERIFY(!rect.intersects(layout.labels[j].rect));
        }
    }

    void fitKeepsSymbolsClearOfOverlays_data()
    {
        QTest::addColumn<int>("icebergs");
        QTest::addColumn<QSize>("size");
        for (const int icebergs : {1, 4, 12, 20, 40})
            for (const QSize& size : {QSize(1280, 800), QSize(1920, 1080), QSize(900, 900)})
                QTest::addRow("%d icebergs, %dx%d", icebergs, size.width(), size.height())
                    << icebergs << size;
    }

    void fitKeepsSymbolsClearOfOverlays()
    {
        QFETCH(int, icebergs);
        QFETCH(QSize, size);
        const MapLayout layout = layoutOf(test::randomPicture(icebergs), size);
        QVERIFY(!layout.title.isNull());
        QVERIFY(!layout.legend.isNull());
        QVERIFY(!layout.scaleBar.isNull());
        QVERIFY(!layout.north.isNull());
        for (const LabelDisk& disk : layout.icebergs) {
            QVERIFY(layout.rect.contains(disk.centre_px));
            for (const QRectF& overlay : layout.overlays())
                QVERIFY(!overlaps(overlay, disk));
        }
    }

    void overlaysDoNotOverlap()
    {
        const MapLayout layout = layoutOf(test::randomPicture(12), {1280, 800});
        const std::vector<QRectF> overlays = layout.overlays();
        QCOMPARE(overlays.size(), std::size_t{4});
        for (std::size_t i = 0; i < overlays.size(); ++i) {
            QVERIFY(layout.rect.contains(overlays[i]));
            for (std::size_t j = 0; j < i; ++j)
                QVERIFY(!overlays[i].intersects(overlays[j]));
        }
    }

    /** A fitted map contains the UAV's whole field of view at any position and heading. */
    void fitShowsTheFieldOfView_data()
    {
        QTest::addColumn<Point>("at_m");
        QTest::addColumn<double>("psi_rad");
        QTest::newRow("below") << Point(1500, -3000) << M_PI / 4;
        QTest::newRow("left") << Point(-4000, 500) << 0.3;
        QTest::newRow("corner") << Point(6000, 6000) << M_PI / 4;
        QTest::newRow("among them") << Point(1000, 1000) << 1.0;
    }
    void fitShowsTheFieldOfView()
    {
        QFETCH(Point, at_m);
        QFETCH(double, psi_rad);
        MapPicture picture = test::randomPicture(4);
        picture.routes[0].track.clear();
        picture.uavs[0].position_m = at_m;
        picture.uavs[0].psi_rad = psi_rad;
        picture.uavs[0].sensor.fov_m = {1500, 1500};
        for (const QSize& size : {QSize(960, 445), QSize(1280, 800)}) {
            const MapLayout layout = layoutOf(picture, size);
            QVERIFY(
                layout.rect.contains(fieldOutline(picture.uavs[0], layout.view).boundingRect()));
        }
    }

    void overlaysCoverNoOther_data()
    {
        QTest::addColumn<QSize>("size_px");
        for (const QSize& size_px : {QSize(960, 420), QSize(960, 480), QSize(1280, 800)})
            QTest::addRow("%d x %d", size_px.width(), size_px.height()) << size_px;
    }

    /** The overview below north arrow and wind. */
    void overlaysCoverNoOther()
    {
        QFETCH(QSize, size_px);
        MapPicture picture = test::randomPicture(12);
        picture.air = {.wind_mps = {6, 8}, .limit_mps = 22};
        const Theme theme = Theme::light();
        const MapStyle style{
            .theme = theme, .locale = QLocale::c(), .inset_px = {208, 208}, .isLive = true};
        const MapLayout layout = arrangeMap(picture, style, QRectF(QPointF(0, 0), QSizeF(size_px)));
        QVERIFY(!layout.wind.isNull());
        QVERIFY(size_px.height() < 440 || !layout.inset.isNull());
        const std::vector<QRectF> overlays = layout.overlays();
        for (std::size_t i = 0; i < overlays.size(); ++i)
            for (std::size_t j = 0; j < i; ++j)
                QVERIFY(!overlays[i].intersects(overlays[j]));
    }

    /** A panel over an iceberg becomes smaller or moves. */
    void panelsMoveAwayFromIcebergs()
    {
        MapPicture picture = test::randomPicture(1);
        picture.title = u"Survey"_s;
        picture.subtitle = u"Shortest path"_s;
        picture.readouts = {{.caption = u"Time"_s, .value = u"12:00:00Z"_s, .unit = {}}};
        const Theme theme = Theme::light();
        const QRectF rect(0, 0, 1280, 800);
        const auto layoutWith = [&](bool isLive, const QPointF& at_px) {
            const MapStyle style{.theme = theme, .locale = QLocale::c(), .isLive = isLive};
            const MapViewTransform view = arrangeMap(picture, style, rect).view;
            picture.icebergs[0].position_m = view.toWorld(at_px);
            return arrangeMap(picture, style, rect, view);
        };
        const MapLayout clear = layoutWith(true, {900, 400});
        QVERIFY(!clear.isTitleCompact && !clear.isLegendCompact);
        const QPointF underTitle(60, clear.title.bottom() - 6);
        const MapLayout titled = layoutWith(true, underTitle);
        QVERIFY(titled.isTitleCompact);
        QVERIFY(titled.title.topLeft() == clear.title.topLeft());
        QVERIFY(!titled.title.contains(underTitle));
        const QPointF aboveCompact(60, clear.legend.top() + 6);
        const MapLayout small = layoutWith(true, aboveCompact);
        QVERIFY(small.isLegendCompact);
        QVERIFY(!small.legend.isNull() && !small.legend.contains(aboveCompact));
        const QPointF underAll = clear.legend.bottomLeft() + QPointF(40, -40);
        const MapLayout away = layoutWith(true, underAll);
        QVERIFY(away.legend.isNull());
        QVERIFY(!away.icons[static_cast<std::size_t>(MapPanel::Legend)].isNull());
        const MapLayout page = layoutWith(false, underAll); // nobody can open an icon of a page
        QVERIFY(!page.legend.isNull() && !page.legend.contains(underAll));
    }

    /** Round symbols there are circles, round the dots of a dense field there are none. */
    void dotsHaveNoCircles()
    {
        MapPicture picture = test::randomPicture(500);
        const QSize size(1000, 700);
        const Theme theme = Theme::light();
        const MapStyle style{.theme = theme, .locale = QLocale::c()};
        const auto drawn = [&] { return mapImage(picture, style, size, 1); };
        const MapLayout layout = layoutOf(picture, size);
        QVERIFY(layout.density.isDense);
        picture.icebergs[0].circle_m = 1e-3; // the row of the legend
        const QImage without = drawn();
        std::optional<std::size_t> symbol;
        for (std::size_t i = 0; i < picture.icebergs.size(); ++i)
            if (layout.density.marks[i] != IcebergMark::Symbol)
                picture.icebergs[i].circle_m = 30 / layout.view.scale_pxpm();
            else
                symbol = i;
        QVERIFY(symbol);
        QCOMPARE(drawn(), without);
        picture.icebergs[*symbol].circle_m = 30 / layout.view.scale_pxpm();
        QVERIFY(drawn() != without);
    }

    /** If there is no room for all readouts, those with the lowest ranks stay. */
    void figuresOfTheLowestRanksAreShown()
    {
        MapPicture picture;
        picture.readouts = {{.caption = u"Time"_s, .value = u"12:00:00Z"_s, .unit = {}},
                            {.caption = u"Zeta"_s, .value = u"1"_s, .unit = u"km²"_s, .rank = 3},
                            {.caption = u"Margin"_s, .value = u"15:06"_s, .unit = {}, .rank = 1}};
        const Theme theme = Theme::light();
        const auto captions = [&](double room_px) {
            QStringList shown;
            for (const MapReadout& readout : readoutsThatFit(picture, theme, room_px))
                shown << readout.caption;
            return shown;
        };
        QCOMPARE(captions(2000), (QStringList{u"Time"_s, u"Zeta"_s, u"Margin"_s}));
        const MapStyle style{.theme = theme, .locale = QLocale::c()};
        const double all_px = titleSize(picture, style, {.widest_px = 2000}).width();
        QCOMPARE(captions(all_px - 40), (QStringList{u"Time"_s, u"Margin"_s}));
        QCOMPARE(captions(0), QStringList());
    }

    /** Changes in flight neither shrink the legend nor move its other rows. */
    void legendOfAFlightStaysAsLargeAsItWas()
    {
        MapPicture picture = test::randomPicture(6);
        picture.routes[0].search_m = {{0, 0}, {100, 100}};
        const Theme theme = Theme::light();
        const MapStyle style{.theme = theme, .locale = QLocale::c(), .isLive = true};
        const QRectF rect(0, 0, 1280, 800);
        const MapLayout searching = arrangeMap(picture, style, rect);
        picture.routes[0].search_m.clear();
        const std::size_t rows = legendRows(picture, style, searching.symbols).size();
        for (MapIceberg& iceberg : picture.icebergs)
            iceberg.inView = false;
        QCOMPARE(legendRows(picture, style, searching.symbols).size(), rows);
        const auto height = [&] {
            return arrangeMap(picture, style, rect, searching.view,
                              continuityOf(picture, searching))
                .legend.height();
        };
        QCOMPARE(height(), searching.legend.height());
        picture.routes[0].track.clear(); // not in flight
        QVERIFY(height() < searching.legend.height());
    }

    /** The row of the legend for dots makes it wider: it is there when the view is chosen. */
    void fitOfADenseFieldKeepsUavsClear()
    {
        MapPicture picture = test::randomPicture(500);
        picture.routes[0].track.clear();
        picture.uavs[0].position_m = {-300, -200};
        for (const QSize& size : {QSize(960, 640), QSize(1050, 600), QSize(1280, 800)}) {
            const MapLayout layout = layoutOf(picture, size);
            QVERIFY(layout.density.isDense);
            const QPointF at = layout.view.toPixel(picture.uavs[0].position_m);
            for (const QRectF& overlay : layout.overlays())
                QVERIFY(!overlay.contains(at));
        }
    }

    /** On a low map, as in the window of 1280 x 800, the legend leaves room for the ice. */
    void legendOfALowMapIsCompact()
    {
        MapPicture picture = test::randomPicture(12);
        picture.routes[0].plan = {0, 1, 2};
        picture.routes[0].planPaths = twoPaths(picture.uavs[0].position_m);
        const MapLayout high = layoutOf(picture, {960, 800});
        const MapLayout low = layoutOf(picture, {960, 445});
        QVERIFY(!high.isLegendCompact && low.isLegendCompact);
        QVERIFY(!low.legend.isNull());
        const auto area = [](const QRectF& rect) { return rect.width() * rect.height(); };
        QVERIFY2(area(low.legend) < 0.7 * area(high.legend),
                 QByteArray::number(area(low.legend) / area(high.legend)));
        QVERIFY(low.legend.width() < 1.2 * high.legend.width());
    }

    /** A narrow map, as beside open checks, where the title leaves no room on the left. */
    void legendOfAVeryLowMapGoesElsewhere()
    {
        const MapLayout layout = layoutOf(test::randomPicture(12), {960, 280});
        QVERIFY(!layout.title.isNull() && !layout.legend.isNull());
        QVERIFY(layout.isTitleCompact ||
                layout.title.bottom() + layout.legend.height() > layout.rect.height() - 36);
        const std::vector<QRectF> overlays = layout.overlays();
        for (std::size_t i = 0; i < overlays.size(); ++i) {
            QVERIFY(layout.rect.contains(overlays[i]));
            for (std::size_t j = 0; j < i; ++j)
                QVERIFY(!overlays[i].intersects(overlays[j]));
        }
    }

    void labelsThatWaitHaveRoomForTheirNumbers_data()
    {
        QTest::addColumn<bool>("comes");
        QTest::newRow("a plan comes") << true;
        QTest::newRow("a plan goes") << false;
    }

    /** Names may not look for a place in every frame; what they say may change meanwhile. */
    void labelsThatWaitHaveRoomForTheirNumbers()
    {
        QFETCH(bool, comes);
        const MapPicture planned = test::randomPicture(12);
        MapPicture unplanned = planned;
        unplanned.routes[0].plan.clear();
        const MapPicture& first = comes ? unplanned : planned;
        const MapPicture& then = comes ? planned : unplanned;
        const Theme theme = Theme::light();
        const MapStyle style{.theme = theme, .locale = kLocale};
        const MapLayout before = layoutOf(first, {1280, 800});
        MapContinuity continuity = continuityOf(first, before);
        continuity.turn = LabelTurn{};
        const MapLayout waiting = arrangeMap(then, style, before.rect, before.view, continuity);
        const MapLayout anew = arrangeMap(then, style, before.rect, before.view);
        for (std::size_t i = 0; i < waiting.labels.size(); ++i) {
            QVERIFY(!waiting.labels[i].rect.isNull());
            COMPARE_NEAR(waiting.labels[i].rect.width(), anew.labels[i].rect.width(), 1e-9);
        }
    }

    void symbolsAreLargeEnoughAndGrowBySize()
    {
        double last_px = 0;
        for (const double radius_m : {3.0, 20.0, 50.0, 90.0, 150.0}) {
            const double radius_px = icebergSymbolRadius_px(radius_m);
            QVERIFY(2 * radius_px >= 14);
            QVERIFY(radius_px > last_px);
            last_px = radius_px;
        }
    }

    void legsStartAtTheUavAndEndAtTheSymbols()
    {
        const MapPicture picture = test::randomPicture(5);
        const MapLayout layout = layoutOf(picture, {1280, 800});
        const std::vector<QLineF> legs = linesOf(planLegs(picture, layout, 0));
        QCOMPARE(legs.size(), picture.routes[0].plan.size());
        const QPointF uav = layout.view.toPixel(picture.uavs[0].position_m);
        COMPARE_NEAR(QLineF(legs[0].p1(), uav).length(), 0, 1e-6);
        for (std::size_t k = 0; k < legs.size(); ++k) {
            const LabelDisk& target = layout.icebergs[toIndex(picture.routes[0].plan[k])];
            if (!legs[k].isNull())
                COMPARE_NEAR(QLineF(legs[k].p2(), target.centre_px).length(), target.radius_px,
                             1e-6);
        }
        for (int k = 0; k < 5; ++k)
            QCOMPARE(layout.stops[static_cast<std::size_t>(k)].order.value(), k + 1);
    }

    void driftArrowsAreTrueToTheMap()
    {
        const MapPicture picture = test::randomPicture(12);
        const MapLayout layout = layoutOf(picture, {1280, 800});
        QVERIFY(layout.symbols.driftTime_s > 0);
        double longest_px = 0;
        for (std::size_t i = 0; i < picture.icebergs.size(); ++i) {
            const QLineF arrow = driftArrow(picture, layout, i);
            const double path_m =
                picture.icebergs[i].velocity_mps.norm() * layout.symbols.driftTime_s;
            COMPARE_NEAR(arrow.length(), path_m * layout.view.scale_pxpm(), 1e-6);
            longest_px = std::max(longest_px, arrow.length());
        }
        QVERIFY(longest_px <= 44);
        QVERIFY(longest_px >= 12); // times grow by at most 3 from step to step
    }
};

QTEST_MAIN(TestMapLayout)
#include "tst_map_layout.moc"
