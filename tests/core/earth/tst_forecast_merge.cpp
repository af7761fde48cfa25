#include "core/earth/forecast_merge.h"
#include "tests/support/approx.h"

#include <QTest>

using namespace berg;
using namespace berg::test;
using namespace std::chrono_literals;

namespace {

Forecast forecastOf(const std::string& source, LatLon place, ForecastEntry entry)
{
    Forecast forecast{.source = source, .issued = ForecastTime(0h), .place = place};
    for (const auto hour : {0h, 3h}) {
        entry.time = ForecastTime(hour);
        forecast.series.push_back(entry);
    }
    return forecast;
}

/** Winds that grow to the east, on a grid of 2 x 3. */
ForecastField windField()
{
    ForecastField field{.columns = 3};
    for (const double latitude : {60.0, 61.0})
        for (const double longitude : {-2.0, -1.0, 0.0})
            field.places.push_back(
                forecastOf("air", {latitude, longitude}, {.wind_mps = Point(10 + longitude, 0)}));
    return field;
}

} // namespace

class TestForecastMerge : public QObject
{
    Q_OBJECT

private slots:
    void onePlaceIsTakenFromItsNeighbours()
    {
        const ForecastField field = windField();
        for (const LatLon& place :
             {LatLon{60.25, -1.5}, LatLon{61, 0}, LatLon{70, 30}, LatLon{60, -2}}) {
            const Forecast near = nearForecastAt(field, place);
            const Forecast all = forecastAt(field, place);
            COMPARE_NEAR(near.series[1].wind_mps->x(), all.series[1].wind_mps->x(), 1e-9);
            QCOMPARE(near.place, place);
        }
    }

    void airAndSeaAreCombined()
    {
        const ForecastField sea{
            .places = {forecastOf("sea", {60.5, -1}, {.current_mps = Point(0.1, 0.2)})}};
        const std::vector<ForecastField> both{sea, windField()};
        const ForecastField all = combined(both);
        QVERIFY(isGrid(all));
        QCOMPARE(all.columns, 3U);
        QCOMPARE(all.places.size(), 6U);
        QCOMPARE(all.places[2].source, std::string("air, sea"));
        COMPARE_NEAR(all.places[2].series[0].wind_mps->x(), 10, 1e-9);
        COMPARE_NEAR(all.places[2].series[0].current_mps->y(), 0.2, 1e-9);
    }

    void aNewerForecastReplacesAQuantity()
    {
        ForecastField newer{.places = {forecastOf("new", {60, -2}, {.wind_mps = Point(1, 1)})}};
        newer.places[0].issued = ForecastTime(1h);
        const std::vector<ForecastField> both{windField(), newer};
        const ForecastField all = combined(both);
        COMPARE_NEAR(all.places[2].series[0].wind_mps->x(), 1, 1e-9);
        QCOMPARE(all.places[2].source, std::string("new"));
    }
};

QTEST_APPLESS_MAIN(TestForecastMerge)
#include "tst_forecast_merge.moc"
