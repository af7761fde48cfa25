#include "tests/support/window/map_builder.h"
#include "tests/support/window/map_layouts.h"
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
};

QTEST_MAIN(TestMapLive)
#include "tst_map_live.moc"
