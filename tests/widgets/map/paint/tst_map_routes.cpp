#include "tests/support/approx.h"
#include "tests/support/window/fleet_maps.h"
#include "widgets/document/scenario_edits.h"
#include "widgets/map/paint/map_legend_rows.h"
#include "widgets/map/paint/map_legs.h"
#include "widgets/map/paint/map_painter.h"
#include "widgets/map/paint/map_surroundings.h"
#include "widgets/map/picture/route_colours.h"
#include "widgets/theme/palette.h"

using namespace berg;
using namespace berg::test;
using namespace Qt::StringLiterals;

namespace {

/** Two UAVs: one flies along the south of the square of icebergs, the other along the north. */
MapPicture twoPlans()
{
    MapPicture picture = withScenario({}, twoUavs());
    picture.routes[0].plan = {0, 1};
    picture.routes[1].plan = {2, 3};
    return picture;
}

QStringList legendTexts(const MapPicture& picture)
{
    const Theme theme = Theme::light();
    QStringList texts;
    for (const LegendRow& row : legendRows(picture, {.theme = theme, .locale = QLocale::c()}, {}))
        texts << row.text;
    return texts;
}

} // namespace

/** Routes of several UAVs, and the additional symbols of a fleet. */
class TestMapRoutes : public QObject
{
    Q_OBJECT

private slots:
    /** Lines and numbers have the colour of each UAV; the colour of a single UAV is not used. */
    void plansAreInTheColoursOfTheirUavs()
    {
        const Theme theme = Theme::light();
        const MapPicture picture = twoPlans();
        const MapStyle style{.theme = theme, .locale = QLocale::c()};
        const QSize size(1000, 700);
        const MapLayout layout = arrangeMap(picture, style, QRectF(QPointF(0, 0), size));
        const QImage image = mapImage(picture, style, size, 1);
        for (std::size_t uav = 0; uav < 2; ++uav) {
            const QColor colour = uavColour(theme, static_cast<int>(uav));
            const std::vector<QPolygonF> legs = planLegs(picture, layout, uav);
            QCOMPARE(legs.size(), std::size_t{2});
            for (const QPolygonF& leg : legs) {
                const QPointF at = QLineF(leg.front(), leg.back()).center(); // an arrow head
                QVERIFY(hasColour(image, QRectF(at - QPointF(12, 12), QSizeF(24, 24)), colour));
            }
            for (const MapPlace iceberg : picture.routes[uav].plan)
                QVERIFY(hasColour(image, layout.labels[toIndex(iceberg)].rect, colour));
        }
        QVERIFY(!hasColour(image, image.rect(), theme.plan));
    }

    void theSoonerVisitHasTheNumber()
    {
        MapPicture picture = twoPlans();
        picture.routes[0].plan = {0, 3, 1};
        picture.routes[1].plan = {1, 2};
        const Theme theme = Theme::light();
        const MapLayout layout =
            arrangeMap(picture, {.theme = theme, .locale = QLocale::c()}, {0, 0, 1000, 700});
        QCOMPARE(layout.stops[0].order.value(), 1);
        QCOMPARE(layout.stops[1].order.value(), 1); // first for the second UAV, third for the first
        QCOMPARE(layout.stops[1].uav, std::size_t{1});
        QCOMPARE(layout.stops[3].uav, std::size_t{0});
        QCOMPARE(layout.stops[2].order.value(), 2);
    }

    void routesStayWithTheirUavs()
    {
        const MapPicture picture = twoPlans();
        Scenario scenario = twoUavs();
        scenario.uavs.erase(scenario.uavs.begin());
        scenario.uavs.push_back(anotherUav(scenario, {0, 0}));
        scenario.uavs.back().id = "uav-3";
        const MapPicture shown = withScenario(picture, scenario);
        QCOMPARE(shown.routes.size(), std::size_t{2});
        QCOMPARE(shown.routes[0].plan, picture.routes[1].plan);
        QVERIFY(shown.routes[1].plan.empty());
    }

    void assignedIcebergsHaveAPin()
    {
        const Theme theme = Theme::dark();
        MapPicture picture = withScenario({}, twoUavs());
        QCOMPARE(picture.icebergs[0].assignedUav, std::optional(1));
        QVERIFY(!picture.icebergs[1].assignedUav);
        const MapStyle style{.theme = theme, .locale = QLocale::c()};
        const QSize size(1000, 700);
        const MapLayout layout = arrangeMap(picture, style, QRectF(QPointF(0, 0), size));
        const auto isPinned = [&](std::size_t i) {
            const QRectF near(layout.icebergs[i].centre_px - QPointF(20, 26), QSizeF(20, 20));
            return hasColour(mapImage(picture, style, size, 1), near, uavColour(theme, 1));
        };
        QVERIFY(isPinned(0));
        QVERIFY(!isPinned(1));
        QVERIFY(legendTexts(picture).contains(u"Assigned to the UAV of this colour"_s));
        picture.uavs[0].label.clear(); // the only one
        picture.icebergs[0].assignedUav.reset();
        QVERIFY(!isPinned(0));
        QVERIFY(!legendTexts(picture).contains(u"Assigned to the UAV of this colour"_s));
    }

    void thoseTooCloseAreFound_data()
    {
        QTest::addColumn<double>("distance_m");
        QTest::addColumn<double>("layers_m");
        QTest::addColumn<bool>("isAloft");
        QTest::addColumn<bool>("isFound");
        QTest::newRow("near") << 199.0 << 29.0 << true << true;
        QTest::newRow("apart") << 201.0 << 0.0 << true << false;
        QTest::newRow("another layer") << 50.0 << 31.0 << true << false;
        QTest::newRow("on the ground") << 50.0 << 0.0 << false << false;
    }

    void thoseTooCloseAreFound()
    {
        QFETCH(double, distance_m);
        QFETCH(double, layers_m);
        QFETCH(bool, isAloft);
        QFETCH(bool, isFound);
        MapPicture picture = withScenario({}, twoUavs());
        picture.separation_m = 200;
        picture.uavs[1].position_m = picture.uavs[0].position_m + Point(0, distance_m);
        picture.uavs[1].altitude_m = picture.uavs[0].altitude_m + layers_m;
        picture.uavs[1].isAloft = isAloft;
        QCOMPARE(pairsTooClose(picture).size(), isFound ? std::size_t{1} : std::size_t{0});
        QCOMPARE(legendTexts(picture).contains(u"UAVs too close to each other"_s), isFound);
        const Theme theme = Theme::light();
        const MapStyle style{.theme = theme, .locale = QLocale::c()};
        const QRectF rect(0, 0, 800, 600);
        const MapViewTransform view({0, 100}, rect.center(), 0.2);
        QImage image(rect.size().toSize(), QImage::Format_RGB32);
        QPainter painter(&image);
        paintMap(painter, picture, style, arrangeMap(picture, style, rect, view));
        const QPointF beside = view.toPixel({0, distance_m / 2}) + QPointF(22, 0);
        QCOMPARE(hasColour(image, QRectF(beside - QPointF(3, 3), QSizeF(6, 6)), theme.uav),
                 isFound);
    }

    void namesOfNeighboursAreBelowEachOther()
    {
        Scenario scenario = twoUavs();
        scenario.uavs[1].position_m = scenario.uavs[0].position_m + Point(20, 0);
        const Theme theme = Theme::light();
        const MapLayout layout =
            arrangeMap(withScenario({}, scenario), {.theme = theme, .locale = QLocale::c()},
                       {0, 0, 1000, 700});
        QCOMPARE(layout.uavLabels.size(), std::size_t{2});
        QVERIFY(!layout.uavLabels[0].intersects(layout.uavLabels[1]));
    }

    /** A UAV's name avoids an iceberg below its symbol. */
    void namesHideNoIceberg()
    {
        MapPicture picture = withScenario({}, twoUavs());
        const Theme theme = Theme::light();
        const MapStyle style{.theme = theme, .locale = QLocale::c()};
        const QRectF rect(0, 0, 1000, 700);
        const MapViewTransform view(picture.uavs[0].position_m, rect.center(), 0.2);
        const auto layout = [&] { return arrangeMap(picture, style, rect, view); };
        QVERIFY(layout().uavLabels[0].center().y() > rect.center().y());
        picture.icebergs.resize(1);
        picture.routes[0].plan.clear();
        picture.routes[1].plan.clear();
        picture.icebergs[0].position_m = view.toWorld(rect.center() + QPointF(0, 28));
        const MapLayout moved = layout();
        QVERIFY(!overlaps(moved.uavLabels[0], moved.icebergs[0]));
    }

    /** Brackets of any UAV: not in the colour of one of them. */
    void bracketsAreNobodys()
    {
        MapPicture picture = withScenario({}, twoUavs());
        const Theme theme = Theme::light();
        QCOMPARE(routeColours(picture, theme).uav, theme.ink);
        picture.uavs.pop_back();
        QCOMPARE(routeColours(picture, theme).uav, theme.uav);
    }

    /** The unit "m²" follows the number even for a very uncertain iceberg. */
    void legendHoldsTheUnitOfSigma()
    {
        MapPicture picture = withScenario({}, twoUavs());
        const MapStyle style{.theme = Theme::light(), .locale = QLocale::c()};
        picture.sigmaFull_m2 = 1.5e14;
        const double number_px =
            QFontMetricsF(style.theme.small()).horizontalAdvance(u"150000000000000"_s);
        QVERIFY(number_px / 2 > kLegendUnits_px);
        QVERIFY(legendSize(picture, style, {}, true).width() > kLegendBar_px + number_px / 2 + 15);
    }

    /** Their names take a row for as many as have room in it. */
    void legendNamesTheUavs()
    {
        const Theme theme = Theme::light();
        MapPicture picture = withScenario({}, twoUavs());
        const double two_px = LegendUavs(picture, theme, 220).height_px();
        QVERIFY(two_px > 0);
        QVERIFY(LegendUavs(picture, theme, 60).height_px() > two_px);
        const MapStyle style{.theme = theme, .locale = QLocale::c()};
        const double legend_px = legendSize(picture, style, {}, false).height();
        picture.uavs.pop_back();
        picture.routes.pop_back();
        picture.uavs[0].label.clear(); // the only one
        picture.icebergs[0].assignedUav.reset();
        COMPARE_NEAR(LegendUavs(picture, theme, 220).height_px(), 0, 0);
        QVERIFY(legendSize(picture, style, {}, false).height() <= legend_px - two_px);
    }
};

QTEST_MAIN(TestMapRoutes)
#include "tst_map_routes.moc"
