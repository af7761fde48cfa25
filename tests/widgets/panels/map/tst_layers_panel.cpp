#include "tests/support/flight/forecast_builder.h"
#include "tests/support/flight/scenario_builder.h"
#include "tests/support/window/map_builder.h"
#include "tests/support/window/panel_test.h"
#include "widgets/map/paint/map_drift.h"
#include "widgets/map/paint/map_layout.h"
#include "widgets/map/paint/map_overlays.h"
#include "widgets/map/paint/map_painter.h"
#include "widgets/map/picture/ice_picture.h"
#include "widgets/panels/map/layers_panel.h"

#include <QComboBox>
#include <QPainter>
#include <QPushButton>
#include <QSignalSpy>
#include <QSlider>

using namespace berg;
using namespace Qt::StringLiterals;

namespace {

const Theme kTheme = Theme::light();

MapStyle styleOf(const MapLayers& layers)
{
    return {.theme = kTheme, .locale = QLocale::c(), .layers = layers};
}

MapPicture picture()
{
    MapPicture shown = test::randomPicture(6);
    shown.routes.front().formerPlan = {5, 4, 3, 2, 1, 0};
    shown.routes.front().swept = std::make_shared<const std::vector<MapPose>>(std::vector<MapPose>{
        {.position_m = {1000, 1000}}, {.position_m = {3000, 1000}, .time_s = 100}});
    shown.comparisonTracks = {{{.position_m = {500, 2500}}, {.position_m = {4500, 2800}}}};
    shown.origin = {48.63, -53.14}; // Bonavista is among them
    Scenario ice;
    ice.origin = shown.origin;
    ice.iceChart = IceChart{
        .areas = {{.concentration_tenths = 5, .outlines_m = {{{0, 0}, {4000, 0}, {0, 4000}}}}}};
    shown.iceChart = iceChartOf(ice);
    Scenario scenario = test::emptySea();
    test::addForecast(scenario);
    shown.weather = mapWeatherAt(scenario, 0);
    shown.airspace = {{.corners_m = {{500, 500}, {4500, 500}, {2500, 3500}}}};
    return shown;
}

/** Drift to the east over the picture, aground at the end. */
DriftTracksPointer someTracks()
{
    DriftTrack track;
    for (int k = 0; k < 4; ++k)
        track.points.push_back({.time_s = k * 21600.0,
                                .position_m = {1000.0 + 900 * k, 2000},
                                .sd_m = 150.0 * k,
                                .isAground = k == 3});
    return std::make_shared<const std::vector<DriftTrack>>(std::vector<DriftTrack>{track});
}

QImage painted(const MapLayers& layers)
{
    return mapImage(picture(), styleOf(layers), {900, 600}, 1);
}

} // namespace

class TestLayersPanel : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }
    void init() { test::failOnWarnings(); }

    void eachLayerIsMadeFaintAndHidden_data()
    {
        QTest::addColumn<int>("layer");
        const std::array<const char*, kMapLayers> names{
            "labels",   "drift",    "rings",  "graticule", "formerPlan", "swept",   "permit",
            "backdrop", "compared", "places", "iceChart",  "wind",       "current", "tracks"};
        for (std::size_t i = 0; i < kMapLayers; ++i)
            QTest::newRow(names[i]) << static_cast<int>(i);
    }

    void eachLayerIsMadeFaintAndHidden()
    {
        QFETCH(int, layer);
        MapLayers all;
        all.backdrop = std::make_shared<const BackdropShapes>(BackdropShapes{
            {.kind = MapShape::Kind::Polygon, .parts = {{{47, -54}, {47, -52}, {50, -53}}}}});
        all.set(MapLayer::Tracks, 1);
        all.tracks = someTracks();
        MapLayers faint = all;
        faint.set(static_cast<MapLayer>(layer), 0.3);
        MapLayers hidden = all;
        hidden.set(static_cast<MapLayer>(layer), 0);
        const QImage full = painted(all);
        QVERIFY(painted(faint) != full);
        QVERIFY(painted(hidden) != full);
        QVERIFY(painted(hidden) != painted(faint));
        QVERIFY(painted(all) == full);
    }

    /** Arrows that would cross the whole map are shortened. */
    void horizonIsChosen()
    {
        const MapPicture shown = picture();
        MapLayers layers;
        layers.horizon_s = 86400;
        const MapLayout map = arrangeMap(shown, styleOf(layers), {0, 0, 900, 600});
        QCOMPARE(map.symbols.driftTime_s, 86400.0);
        bool anyCapped = false;
        for (std::size_t i = 0; i < shown.icebergs.size(); ++i) {
            const QLineF arrow = driftArrow(shown, map, i);
            QVERIFY(arrow.length() < 121);
            anyCapped = anyCapped || isCapped(arrow);
        }
        QVERIFY(anyCapped);
        layers.set(MapLayer::Drift, 0);
        QCOMPARE(arrangeMap(shown, styleOf(layers), {0, 0, 900, 600}).symbols.driftTime_s, 0.0);
    }

    /** The arrow of an iceberg beside the map is visible, up to the length of the longest arrow. */
    void arrowsReachIntoTheMap()
    {
        MapPicture shown;
        shown.sigmaFull_m2 = 10;
        shown.icebergs.push_back({.position_m = {-1000, 0}, .velocity_mps = {1, 0}});
        const MapViewTransform view = arrangeMap(shown, styleOf({}), {0, 0, 900, 600}).view;
        const auto paint = [&](double horizon_s) {
            MapLayers layers;
            layers.horizon_s = horizon_s;
            const double left_px = view.toPixel({-1000, 0}).x() + 90;
            const QRectF rect(left_px, 0, 900, 600);
            QImage image(900, 600, QImage::Format_RGB32);
            QPainter painter(&image);
            painter.translate(-rect.topLeft());
            MapLayout layout = arrangeMap(shown, styleOf(layers), rect, view);
            layout.legend = {}; // the legend states the horizon
            paintMap(painter, shown, styleOf(layers), layout);
            return image;
        };
        QVERIFY(paint(86400) != paint(1e-3));
    }

    /** The samples of the legend have rings as strong as those of the map. */
    void legendHasTheRingsOfTheMap()
    {
        MapLayers hidden;
        hidden.set(MapLayer::Rings, 0);
        const MapPicture shown = picture();
        const QRectF rect(0, 0, 900, 700);
        const MapLayout map = arrangeMap(shown, styleOf({}), rect);
        QVERIFY(!map.isLegendCompact && !map.legend.isNull());
        const auto legend = [&](const MapLayers& layers) {
            QImage image(rect.size().toSize(), QImage::Format_RGB32);
            image.fill(Qt::white);
            QPainter painter(&image);
            paintLegend(painter, map.legend, shown, styleOf(layers), map.symbols, false);
            return image;
        };
        QVERIFY(legend(hidden) != legend({}));
    }

    void editsAreReported()
    {
        LayersPanel panel;
        QSignalSpy edited(&panel, &LayersPanel::layersEdited);
        MapLayers layers;
        layers.set(MapLayer::Rings, 0.3);
        layers.horizon_s = 3600;
        panel.showLayers(layers);
        QCOMPARE(edited.count(), 0); // it was shown
        QCOMPARE(test::child<QSlider>(panel, u"ringsLayer"_s).value(), 30);
        QCOMPARE(test::child<QComboBox>(panel, u"driftHorizon"_s).currentText(), u"1 h"_s);
        QTest::keyClick(&test::child<QSlider>(panel, u"labelsLayer"_s), Qt::Key_Home);
        QCOMPARE(edited.count(), 1);
        QVERIFY(!panel.layers().shows(MapLayer::Labels));
        QCOMPARE(panel.layers().opacity(MapLayer::Rings), 0.3);
        test::child<QComboBox>(panel, u"driftHorizon"_s).setCurrentIndex(0);
        QVERIFY(!panel.layers().horizon_s);
    }

    void marksOfTheDriftAreChosen()
    {
        LayersPanel panel;
        panel.showLayers({});
        QSignalSpy edited(&panel, &LayersPanel::layersEdited);
        auto& marks = test::child<QComboBox>(panel, u"trackMarks"_s);
        QCOMPARE(marks.currentText(), u"every 6 h"_s);
        marks.setCurrentIndex(0);
        QCOMPARE(edited.count(), 1);
        QCOMPARE(panel.layers().trackMark_s, 3600.0);
        QVERIFY(!panel.layers().shows(MapLayer::Tracks)); // hidden unless chosen
    }

    /** Points between two marks belong to the line alone. */
    void pointsBetweenMarksAreLineOnly()
    {
        std::vector<DriftTrack> tracks = *someTracks();
        MapLayers layers;
        layers.set(MapLayer::Tracks, 1);
        layers.tracks = someTracks();
        const QImage marks = painted(layers);
        std::vector<DriftTrackPoint>& points = tracks.front().points;
        points.insert(points.begin() + 1,
                      {.time_s = 1800, .position_m = points.front().position_m, .sd_m = 1000});
        layers.tracks = std::make_shared<const std::vector<DriftTrack>>(tracks);
        QVERIFY(painted(layers) == marks);
        layers.trackMark_s = 1800;
        QVERIFY(painted(layers) != marks);
    }

    /** Marks and circles would cover a field of many icebergs. */
    void manyTracksAreLinesOnly()
    {
        std::vector<DriftTrack> many(30, someTracks()->front());
        MapLayers layers;
        layers.set(MapLayer::Tracks, 1);
        layers.tracks = std::make_shared<const std::vector<DriftTrack>>(many);
        const QImage lines = painted(layers);
        for (DriftTrack& track : many)
            for (DriftTrackPoint& point : track.points)
                point.sd_m = 1000;
        layers.tracks = std::make_shared<const std::vector<DriftTrack>>(many);
        QVERIFY(painted(layers) == lines);
        many.resize(2);
        layers.tracks = std::make_shared<const std::vector<DriftTrack>>(many);
        QVERIFY(painted(layers) != lines);
    }

    void panelNamesTheBackground()
    {
        LayersPanel panel;
        panel.show();
        auto& button = test::child<QPushButton>(panel, u"backdropButton"_s);
        const auto& remove = test::child<QPushButton>(panel, u"backdropRemoveButton"_s);
        const auto& opacity = test::child<QSlider>(panel, u"backdropLayer"_s);
        QVERIFY(!remove.isVisible() && !opacity.isEnabled());
        panel.showBackdrop(u"/charts/sea & ice.kml"_s);
        QCOMPARE(button.text(), u"sea && ice.kml"_s);
        QVERIFY(remove.isVisible() && opacity.isEnabled());
        QSignalSpy asked(&panel, &LayersPanel::backdropRequested);
        button.click();
        QCOMPARE(asked.count(), 1);
        panel.showBackdrop({});
        QVERIFY(!remove.isVisible() && !opacity.isEnabled());
    }
};

QTEST_MAIN(TestLayersPanel)
#include "tst_layers_panel.moc"
