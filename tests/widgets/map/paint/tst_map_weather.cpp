#include "core/base/random.h"
#include "tests/support/approx.h"
#include "tests/support/flight/forecast_builder.h"
#include "tests/support/flight/scenario_builder.h"
#include "tests/support/window/map_builder.h"
#include "tests/support/window/map_layouts.h"
#include "tests/support/window/panel_test.h"
#include "widgets/map/paint/map_legend_rows.h"
#include "widgets/map/paint/map_painter.h"
#include "widgets/map/paint/wind_panel.h"
#include "widgets/map/picture/mission_picture.h"
#include "widgets/map/picture/scenario_picture.h"

#include <QtTest>

using namespace berg;
using namespace berg::test;
using namespace Qt::StringLiterals;

namespace {

constexpr QSize kSize(900, 600);

Scenario forecastScenario()
{
    Scenario scenario = emptySea(8 * 3600);
    addForecast(scenario);
    return scenario;
}

MapPicture forecastPicture(int icebergs = 6)
{
    MapPicture picture = randomPicture(icebergs);
    picture.weather = mapWeatherAt(forecastScenario(), 0);
    return picture;
}

/** Without the legend, whose rows a forecast changes. */
MapStyle styleOf(const Theme& theme, const MapLayers& layers = {})
{
    MapStyle style{.theme = theme, .locale = kLocale, .layers = layers};
    style.panels[static_cast<std::size_t>(MapPanel::Legend)].isHidden = true;
    return style;
}

QImage painted(const MapPicture& picture, const Theme& theme, const MapLayers& layers = {})
{
    return mapImage(picture, styleOf(theme, layers), kSize, 1);
}

QStringList legendOf(const MapPicture& picture, const MapLayers& layers = {})
{
    const Theme theme = Theme::light();
    QStringList texts;
    for (const LegendRow& row :
         legendRows(picture, {.theme = theme, .locale = kLocale, .layers = layers}, {}))
        texts << row.text;
    return texts;
}

} // namespace

/** Wind barbs and current arrows of a forecast on the map. */
class TestMapWeather : public QObject
{
    Q_OBJECT

private slots:
    void init() { failOnWarnings(); }

    /** The lookup for painting agrees with that of the forecast. */
    void valuesAreThoseOfTheForecast()
    {
        const Scenario scenario = forecastScenario();
        const double time_s = 5400;
        const MapWeatherPointer weather = mapWeatherAt(scenario, time_s);
        const LocalFrame frame(scenario.origin);
        Random random(3);
        for (int i = 0; i < 100; ++i) { // some are beyond the grid
            const Point place_m(random.uniform(-60e3, 60e3), random.uniform(-60e3, 60e3));
            const ForecastEntry entry =
                entryAt(*scenario.forecast, frame.toGeographic(place_m),
                        kForecastStartTime + std::chrono::milliseconds(5'400'000));
            const MapWeatherValues values = weather->at(place_m);
            QVERIFY((*values.wind_mps - *entry.wind_mps).norm() < 1e-9);
            QVERIFY((*values.current_mps - *entry.current_mps).norm() < 1e-9);
        }
        QVERIFY(weather->givesWind() && weather->givesCurrent());
    }

    void missingValuesHaveNoMark()
    {
        Scenario scenario = forecastScenario();
        scenario.forecast->places[4].series.clear();
        const MapWeatherPointer weather = mapWeatherAt(scenario, 0);
        QVERIFY(!weather->at(Point::Zero()).wind_mps); // exactly there the others do not count
        QVERIFY(weather->at(Point(5000, 0)).wind_mps);
        QVERIFY(!mapWeatherAt(scenario, -60)->givesWind());
        scenario.startUtc.clear();
        QVERIFY(mapWeatherAt(scenario, 0) == nullptr);
    }

    void picturesOfAMinuteShareTheForecast()
    {
        const Scenario scenario = forecastScenario();
        MapWeatherCache cache;
        const MapWeatherPointer first = cache.at(scenario, 1, 60);
        QVERIFY(cache.at(scenario, 1, 119.9) == first);
        QVERIFY(cache.at(scenario, 1, 120) != first);
        QVERIFY(cache.at(scenario, 2, 120) != first);
    }

    /** Marks stay while only the flight moves, and move with the sea. */
    void marksAreFixedToTheSea()
    {
        const MapPicture picture = forecastPicture();
        const QRectF rect(0, 0, 900, 600);
        const MapViewTransform view({0, 0}, rect.center(), 0.02);
        const MapWeatherMarksPointer marks = weatherMarksIn(picture, view, rect, nullptr);
        QVERIFY(marks->marks.size() > 10 && marks->marks.size() < 120);
        QVERIFY(weatherMarksIn(picture, view, rect, marks) == marks);
        const MapWeatherMarksPointer moved =
            weatherMarksIn(picture, view.moved({10, 0}), rect, marks);
        QVERIFY(moved != marks);
        const QPointF shifted = marks->marks[marks->marks.size() / 2].at_px + QPointF(10, 0);
        QVERIFY(std::ranges::any_of(moved->marks, [&](const MapWeatherMark& mark) {
            return QLineF(mark.at_px, shifted).length() < 1e-6;
        }));
        QVERIFY(weatherMarksIn(randomPicture(3), view, rect, marks) == nullptr);
    }

    void everyThemeShowsThem()
    {
        for (const Theme& theme : {Theme::light(), Theme::dark(), Theme::highContrast(false),
                                   Theme::highContrast(true), Theme::night()}) {
            const QImage without = painted(randomPicture(6), theme);
            QVERIFY(painted(forecastPicture(), theme) != without);
            MapLayers none;
            none.set(MapLayer::Wind, 0);
            none.set(MapLayer::Current, 0);
            QVERIFY(painted(forecastPicture(), theme, none) == without);
        }
    }

    /** Labels and panels are painted as without a forecast. */
    void labelsStayFree()
    {
        MapPicture picture = forecastPicture(40);
        MapPicture plain = picture;
        plain.weather = nullptr;
        const QImage with = painted(picture, Theme::light());
        const QImage without = painted(plain, Theme::light());
        const Theme theme = Theme::light();
        const MapLayout layout =
            arrangeMap(picture, styleOf(theme), QRectF(QPointF(0, 0), QSizeF(kSize)));
        int labels = 0;
        for (const PlacedLabel& label : layout.labels) {
            const QRect rect = label.rect.toRect();
            if (rect.isEmpty() || !QRect(QPoint(0, 0), kSize).contains(rect))
                continue;
            ++labels;
            QVERIFY(with.copy(rect) == without.copy(rect));
        }
        QVERIFY(labels > 10);
    }

    void legendExplainsTheShownLayers()
    {
        QVERIFY(legendOf(forecastPicture()).contains(u"Forecast wind, full barb 10 kn"_s));
        QVERIFY(legendOf(forecastPicture()).contains(u"Forecast current"_s));
        MapLayers hidden;
        hidden.set(MapLayer::Wind, 0);
        hidden.set(MapLayer::Current, 0);
        QVERIFY(!legendOf(forecastPicture(), hidden).join(u' ').contains(u"Forecast"_s));
        QVERIFY(!legendOf(randomPicture(6)).join(u' ').contains(u"Forecast"_s));
    }

    /** The panel shows the wind of the flight, which a forecast decides. */
    void panelNamesTheForecast()
    {
        Scenario scenario = forecastScenario();
        scenario.wind_mps = {1, 0};
        const MapAir air = airOf(scenario);
        QVERIFY((air.wind_mps - Point(10, 0)).norm() < 1e-6);
        QVERIFY((air.current_mps - Point(0.3, 0.4)).norm() < 1e-6);
        QVERIFY(air.isFixed);
        const QString tip = windToolTip(air, kLocale);
        QVERIFY2(tip.contains(u"Gusts 14.0 m/s"_s), qPrintable(tip));
        QVERIFY2(tip.contains(u"Forecast of MET Norway, issued 2026-05-01 06:00 UTC, "
                              "6 h before the start."_s),
                 qPrintable(tip));
        const Theme theme = Theme::light();
        const MapStyle style{.theme = theme, .locale = kLocale};
        MapAir constant = air;
        constant.forecast.clear();
        QVERIFY(windPanelSize(air, style).height() > windPanelSize(constant, style).height());
        scenario.forecast.reset();
        QVERIFY(!airOf(scenario).isFixed && airOf(scenario).forecast.isEmpty());
    }

    void strongForecastStaysInTheDial()
    {
        const QRectF panel(0, 0, 110, 150);
        const MapAir storm{.wind_mps = Point(60, 0), .limit_mps = 22};
        QVERIFY(panel.contains(windTip(panel, storm)));
    }

    void pictureFollowsTheTimeShown()
    {
        FlightRecord record;
        record.scenario = forecastScenario();
        record.noteWeather();
        record.now.phase = RunPhase::Paused;
        record.now.time_s = 2 * 3600;
        record.now.generation = 1;
        SweptPaths swept;
        const MapPicture now = missionPicture(record, kLocale, swept);
        QVERIFY((*now.weather->at(Point::Zero()).wind_mps - forecastWind_mps(2)).norm() < 1e-9);
        QVERIFY(!now.air.isFixed); // the crew may report another wind
        record.instant = record.now;
        record.instant->time_s = 3600;
        const MapPicture then = missionPicture(record, kLocale, swept);
        QVERIFY((*then.weather->at(Point::Zero()).wind_mps - forecastWind_mps(1)).norm() < 1e-9);
    }
};

QTEST_MAIN(TestMapWeather)
#include "tst_map_weather.moc"
