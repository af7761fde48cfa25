#include "core/io/import/fields/geojson_places.h"

#include "core/base/error.h"
#include "core/base/number_text.h"
#include "core/io/text/byte_order_mark.h"
#include "core/io/text/json_writer.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace berg {

namespace {

constexpr double kLargestDegrees = 360; ///< largest value of a longitude
constexpr double kSurelyMetres = 1000;

/** Name or code of a `crs`, as files before RFC 7946 have it. */
std::string systemName(const Json& crs)
{
    if (crs.is_string())
        return crs.get<std::string>();
    const Json* properties = memberOf(&crs, "properties");
    for (const char* member : {"name", "href", "code"}) {
        const Json* value = memberOf(properties, member);
        if (value != nullptr && value->is_string())
            return value->get<std::string>();
        if (value != nullptr && value->is_number_integer())
            return "EPSG:" + std::to_string(value->get<std::int64_t>());
    }
    return typeOf(&crs);
}

/**
 * Returns the code of "EPSG:4326", "urn:ogc:def:crs:EPSG::4326" or ".../EPSG/0/4326", or nullopt
 * for any other name.
 */
std::optional<int> epsgOf(const std::string& name)
{
    const std::string plain = plainName(name);
    if (plain.find("epsg") == std::string::npos)
        return std::nullopt;
    const std::string_view code = std::string_view(name).substr(name.find_last_of(":/") + 1);
    int epsg = 0;
    const auto [end, error] = std::from_chars(code.data(), code.data() + code.size(), epsg);
    return error == std::errc() && end == code.data() + code.size() ? std::optional(epsg)
                                                                    : std::nullopt;
}

/** Whether this is a name by OGC of longitude and latitude of WGS 84. */
bool isWgs84(const std::string& name)
{
    const std::string plain = plainName(name);
    return plain.ends_with("crs84") || plain.ends_with("crs84h") || plain == "wgs84" ||
           plain == "wgs1984";
}

void addParts(const Json* geometry, GeometryParts& parts)
{
    constexpr std::string_view kMulti = "Multi";
    const std::string type = typeOf(geometry);
    if (type == "GeometryCollection") {
        if (const Json* geometries = arrayOf(geometry, "geometries"))
            for (const Json& one : *geometries)
                addParts(&one, parts);
        return;
    }
    const Json* coordinates = arrayOf(geometry, "coordinates");
    const bool isMulti = type.starts_with(kMulti);
    const std::string kind = type.substr(isMulti ? kMulti.size() : 0);
    std::vector<const Json*>* const list = kind == "Point"        ? &parts.points
                                           : kind == "Polygon"    ? &parts.polygons
                                           : kind == "LineString" ? &parts.lines
                                                                  : nullptr;
    if (coordinates == nullptr) {
        ++parts.broken;
        if (kind == "Polygon")
            ++parts.brokenAreas;
    } else if (list == nullptr) {
        parts.other = type.empty() ? "?" : type;
    } else if (!isMulti) {
        list->push_back(coordinates);
    } else {
        for (const Json& one : *coordinates)
            list->push_back(&one);
    }
}

/** Whether a line of a text is a complete object, so that another may follow it. */
bool isWholeObject(std::string_view line)
{
    std::size_t depth = 0;
    bool isInText = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const char c = line[i];
        if (isInText && c == '\\')
            ++i;
        else if (c == '"')
            isInText = !isInText;
        else if (!isInText && (c == '{' || c == '['))
            ++depth;
        else if (!isInText && (c == '}' || c == ']') && (depth == 0 || --depth == 0))
            return i + 1 == line.size();
    }
    return false;
}

std::vector<std::string_view> splitAt(char separator, std::string_view text)
{
    std::vector<std::string_view> texts;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find(separator, at), text.size());
        if (const std::string_view one = trimmed(text.substr(at, end - at)); !one.empty())
            texts.push_back(one);
        at = end + 1;
    }
    return texts;
}

} // namespace

std::string typeOf(const Json* object)
{
    return textOf(memberOf(object, "type"));
}

GeoJsonSystem systemOf(const Json& object, const GeoJsonSystem& outer, const std::string& subject)
{
    const Json* crs = memberOf(&object, "crs");
    if (crs == nullptr || crs->is_null())
        return outer;
    const std::string name = systemName(*crs);
    const std::optional<int> epsg = epsgOf(name);
    if (isWgs84(name) || (epsg && isGeographic(*epsg)))
        return {.name = name, .unprojected = std::nullopt};
    std::optional<Unprojection> unprojected = epsg ? unprojectionOf(*epsg) : std::nullopt;
    if (!unprojected)
        throw Error(ErrorCode::InvalidInput, subject,
                    {{Severity::Error, "crs", {IssueId::CrsUnknown, {cleanText(name, 100)}}}});
    return {.name = "EPSG:" + std::to_string(*epsg), .unprojected = std::move(unprojected)};
}

FilePlace filePlace(const Point& position, const GeoJsonSystem& system)
{
    LatLon place{.latitude_deg = position.y(), .longitude_deg = position.x()};
    if (system.unprojected) {
        if (std::abs(position.x()) <= kLargestDegrees && std::abs(position.y()) <= 90)
            return {.fault = IssueId::PlaceInDegrees, .detail = system.name};
        place = (*system.unprojected)(position);
    } else if (position.cwiseAbs().maxCoeff() > kSurelyMetres) {
        return {.fault = IssueId::PlaceInMetres,
                .detail = numberText(position.x()) + ' ' + numberText(position.y())};
    }
    return {.longitude = jsonText(place.longitude_deg), .latitude = jsonText(place.latitude_deg)};
}

std::optional<Point> positionOf(const Json& position)
{
    if (!position.is_array() || position.size() < 2 || !position[0].is_number() ||
        !position[1].is_number())
        return std::nullopt;
    return Point(position[0].get<double>(), position[1].get<double>());
}

GeometryParts geometryParts(const Json* geometry)
{
    GeometryParts parts;
    addParts(geometry, parts);
    return parts;
}

AreaRings ringsOf(const Json& polygon)
{
    AreaRings rings;
    for (const Json& corners : listOf(polygon)) {
        AreaRing& ring = rings.emplace_back();
        for (const Json& corner : listOf(corners)) {
            const std::optional<Point> position = positionOf(corner);
            if (!position)
                return {};
            ring.push_back(*position);
        }
    }
    return rings;
}

bool hasPlaces(const Json* geometry)
{
    const std::string type = typeOf(geometry);
    if (type != "GeometryCollection")
        return type.ends_with("Point") || type.ends_with("Polygon");
    const Json* geometries = arrayOf(geometry, "geometries");
    return geometries != nullptr && std::any_of(geometries->begin(), geometries->end(),
                                                [](const Json& one) { return hasPlaces(&one); });
}

std::vector<std::string_view> jsonTextsOf(std::string_view text)
{
    constexpr char kRecord = '\x1E'; // RFC 8142
    const std::string_view whole = trimmed(withoutByteOrderMark(text));
    if (whole.starts_with(kRecord))
        return splitAt(kRecord, whole);
    const std::size_t end = whole.find('\n');
    if (end != std::string_view::npos && isWholeObject(trimmed(whole.substr(0, end))))
        return splitAt('\n', whole);
    return {text};
}

} // namespace berg
