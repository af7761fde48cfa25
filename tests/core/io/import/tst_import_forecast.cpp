#include "core/base/stopped.h"
#include "core/io/import/import_forecast.h"
#include "core/io/text/atomic_file.h"
#include "core/scenario/utc_time.h"
#include "core/tracking/wind_drift.h"
#include "tests/fuzz/fuzz_mutator.h"
#include "tests/support/approx.h"
#include "tests/support/expect_error.h"

#include <QTest>

#include <cmath>

using namespace berg;
using namespace berg::test;

namespace {

const std::string kSubject = "mutated.json";

std::string fixture(const std::string& name)
{
    return readFile(BERG_TEST_DATA "/forecast/" + name + ".json");
}

Forecast read(const std::string& text)
{
    return forecastFromJson(text, kSubject);
}

UtcTime at(const char* text)
{
    return parseUtc(text).value();
}

/** The weather with the first occurrence of a text replaced. */
std::string changed(const std::string& from, const std::string& to)
{
    std::string text = fixture("locationforecast");
    const std::size_t place = text.find(from);
    return place == std::string::npos ? std::string() : text.replace(place, from.size(), to);
}

/** Whether times rise and all values are finite and in range. */
bool isSound(const Forecast& forecast)
{
    const auto isFinite = [](const std::optional<Point>& value) {
        return !value || (value->allFinite() && value->norm() <= 150.001);
    };
    for (std::size_t i = 0; i < forecast.series.size(); ++i) {
        const ForecastEntry& entry = forecast.series[i];
        if ((i > 0 && entry.time <= forecast.series[i - 1].time) || !isFinite(entry.wind_mps) ||
            !isFinite(entry.current_mps) || !std::isfinite(entry.gust_mps.value_or(0)) ||
            std::abs(entry.airTemperature_degC.value_or(0)) > 90)
            return false;
    }
    return !forecast.series.empty() && std::abs(forecast.place.latitude_deg) <= 90;
}

} // namespace

class TestImportForecast : public QObject
{
    Q_OBJECT

private slots:
    void weatherIsRead()
    {
        const Forecast weather = read(fixture("locationforecast"));
        QCOMPARE(weather.source, std::string("MET Norway locationforecast"));
        QCOMPARE(weather.issued, at("2026-05-01T11:04:26Z"));
        QCOMPARE(weather.place, (LatLon{64.5, -59.8}));
        QCOMPARE(weather.series.size(), 5U);
        const ForecastEntry& first = weather.series[0];
        QCOMPARE(first.time, at("2026-05-01T12:00:00Z"));
        // The wind comes from 350 degrees, so it blows towards 170.
        COMPARE_NEAR(directionTo_deg(*first.wind_mps), 170, 1e-9);
        COMPARE_NEAR(first.wind_mps->norm(), 8, 1e-12);
        QCOMPARE(first.gust_mps, 12.5);
        QCOMPARE(first.airTemperature_degC, -1.5);
        QCOMPARE(first.fog_percent, 10.0);
        QVERIFY(!first.current_mps);
        QVERIFY(!weather.series[2].gust_mps && !weather.series[2].fog_percent);
        COMPARE_NEAR(directionTo_deg(*weather.series[2].wind_mps), 270, 1e-9);
        const std::vector<ForecastGap> gaps = gapsOf(weather);
        QCOMPARE(gaps.size(), 2U); // wind and temperature, over the last 12 h
        QCOMPARE(gaps[0], (ForecastGap{ForecastQuantity::Wind, at("2026-05-02T00:00:00Z"),
                                       at("2026-05-02T12:00:00Z")}));
    }

    void seaIsRead()
    {
        const Forecast sea = read(fixture("oceanforecast"));
        QCOMPARE(sea.source, std::string("MET Norway oceanforecast"));
        QCOMPARE(sea.series.size(), 13U);
        // The current flows towards 180 degrees.
        COMPARE_NEAR((*sea.series[0].current_mps - Point(0, -0.2)).norm(), 0, 1e-12);
        QVERIFY(!sea.series[0].wind_mps && gapsOf(sea).empty());
    }

    void missingValuesAreGaps()
    {
        const Forecast noDirection =
            read(changed(R"("wind_from_direction": 350.0)", R"("wind_from_direction": null)"));
        QVERIFY(!noDirection.series[0].wind_mps && noDirection.series[0].gust_mps);
        const Forecast noSpeed = read(changed(R"("wind_speed": 8.0,)", ""));
        QVERIFY(!noSpeed.series[0].wind_mps && noSpeed.series[1].wind_mps);
        const Forecast sumOnly = read(changed(R"("instant")", R"("next_1_day")"));
        QVERIFY(!sumOnly.series[0].wind_mps && !sumOnly.series[0].gust_mps);
        QVERIFY(!read(changed(R"("updated_at": "2026-05-01T11:04:26Z",)", "")).issued);
        const Forecast humid = read(changed(
            R"("wind_speed": 8.0,)", R"("wind_speed": 8.0, "dew_point_temperature": -2.5,)"));
        QCOMPARE(humid.series[0].dewPoint_degC, std::optional(-2.5));
        QVERIFY(read("\xEF\xBB\xBF" + fixture("oceanforecast")).issued); // a byte order mark
    }

    void brokenForecastsAreRejected_data()
    {
        QTest::addColumn<QString>("from");
        QTest::addColumn<QString>("to");
        QTest::addColumn<QString>("code");
        QTest::addColumn<QString>("message");
        const auto row = [](const char* name, const char* from, const char* to, const char* code,
                            const char* message) {
            QTest::newRow(name) << from << to << code << message;
        };
        const char* const invalid = "InvalidInput";
        row("no series", "\"timeseries\"", "\"series\"", "WrongFormat",
            "properties.timeseries: is missing");
        row("no properties", "\"properties\"", "\"property\"", "WrongFormat",
            "properties.timeseries: is missing");
        row("cut off", "\"2026-05-02T12:00:00Z\"", "\"2026", "SyntaxError", "line");
        row("number", "350.0", "3x0", "SyntaxError", "line");
        row("infinite", "350.0", "1e999", "SyntaxError", "a number too large");
        row("no place", "64.5,", "\"north\",", invalid,
            "geometry.coordinates: this is not a place on the Earth");
        row("off the Earth", "64.5,", "95,", invalid, "geometry.coordinates: ");
        row("direction", "350.0", "361", invalid,
            "properties.timeseries[0].data.instant.details.wind_from_direction: must be from 0 to "
            "360, not 361");
        row("speed", "\"wind_speed\": 8.0", "\"wind_speed\": -8.0", invalid,
            "details.wind_speed: must be from 0 to 150, not -8");
        row("text", "350.0", "\"N\"", invalid, "wind_from_direction: must be a number, not a");
        row("fog", "30.0", "130", invalid, "timeseries[1].data.instant.details.fog_area_fraction");
        row("time", "2026-05-01T13:00:00Z", "2026-05-01 13:00", invalid,
            "properties.timeseries[1].time: must be a UTC date");
        row("times fall", "2026-05-01T13:00:00Z", "2026-05-01T11:00:00Z", invalid,
            "properties.timeseries[1].time: must rise");
        row("a time twice", "2026-05-01T13:00:00Z", "2026-05-01T12:00:00Z", invalid,
            "properties.timeseries[1].time: must rise");
        row("issued", "2026-05-01T11:04:26Z", "yesterday", invalid,
            "properties.meta.updated_at: must be a UTC date");
        row("unit", "\"m/s\"", "\"knots\"", invalid,
            "properties.meta.units.wind_speed: must be \"m/s\"");
        row("a member twice", "\"wind_speed\": 8.0", "\"wind_speed\": 8.0, \"wind_speed\": 9.0",
            invalid, "wind_speed: appears more than once");
        row("details", "\"details\": {", "\"details\": 7, \"other\": {", invalid,
            "properties.timeseries[0].data.instant.details: must be an object");
    }
    void brokenForecastsAreRejected()
    {
        QFETCH(const QString, from);
        QFETCH(const QString, to);
        QFETCH(const QString, code);
        QFETCH(const QString, message);
        std::string text = changed(from.toStdString(), to.toStdString());
        QVERIFY(!text.empty());
        const std::optional<Error> error = errorOf([&] { (void)read(text); });
        QVERIFY2(error, "the file was accepted");
        QCOMPARE(QString::fromStdString(codeName(error->code())), code);
        QVERIFY2(QString::fromStdString(error->what()).contains(message), error->what());
        QVERIFY(std::string_view(error->what()).starts_with(kSubject + ": "));
        QCOMPARE(error->issues().size(), 1U);
    }

    void otherFilesAreRejected()
    {
        const auto code = [](const std::string& text) { return codeOf([&] { (void)read(text); }); };
        QCOMPARE(code(""), std::string("SyntaxError"));
        QCOMPARE(code("[]"), std::string("WrongFormat"));
        QCOMPARE(code("null"), std::string("WrongFormat"));
        QCOMPARE(code(R"({"properties": []})"), std::string("WrongFormat"));
        QCOMPARE(code(R"({"properties": {"timeseries": {}}})"), std::string("WrongFormat"));
        QCOMPARE(code(readFile(BERG_TEST_DATA "/import/points.geojson")),
                 std::string("WrongFormat"));
        QCOMPARE(code(readFile(BERG_TEST_DATA "/scenarios/plain.berg")),
                 std::string("WrongFormat"));
        QCOMPARE(codeOf([] { (void)loadForecast("missing.json"); }), std::string("FileNotFound"));
    }

    void emptyForecastsAreRejected()
    {
        const std::string head = R"({"geometry": {"coordinates": [-59, 64]}, "properties": )"
                                 R"({"meta": {}, "timeseries": [)";
        const std::optional<Error> none = errorOf([&] { (void)read(head + "]}}"); });
        QVERIFY(none && std::string(none->what()).find("at least 1 entries") != std::string::npos);
        const std::optional<Error> waves = errorOf([&] {
            (void)read(head + R"({"time": "2026-05-01T12:00:00Z", "data": {"instant": )"
                              R"({"details": {"sea_surface_wave_height": 1}}}}]}})");
        });
        QVERIFY(waves);
        QCOMPARE(std::string(waves->what()),
                 kSubject + ": wind_speed: is missing, and so is sea_water_speed");
    }

    void limitsAreKept()
    {
        const std::string deep = std::string(200, '[') + std::string(200, ']');
        QCOMPARE(codeOf([&] { (void)read(deep); }), std::string("SyntaxError"));
        // Only the first hundred faults are listed.
        std::string many = R"({"geometry": {"coordinates": [-59, 64]}, "properties": {"meta": {}, )"
                           R"("timeseries": [0)";
        for (int i = 0; i < 5000; ++i)
            many += ",0";
        const std::optional<Error> error = errorOf([&] { (void)read(many + "]}}"); });
        QVERIFY(error);
        QCOMPARE(error->issues().size(), 101U);
        std::stop_source source;
        source.request_stop();
        QVERIFY_EXCEPTION_THROWN(
            (void)forecastFromJson(fixture("oceanforecast"), kSubject, source.get_token()),
            Stopped);
    }

    void mutantsAreRejectedOrSound()
    {
        for (const char* const name : {"locationforecast", "oceanforecast"}) {
            const std::string text = fixture(name);
            const std::vector<std::string> corpus{text};
            fuzz::Mutator mutator(1, corpus);
            int taken = 0;
            for (int i = 0; i < 3000; ++i) {
                const std::string mutant = mutator.mutated(text);
                try {
                    QVERIFY2(isSound(read(mutant)), mutant.c_str());
                    ++taken;
                } catch (const Error& error) {
                    QVERIFY(!error.issues().empty());
                }
            }
            QVERIFY(taken > 10);
        }
    }
};

QTEST_APPLESS_MAIN(TestImportForecast)
#include "tst_import_forecast.moc"
