#include "core/io/import/maps/map_shapes.h"

#include "core/io/import/fields/geojson_places.h"
#include "core/io/import/fields/import_fields.h"
#include "core/io/import/fields/import_xml.h"
#include "core/io/import/fields/json_members.h"
#include "core/io/import/maps/map_readers.h"
#include "core/io/text/zip_file.h"
#include "core/scenario/ice_chart.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>

namespace berg {

namespace {

constexpr std::uint32_t kIceOpacity = 0x99; // keeps the sea and its graticule visible

/** Returns a number, or a text that is one, or nullopt. */
std::optional<double> numberOf(const Json* value)
{
    if (value != nullptr && value->is_number())
        return value->get<double>();
    return decimalOf(textOf(value));
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
    const double opacity = numberOf(memberOf(properties, opacityName)).value_or(1);
    const double alpha = std::isfinite(opacity) ? std::clamp(opacity, 0.0, 1.0) * 255 : 255;
    return static_cast<std::uint32_t>(std::lround(alpha)) << 24U | rgb;
}

/**
 * Returns the WMO colour of the total concentration for a polygon of an ice chart with codes of
 * SIGRID-3, or nullopt if it has no such code.
 */
std::optional<std::uint32_t> iceColour(const Json* properties)
{
    constexpr int kFastIce = 8;
    const auto code = [&](const char* name) -> std::optional<int> {
        const std::optional<double> value = numberOf(memberOf(properties, name));
        return value && *value >= 0 && *value < 99 ? std::optional(static_cast<int>(*value))
                                                   : std::nullopt;
    };
    const std::optional<int> total = code("CT");
    const std::optional<double> tenths = total ? tenthsOfSigrid(*total) : std::nullopt;
    if (!tenths)
        return std::nullopt;
    const std::uint32_t rgb =
        wmoColour(classOf({.concentration_tenths = tenths, .isFast = code("FA") == kFastIce}));
    return kIceOpacity << 24U | rgb;
}

/** Memory of a shape, bytes. */
std::size_t memoryOf(const MapShape& shape)
{
    std::size_t bytes = sizeof(MapShape) + shape.name.capacity();
    for (const std::vector<LatLon>& part : shape.parts)
        bytes += sizeof(std::vector<LatLon>) + part.capacity() * sizeof(LatLon);
    return bytes;
}

class GeoJsonShapes
{
public:
    explicit GeoJsonShapes(ReadBudget& budget) : m_budget(budget) {}

    std::vector<MapShape> take(std::string_view text)
    {
        ParsedJson file = parseJson(text, m_budget);
        Json& root = file.root;
        if (arrayOf(&root, "features") != nullptr)
            forEachReleased(std::span<Json>(root.find("features")->get_ref<Json::array_t&>()),
                            m_budget, [this](const Json& feature) { addFeature(feature); });
        else
            addFeature(root);
        return std::move(m_shapes);
    }

private:
    void addFeature(const Json& feature)
    {
        m_budget.throwIfStopped();
        const Json* geometry = memberOf(&feature, "geometry");
        const Json* properties = memberOf(&feature, "properties");
        m_model = {.parts = {},
                   .name = cleanText(textOf(memberOf(properties, "name")), kLongestName),
                   .fill = colourOf(properties, "fill", "fill-opacity"),
                   .line = colourOf(properties, "stroke", "stroke-opacity")};
        if (!m_model.fill)
            m_model.fill = iceColour(properties);
        addGeometry(geometry != nullptr ? *geometry : feature);
    }

    void addGeometry(const Json& geometry)
    {
        using Kind = MapShape::Kind;
        const GeometryParts parts = geometryParts(&geometry);
        for (const Json* polygon : parts.polygons)
            add(Kind::Polygon, listOf(*polygon).get_ref<const Json::array_t&>());
        for (const Json* line : parts.lines)
            add(Kind::Line, {line, 1});
        for (const Json* place : parts.points)
            addPlace(*place);
    }

    void addPlace(const Json& position)
    {
        if (const std::optional<LatLon> place = placeOf(&position, AxisOrder::LongitudeFirst))
            store(MapShape::Kind::Place, {{*place}}, m_model.name);
    }

    /** Adds a shape of the lines, unless one of their places is invalid. */
    void add(MapShape::Kind kind, std::span<const Json> lines)
    {
        std::vector<std::vector<LatLon>> parts;
        for (const Json& line : lines) {
            std::optional<std::vector<LatLon>> places = placesOf(&line, AxisOrder::LongitudeFirst);
            if (!places || places->empty())
                return;
            parts.push_back(std::move(*places));
        }
        if (!parts.empty())
            store(kind, std::move(parts), {});
    }

    void store(MapShape::Kind kind, std::vector<std::vector<LatLon>> parts, const std::string& name)
    {
        m_shapes.push_back({.kind = kind,
                            .parts = std::move(parts),
                            .name = name,
                            .fill = m_model.fill,
                            .line = m_model.line});
        m_budget.takeRow(memoryOf(m_shapes.back()));
    }

    ReadBudget& m_budget;
    MapShape m_model; ///< holds name and colours of the feature
    std::vector<MapShape> m_shapes;
};

/** Reads a colour of KML (aabbggrr), or returns nullopt. */
std::optional<std::uint32_t> colourOf(std::string_view text)
{
    const std::string_view digits = trimmed(text);
    std::uint32_t abgr = 0;
    const char* const end = digits.data() + digits.size();
    const auto [read, fault] = std::from_chars(digits.data(), end, abgr, 16);
    if (digits.size() != 8 || fault != std::errc() || read != end)
        return std::nullopt;
    return (abgr & 0xFF00FF00U) | ((abgr & 0xFFU) << 16U) | ((abgr >> 16U) & 0xFFU);
}

/** Returns the key of a style, shortened because every shape stores one. */
std::string styleKey(std::string_view text)
{
    return std::string(trimmed(text).substr(0, kLongestName));
}

struct ShapeStyle
{
    std::optional<std::uint32_t> fill;
    std::optional<std::uint32_t> line;
};

/** Reads the shapes of a KML text with their styles; links and images are ignored. */
class KmlShapes
{
public:
    KmlShapes(std::string_view text, ReadBudget& budget) : m_text(text), m_budget(budget) {}

    std::vector<MapShape> take()
    {
        const XmlEvents events{.opened = [this](XmlPath path) { opened(path.back()); },
                               .closed = [this](XmlPath path) { closed(path); }};
        readXml(m_text, events, m_budget);
        for (std::size_t i = 0; i < m_shapes.size(); ++i) // styles may follow the shapes using them
            setStyle(m_shapes[i], styleOf(m_urls[i]));
        return std::move(m_shapes);
    }

private:
    void opened(const XmlElement& element)
    {
        constexpr std::size_t kStyle = 128 + 2 * kLongestName; // a style with its keys in a map
        const std::string& name = element.name;
        if (name == "Style" || name == "Pair")
            m_budget.take(kStyle);
        if (name == "Placemark") {
            m_name.clear();
            m_url.clear();
            m_own = {};
            m_first = m_shapes.size();
        } else if (name == "Style") {
            m_style = {};
        } else if (name == "Polygon") {
            m_rings.clear();
            m_isSpoiled = false;
        } else if (name == "Track") {
            m_track.clear();
            m_isSpoiled = false;
        } else if (name == "StyleMap") {
            m_mapKey = styleKey('#' + element.attribute("id"));
        } else if (name == "Pair") {
            m_pairKey.clear();
            m_pairUrl.clear();
        }
    }

    void closed(XmlPath path)
    {
        const XmlElement& element = path.back();
        const std::string_view parent = parentName(path);
        if (element.name == "coordinates")
            addCoordinates(path);
        else if (element.name == "coord" && parent == "Track")
            addPose(element.text);
        else if (element.name == "Polygon" && !m_isSpoiled)
            add({.kind = MapShape::Kind::Polygon, .parts = std::move(m_rings)});
        else if (element.name == "Track" && !m_isSpoiled)
            add({.kind = MapShape::Kind::Line, .parts = {std::move(m_track)}});
        else if (element.name == "Placemark")
            finish();
        else if (element.name == "name" && parent == "Placemark")
            m_name = cleanText(element.text, kLongestName);
        else
            closedStyle(path);
    }

    void closedStyle(XmlPath path)
    {
        const XmlElement& element = path.back();
        const std::string_view parent = parentName(path);
        const bool isOff = trimmed(element.text) == "0";
        if (element.name == "styleUrl")
            (parent == "Pair" ? m_pairUrl : m_url) = styleKey(element.text);
        else if (element.name == "key" && parent == "Pair")
            m_pairKey = trimmed(element.text);
        else if (element.name == "Pair" && m_pairKey == "normal")
            m_aliases[m_mapKey] = m_pairUrl;
        else if (element.name == "color" && parent == "PolyStyle")
            m_style.fill = colourOf(element.text);
        else if (element.name == "color" && parent == "LineStyle")
            m_style.line = colourOf(element.text);
        else if (element.name == "fill" && parent == "PolyStyle" && isOff)
            m_style.fill = 0;
        else if (element.name == "outline" && parent == "PolyStyle" && isOff)
            m_style.line = 0;
        else if (element.name == "Style" && parent == "Placemark")
            m_own = m_style;
        else if (element.name == "Style")
            m_styles[styleKey('#' + element.attribute("id"))] = m_style;
    }

    void addCoordinates(XmlPath path)
    {
        std::optional<std::vector<LatLon>> places = placesOfTuples(path.back().text);
        if (!places || places->empty()) {
            m_isSpoiled = true;
            return;
        }
        const std::string_view parent = parentName(path);
        const std::string_view above = parentName(path.first(path.size() - 1));
        if (above == "outerBoundaryIs" || above == "innerBoundaryIs")
            m_rings.push_back(std::move(*places));
        else
            add({.kind = parent == "Point" ? MapShape::Kind::Place : MapShape::Kind::Line,
                 .parts = {std::move(*places)}});
    }

    /** Adds the position of a gx:coord: longitude, latitude and height, separated by blanks. */
    void addPose(const std::string& text)
    {
        std::string tuple(trimmed(text));
        for (char& c : tuple)
            c = c == ' ' || c == '\t' ? ',' : c;
        if (const auto places = placesOfTuples(tuple); places && places->size() == 1)
            m_track.push_back(places->front());
        else
            m_isSpoiled = true;
    }

    void add(MapShape shape)
    {
        if (shape.parts.empty() || shape.parts.front().empty())
            return;
        m_budget.takeRow(memoryOf(shape) + sizeof(std::string) + kLongestName);
        m_shapes.push_back(std::move(shape));
        m_urls.emplace_back();
    }

    void finish()
    {
        for (std::size_t i = m_first; i < m_shapes.size(); ++i) {
            setStyle(m_shapes[i], m_own);
            m_urls[i] = m_url;
            if (m_shapes[i].kind == MapShape::Kind::Place)
                m_shapes[i].name = m_name;
        }
    }

    /** Sets the colours that the shape does not have yet. */
    static void setStyle(MapShape& shape, const ShapeStyle& style)
    {
        shape.fill = shape.fill ? shape.fill : style.fill;
        shape.line = shape.line ? shape.line : style.line;
    }

    [[nodiscard]] ShapeStyle styleOf(const std::string& url) const
    {
        const auto alias = m_aliases.find(url);
        const auto found = m_styles.find(alias == m_aliases.end() ? url : alias->second);
        return found == m_styles.end() ? ShapeStyle() : found->second;
    }

    std::string_view m_text;
    ReadBudget& m_budget;
    std::vector<MapShape> m_shapes;
    std::vector<std::string> m_urls; ///< urls of the styles of the shapes
    std::map<std::string, ShapeStyle> m_styles;
    std::map<std::string, std::string> m_aliases; ///< normal styles of style maps
    // State of the open element:
    std::string m_name;
    std::string m_url;
    ShapeStyle m_own;
    std::size_t m_first = 0; ///< index of the first shape of the Placemark
    ShapeStyle m_style;
    std::string m_mapKey;
    std::string m_pairKey;
    std::string m_pairUrl;
    std::vector<std::vector<LatLon>> m_rings;
    std::vector<LatLon> m_track;
    bool m_isSpoiled = false; ///< a place of the polygon or track is invalid
};

std::vector<MapShape> shapesOf(std::string_view bytes, ReadBudget& budget)
{
    const std::string decoded = textOfXml(bytes, budget.subject());
    const std::string_view text = decoded.empty() ? bytes : std::string_view(decoded);
    if (isKml(text))
        return KmlShapes(text, budget).take();
    if (isUtf8(text) && isGeoJson(text))
        return GeoJsonShapes(budget).take(text);
    throw Error(ErrorCode::WrongFormat, budget.subject(),
                {IssueId::NotFormat, {"GeoJSON, KML or KMZ"}});
}

} // namespace

std::vector<MapShape> readMapShapes(std::string_view bytes, const std::string& subject,
                                    const std::stop_token& stop)
{
    ReadBudget budget(subject, bytes.size(), stop);
    return isZip(bytes) ? shapesOf(unzipped(bytes, ".kml", budget), budget)
                        : shapesOf(bytes, budget);
}

} // namespace berg
