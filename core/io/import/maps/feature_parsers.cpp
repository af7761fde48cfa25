#include "core/io/import/maps/feature_parsers.h"

#include "core/io/import/fields/import_fields.h"
#include "core/io/import/fields/import_xml.h"
#include "core/io/import/maps/map_readers.h"
#include "core/io/text/zip_file.h"
#include "core/scenario/text_checks.h"

#include <algorithm>
#include <cctype>
#include <cmath>

namespace berg {

std::string textOfMap(std::string_view bytes, ReadBudget& budget)
{
    if (!isZip(bytes))
        return textOfXml(bytes, budget.subject());
    std::string inside = unzipped(bytes, ".kml", budget);
    std::string decoded = textOfXml(inside, budget.subject());
    return decoded.empty() ? inside : decoded;
}

std::optional<MapFormat> mapFormatOf(std::string_view text)
{
    if (isKml(text))
        return MapFormat::Kml;
    if (isUtf8(text) && isCzml(text))
        return MapFormat::Czml;
    return isUtf8(text) && isGeoJson(text) ? std::optional(MapFormat::GeoJson) : std::nullopt;
}

std::string_view placeIn(MapFormat format)
{
    return format == MapFormat::GeoJson ? "feature" : format == MapFormat::Czml ? "packet" : "line";
}

KmlStyles readMapFeatures(std::string_view text, MapFormat format, ReadBudget& budget,
                          const std::function<void(const FileFeature&)>& use)
{
    if (format == MapFormat::Kml)
        return readKmlFeatures(text, budget, {.feature = use});
    if (format == MapFormat::Czml)
        readCzmlFeatures(text, budget, use);
    else
        readGeoJsonFeatures(text, CrsUse::Ignored, budget, use);
    return {};
}

const Json* chartProperty(const Json* properties, std::string_view name)
{
    if (properties == nullptr || !properties->is_object())
        return nullptr;
    for (const auto& [key, value] : properties->items())
        if (std::ranges::equal(key, name, [](unsigned char a, unsigned char b) {
                return std::tolower(a) == std::tolower(b);
            }))
            return &value;
    return nullptr;
}

std::optional<int> chartCode(const Json* properties, std::string_view name)
{
    constexpr int kUnknown = 99;
    const std::optional<double> number = numberIn(chartProperty(properties, name));
    const bool isCode =
        number && *number >= 0 && *number < kUnknown && *number == std::floor(*number);
    return isCode ? std::optional(static_cast<int>(*number)) : std::nullopt;
}

} // namespace berg
