#include "core/io/import/import_forecast.h"

#include "core/io/import/fields/json_members.h"
#include "core/io/text/atomic_file.h"
#include "core/scenario/utc_time.h"
#include "core/tracking/wind_drift.h"

#include <array>
#include <string>
#include <utility>

namespace berg {

namespace {

/** A number of `data.instant.details`: its name, its only accepted unit and its range. */
struct ForecastNumber
{
    const char* name;
    const char* unit;
    Limits limits;
};
constexpr Limits kDirection_deg{.low = 0, .high = 360};
constexpr ForecastNumber kWindSpeed{"wind_speed", "m/s", limits::kWindSpeed_mps};
constexpr ForecastNumber kWindFrom{"wind_from_direction", "degrees", kDirection_deg};
constexpr ForecastNumber kGust{"wind_speed_of_gust", "m/s", limits::kWindSpeed_mps};
constexpr ForecastNumber kAirTemperature{"air_temperature", "celsius", limits::kTemperature_degC};
constexpr ForecastNumber kDewPoint{"dew_point_temperature", "celsius", limits::kTemperature_degC};
constexpr ForecastNumber kFog{"fog_area_fraction", "%", {.low = 0, .high = 100}};
constexpr ForecastNumber kCurrentSpeed{"sea_water_speed", "m/s", limits::kSpeed_mps};
constexpr ForecastNumber kCurrentTo{"sea_water_to_direction", "degrees", kDirection_deg};
constexpr std::array kForecastNumbers{kWindSpeed, kWindFrom, kGust,         kAirTemperature,
                                      kDewPoint,  kFog,      kCurrentSpeed, kCurrentTo};

std::optional<double> valueOf(ObjectReader& details, const ForecastNumber& number)
{
    const Json* const value = details.find(number.name);
    if (value == nullptr || value->is_null())
        return std::nullopt;
    return numberOf(*value, details.path(number.name), details.faults(), number.limits);
}

/** Returns the velocity of a speed and a direction, or nullopt if one of them is missing. */
std::optional<Point> velocityOf(const std::optional<double>& speed_mps,
                                const std::optional<double>& direction_deg,
                                Point (*velocity_mps)(double, double))
{
    if (!speed_mps || !direction_deg)
        return std::nullopt;
    return velocity_mps(*speed_mps, *direction_deg);
}

void readDetails(ObjectReader& details, ForecastEntry& entry)
{
    // All values are read before they are combined, so that every fault is reported.
    const std::optional<double> wind_mps = valueOf(details, kWindSpeed);
    const std::optional<double> from_deg = valueOf(details, kWindFrom);
    const std::optional<double> current_mps = valueOf(details, kCurrentSpeed);
    const std::optional<double> to_deg = valueOf(details, kCurrentTo);
    entry.wind_mps = velocityOf(wind_mps, from_deg, windFrom_mps);
    entry.current_mps = velocityOf(current_mps, to_deg, currentTo_mps);
    entry.gust_mps = valueOf(details, kGust);
    entry.airTemperature_degC = valueOf(details, kAirTemperature);
    entry.dewPoint_degC = valueOf(details, kDewPoint);
    entry.fog_percent = valueOf(details, kFog);
}

/** Returns the instant of a member; adds a fault if it is missing or not a UTC time. */
std::optional<UtcTime> timeOf(ObjectReader& object, const char* member)
{
    const Json* const value = object.need(member);
    if (value == nullptr)
        return std::nullopt;
    const std::optional<UtcTime> time = parseUtc(textOf(value));
    if (!time)
        object.faults().add(object.path(member), {IssueId::NotUtcTime});
    return time;
}

/** Reads the object below the reader, empty if it is missing or after adding a fault. */
ObjectReader below(ObjectReader& object, const char* member)
{
    static const Json kEmpty = Json::object();
    const Json* const value = object.need(member);
    return {value == nullptr ? kEmpty : *value, object.path(member), object.faults()};
}

ForecastEntry readEntry(const Json& json, const std::string& path, Faults& faults)
{
    ObjectReader object(json, path, faults);
    ForecastEntry entry;
    entry.time = timeOf(object, "time").value_or(UtcTime());
    ObjectReader data = below(object, "data");
    if (data.isObject() && data.find("instant") == nullptr)
        return entry; // sums over a period only
    ObjectReader instant = below(data, "instant");
    ObjectReader details = below(instant, "details");
    readDetails(details, entry);
    return entry;
}

std::vector<ForecastEntry> readSeries(const Json& list, const std::string& path, ReadBudget& budget,
                                      Faults& faults)
{
    std::vector<ForecastEntry> series;
    for (std::size_t i = 0; i < list.size(); ++i) {
        budget.takeRow(sizeof(ForecastEntry));
        const std::string entry = entryPath(path, i);
        series.push_back(readEntry(list[i], entry, faults));
        if (i > 0 && series[i].time <= series[i - 1].time && !faults.has(entry + ".time") &&
            !faults.has(entryPath(path, i - 1) + ".time"))
            faults.add(entry + ".time", {IssueId::NotRising});
    }
    if (list.empty())
        faults.add(path, {IssueId::LeastEntries, {1}});
    return series;
}

/** Adds a fault for each number in another unit. */
void checkUnits(ObjectReader& meta)
{
    if (meta.find("units") == nullptr)
        return;
    ObjectReader units = below(meta, "units");
    for (const ForecastNumber& number : kForecastNumbers)
        if (const Json* const unit = units.find(number.name);
            unit != nullptr && textOf(unit) != number.unit)
            units.faults().add(units.path(number.name), {IssueId::NotFormat, {number.unit}});
}

LatLon readPlace(const Json& root, Faults& faults)
{
    const std::optional<LatLon> place =
        placeOf(memberOf(memberOf(&root, "geometry"), "coordinates"), AxisOrder::LongitudeFirst);
    if (!place)
        faults.add("geometry.coordinates", {IssueId::NotOnEarth});
    return place.value_or(LatLon{});
}

std::string sourceOf(const Forecast& forecast)
{
    return gives(forecast, ForecastQuantity::Wind) ? "MET Norway locationforecast"
                                                   : "MET Norway oceanforecast";
}

} // namespace

Forecast forecastFromJson(std::string_view text, const std::string& subject,
                          const std::stop_token& stop)
{
    ReadBudget budget(subject, text.size(), stop);
    ParsedJson parsed = parseJson(text, budget);
    const Json* const list = arrayOf(memberOf(&parsed.root, "properties"), "timeseries");
    if (list == nullptr)
        throw Error(ErrorCode::WrongFormat, subject,
                    {{Severity::Error, "properties.timeseries", {IssueId::Missing}}});
    Forecast forecast;
    forecast.place = readPlace(parsed.root, parsed.faults);
    ObjectReader properties(parsed.root.at("properties"), "properties", parsed.faults);
    ObjectReader meta = below(properties, "meta");
    if (meta.find("updated_at") != nullptr)
        forecast.issued = timeOf(meta, "updated_at");
    checkUnits(meta);
    forecast.series = readSeries(*list, properties.path("timeseries"), budget, parsed.faults);
    parsed.faults.throwIfAny(subject);
    if (!gives(forecast, ForecastQuantity::Wind) && !gives(forecast, ForecastQuantity::Current))
        throw Error(ErrorCode::InvalidInput, subject,
                    {{Severity::Error,
                      kWindSpeed.name,
                      {IssueId::MissingBoth, {FieldPath{kCurrentSpeed.name}}}}});
    forecast.source = sourceOf(forecast);
    return forecast;
}

Forecast loadForecast(const std::string& path)
{
    return forecastFromJson(readFile(path), path);
}

} // namespace berg
