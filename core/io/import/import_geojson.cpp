#include "core/base/find_by_id.h"
#include "core/io/import/import_fields.h"
#include "core/io/import/import_readers.h"
#include "core/io/import/json_members.h"
#include "core/io/text/json_writer.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace berg {

namespace {

std::string typeOf(const Json* object)
{
    return textOf(memberOf(object, "type"));
}

/** A value as a cell of a table would have it. */
std::string cellText(const Json& value)
{
    if (value.is_string())
        return value.get<std::string>();
    return value.is_number() ? jsonText(value) : std::string();
}

/** Longitude and latitude of a position; false when it is none. */
bool setPlace(FieldTexts& texts, const Json& position)
{
    if (!position.is_array() || position.size() < 2 || !position[0].is_number() ||
        !position[1].is_number())
        return false;
    texts.set(SightingField::Longitude, jsonText(position[0]));
    texts.set(SightingField::Latitude, jsonText(position[1]));
    return true;
}

/** Middle of the corners of the outer ring, the one that closes it left out; null without one. */
Json middleOf(const Json& rings)
{
    if (!rings.is_array() || rings.empty() || !rings[0].is_array() || rings[0].size() < 4)
        return nullptr;
    const std::size_t corners = rings[0].size() - 1;
    double longitude_deg = 0;
    double latitude_deg = 0;
    for (std::size_t i = 0; i < corners; ++i) {
        const Json& corner = rings[0][i];
        if (!corner.is_array() || corner.size() < 2 || !corner[0].is_number() ||
            !corner[1].is_number())
            return nullptr;
        // Counted from the first corner, the shorter way round: rings cross the antimeridian.
        const double first_deg = rings[0][0][0].get<double>();
        const double east_deg = std::remainder(corner[0].get<double>() - first_deg, 360.0);
        longitude_deg += (first_deg + east_deg) / static_cast<double>(corners);
        latitude_deg += corner[1].get<double>() / static_cast<double>(corners);
    }
    return Json::array({std::remainder(longitude_deg, 360.0), latitude_deg});
}

/** Times of the corners of a line; null without. */
const Json* timesOf(const Json* properties)
{
    const Json* perCorner = memberOf(properties, "coordinateProperties");
    for (const Json* times : {memberOf(perCorner, "times"), memberOf(properties, "coordTimes"),
                              memberOf(properties, "times")})
        if (times != nullptr && times->is_array())
            return times;
    return nullptr;
}

/** Of an export of our own; empty texts without it. */
DriftTexts driftOf(const Json* properties)
{
    const Json* drift = memberOf(properties, "drift_mps");
    if (drift == nullptr || !drift->is_array() || drift->size() != 2)
        return {};
    return {.east = cellText((*drift)[0]), .north = cellText((*drift)[1])};
}

/** Seconds from the time of an iceberg of such an export until it appears. */
std::optional<double> appearsIn_s(const Json* properties)
{
    const std::optional<double> appears_s = numberAt(properties, "appears_s");
    const std::optional<double> time_s = numberAt(properties, "time_s");
    return appears_s && time_s ? std::optional(*appears_s - *time_s) : std::nullopt;
}

/** The features of a collection, or the one that the file is. */
std::span<Json> featuresOf(Json& root)
{
    if (typeOf(&root) != "FeatureCollection" || arrayOf(&root, "features") == nullptr)
        return {&root, 1};
    return root.find("features")->get_ref<Json::array_t&>();
}

std::string nameAt(const Json* properties, const char* name, std::size_t most)
{
    return cleanText(textOf(memberOf(properties, name)), most);
}

std::optional<LatLon> pointOf(const Json& feature)
{
    return placeOf(memberOf(memberOf(&feature, "geometry"), "coordinates"),
                   AxisOrder::LongitudeFirst);
}

void addUav(FileScene& scene, const Json& feature, const Json* properties)
{
    SceneUav* uav = scene.addUav();
    if (uav == nullptr)
        return;
    uav->id = nameAt(properties, "id", kLongestId);
    uav->name = nameAt(properties, "name", kLongestName);
    uav->start = pointOf(feature);
    uav->home = uav->start;
    uav->heading_deg = numberAt(properties, "heading_deg");
    uav->airspeed_mps = numberAt(properties, "airspeed_mps");
    uav->altitude_m = numberAt(properties, "altitude_m");
}

void addHome(FileScene& scene, const Json& feature, const Json* properties)
{
    SceneUav* uav = findById(scene.uavs, nameAt(properties, "uav", kLongestId));
    const std::optional<LatLon> home = pointOf(feature);
    if (uav != nullptr && home)
        uav->home = home;
}

/** Exterior ring of the rings of a polygon; false when it is none. */
bool addPolygon(FileScene& scene, SceneArea& area, const Json& rings)
{
    if (!rings.is_array() || rings.empty())
        return false;
    std::optional<std::vector<LatLon>> exterior =
        placesOf(&rings.front(), AxisOrder::LongitudeFirst);
    if (!exterior)
        return false;
    area.rings.push_back(std::move(*exterior));
    for (std::size_t i = 1; i < rings.size(); ++i)
        addFinding(scene.findings, SceneNote::AreaHoles);
    return true;
}

void addArea(FileScene& scene, const Json& feature, const Json* properties)
{
    const Json* geometry = memberOf(&feature, "geometry");
    const Json* coordinates = arrayOf(geometry, "coordinates");
    const std::string type = textOf(memberOf(geometry, "type"));
    const Json* geofence = memberOf(properties, "geofence");
    SceneArea area{.rings = {},
                   .geofence = geofence != nullptr && *geofence == true,
                   .isNoFly = kindOf(properties) == "no-fly",
                   .name = nameAt(properties, "name", kLongestName),
                   .floor_m = numberAt(properties, "floor_m"),
                   .ceiling_m = numberAt(properties, "ceiling_m")};
    bool isRead = coordinates != nullptr && !coordinates->empty();
    if (isRead && type == "Polygon")
        isRead = addPolygon(scene, area, *coordinates);
    else if (isRead && type == "MultiPolygon")
        isRead = std::all_of(coordinates->begin(), coordinates->end(),
                             [&](const Json& rings) { return addPolygon(scene, area, rings); });
    else
        isRead = false;
    if (isRead)
        scene.addArea(std::move(area));
    else
        addFinding(scene.findings, SceneNote::AreaUnreadable);
}

void addAsset(FileScene& scene, const Json& feature, const Json* properties)
{
    const std::optional<LatLon> place = pointOf(feature);
    if (!place) {
        addFinding(scene.findings, SceneNote::NumberWrong, "asset");
        return;
    }
    SceneAsset asset{.name = nameAt(properties, "name", kLongestName),
                     .place = *place,
                     .time = parseUtc(textOf(memberOf(properties, "time"))),
                     .range_m = numberAt(properties, "range_m"),
                     .standoff_m = numberAt(properties, "standoff_m"),
                     .standoffCeiling_m = numberAt(properties, "standoff_ceiling_m")};
    const Json* velocity = arrayOf(properties, "velocity_mps");
    if (velocity != nullptr && velocity->size() == 2 && (*velocity)[0].is_number() &&
        (*velocity)[1].is_number())
        asset.velocity_mps = Point((*velocity)[0].get<double>(), (*velocity)[1].get<double>());
    scene.addAsset(std::move(asset));
}

/** Adds what a feature of ours says; plans, visits and tracks are passed over. */
void addSceneFeature(FileScene& scene, const Json& feature)
{
    const Json* properties = memberOf(&feature, "properties");
    const std::string kind = kindOf(properties);
    if (isOwnGeoJson(properties))
        addUav(scene, feature, properties);
    else if (kind == "home")
        addHome(scene, feature, properties);
    else if (kind == "area" || kind == "no-fly")
        addArea(scene, feature, properties);
    else if (kind == "asset")
        addAsset(scene, feature, properties);
}

/** Gathers the sightings of one file. */
class GeoJsonSightings
{
public:
    explicit GeoJsonSightings(const ImportText& source) : m_source(source), m_names(source.mapping)
    {
    }

    SightingTable take()
    {
        m_table.rejected.place = "feature";
        ParsedJson file = parseJson(m_source.text, m_source.budget);
        const std::span<Json> features = featuresOf(file.root);
        for (const Json& feature : features) {
            const std::string type = typeOf(memberOf(&feature, "geometry"));
            m_isRoute = m_isRoute && type != "Point" && type != "Polygon";
            m_isOwn = m_isOwn || isOwnGeoJson(memberOf(&feature, "properties"));
        }
        forEachReleased(features, m_source.budget, [this](const Json& one) { addFeature(one); });
        m_names.requireMapped(m_source.budget.subject());
        return std::move(m_table);
    }

private:
    void reject(IssueId fault, const std::string& detail = {})
    {
        addRow(m_table,
               RejectedRow{.line = m_feature, .fault = fault, .detail = cleanText(detail, 60)},
               m_source.budget);
    }

    void addFeature(const Json& feature)
    {
        m_source.budget.goOn();
        ++m_feature;
        const bool bare = typeOf(&feature) != "Feature";
        const Json* geometry = bare ? &feature : memberOf(&feature, "geometry");
        const Json* properties = bare ? nullptr : memberOf(&feature, "properties");
        const Json* coordinates = memberOf(geometry, "coordinates");
        const std::string type = typeOf(geometry);
        if (m_isOwn && !kindOf(properties).empty() && kindOf(properties) != "iceberg") {
            addSceneFeature(m_table.scene, feature);
            return;
        }
        FieldTexts texts;
        readProperties(properties, texts);
        if (const Json* id = bare ? nullptr : memberOf(&feature, "id"))
            texts.set({.field = SightingField::Id, .rank = 1000}, cellText(*id));
        if (coordinates == nullptr)
            reject(IssueId::NoPosition);
        else if (type == "Point")
            addPoint(texts, *coordinates, properties);
        else if (type == "Polygon")
            addPoint(texts, middleOf(*coordinates), properties);
        else if (const Json* times = timesOf(properties); times && type == "LineString")
            addCorners(texts, *coordinates, times);
        else if (m_isRoute && type == "LineString")
            addCorners({}, *coordinates, nullptr);
        else
            reject(IssueId::NotAPoint, type);
    }

    void readProperties(const Json* properties, FieldTexts& texts)
    {
        if (properties == nullptr || !properties->is_object())
            return;
        for (const auto& [name, value] : properties->items()) {
            const std::optional<FieldUse> use = m_names.of(name);
            // The place is the geometry's.
            if (use && use->field != SightingField::Latitude &&
                use->field != SightingField::Longitude)
                texts.set(*use, cellText(value));
        }
    }

    void addPoint(FieldTexts& texts, const Json& position, const Json* properties)
    {
        if (!setPlace(texts, position)) {
            reject(IssueId::NoPosition);
            return;
        }
        std::variant<Sighting, RejectedRow> row =
            withDrift(sightingIn(m_table, m_source, texts, m_feature, false), driftOf(properties));
        if (auto* const sighting = std::get_if<Sighting>(&row)) {
            sighting->appearsIn_s = appearsIn_s(properties);
            sighting->change =
                changeOf([&](const char* name) { return numberAt(properties, name); });
        }
        addRow(m_table, std::move(row), m_source.budget);
    }

    void addCorners(const FieldTexts& common, const Json& corners, const Json* times)
    {
        const std::size_t first = m_table.sightings.size();
        for (std::size_t i = 0; corners.is_array() && i < corners.size(); ++i) {
            m_source.budget.goOn();
            FieldTexts texts = common;
            const bool placed = setPlace(texts, corners[i]);
            if (times != nullptr && i < times->size())
                texts.set(SightingField::Time, cellText((*times)[i]));
            if (placed)
                addRow(m_table, sightingIn(m_table, m_source, texts, m_feature, times != nullptr),
                       m_source.budget);
            else
                reject(IssueId::NoPosition);
        }
        if (times != nullptr)
            m_tracks.give(m_table, first);
    }

    const ImportText& m_source;
    ColumnNames m_names;
    SightingTable m_table;
    TrackIds m_tracks;
    bool m_isOwn = false;  ///< an export of our own
    bool m_isRoute = true; ///< no feature has a place of its own
    std::size_t m_feature = 0;
};

} // namespace

bool isJsonObject(std::string_view text)
{
    return text.substr(0, 16).find('{') != std::string_view::npos && trimmed(text)[0] != '<';
}

SightingTable readGeoJson(const ImportText& source)
{
    return GeoJsonSightings(source).take();
}

bool isGeoJson(std::string_view text)
{
    return isJsonObject(text) && text.find("\"coordinates\"") != std::string_view::npos;
}

bool isMetno(std::string_view text)
{
    return isGeoJson(text) && (text.find("\"BRGARE\"") != std::string_view::npos ||
                               text.find("\"IA_BLN\"") != std::string_view::npos);
}

} // namespace berg
