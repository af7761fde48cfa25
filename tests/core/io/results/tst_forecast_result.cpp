#include "core/io/results/forecast_result.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

using namespace berg;
using namespace std::chrono_literals;

namespace {

const Forecast kForecast{
    .source = "test",
    .place = {64.5, -59.8},
    .series = {{.time = ForecastTime(0ms),
                .wind_mps = Point(0, -8.123),
                .airTemperature_degC = -0.001,
                .current_mps = Point(0.2, 0)},
               {.time = ForecastTime(1h), .wind_mps = Point(0, 0), .fog_percent = 30}}};

} // namespace

class TestForecastResult : public QObject
{
    Q_OBJECT

private slots:
    void table()
    {
        // The wind blows to the south, so it comes from 0 degrees. A calm has no direction.
        QCOMPARE(forecastCsv(kForecast),
                 std::string("time,wind_speed_mps,wind_from_deg,gust_mps,air_temperature_degC,"
                             "fog_percent,current_speed_mps,current_to_deg\n"
                             "1970-01-01T00:00:00Z,8.12,0,,0,,0.2,90\n"
                             "1970-01-01T01:00:00Z,0,,,,30,,\n"));
    }

    void furtherColumnsAreShownWhereTheyHoldAValue()
    {
        Forecast forecast = kForecast;
        forecast.series[1].visibility_m = 4000;
        forecast.depth_m = 250;
        QCOMPARE(forecastCsv(forecast),
                 std::string("time,wind_speed_mps,wind_from_deg,gust_mps,air_temperature_degC,"
                             "fog_percent,current_speed_mps,current_to_deg,visibility_m\n"
                             "1970-01-01T00:00:00Z,8.12,0,,0,,0.2,90,\n"
                             "1970-01-01T01:00:00Z,0,,,,30,,,4000\n"));
        const std::vector<ForecastGridFacts> grids{
            {.file = "a.nc", .format = "NetCDF", .rows = 2, .columns = 3, .thinning = 4}};
        const QJsonObject json =
            QJsonDocument::fromJson(QByteArray::fromStdString(forecastJson(forecast, {}, grids)))
                .object();
        QCOMPARE(json["depth_m"].toDouble(), 250.0);
        QCOMPARE(json["series"][1]["visibility_m"].toDouble(), 4000.0);
        QVERIFY(json["series"][0]["visibility_m"].isNull());
        QVERIFY(!json["series"][0].toObject().contains("ceiling_m"));
        QCOMPARE(json["grids"][0]["columns"].toInt(), 3);
    }

    void document()
    {
        const std::vector<ForecastGap> gaps{
            {ForecastQuantity::Wind, ForecastTime(0ms), ForecastTime(9h)}};
        const QJsonObject json =
            QJsonDocument::fromJson(QByteArray::fromStdString(forecastJson(kForecast, gaps)))
                .object();
        QVERIFY(json["issued"].isNull());
        QCOMPARE(json["latitude_deg"].toDouble(), 64.5);
        QCOMPARE(json["series"][0]["current_to_deg"].toDouble(), 90.0);
        QVERIFY(json["series"][1]["wind_from_deg"].isNull());
        QCOMPARE(json["gaps"][0]["to"].toString(), QString("1970-01-01T09:00:00Z"));
        QCOMPARE(json["missing"].toArray(), (QJsonArray{"gust"}));
    }
};

QTEST_APPLESS_MAIN(TestForecastResult)
#include "tst_forecast_result.moc"
