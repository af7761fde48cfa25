#include "core/base/error.h"
#include "core/io/import/fields/feature_ids.h"
#include "core/io/import/maps/feature_parsers.h"
#include "core/io/import/maps/feature_sightings.h"
#include "core/io/import/maps/map_readers.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <span>
#include <utility>

namespace berg {

namespace {

bool isCollection(const Json& object)
{
    return arrayOf(&object, "features") != nullptr && typeOf(&object) != "Feature";
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

/** Returns the geometry of a feature, or a bare one itself. */
const Json* geometryOf(const Json& feature)
{
    const Json* const geometry = memberOf(&feature, "geometry");
    return geometry != nullptr || typeOf(&feature) == "Feature" ? geometry : &feature;
}

/** Returns a colour "#rrggbb" with the opacity of another property, or nullopt. */
std::optional<std::uint32_t> colourOf(const Json* properties, const char* name,
                                      const char* opacityName)
{
    const std::string text = textOf(memberOf(properties, name));
    std::uint32_t rgb = 0;
    const char* const end = text.data() + text.size();
    if (text.size() != 7 || text[0] != '#' ||
        std::from_chars(text.data() + 1, end, rgb, 16).ptr != end)
        return std::nullopt;
    const double opacity = numberIn(memberOf(properties, opacityName)).value_or(1);
    const double alpha = std::isfinite(opacity) ? std::clamp(opacity, 0.0, 1.0) * 255 : 255;
    return static_cast<std::uint32_t>(std::lround(alpha)) << 24U | rgb;
}

/** Returns the place of a position, or nullopt if it is not one. */
std::optional<LatLon> placeIn(const Json& position, const GeoJsonSystem& system)
{
    const std::optional<Point> given = positionOf(position);
    if (!given)
        return std::nullopt;
    const LatLon read = system.unprojected
                            ? (*system.unprojected)(*given)
                            : LatLon{.latitude_deg = given->y(), .longitude_deg = given->x()};
    return scenePlace(read.latitude_deg, read.longitude_deg);
}

/** Returns the places of a list of positions, or nullopt if one of them is not a place. */
std::optional<std::vector<LatLon>> placesIn(const Json& positions, const GeoJsonSystem& system)
{
    if (!positions.is_array())
        return std::nullopt;
    std::vector<LatLon> places;
    for (const Json& position : positions) {
        const std::optional<LatLon> place = placeIn(position, system);
        if (!place)
            return std::nullopt;
        places.push_back(*place);
    }
    return places;
}

/** Returns the times of the places of a feature, or null if there are none. */
const Json* timesOf(const Json* properties)
{
    const Json* perCorner = memberOf(properties, "coordinateProperties");
    for (const Json* times : {memberOf(perCorner, "times"), memberOf(properties, "coordTimes"),
                              memberOf(properties, "times")})
        if (times != nullptr && times->is_array())
            return times;
    return nullptr;
}

FilePlace icebergAtCorner(const Json& position, const GeoJsonSystem& system, const Json* time)
{
    const std::optional<Point> given = positionOf(position);
    FilePlace place = given ? filePlace(*given, system) : FilePlace{.fault = IssueId::NoPosition};
    if (time != nullptr)
        place.time = cellText(*time);
    return place;
}

/** Adds lines; with times in one list, or in one list per line, they are tracks. */
void addLines(FileGeometry& geometry, const std::vector<const Json*>& lines, const Json* times)
{
    const GeoJsonSystem& system = *geometry.system;
    const bool areApart = times != nullptr && !times->empty() && times->front().is_array();
    std::size_t before = 0; // number of corners of the previous lines
    bool isLeft = false;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const Json* const line = lines[i];
        const Json* own = times;
        if (areApart)
            own = i < times->size() ? &listOf((*times)[i]) : nullptr;
        const std::size_t count = listOf(*line).size();
        const auto at = [line, own, &system, from = areApart ? 0 : before](std::size_t corner) {
            const bool isTimed = own != nullptr && from + corner < own->size();
            return icebergAtCorner((*line)[corner], system,
                                   isTimed ? &(*own)[from + corner] : nullptr);
        };
        geometry.shapes.push_back(
            {.kind = times == nullptr ? ShapeKind::Line : ShapeKind::Track,
             .icebergs = {.count = count, .at = at},
             .readPart = [line, &system](std::size_t) { return placesIn(*line, system); }});
        isLeft = isLeft || (areApart && own != nullptr && count < own->size());
        before += count;
    }
    if (!lines.empty() && times != nullptr)
        geometry.shapes.back().icebergs.timesLeft =
            isLeft || times->size() > (areApart ? lines.size() : before);
}

/** Adds points; with a time each they are one track. */
void addPoints(FileGeometry& geometry, const std::vector<const Json*>& points, const Json* times)
{
    const GeoJsonSystem& system = *geometry.system;
    const bool areTimed = times != nullptr && times->size() == points.size();
    const auto at = [points, &system, times = areTimed ? times : nullptr](std::size_t i) {
        return icebergAtCorner(*points[i], system, times == nullptr ? nullptr : &(*times)[i]);
    };
    if (!points.empty())
        geometry.shapes.push_back(
            {.parts = points.size(),
             .icebergs = {.count = points.size(), .at = at, .areTimed = areTimed}});
}

/** Returns areas, then lines, then points. */
FileGeometry geometryIn(const Json* given, const Json* times, const GeoJsonSystem& system)
{
    GeometryParts parts = geometryParts(given);
    const std::size_t wrong =
        std::erase_if(parts.points, [](const Json* position) { return !positionOf(*position); });
    FileGeometry geometry{.broken = parts.broken - parts.brokenAreas + wrong,
                          .other = parts.lines.empty() ? parts.other : "LineString",
                          .system = &system};
    for (const Json* polygon : parts.polygons)
        geometry.shapes.push_back(
            {.kind = ShapeKind::Area,
             .parts = listOf(*polygon).size(),
             .readPart = [polygon,
                          &system](std::size_t part) { return placesIn((*polygon)[part], system); },
             .rings = [polygon] { return ringsOf(*polygon); }});
    for (std::size_t i = 0; i < parts.brokenAreas; ++i)
        geometry.shapes.push_back({.kind = ShapeKind::Area, .parts = 0});
    addLines(geometry, parts.lines, times);
    addPoints(geometry, parts.points, times);
    return geometry;
}

/** Walks through one file. */
class GeoJsonWalk
{
public:
    GeoJsonWalk(CrsUse crs, ReadBudget& budget, const std::function<void(const FileFeature&)>& use)
        : m_crs(crs), m_budget(budget), m_use(use)
    {
    }

    void read(std::string_view text)
    {
        m_feature.isOwn = isOwnExport(text);
        const std::vector<std::string_view> texts = jsonTextsOf(text);
        if (texts.size() == 1)
            readWhole(texts.front());
        else
            readSequence(texts);
    }

private:
    void readWhole(std::string_view text)
    {
        ParsedJson file = parseJson(text, m_budget);
        survey(file.root);
        const GeoJsonSystem system = systemIn(file.root, {});
        forEachReleased(featuresOf(file.root), m_budget,
                        [&](const Json& one) { addObject(one, system); });
    }

    /** Reads a sequence of texts; a broken one does not affect the others. */
    void readSequence(const std::vector<std::string_view>& texts)
    {
        ReadBudget ahead = m_budget;
        for (const std::string_view text : texts)
            withParsed(text, ahead, [this](const Json& root) { survey(root); });
        for (const std::string_view text : texts)
            if (!withParsed(text, m_budget, [this](const Json& root) { addObject(root, {}); })) {
                FileFeature broken;
                broken.line = ++m_feature.line;
                broken.broken = text.substr(0, 200);
                m_use(broken);
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

    GeoJsonSystem systemIn(const Json& object, const GeoJsonSystem& outer) const
    {
        return m_crs == CrsUse::Ignored ? outer : systemOf(object, outer, m_budget.subject());
    }

    /** Determines whether the file is a route: no feature has a place of its own. */
    void survey(const Json& object)
    {
        m_budget.throwIfStopped();
        if (!object.is_array() && !isCollection(object))
            m_isRoute = m_isRoute && !hasPlaces(geometryOf(object));
        else
            for (const Json& one : object.is_array() ? object : *memberOf(&object, "features"))
                survey(one);
    }

    /** Hands over a feature, or each feature of a collection or list. */
    void addObject(const Json& object, const GeoJsonSystem& outer)
    {
        const GeoJsonSystem system = systemIn(object, outer);
        if (!object.is_array() && !isCollection(object)) {
            addFeature(object, system);
            return;
        }
        for (const Json& one : object.is_array() ? object : *memberOf(&object, "features"))
            addObject(one, system);
    }

    void addFeature(const Json& object, const GeoJsonSystem& system)
    {
        m_budget.throwIfStopped();
        FileFeature& feature = m_feature;
        ++feature.line;
        const Json* const geometry = geometryOf(object);
        const bool isBare = geometry == &object;
        feature.properties = isBare ? nullptr : memberOf(&object, "properties");
        const Json* const id = isBare ? nullptr : memberOf(&object, "id");
        feature.id = id == nullptr ? std::string() : cellText(*id);
        feature.kind = feature.isOwn ? featureKind(feature.properties, {}) : std::string();
        feature.fill = colourOf(feature.properties, "fill", "fill-opacity");
        feature.stroke = colourOf(feature.properties, "stroke", "stroke-opacity");
        feature.geometry = [this, geometry, &system] {
            FileGeometry read = geometryIn(geometry, timesOf(m_feature.properties), system);
            read.isRoute = m_isRoute;
            return read;
        };
        m_use(feature);
    }

    CrsUse m_crs;
    ReadBudget& m_budget;
    const std::function<void(const FileFeature&)>& m_use;
    FileFeature m_feature; ///< the last one
    bool m_isRoute = true; ///< whether no feature of the file has a point or an area
};

} // namespace

void readGeoJsonFeatures(std::string_view text, CrsUse crs, ReadBudget& budget,
                         const std::function<void(const FileFeature&)>& use)
{
    GeoJsonWalk(crs, budget, use).read(text);
}

SightingTable readGeoJson(const ImportText& source)
{
    FeatureSightings found(source, placeIn(MapFormat::GeoJson));
    FeatureIds ids(source.budget);
    readGeoJsonFeatures(source.text, CrsUse::Needed, source.budget,
                        [&found, &ids](const FileFeature& feature) {
                            const std::size_t first = found.table().sightings.size();
                            const bool isProperty = found.add(feature);
                            ids.add(found.table(), first, feature.id, isProperty);
                        });
    ids.finish(found.table());
    return found.take();
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
