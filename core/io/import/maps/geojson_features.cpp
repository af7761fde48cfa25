#include "core/base/error.h"
#include "core/io/import/fields/feature_scene.h"
#include "core/io/import/fields/import_scene.h"
#include "core/io/import/maps/feature_parsers.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <span>
#include <utility>

namespace berg {

namespace {

std::string typeOf(const Json* object)
{
    return textOf(memberOf(object, "type"));
}

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

/** Returns areas, then lines, then points. */
std::vector<FileShape> shapesOf(const Json* geometry, const GeoJsonSystem& system)
{
    std::vector<FileShape> shapes;
    const GeometryParts parts = geometryParts(geometry);
    for (const Json* polygon : parts.polygons)
        shapes.push_back({.kind = FileShape::Kind::Area,
                          .parts = listOf(*polygon).size(),
                          .placesOf = [polygon, &system](std::size_t part) {
                              return placesIn((*polygon)[part], system);
                          }});
    for (std::size_t i = 0; i < parts.brokenAreas; ++i)
        shapes.push_back({.kind = FileShape::Kind::Area, .parts = 0});
    for (const Json* line : parts.lines)
        shapes.push_back({.kind = FileShape::Kind::Line, .placesOf = [line, &system](std::size_t) {
                              return placesIn(*line, system);
                          }});
    if (!parts.points.empty())
        shapes.push_back({.parts = parts.points.size(),
                          .placesOf = [points = parts.points, &system](
                                          std::size_t part) -> std::optional<std::vector<LatLon>> {
                              const std::optional<LatLon> place = placeIn(*points[part], system);
                              return place ? std::optional(std::vector{*place}) : std::nullopt;
                          }});
    return shapes;
}

/** Walks through one file. */
class GeoJsonWalk
{
public:
    GeoJsonWalk(CrsUse crs, ReadBudget& budget,
                const std::function<void(const GeoJsonFeature&)>& use)
        : m_crs(crs), m_budget(budget), m_use(use)
    {
    }

    void read(std::string_view text)
    {
        m_feature.isOwn = isOwnExport(text);
        m_feature.isRoute = true;
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
                GeoJsonFeature broken;
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
            m_feature.isRoute = m_feature.isRoute && !hasPlaces(geometryOf(object));
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
        GeoJsonFeature& feature = m_feature;
        ++feature.line;
        feature.geometry = geometryOf(object);
        const bool isBare = feature.geometry == &object;
        feature.properties = isBare ? nullptr : memberOf(&object, "properties");
        const Json* const id = isBare ? nullptr : memberOf(&object, "id");
        feature.id = id == nullptr ? std::string() : cellText(*id);
        feature.kind = feature.isOwn ? featureKind(feature.properties, {}) : std::string();
        feature.fill = colourOf(feature.properties, "fill", "fill-opacity");
        feature.stroke = colourOf(feature.properties, "stroke", "stroke-opacity");
        feature.system = system;
        feature.shapes = [&feature] { return shapesOf(feature.geometry, feature.system); };
        m_use(feature);
    }

    CrsUse m_crs;
    ReadBudget& m_budget;
    const std::function<void(const GeoJsonFeature&)>& m_use;
    GeoJsonFeature m_feature; ///< the last one
};

} // namespace

void readGeoJsonFeatures(std::string_view text, CrsUse crs, ReadBudget& budget,
                         const std::function<void(const GeoJsonFeature&)>& use)
{
    GeoJsonWalk(crs, budget, use).read(text);
}

} // namespace berg
