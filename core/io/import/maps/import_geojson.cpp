#include "core/base/error.h"
#include "core/io/import/fields/feature_ids.h"
#include "core/io/import/fields/import_fields.h"
#include "core/io/import/fields/json_members.h"
#include "core/io/import/maps/geojson_places.h"
#include "core/io/import/maps/geojson_scene.h"
#include "core/io/import/maps/map_readers.h"
#include "core/io/text/json_writer.h"

#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace berg {

namespace {

std::string typeOf(const Json* object)
{
    return textOf(memberOf(object, "type"));
}

/** Returns a value in the form of a table cell. */
std::string cellText(const Json& value)
{
    if (value.is_string())
        return value.get<std::string>();
    return value.is_number() ? jsonText(value) : std::string();
}

/** Returns the times of the corners of a line, or null if there are none. */
const Json* timesOf(const Json* properties)
{
    const Json* perCorner = memberOf(properties, "coordinateProperties");
    for (const Json* times : {memberOf(perCorner, "times"), memberOf(properties, "coordTimes"),
                              memberOf(properties, "times")})
        if (times != nullptr && times->is_array())
            return times;
    return nullptr;
}

/** Returns the drift in a Bergwatch export; the texts are empty without it. */
DriftTexts driftOf(const Json* properties)
{
    const Json* drift = memberOf(properties, "drift_mps");
    if (drift == nullptr || !drift->is_array() || drift->size() != 2)
        return {};
    return {.east = cellText((*drift)[0]), .north = cellText((*drift)[1])};
}

/** Returns the seconds from the time of an iceberg of a Bergwatch export until it appears. */
std::optional<double> appearsIn_s(const Json* properties)
{
    const std::optional<double> appears_s = numberAt(properties, "appears_s");
    const std::optional<double> time_s = numberAt(properties, "time_s");
    return appears_s && time_s ? std::optional(*appears_s - *time_s) : std::nullopt;
}

bool isCollection(const Json& object)
{
    return typeOf(&object) == "FeatureCollection" && arrayOf(&object, "features") != nullptr;
}

/** Returns the features of a collection or a list, or the single one that the file is. */
std::span<Json> featuresOf(Json& root)
{
    if (root.is_array())
        return root.get_ref<Json::array_t&>();
    if (!isCollection(root))
        return {&root, 1};
    return root.find("features")->get_ref<Json::array_t&>();
}

/** Parts of a feature's geometry and their coordinate system. */
struct PlacedFeature
{
    const Json* properties = nullptr;
    const GeoJsonSystem& system;
    GeometryParts parts;
};

/** Collects the sightings of one file. */
class GeoJsonSightings
{
public:
    explicit GeoJsonSightings(const ImportText& source)
        : m_source(source), m_names(source.mapping), m_featureIds(source.budget)
    {
    }

    SightingTable take()
    {
        m_table.rejected.place = "feature";
        m_table.noted.place = "feature";
        const std::vector<std::string_view> texts = jsonTextsOf(m_source.text);
        if (texts.size() == 1)
            readWhole(texts.front());
        else
            readSequence(texts);
        m_featureIds.finish(m_table);
        m_names.requireMapped(m_source.budget.subject());
        m_table.idCandidates = m_names.unknown();
        return std::move(m_table);
    }

private:
    void readWhole(std::string_view text)
    {
        ParsedJson file = parseJson(text, m_source.budget);
        survey(file.root);
        const GeoJsonSystem system = systemOf(file.root, {}, m_source.budget.subject());
        forEachReleased(featuresOf(file.root), m_source.budget,
                        [&](const Json& one) { addObject(one, system); });
    }

    /** Reads a sequence of texts; a broken one is rejected and does not affect the others. */
    void readSequence(const std::vector<std::string_view>& texts)
    {
        ReadBudget ahead = m_source.budget;
        for (const std::string_view text : texts)
            withParsed(text, ahead, [this](const Json& root) { survey(root); });
        for (const std::string_view text : texts)
            if (!withParsed(text, m_source.budget,
                            [this](const Json& root) { addObject(root, {}); })) {
                ++m_feature;
                reject(IssueId::FeatureBroken, std::string(text.substr(0, 200)));
            }
    }

    /**
     * Calls `use` with the tree of a text and then frees its memory. Returns false if the text is
     * broken.
     */
    template <class Use>
    static bool withParsed(std::string_view text, ReadBudget& budget, Use use)
    {
        const std::size_t before = budget.memory();
        std::optional<ParsedJson> file;
        try {
            file.emplace(parseJson(text, budget));
        } catch (const Error& error) {
            if (error.code() != ErrorCode::SyntaxError)
                throw;
            budget.release(budget.memory() - before);
            return false;
        }
        const std::size_t tree = budget.memory() - before;
        use(std::as_const(file->root));
        budget.release(tree);
        return true;
    }

    /** Determines properties of the file as a whole. */
    void survey(const Json& object)
    {
        m_source.budget.throwIfStopped();
        if (object.is_array() || isCollection(object)) {
            for (const Json& one : object.is_array() ? object : *memberOf(&object, "features"))
                survey(one);
            return;
        }
        const bool isBare = typeOf(&object) != "Feature";
        m_isRoute = m_isRoute && !hasPlaces(isBare ? &object : memberOf(&object, "geometry"));
        m_isOwn = m_isOwn || isOwnGeoJson(memberOf(&object, "properties"));
    }

    void reject(IssueId fault, const std::string& detail = {})
    {
        reject({.fault = fault, .detail = cleanText(detail, 60)});
    }
    void reject(RejectedRow row)
    {
        row.line = m_feature;
        addRow(m_table, std::move(row), m_source.budget);
    }
    void note(IssueId what) { m_table.noted.add({.line = m_feature, .fault = what, .detail = {}}); }

    /** Adds a feature, or each feature of a collection or list. */
    void addObject(const Json& object, const GeoJsonSystem& outer)
    {
        const GeoJsonSystem system = systemOf(object, outer, m_source.budget.subject());
        if (!object.is_array() && !isCollection(object)) {
            addFeature(object, system);
            return;
        }
        for (const Json& one : object.is_array() ? object : *memberOf(&object, "features"))
            addObject(one, system);
    }

    void addFeature(const Json& feature, const GeoJsonSystem& system)
    {
        m_source.budget.throwIfStopped();
        ++m_feature;
        const bool bare = typeOf(&feature) != "Feature";
        const Json* geometry = bare ? &feature : memberOf(&feature, "geometry");
        const Json* properties = bare ? nullptr : memberOf(&feature, "properties");
        if (m_isOwn && !kindOf(properties).empty() && kindOf(properties) != "iceberg") {
            addSceneFeature(m_table.scene, feature);
            return;
        }
        FieldTexts texts;
        readProperties(properties, texts);
        const bool isProperty = !texts.text(SightingField::Id).empty();
        const Json* id = bare ? nullptr : memberOf(&feature, "id");
        if (id != nullptr)
            texts.set({.field = SightingField::Id, .rank = kFeatureIdRank}, cellText(*id));
        const std::size_t first = m_table.sightings.size();
        addPlaces(texts,
                  {.properties = properties, .system = system, .parts = partsOf(geometry, system)});
        m_featureIds.add(m_table, first, id == nullptr ? std::string() : cellText(*id), isProperty);
    }

    void addPlaces(const FieldTexts& texts, const PlacedFeature& feature)
    {
        const GeometryParts& parts = feature.parts;
        const Json* times = timesOf(feature.properties);
        if (!parts.lines.empty() && times != nullptr)
            addTrack(texts, feature, *times);
        else if (!parts.points.empty())
            addPoints(texts, feature, parts.points, times);
        else if (!parts.areas.empty())
            addAreas(texts, feature);
        else if (m_isRoute && !parts.lines.empty())
            addRoute(feature);
        else if (parts.broken == 0)
            reject(IssueId::NotAPoint, parts.lines.empty() ? parts.other : "LineString");
        for (std::size_t i = 0; i < parts.broken; ++i)
            reject(IssueId::NoPosition);
        noteOtherParts(parts, times != nullptr);
    }

    void readProperties(const Json* properties, FieldTexts& texts)
    {
        if (properties == nullptr || !properties->is_object())
            return;
        for (const auto& [name, value] : properties->items()) {
            const std::optional<FieldUse> use = m_names.of(name);
            // The geometry determines the place.
            if (use && use->field != SightingField::Latitude &&
                use->field != SightingField::Longitude)
                texts.set(*use, cellText(value));
        }
    }

    /** Notes the parts of a collection that are not used. */
    void noteOtherParts(const GeometryParts& parts, bool hasTimes)
    {
        const bool hasLines = !parts.lines.empty();
        const bool hasPoints = !parts.points.empty();
        const bool hasAreas = !parts.areas.empty();
        if (hasLines && hasTimes && (hasPoints || hasAreas))
            note(IssueId::TrackAlone);
        else if (hasPoints && (hasLines || hasAreas))
            note(IssueId::PointsAlone);
        else if (hasLines && hasAreas)
            note(IssueId::AreasAlone);
    }

    /** Adds points: with a time each they are a track, otherwise an iceberg each. */
    void addPoints(const FieldTexts& common, const PlacedFeature& feature,
                   const std::vector<Point>& points, const Json* times)
    {
        const std::size_t first = m_table.sightings.size();
        const bool isTrack = times != nullptr && times->size() == points.size();
        const bool areSeveral = points.size() > 1 && !isTrack;
        if (areSeveral)
            note(IssueId::SeveralPlaces);
        for (std::size_t i = 0; i < points.size(); ++i) {
            const std::size_t before = m_table.sightings.size();
            FieldTexts texts = common;
            if (isTrack)
                texts.set(SightingField::Time, cellText((*times)[i]));
            addPoint(texts, feature, points[i]);
            if (areSeveral && m_table.sightings.size() > before)
                m_table.sightings.back().part = static_cast<std::uint32_t>(i) + 1;
        }
        if (isTrack) {
            m_tracks.give(m_table, first);
        }
    }

    void addPoint(FieldTexts& texts, const PlacedFeature& feature, const Point& point)
    {
        if (std::optional<RejectedRow> fault = setPlace(texts, point, feature.system)) {
            reject(std::move(*fault));
            return;
        }
        const Json* properties = feature.properties;
        std::variant<Sighting, RejectedRow> row = withDrift(
            m_table, sightingIn(m_table, m_source, texts, m_feature, false), driftOf(properties));
        if (auto* const sighting = std::get_if<Sighting>(&row)) {
            sighting->appearsIn_s = appearsIn_s(properties);
            sighting->change =
                changeOf([&](const char* name) { return numberAt(properties, name); });
        }
        addRow(m_table, std::move(row), m_source.budget);
    }

    void addAreas(const FieldTexts& texts, const PlacedFeature& feature)
    {
        for (const AreaRings& area : feature.parts.areas)
            for (const Point& corner : area.front()) {
                FieldTexts unused; // only checks the corner, as the centroid of coordinates in
                                   // metres could pass for a longitude
                if (std::optional<RejectedRow> fault = setPlace(unused, corner, feature.system)) {
                    reject(std::move(*fault));
                    return;
                }
            }
        const double turn = feature.system.unprojected ? 0 : kTurn_deg;
        addPoints(texts, feature, centroidsOf(feature.parts.areas, turn), nullptr);
    }

    /** Adds corners of lines with a time for each, in one list or in one list per line. */
    void addTrack(const FieldTexts& common, const PlacedFeature& feature, const Json& times)
    {
        const std::size_t first = m_table.sightings.size();
        const bool areApart = !times.empty() && times.front().is_array();
        std::size_t line = 0;
        std::size_t before = 0; // number of corners of the previous lines
        bool isLeft = false;
        for (const Json* corners : feature.parts.lines) {
            const bool isTimed = !areApart || line < times.size();
            const Json& own = listOf(areApart && isTimed ? times[line] : times);
            std::size_t at = areApart ? 0 : before;
            for (const Json& corner : listOf(*corners)) {
                FieldTexts texts = common;
                if (isTimed && at < own.size())
                    texts.set(SightingField::Time, cellText(own[at]));
                ++at;
                addCorner(texts, feature, corner, true);
            }
            isLeft = isLeft || (areApart && isTimed && at < own.size());
            ++line;
            before += listOf(*corners).size();
        }
        if (isLeft || (areApart ? times.size() > line : times.size() > before))
            note(IssueId::TimesLeft);
        m_tracks.give(m_table, first);
    }

    void addRoute(const PlacedFeature& feature)
    {
        for (const Json* corners : feature.parts.lines)
            for (const Json& corner : listOf(*corners)) {
                FieldTexts texts;
                addCorner(texts, feature, corner, false);
            }
    }

    void addCorner(FieldTexts& texts, const PlacedFeature& feature, const Json& corner,
                   bool timeNeeded)
    {
        m_source.budget.throwIfStopped();
        const std::optional<Point> position = positionOf(corner);
        if (!position)
            reject(IssueId::NoPosition);
        else if (std::optional<RejectedRow> fault = setPlace(texts, *position, feature.system))
            reject(std::move(*fault));
        else
            addRow(m_table, sightingIn(m_table, m_source, texts, m_feature, timeNeeded),
                   m_source.budget);
    }

    const ImportText& m_source;
    ColumnNames m_names;
    SightingTable m_table;
    TrackIds m_tracks;
    FeatureIds m_featureIds;
    bool m_isOwn = false;  ///< the file is a Bergwatch export
    bool m_isRoute = true; ///< no feature has a place of its own
    std::size_t m_feature = 0;
};

} // namespace

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
