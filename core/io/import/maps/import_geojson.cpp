#include "core/io/import/fields/feature_ids.h"
#include "core/io/import/maps/feature_parsers.h"
#include "core/io/import/maps/feature_sightings.h"
#include "core/io/import/maps/map_readers.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace berg {

namespace {

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
        readGeoJsonFeatures(m_source.text, CrsUse::Needed, m_source.budget,
                            [this](const GeoJsonFeature& feature) { addFeature(feature); });
        m_featureIds.finish(m_found.table());
        return m_found.take();
    }

private:
    void addFeature(const GeoJsonFeature& feature)
    {
        const bool isProperty = m_found.begin(feature);
        if (!feature.broken.empty()) {
            m_found.reject(IssueId::FeatureBroken, feature.broken);
            return;
        }
        if (m_found.addToScene(feature))
            return;
        const std::size_t first = m_found.table().sightings.size();
        addPlaces(PlacedFeature(feature.geometry, timesOf(feature.properties), feature.system),
                  feature.isRoute);
        m_featureIds.add(m_found.table(), first, feature.id, isProperty);
    }

    void addPlaces(const PlacedFeature& feature, bool isRoute)
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
        else if (isRoute && kinds.lines)
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
            m_found.addTrackPlace(texts, m_found.line(), timeNeeded);
    }

    const ImportText& m_source;
    FeatureSightings m_found;
    FeatureIds m_featureIds;
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
