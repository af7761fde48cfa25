#include "core/io/import/import_scenario_forecast.h"

#include "core/base/angles.h"
#include "core/base/error.h"
#include "core/earth/forecast_merge.h"
#include "core/earth/geodesy.h"
#include "core/io/text/json_writer.h"
#include "core/scenario/utc_time.h"

#include <algorithm>
#include <cmath>

namespace berg {

namespace {

std::vector<Point> placesIn(const Scenario& scenario)
{
    std::vector<Point> places = scenario.area_m;
    for (const Iceberg& iceberg : scenario.icebergs)
        places.push_back(iceberg.position_m);
    for (const Uav& uav : scenario.uavs)
        places.push_back(uav.position_m);
    if (scenario.asset)
        places.push_back(scenario.asset->position_m);
    if (scenario.groundStation)
        places.push_back(scenario.groundStation->position_m);
    if (places.empty())
        places.emplace_back(0, 0);
    return places;
}

/** Start and end of a run. */
struct RunWindow
{
    ForecastTime start;
    ForecastTime end;
};

RunWindow runWindow(const Scenario& scenario, const std::optional<ForecastTime>& at)
{
    const std::optional<ForecastTime> start = at ? at : parseUtc(scenario.startUtc);
    if (!start)
        throw Error(ErrorCode::InvalidInput, "scenario",
                    {{Severity::Error, "start_utc", {IssueId::Missing}}});
    return {.start = *start,
            .end = *start + std::chrono::milliseconds(std::llround(scenario.duration_s * 1000))};
}

/** Keeps the instants that are needed, the last before them and the first after them. */
void cutTo(const RunWindow& run, ForecastField& field)
{
    const ForecastTime needed = run.end + kForecastAfterRun;
    for (Forecast& place : field.places) {
        std::vector<ForecastEntry>& series = place.series;
        const auto end = std::ranges::lower_bound(series, needed, {}, &ForecastEntry::time);
        if (end != series.end())
            series.erase(end + 1, series.end());
        const auto after = std::ranges::upper_bound(series, run.start, {}, &ForecastEntry::time);
        if (after != series.begin())
            series.erase(series.begin(), after - 1);
    }
}

} // namespace

ForecastReadOptions forecastOptions(const Scenario& scenario, const std::optional<ForecastTime>& at)
{
    const RunWindow run = runWindow(scenario, at);
    const LocalFrame frame(scenario.origin);
    Point low = Point::Constant(std::numeric_limits<double>::infinity());
    Point high = -low;
    for (const Point& place : placesIn(scenario)) {
        low = low.cwiseMin(place);
        high = high.cwiseMax(place);
    }
    const Point margin = Point::Constant(kForecastMargin_m);
    GeoBox box{.south_deg = 90, .north_deg = -90};
    double west = 180;
    double east = -180;
    for (const Point& corner : {Point(low - margin), Point(high + margin),
                                Point(low.x() - kForecastMargin_m, high.y() + kForecastMargin_m),
                                Point(high.x() + kForecastMargin_m, low.y() - kForecastMargin_m)}) {
        const LatLon place = frame.toGeographic(corner);
        box.south_deg = std::min(box.south_deg, place.latitude_deg);
        box.north_deg = std::max(box.north_deg, place.latitude_deg);
        const double offset = place.longitude_deg - scenario.origin.longitude_deg;
        const double turned = offset - 360 * std::floor((offset + 180) / 360);
        west = std::min(west, turned);
        east = std::max(east, turned);
    }
    const auto longitude = [&](double offset) {
        const double turned = scenario.origin.longitude_deg + offset;
        return turned - 360 * std::floor((turned + 180) / 360);
    };
    box.west_deg = longitude(west);
    box.east_deg = longitude(east);
    return {.area = box,
            .since = run.start,
            .until = run.end + kForecastAfterRun,
            .mostEntries = kMostScenarioEntries};
}

const Forecast& middleOf(const ForecastField& field)
{
    require(isGrid(field), "middleOf: no grid");
    const std::size_t rows = field.places.size() / field.columns;
    return field.places[rows / 2 * field.columns + field.columns / 2];
}

ForecastImport withForecast(const Scenario& base, const ForecastReading& reading,
                            const std::string& subject, bool replace,
                            const std::optional<ForecastTime>& at)
{
    const RunWindow run = runWindow(base, at);
    ForecastField field = reading.field;
    const Forecast& first = field.places.front();
    if (first.series.empty() || first.series.back().time < run.start ||
        first.series.front().time > run.end)
        throw Error(ErrorCode::InvalidInput, subject,
                    {{Severity::Error,
                      "time",
                      {IssueId::ForecastNotThen,
                       {first.series.empty() ? "-" : utcText(first.series.front().time, 0),
                        first.series.empty() ? "-" : utcText(first.series.back().time, 0)}}}});
    cutTo(run, field);
    ForecastImport made{.scenario = base};
    if (base.forecast && !replace) {
        const std::array both{std::move(field), *base.forecast};
        field = combined(both);
    }
    if (at)
        made.scenario.startUtc = utcText(*at, 0);
    const Forecast& middle = middleOf(field);
    for (const ForecastQuantity quantity : kForecastQuantities)
        if (std::ranges::any_of(field.places,
                                [&](const Forecast& place) { return gives(place, quantity); }))
            made.quantities.push_back(quantity);
    made.gaps = gapsOf(middle, run.start, run.end);
    made.age_h = ageAt_h(middle, run.start);
    made.scenario.forecast = std::move(field);
    return made;
}

std::string forecastImportJson(const ForecastImport& imported, const ForecastReading& reading)
{
    const ForecastField& field = *imported.scenario.forecast;
    const Forecast& first = field.places.front();
    std::vector<std::string> quantities;
    for (const ForecastQuantity quantity : imported.quantities)
        quantities.emplace_back(nameOf(quantity));
    JsonObject json;
    json.add("format", reading.format);
    json.add("source", first.source);
    json.addText("issued",
                 first.issued ? jsonText(utcText(*first.issued, 0)) : std::string("null"));
    json.add("places", field.places.size());
    json.add("columns", field.columns);
    json.add("thinning", reading.thinning);
    json.add("from", utcText(first.series.front().time, 0));
    json.add("to", utcText(first.series.back().time, 0));
    json.add("times", first.series.size());
    json.addText("quantities", jsonArrayOf(quantities));
    return json.inLines(0) + '\n';
}

} // namespace berg
