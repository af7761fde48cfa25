#include "core/io/import/airspace/import_airspace.h"

#include "core/base/error.h"
#include "core/base/stopped.h"
#include "core/geometry/covering_outline.h"
#include "core/geometry/outline.h"
#include "core/io/import/fields/area_outline.h"
#include "core/io/import/fields/import_fields.h"
#include "core/io/import/maps/feature_parsers.h"
#include "core/io/import/scenario/import_icebergs.h"
#include "core/io/text/byte_order_mark.h"
#include "core/io/text/json_writer.h"
#include "core/permit/airspace.h"
#include "core/permit/operation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <span>

namespace berg {

namespace {

/** Returns the first of the properties that is a text; empty if none is. */
std::string textAt(const Json* properties, std::initializer_list<const char*> names,
                   std::size_t most)
{
    for (const char* name : names)
        if (std::string text = cleanText(textOf(memberOf(properties, name)), most); !text.empty())
            return text;
    return {};
}

/** Reads a height as "FL 65" or as `{"value": 65, "unit": 6}`. */
std::optional<double> limitOf(const Json& value, HeightLimit limit)
{
    if (value.is_string())
        return airspaceHeight_m(value.get_ref<const std::string&>(), limit);
    if (value.is_number() && value.get<double>() == 0)
        return 0;
    const Json* number = memberOf(&value, "value");
    if (number == nullptr || !number->is_number())
        return std::nullopt;
    const Json* unit = memberOf(&value, "unit");
    const std::string text = jsonText(number->get<double>());
    const int code = unit != nullptr && unit->is_number_integer() ? unit->get<int>() : 1;
    return airspaceHeight_m(code == 0   ? text + " M"
                            : code == 6 ? "FL " + text
                                        : text + " FT",
                            limit);
}

constexpr std::array kFloors = {"floor", "lower", "lowerLimit", "LOWER"};
constexpr std::array kCeilings = {"ceiling", "upper", "upperLimit", "UPPER"};

/**
 * Whether a height is a number without a unit, so that it may be in metres or feet. In formats
 * without types a text may be such a number.
 */
bool lacksUnit(const Json* properties, const char* metres, std::span<const char* const> names,
               bool hasTypes)
{
    const auto isBare = [&](const char* name) {
        const Json* const value = memberOf(properties, name);
        const Json* const number = memberOf(value, "value");
        const bool isNumber = value != nullptr && (value->is_number() || !hasTypes);
        return (isNumber && numberIn(value).value_or(0) != 0) ||
               (number != nullptr && number->is_number() && !memberOf(value, "unit"));
    };
    return !numberIn(memberOf(properties, metres)) && std::ranges::any_of(names, isBare);
}

std::optional<double> heightAt(const Json* properties, const char* metres,
                               std::span<const char* const> names, HeightLimit limit)
{
    if (const std::optional<double> height_m = numberIn(memberOf(properties, metres)))
        return height_m;
    for (const char* name : names)
        if (const Json* value = memberOf(properties, name))
            if (const std::optional<double> height_m = limitOf(*value, limit))
                return height_m;
    return std::nullopt;
}

std::string timeAt(const Json* properties, const char* name)
{
    std::string text = textOf(memberOf(properties, name));
    return isUtcTime(text) ? text : std::string();
}

FileAirspace describedBy(const FileFeature& feature)
{
    const Json* const properties = feature.properties;
    FileAirspace area{
        .name = textAt(properties, {"name", "NAME", "title"}, kLongestName),
        .kind = textAt(properties, {"class", "CLASS", "type", "TYPE", "kind"}, kLongestId),
        .rings = {},
        .fromUtc = timeAt(properties, "from_utc"),
        .untilUtc = timeAt(properties, "until_utc"),
        .line = feature.line};
    if (area.name.empty() && memberOf(properties, "name") == nullptr) // else it says there is none
        area.name = cleanText(feature.name, kLongestName);
    const double floor_m = heightAt(properties, "floor_m", kFloors, HeightLimit::Floor).value_or(0);
    area.floor_m = std::clamp(floor_m, 0.0, kLargestLength_m);
    area.ceiling_m = heightAt(properties, "ceiling_m", kCeilings, HeightLimit::Ceiling);
    if (area.kind == "airspace") // the value for all areas in Bergwatch files
        area.kind.clear();
    if (area.ceiling_m && !(*area.ceiling_m <= kLargestLength_m))
        area.ceiling_m.reset();
    return area;
}

/**
 * Adds one area for each polygon, because those of a MultiPolygon may be apart. Holes count as
 * airspace.
 */
void addFeature(const FileFeature& feature, bool hasTypes, AirspaceTable& table, ReadBudget& budget)
{
    if (!feature.broken.empty())
        table.rejected.add({.line = feature.line,
                            .fault = IssueId::FeatureBroken,
                            .detail = cleanText(feature.broken, 60)});
    const FileAirspace area = describedBy(feature);
    const bool isClear = !lacksUnit(feature.properties, "floor_m", kFloors, hasTypes) &&
                         !lacksUnit(feature.properties, "ceiling_m", kCeilings, hasTypes);
    for (const FileShape& shape : feature.geometry().shapes) {
        if (shape.kind != ShapeKind::Area)
            continue;
        std::optional<std::vector<LatLon>> ring = placesOf(shape, 0);
        if (!ring || !isClear) {
            table.rejected.add({.line = feature.line,
                                .fault = ring ? IssueId::AirspaceUnit : IssueId::AirspaceUnreadable,
                                .detail = cleanText(area.name, 60)});
            continue;
        }
        budget.takeRow(sizeof area + area.name.size() + ring->size() * sizeof(LatLon));
        table.areas.push_back(area);
        table.areas.back().rings.push_back(std::move(*ring));
    }
}

/** Returns the corners in the plane, without those that were inserted for a map if `isOfMap`. */
std::vector<Point> ringOf(const FileAirspace& area, const LocalFrame& frame, bool isOfMap)
{
    constexpr std::size_t kMostVertices = 20'000; // thinning more takes long
    const bool isLong = area.rings.front().size() > kMostVertices;
    std::vector<Point> ring_m;
    if (isOfMap && !isLong)
        ring_m = areaOutline(area.rings, frame);
    if (ring_m.size() >= 3 && ring_m.size() <= kMostAreaCorners)
        return ring_m;
    ring_m.clear();
    for (const LatLon& place : area.rings.front())
        ring_m.push_back(frame.toPlane(place));
    return isLong ? convexHull(std::move(ring_m)) : ring_m;
}

/**
 * Returns the outline in a form that a scenario can hold, or nullopt if it encloses nothing or is
 * off the plane.
 */
std::optional<CoveringOutline> outlineOf(const FileAirspace& area, const LocalFrame& frame,
                                         bool isOfMap)
{
    std::vector<Point> ring_m = ringOf(area, frame, isOfMap);
    if (!std::ranges::all_of(ring_m, onPlane))
        return std::nullopt;
    for (Point& corner_m : ring_m)
        corner_m = toCentimetre(corner_m);
    std::optional<CoveringOutline> outline = coveringOutline(ring_m, kMostAreaCorners);
    if (!outline)
        return std::nullopt;
    outline->wasThinned =
        outline->wasThinned || (!isOfMap && ring_m.size() < area.rings.front().size());
    for (Point& corner_m : outline->corners_m)
        corner_m = toCentimetre(corner_m);
    const bool fits =
        std::ranges::all_of(outline->corners_m, onPlane) && isSimplePolygon(outline->corners_m);
    if (!fits)
        outline->corners_m = convexHull(std::move(outline->corners_m));
    return outline;
}

/** Whether all corners are beyond the plane and the area does not contain the place. */
bool isFar(const std::vector<Point>& ring_m, const Point& place_m)
{
    return std::ranges::none_of(ring_m, onPlane) && !insidePolygon(ring_m, place_m);
}

/**
 * Reads the areas of a map with these properties, if present: `name`; `class`, `type`, `kind`;
 * `floor_m`, `ceiling_m`, or `floor`, `ceiling`, `lower`, `upper`, `lowerLimit`, `upperLimit` with
 * a height as in OpenAir or `{value, unit}` (0 m, 1 ft, 6 FL), but not a plain number; `from_utc`,
 * `until_utc`. Of a Bergwatch export only airspace is read.
 */
AirspaceTable readMapAirspace(std::string_view text, MapFormat format, ReadBudget& budget)
{
    AirspaceTable table;
    table.rejected.place = placeIn(format);
    readMapFeatures(text, format, budget, [&](const FileFeature& feature) {
        if (!feature.isOwn || feature.kind == "airspace")
            addFeature(feature, format != MapFormat::Kml, table, budget);
    });
    return table;
}

/** Adds the areas of a file to a scenario. */
class AirspaceImport
{
public:
    AirspaceImport(const Scenario& base, const AirspaceTable& table, bool isOfMap)
        : m_result{.scenario = base, .rejected = table.rejected, .noted = table.noted}
        , m_frame(base.origin)
        , m_isOfMap(isOfMap)
        , m_near_m(grownOutline(
              operationVolume(base, base.operation.value_or(Operation())).outlines_m[0],
              kNearAirspace_m))
    {
        m_result.notNeeded.place = m_result.noted.place = table.rejected.place;
    }

    void add(const FileAirspace& area)
    {
        std::vector<Point> ring_m;
        for (const LatLon& place : area.rings.front())
            ring_m.push_back(m_frame.toPlane(place));
        if (isFar(ring_m, m_near_m.front())) {
            leaveOut(area, IssueId::AirspaceFar);
            return;
        }
        const bool isThick = !area.ceiling_m || *area.ceiling_m > area.floor_m;
        const std::optional<CoveringOutline> outline = outlineOf(area, m_frame, m_isOfMap);
        if (!outline || !isThick) {
            const bool isHere = std::ranges::all_of(ring_m, onPlane);
            list(m_result.rejected, area,
                 !isHere    ? IssueId::TooFar
                 : !isThick ? IssueId::AirspaceThin
                            : IssueId::AirspaceOutline);
            return;
        }
        if (!polygonsMeet(m_near_m, outline->corners_m)) {
            leaveOut(area, IssueId::AirspaceFar);
            return;
        }
        if (take(area, outline->corners_m) && (outline->wasCrossing || outline->wasThinned))
            list(m_result.noted, area,
                 outline->wasCrossing ? IssueId::AirspaceCrossing : IssueId::AirspaceCorners);
    }

    AirspaceResult result() { return std::move(m_result); }

private:
    static void list(Rejections& rows, const FileAirspace& area, IssueId fault)
    {
        rows.add({.line = area.line, .fault = fault, .detail = cleanText(area.name, 60)});
    }

    void leaveOut(const FileAirspace& area, IssueId fault)
    {
        ++(fault == IssueId::AirspaceFar ? m_result.far : m_result.tooMany);
        list(m_result.notNeeded, area, fault);
    }

    /** Adds the area. Returns false if the scenario has it already or has no room for it. */
    bool take(const FileAirspace& area, const std::vector<Point>& corners_m)
    {
        AirspaceArea added{.name = area.name,
                           .kind = area.kind,
                           .corners_m = corners_m,
                           .floor_m = area.floor_m,
                           .ceiling_m = area.ceiling_m,
                           .fromUtc = area.fromUtc,
                           .untilUtc = area.untilUtc};
        if (endsTooEarly(added)) // neither time is reliable then, so the area applies at all times
            added.fromUtc = added.untilUtc = {};
        std::vector<AirspaceArea>& airspace = m_result.scenario.airspace;
        if (std::ranges::find(airspace, added) != airspace.end()) {
            ++m_result.known;
            return false;
        }
        if (airspace.size() >= kMostAirspaceAreas) {
            leaveOut(area, IssueId::AirspaceMore);
            return false;
        }
        airspace.push_back(std::move(added));
        ++m_result.added;
        return true;
    }

    AirspaceResult m_result;
    LocalFrame m_frame;
    bool m_isOfMap; ///< whether outlines have additional corners for a map, or are cut
    std::vector<Point> m_near_m;
};

} // namespace

AirspaceResult importAirspace(const Scenario& base, std::string_view bytes,
                              const std::string& subject, const std::stop_token& stop)
{
    ReadBudget budget(subject, bytes.size(), stop);
    const std::string decoded = textOfMap(bytes, budget);
    const std::string_view text =
        withoutByteOrderMark(decoded.empty() ? bytes : std::string_view(decoded));
    const std::optional<MapFormat> map =
        trimmed(text).starts_with('{') ? MapFormat::GeoJson : mapFormatOf(text);
    if (!map && !isOpenAir(text))
        throw Error(ErrorCode::WrongFormat, subject, {IssueId::NotAirspace});
    const AirspaceTable table =
        map ? readMapAirspace(text, *map, budget) : readOpenAir(text, budget);
    if (table.areas.empty() && table.rejected.count == 0)
        throw Error(ErrorCode::InvalidInput, subject, {IssueId::NoAirspace});
    AirspaceImport import(base, table, map.has_value());
    for (const FileAirspace& area : table.areas) {
        throwIfStopped(stop);
        import.add(area);
    }
    return import.result();
}

} // namespace berg
