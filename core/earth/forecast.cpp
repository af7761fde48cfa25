#include "core/earth/forecast.h"

#include "core/base/error.h"

#include <algorithm>
#include <map>

namespace berg {

namespace {

/** Calls `use` with the member of the quantity in each of the entries, all of one type. */
template <class Use, class... Entries>
auto withMember(ForecastQuantity quantity, const Use& use, Entries&... entries)
{
    switch (quantity) {
    case ForecastQuantity::Wind:
        return use(entries.wind_mps...);
    case ForecastQuantity::Gust:
        return use(entries.gust_mps...);
    case ForecastQuantity::AirTemperature:
        return use(entries.airTemperature_degC...);
    case ForecastQuantity::DewPoint:
        return use(entries.dewPoint_degC...);
    case ForecastQuantity::Fog:
        return use(entries.fog_percent...);
    case ForecastQuantity::Visibility:
        return use(entries.visibility_m...);
    case ForecastQuantity::Ceiling:
        return use(entries.ceiling_m...);
    case ForecastQuantity::Current:
        break;
    }
    return use(entries.current_mps...);
}

/** Sets the quantity of `to` to that of `from`. */
void copy(ForecastQuantity quantity, const ForecastEntry& from, ForecastEntry& to)
{
    withMember(
        quantity, [](const auto& source, auto& target) { target = source; }, from, to);
}

/** Sets the quantity of `entry`, linear between two entries that give it. */
void interpolate(ForecastQuantity quantity, const ForecastEntry& before, const ForecastEntry& after,
                 ForecastEntry& entry)
{
    using Seconds = std::chrono::duration<double>;
    const double share = Seconds(entry.time - before.time) / Seconds(after.time - before.time);
    withMember(
        quantity,
        [share](const auto& a, const auto& b, auto& value) { value = *a + share * (*b - *a); },
        before, after, entry);
}

/** Sets the quantity of `entry` from its neighbours; `next` is the first entry not before it. */
void setFromNeighbours(const Forecast& forecast, std::size_t next, ForecastQuantity quantity,
                       ForecastEntry& entry)
{
    const std::vector<ForecastEntry>& series = forecast.series;
    const auto far = [&](std::size_t i) {
        return std::chrono::abs(series[i].time - entry.time) > kLongestForecastStep;
    };
    std::size_t after = next;
    while (after < series.size() && !gives(series[after], quantity) && !far(after))
        ++after;
    if (after == series.size() || !gives(series[after], quantity))
        return;
    if (series[after].time == entry.time) {
        copy(quantity, series[after], entry);
        return;
    }
    std::size_t before = next;
    while (before > 0 && !gives(series[before - 1], quantity) && !far(before - 1))
        --before;
    if (before == 0 || !gives(series[before - 1], quantity) ||
        series[after].time - series[before - 1].time > kLongestForecastStep)
        return;
    interpolate(quantity, series[before - 1], series[after], entry);
}

/** Returns the forecast that gives the quantity and was issued last, or null without one. */
const Forecast* newestWith(std::span<const Forecast> forecasts, ForecastQuantity quantity)
{
    const Forecast* newest = nullptr;
    for (const Forecast& forecast : forecasts)
        if (gives(forecast, quantity) && (newest == nullptr || forecast.issued > newest->issued))
            newest = &forecast;
    return newest;
}

} // namespace

std::string_view nameOf(ForecastQuantity quantity)
{
    switch (quantity) {
    case ForecastQuantity::Wind:
        return "wind";
    case ForecastQuantity::Gust:
        return "gust";
    case ForecastQuantity::AirTemperature:
        return "air temperature";
    case ForecastQuantity::DewPoint:
        return "dew point";
    case ForecastQuantity::Fog:
        return "fog";
    case ForecastQuantity::Visibility:
        return "visibility";
    case ForecastQuantity::Ceiling:
        return "ceiling";
    case ForecastQuantity::Current:
        break;
    }
    return "current";
}

bool gives(const ForecastEntry& entry, ForecastQuantity quantity)
{
    return withMember(
        quantity, [](const auto& value) { return value.has_value(); }, entry);
}

bool gives(const Forecast& forecast, ForecastQuantity quantity)
{
    return std::ranges::any_of(
        forecast.series, [quantity](const ForecastEntry& entry) { return gives(entry, quantity); });
}

ForecastEntry entryAt(const Forecast& forecast, ForecastTime time)
{
    const auto next = std::ranges::lower_bound(forecast.series, time, {}, &ForecastEntry::time);
    ForecastEntry entry{.time = time};
    for (const ForecastQuantity quantity : kForecastQuantities)
        setFromNeighbours(forecast, static_cast<std::size_t>(next - forecast.series.begin()),
                          quantity, entry);
    return entry;
}

std::optional<double> ageAt_h(const Forecast& forecast, ForecastTime time)
{
    using Hours = std::chrono::duration<double, std::ratio<3600>>;
    return forecast.issued ? std::optional(Hours(time - *forecast.issued).count()) : std::nullopt;
}

std::vector<ForecastGap> gapsOf(const Forecast& forecast, std::optional<ForecastTime> since,
                                std::optional<ForecastTime> until)
{
    const auto isWithin = [&](ForecastTime from, ForecastTime to) {
        return (!since || to > *since) && (!until || from < *until);
    };
    std::vector<ForecastGap> gaps;
    for (const ForecastQuantity quantity : kForecastQuantities) {
        const ForecastEntry* last = nullptr;
        for (const ForecastEntry& entry : forecast.series) {
            if (!gives(entry, quantity))
                continue;
            if (last != nullptr && entry.time - last->time > kLongestForecastStep &&
                isWithin(last->time, entry.time))
                gaps.push_back({.quantity = quantity, .from = last->time, .to = entry.time});
            last = &entry;
        }
    }
    return gaps;
}

Forecast cut(const Forecast& forecast, std::optional<ForecastTime> since,
             std::optional<ForecastTime> until)
{
    Forecast part = forecast;
    part.series.clear();
    if (forecast.series.empty())
        return part;
    const ForecastTime first =
        std::max(since.value_or(ForecastTime::min()), forecast.series.front().time);
    const ForecastTime last =
        std::min(until.value_or(ForecastTime::max()), forecast.series.back().time);
    if (first > last)
        return part;
    part.series.push_back(entryAt(forecast, first));
    for (const ForecastEntry& entry : forecast.series)
        if (entry.time > first && entry.time < last)
            part.series.push_back(entryAt(forecast, entry.time));
    if (last > first)
        part.series.push_back(entryAt(forecast, last));
    return part;
}

Forecast combined(std::span<const Forecast> forecasts)
{
    require(!forecasts.empty(), "combined: no forecast");
    Forecast all{.place = forecasts.front().place};
    std::map<ForecastTime, ForecastEntry> entries;
    std::vector<const Forecast*> used;
    for (const ForecastQuantity quantity : kForecastQuantities) {
        const Forecast* const newest = newestWith(forecasts, quantity);
        if (newest == nullptr)
            continue;
        if (std::ranges::find(used, newest) == used.end())
            used.push_back(newest);
        for (const ForecastEntry& entry : newest->series)
            if (gives(entry, quantity))
                copy(quantity, entry, entries[entry.time]);
    }
    for (const Forecast* const forecast : used) {
        if (all.source.find(forecast->source) == std::string::npos)
            all.source += (all.source.empty() ? "" : ", ") + forecast->source;
        if (forecast->issued && (!all.issued || *forecast->issued < *all.issued))
            all.issued = forecast->issued;
    }
    for (auto& [time, entry] : entries) {
        entry.time = time;
        all.series.push_back(entry);
    }
    return all;
}

} // namespace berg
