#include "core/io/results/forecast_result.h"

#include "core/base/number_text.h"
#include "core/io/text/json_writer.h"
#include "core/scenario/utc_time.h"
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

/** Returns the columns of a forecast: the usual ones, and the others that hold a value. */
std::vector<std::size_t> columnsOf(const Forecast& forecast)
{
    std::array<bool, kForecastColumns.size()> isShown{};
    std::fill_n(isShown.begin(), kUsualForecastColumns, true);
    for (const ForecastEntry& entry : forecast.series) {
        const auto cells = forecastCells(entry);
        for (std::size_t i = kUsualForecastColumns; i < cells.size(); ++i)
            isShown[i] = isShown[i] || !cells[i].empty();
    }
    std::vector<std::size_t> columns;
    for (std::size_t i = 0; i < isShown.size(); ++i)
        if (isShown[i])
            columns.push_back(i);
    return columns;
}

std::string entryJson(const ForecastEntry& entry, const std::vector<std::size_t>& columns)
{
    JsonObject json;
    json.add("time", utcText(entry.time, 0));
    const auto cells = forecastCells(entry);
    for (const std::size_t i : columns)
        json.addText(kForecastColumns[i], cells[i].empty() ? "null" : cells[i]);
    return json.inLine();
}

std::string gridJson(const ForecastGridFacts& grid)
{
    JsonObject json;
    json.add("file", grid.file);
    json.add("format", grid.format);
    json.add("rows", grid.rows);
    json.add("columns", grid.columns);
    json.add("south_deg", grid.southWest.latitude_deg);
    json.add("west_deg", grid.southWest.longitude_deg);
    json.add("north_deg", grid.northEast.latitude_deg);
    json.add("east_deg", grid.northEast.longitude_deg);
    json.add("thinning", grid.thinning);
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
            directionText(entry.current_mps), rounded(entry.dewPoint_degC),
            rounded(entry.visibility_m),      rounded(entry.ceiling_m)};
}

std::vector<ForecastQuantity> missingQuantities(const Forecast& forecast)
{
    using enum ForecastQuantity;
    std::vector<ForecastQuantity> missing;
    for (const ForecastQuantity quantity : {Wind, Gust, AirTemperature, Fog, Current})
        if (!gives(forecast, quantity))
            missing.push_back(quantity);
    return missing;
}

std::string forecastCsv(const Forecast& forecast)
{
    const std::vector<std::size_t> columns = columnsOf(forecast);
    std::string text = "time";
    for (const std::size_t column : columns)
        text.append(",").append(kForecastColumns[column]);
    for (const ForecastEntry& entry : forecast.series) {
        text += '\n' + utcText(entry.time, 0);
        const auto cells = forecastCells(entry);
        for (const std::size_t column : columns)
            text += ',' + cells[column];
    }
    return text + '\n';
}

std::string forecastJson(const Forecast& forecast, const std::vector<ForecastGap>& gaps,
                         const std::vector<ForecastGridFacts>& grids)
{
    std::vector<std::string> missing;
    for (const ForecastQuantity quantity : missingQuantities(forecast))
        missing.push_back(jsonText(nameOf(quantity)));
    const std::vector<std::size_t> columns = columnsOf(forecast);
    const auto entryText = [&](const ForecastEntry& entry) { return entryJson(entry, columns); };
    JsonObject json;
    json.add("source", forecast.source);
    json.addText("issued",
                 forecast.issued ? jsonText(utcText(*forecast.issued, 0)) : std::string("null"));
    json.add("latitude_deg", forecast.place.latitude_deg);
    json.add("longitude_deg", forecast.place.longitude_deg);
    if (forecast.depth_m)
        json.add("depth_m", *forecast.depth_m);
    json.addText("series", jsonLines(textsOf(forecast.series, entryText), 1));
    json.addText("gaps", jsonLines(textsOf(gaps, gapJson), 1));
    json.addText("missing", jsonArray(missing));
    if (!grids.empty())
        json.addText("grids", jsonLines(textsOf(grids, gridJson), 1));
    return json.inLines(0) + '\n';
}

} // namespace berg
