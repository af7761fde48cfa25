#include "core/base/error.h"
#include "core/io/import/fields/feature_ids.h"
#include "core/io/import/fields/geojson_places.h"
#include "core/io/import/maps/feature_sightings.h"
#include "core/io/import/maps/map_readers.h"

#include <algorithm>
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

/** Reads a place, or the outlines of polygons, which are all read or none. */
SceneGeometry sceneGeometry(const Json* geometry)
{
    SceneGeometry read{.place =
                           placeOf(memberOf(geometry, "coordinates"), AxisOrder::LongitudeFirst)};
    for (const Json* polygon : geometryParts(geometry).polygons) {
        const Json& rings = listOf(*polygon);
        std::optional<std::vector<LatLon>> exterior =
            rings.empty() ? std::nullopt : placesOf(&rings.front(), AxisOrder::LongitudeFirst);
        if (!exterior) {
            read.rings.clear();
            break;
        }
        read.rings.push_back(std::move(*exterior));
        read.holes += rings.size() - 1;
    }
    return read;
}

/** Places of a feature in its coordinate system. */
struct PlacedFeature
{
    PlacedFeature(const Json* geometry, const Json* timesOfPlaces, const GeoJsonSystem& ofFile)
        : system(ofFile), times(timesOfPlaces)
    {
        GeometryParts parts = geometryParts(geometry);
        for (const Json* position : parts.points)
            if (const std::optional<Point> point = positionOf(*position))
                points.push_back(*point);
        for (const Json* polygon : parts.polygons)
            if (AreaRings rings = ringsOf(*polygon, system); !rings.empty())
                areas.push_back(std::move(rings));
        broken = parts.broken + parts.points.size() - points.size() + parts.polygons.size() -
                 areas.size();
        lines = std::move(parts.lines);
        other = std::move(parts.other);
    }

    const GeoJsonSystem& system;
    const Json* times; ///< times of the corners; null if there are none
    std::vector<Point> points;
    std::vector<AreaRings> areas;
    std::vector<const Json*> lines; ///< lists of positions
    std::size_t broken = 0;         ///< number of faulty points and areas
    std::string other;              ///< type of a geometry of another kind
};

/** Collects the sightings of one file. */
class GeoJsonReader
{
public:
    explicit GeoJsonReader(const ImportText& source)
        : m_source(source), m_found(source, "feature"), m_featureIds(source.budget)
    {
    }

    SightingTable take()
    {
        const std::vector<std::string_view> texts = jsonTextsOf(m_source.text);
        if (texts.size() == 1)
            readWhole(texts.front());
        else
            readSequence(texts);
        m_featureIds.finish(m_found.table());
        return m_found.take();
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
                m_found.begin(++m_feature);
                m_found.reject(IssueId::FeatureBroken, std::string(text.substr(0, 200)));
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

    /** Determines whether the file is a route: no feature has a place of its own. */
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
    }

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
        m_found.begin(++m_feature);
        const bool bare = typeOf(&feature) != "Feature";
        const Json* geometry = bare ? &feature : memberOf(&feature, "geometry");
        const Json* properties = bare ? nullptr : memberOf(&feature, "properties");
        m_found.setProperties(properties);
        if (m_found.addToScene({}, [geometry] { return sceneGeometry(geometry); }))
            return;
        FieldTexts& texts = m_found.texts();
        const bool isProperty = !texts.text(SightingField::Id).empty();
        const Json* member = bare ? nullptr : memberOf(&feature, "id");
        const std::string id = member == nullptr ? std::string() : cellText(*member);
        texts.set({.field = SightingField::Id, .rank = kFeatureIdRank}, id);
        const std::size_t first = m_found.table().sightings.size();
        addPlaces(PlacedFeature(geometry, timesOf(properties), system));
        m_featureIds.add(m_found.table(), first, id, isProperty);
    }

    void addPlaces(const PlacedFeature& feature)
    {
        const GeometryKinds kinds{.tracks = !feature.lines.empty() && feature.times != nullptr,
                                  .points = !feature.points.empty(),
                                  .areas = !feature.areas.empty(),
                                  .lines = !feature.lines.empty()};
        if (kinds.tracks)
            addTrack(feature);
        else if (kinds.points && feature.times && feature.times->size() == feature.points.size())
            addPointTrack(feature);
        else if (kinds.points)
            addEach(feature.points, feature.system);
        else if (kinds.areas)
            addAreas(feature);
        else if (m_isRoute && kinds.lines)
            addRoute(feature);
        else if (feature.broken == 0)
            m_found.reject(IssueId::NotAPoint, kinds.lines ? "LineString" : feature.other);
        for (std::size_t i = 0; i < feature.broken; ++i)
            m_found.reject(IssueId::NoPosition);
        m_found.noteUnused(kinds);
    }

    /** Adds points, an iceberg each. */
    void addEach(const std::vector<Point>& points, const GeoJsonSystem& system)
    {
        m_found.addPlaces(
            points,
            [&system](FieldTexts& texts, const Point& point) {
                return setPlace(texts, point, system);
            },
            [](const Point&) {});
    }

    void addPointTrack(const PlacedFeature& feature)
    {
        const std::size_t first = m_found.table().sightings.size();
        for (std::size_t i = 0; i < feature.points.size(); ++i) {
            FieldTexts texts = m_found.texts();
            texts.set(SightingField::Time, cellText((*feature.times)[i]));
            if (auto fault = setPlace(texts, feature.points[i], feature.system))
                m_found.reject(std::move(*fault));
            else
                m_found.addPlace(texts);
        }
        m_found.endTrack(first);
    }

    void addAreas(const PlacedFeature& feature)
    {
        for (const AreaRings& area : feature.areas)
            for (const Point& corner : area.front()) {
                FieldTexts unused; // only checks the corner, as the centroid of coordinates in
                                   // metres could pass for a longitude
                if (std::optional<RejectedRow> fault = setPlace(unused, corner, feature.system)) {
                    m_found.reject(std::move(*fault));
                    return;
                }
            }
        const double turn = feature.system.unprojected ? 0 : kTurn_deg;
        addEach(centroidsOf(feature.areas, turn), feature.system);
    }

    /** Adds corners of lines with a time for each, in one list or in one list per line. */
    void addTrack(const PlacedFeature& feature)
    {
        const Json& times = *feature.times;
        const std::size_t first = m_found.table().sightings.size();
        const bool areApart = !times.empty() && times.front().is_array();
        std::size_t line = 0;
        std::size_t before = 0; // number of corners of the previous lines
        bool isLeft = false;
        for (const Json* corners : feature.lines) {
            const bool isTimed = !areApart || line < times.size();
            const Json& own = listOf(areApart && isTimed ? times[line] : times);
            std::size_t at = areApart ? 0 : before;
            for (const Json& corner : listOf(*corners)) {
                FieldTexts texts = m_found.texts();
                if (isTimed && at < own.size())
                    texts.set(SightingField::Time, cellText(own[at]));
                ++at;
                addCorner(texts, feature.system, corner, true);
            }
            isLeft = isLeft || (areApart && isTimed && at < own.size());
            ++line;
            before += listOf(*corners).size();
        }
        if (isLeft || (areApart ? times.size() > line : times.size() > before))
            m_found.note(IssueId::TimesLeft);
        m_found.endTrack(first);
    }

    void addRoute(const PlacedFeature& feature)
    {
        for (const Json* corners : feature.lines)
            for (const Json& corner : listOf(*corners)) {
                FieldTexts texts;
                addCorner(texts, feature.system, corner, false);
            }
    }

    void addCorner(FieldTexts& texts, const GeoJsonSystem& system, const Json& corner,
                   bool timeNeeded)
    {
        const std::optional<Point> position = positionOf(corner);
        if (!position)
            m_found.reject(IssueId::NoPosition);
        else if (std::optional<RejectedRow> fault = setPlace(texts, *position, system))
            m_found.reject(std::move(*fault));
        else
            m_found.addTrackPlace(texts, m_feature, timeNeeded);
    }

    const ImportText& m_source;
    FeatureSightings m_found;
    FeatureIds m_featureIds;
    bool m_isRoute = true; ///< no feature has a place of its own
    std::size_t m_feature = 0;
};

} // namespace

SightingTable readGeoJson(const ImportText& source)
{
    return GeoJsonReader(source).take();
}

bool isGeoJson(std::string_view text)
{
    const char first = firstOfJson(text);
    return (first == '{' || first == '[') && text.find("\"coordinates\"") != std::string_view::npos;
}

bool isMetno(std::string_view text)
{
    return isGeoJson(text) && (text.find("\"BRGARE\"") != std::string_view::npos ||
                               text.find("\"IA_BLN\"") != std::string_view::npos);
}

} // namespace berg
