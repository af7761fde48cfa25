#include "tests/support/flight/scenario_builder.h"
#include "tests/support/window/map_builder.h"
#include "widgets/map/paint/map_legend_rows.h"
#include "widgets/map/paint/map_painter.h"
#include "widgets/map/picture/ice_picture.h"
#include "widgets/map/picture/scenario_picture.h"

#include <QtTest>

using namespace berg;
using namespace berg::test;
using namespace Qt::StringLiterals;

namespace {

Scenario withIce()
{
    Scenario scenario = emptySea();
    scenario.startUtc = "2021-01-19T00:00:00Z";
    addIceberg(scenario, 1000, 1000);
    const std::vector<Point> outline_m{
        {-20'000, -20'000}, {20'000, -20'000}, {20'000, 20'000}, {-20'000, 20'000}};
    const std::vector<Point> hole_m{{-9000, -9000}, {-5000, -9000}, {-5000, -5000}, {-9000, -5000}};
    scenario.iceChart = IceChart{
        .source = "chart.shp",
        .dateUtc = "2021-01-18T18:00:00Z",
        .areas = {
            {.label = "9-10/10", .concentration_tenths = 9.5, .outlines_m = {outline_m, hole_m}},
            {.concentration_tenths = 2,
             .outlines_m = {{{30'000, 0}, {40'000, 0}, {40'000, 9000}}}}}};
    return scenario;
}

QStringList legendOf(const Scenario& scenario, double opacity = 1)
{
    const MapPicture picture = withScenario({}, scenario);
    const Theme theme = Theme::light();
    MapStyle style{.theme = theme, .locale = QLocale::c()};
    style.layers.set(MapLayer::IceChart, opacity);
    QStringList texts;
    for (const LegendRow& row : legendRows(picture, style, {}))
        texts << row.text;
    return texts;
}

} // namespace

/** Tests of the ice chart below the icebergs. */
class TestIcePicture : public QObject
{
    Q_OBJECT

private slots:
    void legendHasDateAndClasses()
    {
        const QStringList rows = legendOf(withIce());
        QVERIFY2(rows.contains(u"Ice chart: 2021-01-18 18:00 UTC"_s), qPrintable(rows.join(u'\n')));
        QVERIFY(rows.contains(u"Ice 9–10 tenths"_s) && rows.contains(u"Ice 1–3 tenths"_s));
        QVERIFY(!rows.contains(u"Fast ice"_s));
        QVERIFY(legendOf(withIce(), 0).filter(u"Ice "_s).isEmpty());
        Scenario old = withIce();
        old.startUtc = "2021-01-21T00:00:00Z";
        QVERIFY(legendOf(old).contains(u"Old ice chart: 2021-01-18 18:00 UTC"_s));
        old.iceChart->dateUtc.clear();
        QVERIFY(legendOf(old).contains(u"Ice chart: no date"_s));
        QVERIFY(legendOf(emptySea()).filter(u"Ice "_s).isEmpty());
    }

    void areasAreFoundOutsideTheirHoles()
    {
        const IceChartPointer chart = iceChartOf(withIce());
        QCOMPARE(iceAreaAt(*chart, {0, 0})->label, std::string("9-10/10"));
        QVERIFY(iceAreaAt(*chart, {-7000, -7000}) == nullptr);
        QVERIFY(iceAreaAt(*chart, {25'000, 0}) == nullptr);
    }

    void chartIsProjectedOnce()
    {
        Scenario scenario = withIce();
        const IceChartPointer chart = iceChartOf(scenario);
        scenario.name = "other";
        QCOMPARE(iceChartOf(scenario), chart);
        scenario.iceChart->areas.pop_back();
        QVERIFY(iceChartOf(scenario) != chart);
        scenario.iceChart.reset();
        QVERIFY(iceChartOf(scenario) == nullptr);
    }

    void iceLiesBelowTheIcebergs_data()
    {
        QTest::addColumn<bool>("isDark");
        QTest::newRow("light") << false;
        QTest::newRow("dark") << true;
    }

    void iceLiesBelowTheIcebergs()
    {
        QFETCH(bool, isDark);
        const Theme theme = isDark ? Theme::dark() : Theme::light();
        const MapStyle style{.theme = theme, .locale = QLocale::c()};
        const MapPicture picture = withScenario({}, withIce());
        const QSize size(900, 600);
        const QImage image = mapImage(picture, style, size, 1);
        Scenario bare = withIce();
        bare.iceChart.reset();
        const QImage without = mapImage(withScenario({}, bare), style, size, 1);
        const MapLayout layout = arrangeMap(picture, style, QRectF(QPointF(0, 0), QSizeF(size)));
        const QPoint water = layout.view.toPixel({700, 300}).toPoint();
        const auto redness = [&water](const QImage& of) {
            return of.pixelColor(water).red() - of.pixelColor(water).blue();
        };
        QVERIFY(redness(image) > redness(without) + 20);
        const QPoint iceberg = layout.icebergs.front().centre_px.toPoint();
        QCOMPARE(image.pixel(iceberg), without.pixel(iceberg));
    }
};

QTEST_MAIN(TestIcePicture)
#include "tst_ice_picture.moc"
