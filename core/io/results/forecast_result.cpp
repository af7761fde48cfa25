#include "core/io/results/forecast_result.h"

#include "core/base/number_text.h"
#include "core/io/text/json_writer.h"
#include "core/io/text/utc_time.h"
#include "core/tracking/wind_drift.h"

#include <algorithm>
#include <cmath>

namespace berg {

namespace {

/** Returns a number with at most two decimals. */
std::string rounded(double value)
{
    return numberText(std::round(value * 100) / 100 + 0.0); // no -0
}

std::string rounded(const std::optional<double>& value)
{
    return value ? rounded(*value) : std::string();
}

/** Returns a direction in [0, 360) with one decimal; empty for no velocity. */
std::string directionText(const std::optional<Point>& velocity_mps)
{
    if (!velocity_mps || *velocity_mps == Point::Zero())
        return {};
    const double tenths = std::round(directionTo_deg(*velocity_mps) * 10);
    return numberText(tenths >= 3600 ? 0 : tenths / 10);
}

std::optional<Point> reversed(const std::optional<Point>& velocity_mps)
{
    return velocity_mps ? std::optional<Point>(-*velocity_mps) : std::nullopt;
}

std::optional<double> speedOf(const std::optional<Point>& velocity_mps)
{
    return velocity_mps ? std::optional(velocity_mps->norm()) : std::nullopt;
}

std::string entryJson(const ForecastEntry& entry)
{
    JsonObject json;
    json.add("time", utcText(entry.time, 0));
    const auto cells = forecastCells(entry);
    for (std::size_t i = 0; i < cells.size(); ++i)
        json.addText(kForecastColumns[i], cells[i].empty() ? "null" : cells[i]);
    return json.inLine();
}

std::string gapJson(const ForecastGap& gap)
{
    JsonObject json;
    json.add("quantity", nameOf(gap.quantity));
    json.add("from", utcText(gap.from, 0));
    json.add("to", utcText(gap.to, 0));
    return json.inLine();
}

} // namespace

std::array<std::string, kForecastColumns.size()> forecastCells(const ForecastEntry& entry)
{
    return {rounded(speedOf(entry.wind_mps)), directionText(reversed(entry.wind_mps)),
            rounded(entry.gust_mps),          rounded(entry.airTemperature_degC),
            rounded(entry.fog_percent),       rounded(speedOf(entry.current_mps)),
            directionText(entry.current_mps)};
}

std::string forecastCsv(const Forecast& forecast)
{
    std::string text = "time";
    for (const std::string_view column : kForecastColumns)
        text.append(",").append(column);
    for (const ForecastEntry& entry : forecast.series) {
        text += '\n' + utcText(entry.time, 0);
        for (const std::string& cell : forecastCells(entry))
            text += ',' + cell;
    }
    return text + '\n';
}

std::string forecastJson(const Forecast& forecast, const std::vector<ForecastGap>& gaps)
{
    std::vector<std::string> missing;
    for (const ForecastQuantity quantity : kForecastQuantities)
        if (!gives(forecast, quantity))
            missing.push_back(jsonText(nameOf(quantity)));
    JsonObject json;
    json.add("source", forecast.source);
    json.addText("issued",
                 forecast.issued ? jsonText(utcText(*forecast.issued, 0)) : std::string("null"));
    json.add("latitude_deg", forecast.place.latitude_deg);
    json.add("longitude_deg", forecast.place.longitude_deg);
    json.addText("series", jsonLines(textsOf(forecast.series, entryJson), 1));
    json.addText("gaps", jsonLines(textsOf(gaps, gapJson), 1));
    json.addText("missing", jsonArray(missing));
    return json.inLines(0) + '\n';
}

} // namespace berg
