#include "tests/support/window/map_builder.h"
#include "tests/support/window/map_layouts.h"
#include "widgets/map/paint/map_marks.h"
#include "widgets/map/paint/map_painter.h"

#include <QtTest>

using namespace berg;
using namespace berg::test;
using namespace Qt::StringLiterals;

namespace {

constexpr QSize kSize_px(900, 600);

/** Whether the images differ within 12 px of a place. */
bool differNear(const QImage& a, const QImage& b, const QPointF& at)
{
    const QRect rect = QRect(at.toPoint() - QPoint(12, 12), QSize(24, 24)) & a.rect();
    return a.copy(rect) != b.copy(rect);
}

} // namespace

/** Aircraft, ghosts and traffic are painted at their places. */
class TestMapLive : public QObject
{
    Q_OBJECT

private slots:
    void everySymbolIsAtItsPlace_data()
    {
        QTest::addColumn<Theme>("theme");
        QTest::newRow("light") << Theme::light();
        QTest::newRow("dark") << Theme::dark();
    }

    void everySymbolIsAtItsPlace()
    {
        QFETCH(Theme, theme);
        const MapStyle style{.theme = theme, .locale = kLocale};
        MapPicture picture = randomPicture(3);
        const QImage without = mapImage(picture, style, kSize_px, 1);
        const MapLayout layout = arrangeMap(picture, style, QRectF(QPointF(0, 0), kSize_px));
        const auto pixel = [&](const Point& place_m) { return layout.view.toPixel(place_m); };
        const Point middle_m = layout.view.toWorld(layout.rect.center());
        const auto at = [&](double east, double north) {
            return Point(middle_m + Point(east, north) / layout.view.scale_pxpm());
        };
        MapAircraft flying{.position_m = at(60, 60), .label = u"Aircraft 1"_s};
        flying.track_m = {at(-60, 60), at(60, 60)};
        MapAircraft ghost{.position_m = at(-60, -60), .label = u"Aircraft 2"_s, .isGhost = true};
        ghost.contact_m = at(90, -90);
        MapAircraft flown{.position_m = at(-150, 150), .isFlown = true};
        picture.live.aircraft = {flying, ghost, flown};
        picture.live.traffic = {{.position_m = at(120, 0), .label = u"POLAR"_s, .isShip = true}};
        const QImage with = mapImage(picture, style, kSize_px, 1);
        QVERIFY(differNear(with, without, pixel(flying.position_m)));
        QVERIFY(differNear(with, without, pixel(at(0, 60)))); // the track
        QVERIFY(differNear(with, without, pixel(ghost.position_m)));
        QVERIFY(differNear(with, without, pixel(*ghost.contact_m)));
        QVERIFY(differNear(with, without, pixel(at(120, 0))));
        MapPicture heard = picture;
        heard.live.aircraft[1].isGhost = false;
        QVERIFY(differNear(with, mapImage(heard, style, kSize_px, 1), pixel(ghost.position_m)));
        // Its UAV's symbol shows it already.
        QVERIFY(!differNear(with, without, pixel(flown.position_m)));
    }

    /** Two aircraft side by side, below them one whose label has no room on either side. */
    void labelsDoNotCoverEachOther()
    {
        const auto at = [](double x, double y, double width = 60) {
            return LabelRequest{.anchor = {.centre_px = {x, y}, .radius_px = 19},
                                .size_px = {width, 14},
                                .previous = {}};
        };
        const std::vector<LabelRequest> requests{at(100, 100), at(150, 100), at(150, 108),
                                                 at(400, 400)};
        const QRectF taken(200, 90, 50, 50);
        const LabelDisk disk{.centre_px = {450, 400}, .radius_px = 20};
        LabelSurroundings surroundings{.area = {}, .solids = {taken}, .disks = {disk}, .lines = {}};
        const std::vector<QRectF> places = placesBeside(requests, surroundings);
        QCOMPARE(places.size(), requests.size());
        QVERIFY(places[0].right() < 100 - 19);         // the other aircraft is on the right
        QCOMPARE(places[3], QRectF(317, 393, 60, 14)); // the disk is on the right
        for (std::size_t i = 0; i < 2; ++i) {
            QVERIFY(!places[i].intersects(taken));
            for (std::size_t j = 0; j < i; ++j)
                QVERIFY(!places[i].intersects(places[j]));
        }
        surroundings.solids = {QRectF(0, 0, 1000, 1000)};
        QCOMPARE(placesBeside(requests, surroundings)[3], QRectF(423, 393, 60, 14));
    }
};

QTEST_MAIN(TestMapLive)
#include "tst_map_live.moc"
