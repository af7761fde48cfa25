#include "core/io/import/import_airspace.h"

#include "core/base/error.h"
#include "core/base/outline.h"
#include "core/base/stopped.h"
#include "core/io/import/area_outline.h"
#include "core/io/import/import_fields.h"
#include "core/io/import/import_formats.h"
#include "core/io/import/import_icebergs.h"
#include "core/io/import/json_members.h"
#include "core/io/text/byte_order_mark.h"
#include "core/io/text/json_writer.h"
#include "core/scenario/airspace.h"
#include "core/scenario/operation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <span>

namespace berg {

namespace {

/** Of the first of the properties that is a text. */
std::string textAt(const Json* properties, std::initializer_list<const char*> names,
                   std::size_t most)
{
    for (const char* name : names)
        if (std::string text = cleanText(textOf(memberOf(properties, name)), most); !text.empty())
            return text;
    return {};
}

/** Of "FL 65", or of `{"value": 65, "unit": 6}`. */
std::optional<double> limitOf(const Json& value)
{
    if (value.is_string())
        return airspaceHeight_m(value.get_ref<const std::string&>());
    if (value.is_number() && value.get<double>() == 0)
        return 0;
    const Json* number = memberOf(&value, "value");
    if (number == nullptr || !number->is_number())
        return std::nullopt;
    const Json* unit = memberOf(&value, "unit");
    const std::string text = jsonText(number->get<double>());
    const int code = unit != nullptr && unit->is_number_integer() ? unit->get<int>() : 1;
    return airspaceHeight_m(code == 0 ? text + " M" : code == 6 ? "FL " + text : text + " FT");
}

constexpr std::array kFloors = {"floor", "lower", "lowerLimit", "LOWER"};
constexpr std::array kCeilings = {"ceiling", "upper", "upperLimit", "UPPER"};

/** Whether a height is a number that nobody says is in metres or feet. */
bool lacksUnit(const Json* properties, const char* metres, std::span<const char* const> names)
{
    return !numberAt(properties, metres) && std::ranges::any_of(names, [&](const char* name) {
        const Json* value = memberOf(properties, name);
        const Json* number = memberOf(value, "value");
        return (value != nullptr && value->is_number() && value->get<double>() != 0) ||
               (number != nullptr && number->is_number() && !memberOf(value, "unit"));
    });
}

std::optional<double> heightAt(const Json* properties, const char* metres,
                               std::span<const char* const> names)
{
    if (const std::optional<double> height_m = numberAt(properties, metres))
        return height_m;
    for (const char* name : names)
        if (const Json* value = memberOf(properties, name))
            if (const std::optional<double> height_m = limitOf(*value))
                return height_m;
    return std::nullopt;
}

std::string timeAt(const Json* properties, const char* name)
{
    std::string text = textOf(memberOf(properties, name));
    return isUtcTime(text) ? text : std::string();
}

FileAirspace describedBy(const Json* properties)
{
    FileAirspace area{
        .name = textAt(properties, {"name", "NAME", "title"}, kLongestName),
        .kind = textAt(properties, {"class", "CLASS", "type", "TYPE", "kind"}, kLongestId),
        .rings = {},
        .fromUtc = timeAt(properties, "from_utc"),
        .untilUtc = timeAt(properties, "until_utc")};
    const double floor_m = heightAt(properties, "floor_m", kFloors).value_or(0);
    area.floor_m = std::clamp(floor_m, 0.0, kLargestLength_m);
    area.ceiling_m = heightAt(properties, "ceiling_m", kCeilings);
    if (area.kind == "airspace") // that of all of them in files of ours
        area.kind.clear();
    if (area.ceiling_m && !(*area.ceiling_m <= kLargestLength_m))
        area.ceiling_m.reset();
    return area;
}

/** One area for each polygon: those of a MultiPolygon may lie apart. Holes count as airspace. */
void addPolygons(const Json* geometry, const FileAirspace& area, bool isClear, AirspaceTable& table,
                 ReadBudget& budget)
{
    const Json* coordinates = arrayOf(geometry, "coordinates");
    const std::string type = textOf(memberOf(geometry, "type"));
    if (const Json* parts = arrayOf(geometry, "geometries"); parts && type == "GeometryCollection")
        for (const Json& part : *parts)
            addPolygons(&part, area, isClear, table, budget);
    if (type != "Polygon" && type != "MultiPolygon")
        return;
    const auto add = [&](const Json& rings) {
        std::optional<std::vector<LatLon>> ring;
        if (rings.is_array() && !rings.empty())
            ring = placesOf(&rings.front(), AxisOrder::LongitudeFirst);
        if (!ring || !isClear) {
            table.rejected.add({.line = area.line,
                                .fault = ring ? IssueId::AirspaceUnit : IssueId::AirspaceUnreadable,
                                .detail = cleanText(area.name, 60)});
            return;
        }
        budget.takeRow(sizeof area + area.name.size() + ring->size() * sizeof(LatLon));
        table.areas.push_back(area);
        table.areas.back().rings.push_back(std::move(*ring));
    };
    if (coordinates == nullptr)
        add(Json());
    else if (type == "Polygon")
        add(*coordinates);
    else
        std::ranges::for_each(*coordinates, add);
}

void addFeature(const Json& feature, std::size_t number, AirspaceTable& table, ReadBudget& budget)
{
    const Json* properties = memberOf(&feature, "properties");
    FileAirspace area = describedBy(properties);
    area.line = number;
    const bool isClear = !lacksUnit(properties, "floor_m", kFloors) &&
                         !lacksUnit(properties, "ceiling_m", kCeilings);
    addPolygons(memberOf(&feature, "geometry"), area, isClear, table, budget);
}

/** The corners in the plane; none: no outline that a scenario can hold. */
std::optional<std::vector<Point>> outlineOf(const FileAirspace& area, const LocalFrame& frame)
{
    constexpr std::size_t kMostVertices = 20'000; // more take long to thin out
    if (area.rings.front().size() > kMostVertices)
        return std::nullopt;
    std::vector<Point> corners_m = areaOutline(area.rings, frame);
    for (Point& corner_m : corners_m)
        corner_m = toCentimetre(corner_m);
    corners_m.erase(std::unique(corners_m.begin(), corners_m.end()), corners_m.end());
    const bool fits = corners_m.size() >= 3 && corners_m.size() <= kMostAreaCorners &&
                      std::ranges::all_of(corners_m, onPlane) && isSimplePolygon(corners_m);
    return fits ? std::optional(std::move(corners_m)) : std::nullopt;
}

/** All of its corners are beyond the plane, and it does not enclose the place. */
bool isFar(const std::vector<Point>& ring_m, const Point& place_m)
{
    return std::ranges::none_of(ring_m, onPlane) && !insidePolygon(ring_m, place_m);
}

/**
 * Polygons of a GeoJSON text, by whatever of these properties there are: `name`; `class`, `type`,
 * `kind`; `floor_m`, `ceiling_m`, or `floor`, `ceiling`, `lower`, `upper`, `lowerLimit`,
 * `upperLimit` with a height as in OpenAir or `{value, unit}` (0 m, 1 ft, 6 FL), which a number
 * alone is not; `from_utc`,
 * `until_utc`. Of an export of our own those of airspace.
 */
AirspaceTable readAirspaceGeoJson(std::string_view text, ReadBudget& budget)
{
    ParsedJson file = parseJson(text, budget);
    const Json* features = arrayOf(&file.root, "features");
    AirspaceTable table;
    table.rejected.place = "feature";
    if (features == nullptr) {
        addFeature(file.root, 1, table, budget);
        return table;
    }
    const bool isOwn = std::ranges::any_of(*features, [](const Json& feature) {
        return isOwnGeoJson(memberOf(&feature, "properties"));
    });
    std::size_t number = 0;
    for (const Json& feature : *features) {
        budget.goOn();
        ++number;
        if (!isOwn || kindOf(memberOf(&feature, "properties")) == "airspace")
            addFeature(feature, number, table, budget);
    }
    return table;
}

} // namespace

AirspaceResult importAirspace(const Scenario& base, std::string_view bytes,
                              const std::string& subject, const std::stop_token& stop)
{
    ReadBudget budget(subject, bytes.size(), stop);
    const std::string decoded = textOfBytes(bytes, subject);
    const std::string_view text =
        withoutByteOrderMark(decoded.empty() ? bytes : std::string_view(decoded));
    const bool isJson = trimmed(text).starts_with('{');
    if (!isJson && !isOpenAir(text))
        throw Error(ErrorCode::WrongFormat, subject, {IssueId::NotAirspace});
    const AirspaceTable table =
        isJson ? readAirspaceGeoJson(text, budget) : readOpenAir(text, budget);
    if (table.areas.empty() && table.rejected.count == 0)
        throw Error(ErrorCode::InvalidInput, subject, {IssueId::NoAirspace});

    AirspaceResult result{.scenario = base, .rejected = table.rejected};
    const LocalFrame frame(base.origin);
    const std::vector<Point> near_m = grownOutline(
        operationVolume(base, base.operation.value_or(Operation())).outlines_m[0], kNearAirspace_m);
    std::vector<AirspaceArea>& airspace = result.scenario.airspace;
    for (const FileAirspace& area : table.areas) {
        throwIfStopped(stop);
        std::vector<Point> ring_m;
        for (const LatLon& place : area.rings.front())
            ring_m.push_back(frame.toPlane(place));
        if (isFar(ring_m, near_m.front())) {
            ++result.far;
            continue;
        }
        std::optional<std::vector<Point>> corners_m = outlineOf(area, frame);
        if (!corners_m || (area.ceiling_m && *area.ceiling_m <= area.floor_m)) {
            result.rejected.add({.line = area.line,
                                 .fault = std::ranges::all_of(ring_m, onPlane)
                                              ? IssueId::AirspaceOutline
                                              : IssueId::TooFar,
                                 .detail = cleanText(area.name, 60)});
            continue;
        }
        if (!polygonsMeet(near_m, *corners_m)) {
            ++result.far;
            continue;
        }
        AirspaceArea added{.name = area.name,
                           .kind = area.kind,
                           .corners_m = std::move(*corners_m),
                           .floor_m = area.floor_m,
                           .ceiling_m = area.ceiling_m,
                           .fromUtc = area.fromUtc,
                           .untilUtc = area.untilUtc};
        if (endsTooEarly(added)) // neither is to be trusted: in force at all times
            added.fromUtc = added.untilUtc = {};
        if (std::ranges::find(airspace, added) != airspace.end())
            ++result.known;
        else if (airspace.size() >= kMostAirspaceAreas)
            ++result.tooMany;
        else {
            airspace.push_back(std::move(added));
            ++result.added;
        }
    }
    return result;
}

} // namespace berg
