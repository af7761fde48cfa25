#include "core/presets/presets.h"
#include "tests/support/window/panel_test.h"
#include "widgets/map/paint/map_drift.h"
#include "widgets/map/paint/map_layout.h"
#include "widgets/map/paint/map_legend_rows.h"
#include "widgets/map/picture/scenario_picture.h"

#include <algorithm>

using namespace berg;
using namespace Qt::StringLiterals;

namespace {

const QRectF kMap(0, 0, 900, 420);

/** A field of 9 km by 4.2 km, all of it planned by number. */
MapPicture field(int icebergs)
{
    MapPicture picture =
        withScenario({}, randomScenario(3, {.icebergs = icebergs, .size_m = {9000, 4200}}));
    picture.routes.resize(picture.uavs.size());
    for (int i = 0; i < icebergs; ++i)
        picture.routes.front().plan.push_back(MapPlace::of(i));
    return picture;
}

/** With so many metres in a pixel. */
MapLayout layoutOf(const MapPicture& picture, double metres = 10, bool wasDense = false)
{
    const Theme theme = Theme::light();
    return arrangeMap(picture, {.theme = theme, .locale = QLocale::c()}, kMap,
                      MapViewTransform({4500, 2100}, kMap.center(), 1 / metres),
                      {.crowding = {.isCrowded = wasDense, .isDense = wasDense}});
}

/** A scale at which a field of 300 icebergs has room for small symbols and no more. */
constexpr double kCrowded = 7;

/** Icebergs in sight of which a label is missing that must be there. */
QStringList namelessNext(const MapPicture& picture, const MapLayout& map)
{
    QStringList nameless;
    for (std::size_t i = 0; i < picture.icebergs.size(); ++i)
        if (isNext(map.stops[i]) && kMap.contains(map.icebergs[i].centre_px) &&
            map.labels[i].rect.isNull())
            nameless << picture.icebergs[i].id;
    return nameless;
}

std::ptrdiff_t marked(const MapLayout& map, IcebergMark mark)
{
    return std::ranges::count(map.density.marks, mark);
}

} // namespace

/** Symbols without room become dots or numbers. */
class TestMapDensity : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnWarnings(); }

    /** A plan of coverage comes back to some; the sooner of two plans counts. */
    void laterVisitsAreNumbered()
    {
        MapPicture picture = field(4);
        const double once_px = layoutOf(picture).labels[1].rect.width();
        picture.routes.front().plan = {0, 1, 2, 1, 3, 1};
        std::vector<MapStop> stops = stopsOf(picture);
        QCOMPARE(stops[1].order.value(), 2);
        QCOMPARE(stops[1].later, std::vector<int>({4, 6}));
        QVERIFY(stops[0].later.empty());
        QVERIFY(layoutOf(picture).labels[1].rect.width() > once_px + 2 * kLaterDisk_px);
        const Theme theme = Theme::light();
        const MapStyle style{.theme = theme, .locale = QLocale::c()};
        const auto rows = [&] { return legendRows(picture, style, {}).size(); };
        const std::size_t withLater = rows();
        picture.routes.front().plan = {0, 1, 2, 3};
        QCOMPARE(rows(), withLater - 1);
        picture.routes.front().plan = {0, 2, 1, 1};
        picture.routes.resize(2);
        picture.routes.back().plan = {1};
        stops = stopsOf(picture);
        QCOMPARE(stops[1].uav, std::size_t{1});
        QVERIFY(stops[1].later.empty());
    }

    void fieldsWithRoomKeepTheirSymbols()
    {
        for (const int icebergs : {12, 39, 100}) {
            const MapLayout map = layoutOf(field(icebergs));
            QVERIFY(!map.density.isDense);
            QCOMPARE(marked(map, IcebergMark::Symbol), icebergs);
        }
        // Few are symbols however near they are.
        QVERIFY(!layoutOf(field(39), 100).density.isDense);
    }

    void nextTenAreNumberedAndTheOthersDots()
    {
        const MapPicture picture = field(500);
        const MapLayout map = layoutOf(picture);
        QVERIFY(map.density.isDense);
        QCOMPARE(marked(map, IcebergMark::Symbol), kNumberedNext);
        for (std::size_t i = 0; i < picture.icebergs.size(); ++i) {
            QCOMPARE(map.density.marks[i] == IcebergMark::Symbol,
                     map.stops[i].order <= kNumberedNext);
            QVERIFY(map.density.marks[i] == IcebergMark::Symbol || map.labels[i].rect.isNull());
            QVERIFY(driftArrow(picture, map, i).isNull());
        }
        const auto named = std::ranges::count_if(
            map.labels, [](const PlacedLabel& label) { return !label.rect.isNull(); });
        QCOMPARE(named, kNumberedNext);
    }

    /** Between symbols with rings and dots. */
    void crowdedSymbolsAreSmallAndShowSigmaByColour()
    {
        const MapPicture picture = field(300);
        const MapLayout map = layoutOf(picture, kCrowded);
        QVERIFY(map.density.isCrowded && !map.density.isDense);
        QVERIFY(!map.symbols.showsRings);
        QCOMPARE(marked(map, IcebergMark::Symbol), 300);
        for (const LabelDisk& disk : map.icebergs)
            QVERIFY(disk.radius_px < 10); // rings are 25 px
        QVERIFY(layoutOf(picture, 3).symbols.showsRings);
    }

    /** Later visits have a name only if the next visits leave room. */
    void nextTenHaveNamesFirst()
    {
        MapPicture picture = field(300);
        std::ranges::reverse(picture.routes.front().plan); // else the first ones would be named
        QCOMPARE(namelessNext(picture, layoutOf(picture, kCrowded)), QStringList());
        // While the map moves no other label is placed anew; standing labels yield.
        const Theme theme = Theme::light();
        MapContinuity before = continuityOf(picture, layoutOf(picture, kCrowded));
        std::ranges::reverse(picture.routes.front().plan);
        before.turn = LabelTurn{};
        const MapLayout map =
            arrangeMap(picture, {.theme = theme, .locale = QLocale::c()}, kMap,
                       MapViewTransform({4500, 2100}, kMap.center(), 1 / kCrowded), before);
        QCOMPARE(namelessNext(picture, map), QStringList());
        for (std::size_t i = 0; i < map.labels.size(); ++i)
            for (std::size_t k = 0; k < i; ++k)
                QVERIFY(!map.labels[i].rect.intersects(map.labels[k].rect));
    }

    void numbersCountTheIcebergsOfAGroup()
    {
        for (const double metres : {10.0, 40.0, 200.0}) {
            const MapLayout map = layoutOf(field(500), metres);
            std::ptrdiff_t counted = 0;
            for (const MapCount& count : map.density.counts) {
                QVERIFY(count.icebergs >= 3);
                QVERIFY(count.sigma_m2 > 0);
                QVERIFY(kMap.contains(count.centre_px));
                counted += count.icebergs;
            }
            QCOMPARE(counted, marked(map, IcebergMark::Counted));
            QVERIFY(metres < 40 || counted > 250);
        }
    }

    /** They would be hidden when they matter most. */
    void lostIcebergsAndAlarmsKeepTheirSymbols()
    {
        MapPicture picture = field(500);
        picture.icebergs[100].status = TrackStatus::Lost;
        picture.icebergs[200].ringEntry_s = 60;
        const MapLayout map = layoutOf(picture);
        QVERIFY(map.density.marks[100] == IcebergMark::Symbol);
        QVERIFY(map.density.marks[200] == IcebergMark::Symbol);
        QCOMPARE(marked(map, IcebergMark::Symbol), kNumberedNext + 2);
    }

    /** A field at the limit stays what it is. */
    void doesNotFlickerAtTheLimit()
    {
        const MapPicture picture = field(300);
        const auto isDense = [&](double metres, bool wasDense) {
            return layoutOf(picture, metres, wasDense).density.isDense;
        };
        double limit = 4;
        while (limit < 40 && !isDense(limit, false))
            limit *= 1.02;
        QVERIFY(limit > 4.1 && limit < 40);
        QVERIFY(isDense(limit / 1.05, true));
        QVERIFY(!isDense(limit / 1.05, false));
        QVERIFY(!isDense(limit / 1.3, true));
    }
};

QTEST_MAIN(TestMapDensity)
#include "tst_map_density.moc"
