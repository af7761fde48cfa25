#include "core/earth/forecast_field.h"

#include <QtTest>

using namespace berg;
using namespace std::chrono_literals;

namespace {

Forecast windForecast(double latitude_deg, double longitude_deg, const Point& wind_mps)
{
    return {.source = "test",
            .place = {latitude_deg, longitude_deg},
            .series = {{.time = ForecastTime(0h), .wind_mps = wind_mps},
                       {.time = ForecastTime(2h), .wind_mps = Point(2 * wind_mps)}}};
}

/** Two rows of two places, across the date line; the wind to the north is one at each step. */
ForecastField squareGrid()
{
    return {.columns = 2,
            .places = {windForecast(60, 179, Point(0, 0)), windForecast(60, -179, Point(4, 0)),
                       windForecast(62, 179, Point(0, 8)), windForecast(62, -179, Point(4, 8))}};
}

} // namespace

class TestForecastField : public QObject
{
    Q_OBJECT

private slots:
    void valuesAreBilinearAndLinearInTime()
    {
        QVERIFY(isGrid(squareGrid()));
        const ForecastEntry entry = entryAt(squareGrid(), {60.5, 180}, ForecastTime(1h));
        QCOMPARE(entry.wind_mps->x(), 1.5 * 2);
        QCOMPARE(entry.wind_mps->y(), 1.5 * 2);
        QVERIFY(!entry.gust_mps);
        QCOMPARE(forecastAt(squareGrid(), {60.5, -180}).series[1].wind_mps->x(), 2.0 * 2);
    }

    void edgesApplyOutside()
    {
        QCOMPARE(*entryAt(squareGrid(), {70, -100}, ForecastTime(0h)).wind_mps, Point(4, 8));
        QCOMPARE(*entryAt(squareGrid(), {50, 100}, ForecastTime(0h)).wind_mps, Point(0, 0));
    }

    void aMissingCornerGivesItsWeightToTheOthers()
    {
        ForecastField field = squareGrid();
        for (ForecastEntry& entry : field.places[0].series)
            entry.wind_mps.reset();
        QCOMPARE(*entryAt(field, {60, 180}, ForecastTime(0h)).wind_mps, Point(4, 0));
        for (Forecast& forecast : field.places)
            forecast.series.clear();
        QVERIFY(!entryAt(field, {60, 180}, ForecastTime(0h)).wind_mps);
    }

    void depthsAreBilinear()
    {
        ForecastField field = squareGrid();
        QVERIFY(!depthAt_m(field, {60, 179}));
        for (Forecast& forecast : field.places)
            forecast.depth_m = 10 * (forecast.place.latitude_deg - 60) + 100;
        QCOMPARE(*depthAt_m(field, {61, 179.5}), 110.0);
        QCOMPARE(*forecastAt(field, {61, 179.5}).depth_m, 110.0);
    }

    void anIncompleteGridIsNone()
    {
        ForecastField field = squareGrid();
        field.places.pop_back();
        QVERIFY(!isGrid(field));
        QVERIFY(!isGrid(ForecastField()));
        field = squareGrid();
        std::swap(field.places[0], field.places[2]);
        std::swap(field.places[1], field.places[3]);
        QVERIFY(!isGrid(field)); // from north to south
        field = squareGrid();
        field.places[3].place.latitude_deg = 62.5;
        QVERIFY(!isGrid(field));
    }
};

QTEST_APPLESS_MAIN(TestForecastField)
#include "tst_forecast_field.moc"
