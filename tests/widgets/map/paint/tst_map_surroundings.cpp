#include "core/tracking/position_error.h"
#include "tests/support/approx.h"
#include "tests/support/flight/mission_builder.h"
#include "tests/support/window/map_builder.h"
#include "tests/support/window/map_layouts.h"
#include "widgets/map/paint/map_legend_rows.h"
#include "widgets/map/paint/map_legs.h"
#include "widgets/map/paint/map_painter.h"
#include "widgets/map/picture/mission_picture.h"
#include "widgets/map/picture/scenario_picture.h"

#include <QtTest>

using namespace berg;
using namespace berg::test;
using namespace Qt::StringLiterals;

namespace {

constexpr QSize kSize_px(1280, 800);

QStringList legendOf(const MapPicture& picture)
{
    const Theme theme = Theme::light();
    const MapStyle style{.theme = theme, .locale = kLocale};
    QStringList texts;
    for (const LegendRow& row : legendRows(picture, style, {}))
        texts << row.text;
    return texts;
}

/** Number of pixels within `reach_px` of a place in which two pictures differ. */
int differenceNear(const QImage& a, const QImage& b, const QPointF& at, int reach_px)
{
    int count = 0;
    for (int dy = -reach_px; dy <= reach_px; ++dy)
        for (int dx = -reach_px; dx <= reach_px; ++dx) {
            const QPoint p = at.toPoint() + QPoint(dx, dy);
            if (a.rect().contains(p) && a.pixel(p) != b.pixel(p))
                ++count;
        }
    return count;
}

/** Painted in one layout, so that nothing but the change differs. */
QImage painted(const MapPicture& picture, const MapLayout& layout, const Theme& theme)
{
    QImage image(kSize_px, QImage::Format_RGB32);
    QPainter painter(&image);
    paintMap(painter, picture, {.theme = theme, .locale = kLocale}, layout);
    return image;
}

Scenario kalmanScenario()
{
    return changed([](Scenario& scenario) {
        scenario.area_m.clear();
        scenario.observer.model = ObserverModel::Kalman;
    });
}

FlightRecord recordOfStart(const Scenario& scenario)
{
    return recordOf(flown(scenario, 0));
}

} // namespace

/** Asset, observer, fence, home and clusters on the map. */
class TestMapWorld : public QObject
{
    Q_OBJECT

private slots:
    /** An iceberg lies at the default place of the name. */
    void areaNamesAvoidIcebergs()
    {
        MapPicture picture = missionPicture(recordOfStart(fourIcebergs()), kLocale);
        const MapLayout layout = arrangeMap(picture, {.theme = Theme::light(), .locale = kLocale},
                                            QRectF(QPointF(0, 0), QSizeF(kSize_px)));
        const QPointF berg_px = layout.icebergs[0].centre_px;
        const auto places_m = [&](double left, double top, double right, double bottom) {
            std::vector<Point> corners_m;
            for (const QPointF& corner : {QPointF(left, top), QPointF(right, top),
                                          QPointF(right, bottom), QPointF(left, bottom)})
                corners_m.push_back(layout.view.toWorld(berg_px + corner));
            return corners_m;
        };
        picture.airspace = {{.title = {}, .corners_m = places_m(-200, -20, 200, 200)}};
        picture.closed = {{.name = {}, .corners_m = places_m(-160, -120, 160, 120)}};
        const QImage without = painted(picture, layout, Theme::light());
        picture.airspace[0].title = u"TRA Barents West"_s;
        picture.closed[0].name = u"Closed area"_s;
        const QImage with = painted(picture, layout, Theme::light());
        QVERIFY(with != without);
        QCOMPARE(differenceNear(with, without, berg_px,
                                static_cast<int>(layout.icebergs[0].radius_px * 0.7)),
                 0);
    }

    /** A no-fly area is never taken for the airspace that it lies in. */
    void airspaceNamesAvoidNoFlyAreas()
    {
        MapPicture picture;
        const MapLayout layout = layoutOf(picture, kSize_px);
        std::vector<Point> corners_m;
        for (const QPointF& corner_px : {QPointF(600, 400), QPointF(740, 400), QPointF(740, 450),
                                         QPointF(600, 450)}) // room for one name
            corners_m.push_back(layout.view.toWorld(corner_px));
        picture.airspace = {{.title = u"TRA Barents"_s, .corners_m = corners_m}};
        MapPicture other = picture;
        other.airspace[0].title = u"CYA 701"_s;
        const Theme theme = Theme::light();
        QVERIFY(painted(picture, layout, theme) != painted(other, layout, theme));
        picture.closed = {{.name = u"Mines"_s, .corners_m = corners_m}};
        other.closed = picture.closed;
        QVERIFY(painted(picture, layout, theme) == painted(other, layout, theme));
    }

    void ofTheExactObserverNothingIsAdded()
    {
        const MapPicture picture = missionPicture(recordOfStart(fourIcebergs()), kLocale);
        for (const MapIceberg& iceberg : picture.icebergs) {
            QVERIFY(!iceberg.circle_m);
            QVERIFY(!iceberg.truth_m);
            QVERIFY(!iceberg.ringEntry_s);
        }
        QVERIFY(!picture.uavs[0].home_m);
        QVERIFY(!picture.isFenced);
    }

    void filteredEstimatesHaveCircleAndTruth()
    {
        const FlightRecord record = recordOfStart(kalmanScenario());
        MapPicture picture = missionPicture(record, kLocale);
        for (std::size_t i = 0; i < picture.icebergs.size(); ++i) {
            COMPARE_NEAR(picture.icebergs[i].circle_m.value(),
                         radius95_m(record.now.world.tracks[i].sigma_m2), 1e-12);
            QVERIFY(*picture.icebergs[i].truth_m == record.now.truth_m[i]);
        }
        QVERIFY(legendOf(picture).contains(u"True position"_s));
        QVERIFY(legendOf(picture).contains(u"95 % position circle"_s));
        hideTruth(picture);
        for (const MapIceberg& iceberg : picture.icebergs)
            QVERIFY(!iceberg.truth_m && iceberg.circle_m);
        QVERIFY(!legendOf(picture).contains(u"True position"_s));
    }

    void trackStatesAreShown()
    {
        FlightRecord record = recordOfStart(kalmanScenario());
        record.now.world.tracks[0].status = TrackStatus::Lost;
        record.now.world.tracks[1].status = TrackStatus::GivenUp;
        record.now.world.tracks[2].left = true;
        const MapPicture picture = missionPicture(record, kLocale);
        QCOMPARE(picture.icebergs.size(), std::size_t{3}); // the one that has left is not drawn
        QVERIFY(picture.icebergs[0].status == TrackStatus::Lost);
        QVERIFY(picture.icebergs[1].status == TrackStatus::GivenUp);
        QCOMPARE(labelText(picture.icebergs[0], {}), u"berg-1 · lost"_s);
        QVERIFY(labelText(picture.icebergs[1], {}).endsWith(u" · given up"_s));
        QCOMPARE(picture.icebergs[2].key.value(), std::string("berg-4"));
        const QStringList legend = legendOf(picture);
        QVERIFY(legend.contains(u"Lost: not found where expected"_s));
        QVERIFY(legend.contains(u"Search given up"_s));
    }

    void trackStatesDifferInShape()
    {
        MapPicture picture = randomPicture(5);
        const MapLayout layout = layoutOf(picture, kSize_px);
        for (const Theme& theme : {Theme::light(), Theme::dark()}) {
            std::vector<QImage> images;
            for (const TrackStatus status :
                 {TrackStatus::Tracked, TrackStatus::Lost, TrackStatus::GivenUp}) {
                picture.icebergs[0].status = status;
                images.push_back(painted(picture, layout, theme));
            }
            const QPointF at = layout.icebergs[0].centre_px;
            QVERIFY(differenceNear(images[0], images[1], at, 12) > 40);
            QVERIFY(differenceNear(images[0], images[2], at, 12) > 40);
            QVERIFY(differenceNear(images[1], images[2], at, 12) > 10); // ? and ×
        }
    }

    /** The rest of the pattern is centred on the estimate of the searched iceberg. */
    void searchPatternIsDrawn()
    {
        FlightRecord record = recordOfStart(kalmanScenario());
        UavState& world = record.now.world.uavs[0];
        world.search = Search{.iceberg = 1,
                              .path = LostSearch(record.scenario.observer, SensorSpec(), 200, 0)};
        QVERIFY(missionPicture(record, kLocale).routes[0].search_m.empty()); // not flown
        world.mode = FlightMode::Search;
        const LostSearch& path = world.search->path;
        const MapPicture picture = missionPicture(record, kLocale);
        QCOMPARE(picture.routes[0].search_m.size(), path.corners_m().size() - path.next());
        QVERIFY(picture.routes[0].search_m.front() == record.estimate_m(1) + path.corner_m());
        QVERIFY(legendOf(picture).contains(u"Search pattern"_s));
        MapPicture without = picture;
        without.routes[0].search_m.clear();
        const MapLayout layout = layoutOf(picture, kSize_px);
        const QPointF along = (layout.view.toPixel(picture.routes[0].search_m[0]) +
                               layout.view.toPixel(picture.routes[0].search_m[1])) /
                              2;
        const Theme theme = Theme::light();
        QVERIFY(differenceNear(painted(picture, layout, theme), painted(without, layout, theme),
                               along, 6) > 5);
        QVERIFY(withScenario(picture, record.scenario).routes[0].search_m.empty());
    }

    void truthIsPaintedWhereItIs()
    {
        MapPicture picture = randomPicture(5);
        picture.icebergs[0].position_m = {1000, 1000};
        const MapLayout layout = layoutOf(picture, kSize_px);
        const Theme theme = Theme::light();
        const QImage without = painted(picture, layout, theme);
        const Point truth_m(1000 + 60 / layout.view.scale_pxpm(), 1000);
        picture.icebergs[0].truth_m = truth_m;
        const QPointF at = layout.view.toPixel(truth_m);
        QVERIFY(differenceNear(without, painted(picture, layout, theme), at, 5) > 20);
        // If estimate and truth coincide, nothing is drawn.
        picture.icebergs[0].truth_m = Point(1000 + 2 / layout.view.scale_pxpm(), 1000);
        QCOMPARE(differenceNear(without, painted(picture, layout, theme),
                                layout.icebergs[0].centre_px, 30),
                 0);
    }

    void homeIsWhereTheUavLands_data()
    {
        QTest::addColumn<double>("endurance_s");
        QTest::addColumn<bool>("hasOwn");
        QTest::addColumn<bool>("isShown");
        QTest::newRow("unlimited") << 0.0 << false << false;
        QTest::newRow("at the start") << 900.0 << false << true;
        QTest::newRow("elsewhere") << 900.0 << true << true;
        QTest::newRow("unlimited, with a home") << 0.0 << true << true;
    }

    void homeIsWhereTheUavLands()
    {
        QFETCH(double, endurance_s);
        QFETCH(bool, hasOwn);
        QFETCH(bool, isShown);
        const Scenario scenario = changed([&](Scenario& s) {
            s.uavs.front().spec.endurance_s = endurance_s;
            if (hasOwn)
                s.uavs.front().home_m = Point(100, 200);
        });
        const MapPicture picture = withScenario({}, scenario);
        QCOMPARE(picture.uavs[0].home_m.has_value(), isShown);
        QCOMPARE(legendOf(picture).contains(u"Home"_s), isShown);
        if (isShown)
            QVERIFY(*picture.uavs[0].home_m == (hasOwn ? Point(100, 200) : Point(-500, 500)));
    }

    void enduranceLeftIsAReadout()
    {
        FlightRecord record =
            recordOfStart(changed([](Scenario& s) { s.uavs.front().spec.endurance_s = 900; }));
        record.now.world.uavs[0].aloft_s = 185;
        const MapReadout aloft = missionPicture(record, kLocale).readouts[3];
        QCOMPARE(aloft.caption, u"Until the reserve"_s);
        QCOMPARE(aloft.value, u"08:55"_s);                  // before the reserve of 20 %
        record.now.world.uavs[0].mode = FlightMode::Ground; // made ready again
        QCOMPARE(missionPicture(record, kLocale).readouts[3].value, u"12:00"_s);
        QCOMPARE(missionPicture(recordOfStart(fourIcebergs()), kLocale).readouts.size(),
                 std::size_t{3});
    }

    void closedAreasAreDrawnWithTheirHeights()
    {
        Scenario scenario = fourIcebergs();
        const MapPicture open = withScenario({}, scenario);
        QVERIFY(open.closed.empty());
        scenario.noFly = {{.name = "Mines",
                           .corners_m = {{500, 500}, {1500, 500}, {1500, 1500}, {500, 1500}},
                           .ceiling_m = 300}};
        scenario.asset = Asset{.position_m = {3000, 3000}, .standoff_m = 400};
        MapPicture picture = withScenario({}, scenario);
        QCOMPARE(picture.closed.size(), std::size_t{2});
        QVERIFY(!picture.closed[0].isRing && picture.closed[1].isRing);
        const QStringList legend = legendOf(picture);
        QVERIFY(legend.contains(u"No-fly area"_s));
        QVERIFY(legend.contains(u"Stand-off round the asset"_s));
        const MapLayout layout = layoutOf(picture, kSize_px);
        for (const Theme& theme : {Theme::light(), Theme::dark()}) {
            const QImage with = painted(picture, layout, theme);
            MapPicture none = picture;
            none.closed.clear();
            const QImage without = painted(none, layout, theme);
            const auto changed = [&](const Point& low_m, const Point& high_m) {
                const QRect box = QRectF(layout.view.toPixel(low_m), layout.view.toPixel(high_m))
                                      .normalized()
                                      .toRect();
                int count = 0;
                for (int y = box.top(); y <= box.bottom(); ++y)
                    for (int x = box.left(); x <= box.right(); ++x)
                        count += with.pixel(x, y) != without.pixel(x, y) ? 1 : 0;
                return double(count) / (box.width() * box.height());
            };
            QVERIFY(changed({500, 500}, {1500, 1500}) > 0.08); // hatched, not filled
            QVERIFY(changed({500, 500}, {1500, 1500}) < 0.6);
            QVERIFY(changed({2700, 2700}, {3300, 3300}) > 0.05);
        }
    }

    void fenceIsInTheLegend()
    {
        Scenario scenario = fourIcebergs();
        QVERIFY(!legendOf(withScenario({}, scenario)).join(u' ').contains(u"Geofence"_s));
        scenario.geofence = true;
        const MapPicture picture = withScenario({}, scenario);
        QVERIFY(legendOf(picture).contains(u"Geofence (kept if the UAV starts inside it)"_s));
        MapPicture open = picture;
        open.isFenced = false;
        const MapLayout layout = layoutOf(picture, kSize_px);
        const QPointF side =
            (layout.view.toPixel(scenario.area_m[0]) + layout.view.toPixel(scenario.area_m[1])) / 2;
        // Posts stand inside for either orientation of the corners.
        const auto inward = [&](const MapPicture& fenced) {
            const QImage with = painted(fenced, layout, Theme::light());
            const QImage without = painted(open, layout, Theme::light());
            int inside = 0;
            int outside = 0;
            for (int dy = -20; dy <= 20; ++dy)
                for (int dx = 3; dx <= 5; ++dx) {
                    const QPoint at = side.toPoint() + QPoint(0, dy);
                    inside += with.pixel(at + QPoint(dx, 0)) != without.pixel(at + QPoint(dx, 0));
                    outside += with.pixel(at - QPoint(dx, 0)) != without.pixel(at - QPoint(dx, 0));
                }
            return inside > 0 && outside == 0;
        };
        QVERIFY(inward(picture));
        MapPicture reversed = picture;
        std::reverse(reversed.area_m.begin(), reversed.area_m.end());
        QVERIFY(inward(reversed));
    }

    void ringsAreInTheLegendWithAnAsset()
    {
        const Scenario scenario =
            changed([](Scenario& s) { s.asset = Asset{.position_m = Point(3000, -4000)}; });
        QVERIFY(legendOf(withScenario({}, scenario)).contains(u"Inner ring: alarm"_s));
        QVERIFY(
            legendOf(withScenario({}, scenario)).contains(u"Asset's range: more urgent inside"_s));
        QVERIFY(!legendOf(withScenario({}, fourIcebergs())).contains(u"Inner ring: alarm"_s));
    }

    /** berg-1 is on course in the scenario's picture and in the flight's. */
    void alarmIsMarkedAtTheIceberg()
    {
        const Scenario scenario = changed([](Scenario& s) {
            s.current_mps = Point::Zero();
            s.asset = Asset{.position_m = Point(2000, 0), .range_m = 1000, .alarm_m = 900};
            s.icebergs[0].velocity_mps = {0, -0.2};
        });
        const MapPicture before = withScenario({}, scenario);
        const MapPicture flight = missionPicture(recordOfStart(scenario), kLocale);
        for (const MapPicture& picture : {before, flight}) {
            COMPARE_NEAR(picture.icebergs[0].ringEntry_s.value_or(-1), 500, 1e-6);
            QVERIFY(!picture.icebergs[2].ringEntry_s);
            QVERIFY(legendOf(picture).contains(u"Will enter inner ring"_s));
        }
    }

    void clustersFollowTheIcebergs()
    {
        FlightRecord record = recordOfStart(fourIcebergs());
        record.now.plans[0] = std::make_shared<const Plan>(
            Plan{.uavs = {{.order = {2, 0, 3, 1}, .clusters = {{0, 3}}}}});
        MapPicture picture = missionPicture(record, kLocale);
        QCOMPARE(picture.clusters, (std::vector<MapPlaces>{{0, 3}}));
        QVERIFY(legendOf(picture).contains(u"Planned as one point"_s));
        Scenario edited = fourIcebergs();
        edited.icebergs.erase(edited.icebergs.begin() + 1);
        picture = withScenario(picture, edited);
        QCOMPARE(picture.clusters, (std::vector<MapPlaces>{{0, 2}}));
    }

    /** The leg to a cluster ends at the middle of its circle, and the next one starts there. */
    void legsGoToTheMiddleOfACluster()
    {
        MapPicture picture = randomPicture(4);
        picture.icebergs[0].position_m = {1000, 1000};
        picture.icebergs[1].position_m = {1400, 1000};
        picture.icebergs[2].position_m = {4000, 3000};
        picture.routes[0].plan = {0, 1, 2};
        picture.clusters = {{0, 1}};
        const MapLayout layout = layoutOf(picture, kSize_px);
        const std::vector<QPolygonF> legs = planLegs(picture, layout, 0);
        QCOMPARE(legs.size(), std::size_t{3});
        const QPointF middle = layout.view.toPixel({1200, 1000});
        COMPARE_NEAR(QLineF(legs[0].back(), middle).length(), 0, 1e-6);
        QVERIFY(legs[1].isEmpty());
        COMPARE_NEAR(QLineF(legs[2].front(), middle).length(), 0, 1e-6);
    }

    /** A bay between the UAV and the iceberg: the leg goes round its corner, inside. */
    void legsGoRoundTheFence()
    {
        Scenario scenario = changed([](Scenario& s) {
            s.area_m = {{-2000, -2000}, {8000, -2000}, {8000, 6000}, {3200, 6000},
                        {3200, 1500},   {2200, 1500},  {2200, 6000}, {-2000, 6000}};
            s.geofence = true;
            s.uavs.front().position_m = {0, 4000};
            s.icebergs.resize(1);
            s.icebergs.front().position_m = {5500, 4000};
            s.icebergs.front().velocity_mps = {0, 0};
            s.current_mps = {0, 0};
        });
        const MapPicture picture = missionPicture(recordOfStart(scenario), kLocale);
        QCOMPARE(picture.routes[0].planCorners.size(), std::size_t{1});
        QVERIFY(!picture.routes[0].planCorners[0].empty());
        const MapLayout layout = layoutOf(picture, kSize_px);
        const QPolygonF leg = planLegs(picture, layout, 0)[0];
        QCOMPARE(leg.size(), static_cast<qsizetype>(picture.routes[0].planCorners[0].size()) + 2);
        QPolygonF fence;
        for (const Point& corner_m : scenario.area_m)
            fence << layout.view.toPixel(corner_m);
        for (qsizetype i = 1; i < leg.size(); ++i)
            for (double share = 0.05; share < 1; share += 0.05)
                QVERIFY(fence.containsPoint(QLineF(leg[i - 1], leg[i]).pointAt(share),
                                            Qt::OddEvenFill));
        // Corners are places: they go with the first edit that moves something.
        QCOMPARE(withScenario(picture, scenario).routes[0].planCorners.size(), std::size_t{1});
        scenario.icebergs.front().position_m.y() += 100;
        QVERIFY(withScenario(picture, scenario).routes[0].planCorners.empty());
    }

    void planEndsWithTheHomeLeg()
    {
        MapPicture picture = randomPicture(4);
        picture.uavs[0].home_m = Point(0, 0);
        const MapLayout layout = layoutOf(picture, kSize_px);
        QCOMPARE(planLegs(picture, layout, 0).size(), std::size_t{4});
        QVERIFY(homeLeg(picture, layout, 0).isEmpty());
        picture.routes[0].thisSortie = 2;
        QCOMPARE(planLegs(picture, layout, 0).size(), std::size_t{2});
        COMPARE_NEAR(
            QLineF(homeLeg(picture, layout, 0).back(), layout.view.toPixel({0, 0})).length(), 0,
            1e-6);
        picture.routes[0].thisSortie = 0; // straight home from where it is
        QVERIFY(planLegs(picture, layout, 0).empty());
        COMPARE_NEAR(QLineF(homeLeg(picture, layout, 0).front(),
                            layout.view.toPixel(picture.uavs[0].position_m))
                         .length(),
                     0, 1e-6);
    }
};

QTEST_MAIN(TestMapWorld)
#include "tst_map_surroundings.moc"
