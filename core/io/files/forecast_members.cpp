// Reads and writes the forecast of a scenario file.

#include "core/io/files/members.h"
#include "core/scenario/utc_time.h"

namespace berg {

namespace {

/** Reads a member that is a UTC time; nullopt if it is missing or after adding a fault. */
std::optional<UtcTime> readUtcMember(ObjectReader& object, const char* name, bool isNeeded)
{
    if ((isNeeded ? object.need(name) : object.find(name)) == nullptr)
        return std::nullopt;
    const std::string path = object.path(name);
    const std::string text = object.text(name);
    const std::optional<UtcTime> time = parseUtc(text);
    if (!time && !object.faults().has(path))
        object.faults().add(path, {IssueId::NotUtcTime});
    return time;
}

ForecastEntry readForecastEntry(const Json& value, const std::string& path, Faults& faults)
{
    ObjectReader object(value, path, faults);
    ForecastEntry entry;
    entry.time = readUtcMember(object, "time", true).value_or(UtcTime());
    readFields(object, fieldsOf<ForecastEntry>(), entry);
    entry.extraJson = object.unknown();
    return entry;
}

std::string forecastEntryText(const ForecastEntry& entry)
{
    JsonObject object;
    object.add("time", utcText(entry.time, 0));
    writeFields(object, fieldsOf<ForecastEntry>(), entry);
    object.addExtra(entry.extraJson);
    return object.inLine();
}

Forecast readForecastPlace(const Json& value, const std::string& path, Faults& faults)
{
    ObjectReader object(value, path, faults);
    Forecast place;
    readFields(object, fieldsOf<Forecast>(), place);
    const Json* const series = object.neededArray("series");
    makeRoom(place.series, series, faults);
    for (std::size_t i = 0; series != nullptr && i < series->size(); ++i)
        place.series.push_back(
            readForecastEntry((*series)[i], entryPath(object.path("series"), i), faults));
    place.extraJson = object.unknown();
    return place;
}

std::string forecastPlaceText(const Forecast& place)
{
    JsonObject object;
    writeFields(object, fieldsOf<Forecast>(), place);
    object.addText("series", jsonLines(textsOf(place.series, forecastEntryText), 3));
    object.addExtra(place.extraJson);
    return object.inLine();
}

/** Returns the number of entries at all places of a file, as far as they are lists. */
std::size_t entriesIn(const Json& places)
{
    std::size_t count = 0;
    for (const Json& place : places)
        if (place.is_object())
            if (const auto series = place.find("series"); series != place.end())
                count += series->is_array() ? series->size() : 0;
    return count;
}

} // namespace

template <>
ForecastField readObject(const Json& value, const std::string& path, Faults& faults)
{
    ObjectReader object(value, path, faults);
    ForecastField field;
    const std::string source = object.text("source");
    const std::optional<ForecastTime> issued = readUtcMember(object, "issued", false);
    constexpr WholeLimits kColumns{.low = 1, .high = kMostForecastPlaces};
    field.columns = static_cast<std::size_t>(object.whole("columns", 1, kColumns));
    const Json* const places = object.neededArray("places");
    const std::string list = object.path("places");
    if (places != nullptr && (places->empty() || places->size() > kMostForecastPlaces))
        faults.add(list, {IssueId::ForecastPlaces,
                          {countOf(kMostForecastPlaces), countOf(places->size())}});
    else if (places != nullptr && entriesIn(*places) > kMostForecastEntries)
        faults.add(list, {IssueId::ForecastEntries,
                          {countOf(kMostForecastEntries), countOf(entriesIn(*places))}});
    else
        for (std::size_t i = 0; places != nullptr && i < places->size(); ++i) {
            field.places.push_back(readForecastPlace((*places)[i], entryPath(list, i), faults));
            field.places.back().source = source;
            field.places.back().issued = issued;
        }
    field.extraJson = object.unknown();
    return field;
}

template <>
std::string objectText(const ForecastField& object)
{
    JsonObject json;
    if (!object.places.empty() && !object.places.front().source.empty())
        json.add("source", object.places.front().source);
    if (!object.places.empty() && object.places.front().issued)
        json.add("issued", utcText(*object.places.front().issued, 0));
    if (object.columns != 1)
        json.add("columns", static_cast<std::int64_t>(object.columns));
    json.addText("places", jsonLines(textsOf(object.places, forecastPlaceText), 2));
    json.addExtra(object.extraJson);
    return json.inLine();
}

} // namespace berg
