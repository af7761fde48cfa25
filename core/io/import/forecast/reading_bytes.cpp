#include "core/io/import/forecast/reading_bytes.h"

#include "core/io/text/byte_stream.h"

namespace berg {

namespace {

void addMaybe(ByteWriter& bytes, const std::optional<double>& value)
{
    bytes.add(value.has_value());
    if (value)
        bytes.add(*value);
}

void addMaybe(ByteWriter& bytes, const std::optional<Point>& value)
{
    bytes.add(value.has_value());
    if (value) {
        bytes.add(value->x());
        bytes.add(value->y());
    }
}

std::optional<double> takeNumber(ByteReader& bytes)
{
    return bytes.take<bool>() ? std::optional(bytes.take<double>()) : std::nullopt;
}

std::optional<Point> takePoint(ByteReader& bytes)
{
    if (!bytes.take<bool>())
        return std::nullopt;
    const auto x = bytes.take<double>();
    const auto y = bytes.take<double>();
    return Point(x, y);
}

ForecastTime takeTime(ByteReader& bytes)
{
    return ForecastTime(ForecastTime::duration(bytes.take<ForecastTime::rep>()));
}

void addEntry(ByteWriter& bytes, const ForecastEntry& entry)
{
    bytes.add(entry.time.time_since_epoch().count());
    addMaybe(bytes, entry.wind_mps);
    addMaybe(bytes, entry.gust_mps);
    addMaybe(bytes, entry.airTemperature_degC);
    addMaybe(bytes, entry.dewPoint_degC);
    addMaybe(bytes, entry.fog_percent);
    addMaybe(bytes, entry.visibility_m);
    addMaybe(bytes, entry.ceiling_m);
    addMaybe(bytes, entry.current_mps);
}

ForecastEntry takeEntry(ByteReader& bytes)
{
    ForecastEntry entry;
    entry.time = takeTime(bytes);
    entry.wind_mps = takePoint(bytes);
    entry.gust_mps = takeNumber(bytes);
    entry.airTemperature_degC = takeNumber(bytes);
    entry.dewPoint_degC = takeNumber(bytes);
    entry.fog_percent = takeNumber(bytes);
    entry.visibility_m = takeNumber(bytes);
    entry.ceiling_m = takeNumber(bytes);
    entry.current_mps = takePoint(bytes);
    return entry;
}

} // namespace

std::string bytesOf(const ForecastReading& reading)
{
    ByteWriter bytes;
    bytes.add(reading.format);
    bytes.add(reading.thinning);
    bytes.add(reading.field.columns);
    bytes.add(reading.field.places.size());
    for (const Forecast& forecast : reading.field.places) {
        bytes.add(forecast.source);
        bytes.add(forecast.issued.has_value());
        bytes.add(forecast.issued.value_or(ForecastTime()).time_since_epoch().count());
        bytes.add(forecast.place.latitude_deg);
        bytes.add(forecast.place.longitude_deg);
        addMaybe(bytes, forecast.depth_m);
        bytes.add(forecast.series.size());
        for (const ForecastEntry& entry : forecast.series)
            addEntry(bytes, entry);
    }
    return bytes.done();
}

ForecastReading readingFrom(std::string_view text)
{
    ByteReader bytes(text);
    ForecastReading reading;
    reading.format = bytes.takeText();
    reading.thinning = bytes.take<std::size_t>();
    reading.field.columns = bytes.take<std::size_t>();
    reading.field.places.resize(bytes.take<std::size_t>());
    for (Forecast& forecast : reading.field.places) {
        forecast.source = bytes.takeText();
        const bool isIssued = bytes.take<bool>();
        const ForecastTime issued = takeTime(bytes);
        if (isIssued)
            forecast.issued = issued;
        forecast.place.latitude_deg = bytes.take<double>();
        forecast.place.longitude_deg = bytes.take<double>();
        forecast.depth_m = takeNumber(bytes);
        forecast.series.resize(bytes.take<std::size_t>());
        for (ForecastEntry& entry : forecast.series)
            entry = takeEntry(bytes);
    }
    return reading;
}

} // namespace berg
