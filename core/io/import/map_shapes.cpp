#include "core/io/import/map_shapes.h"

#include "core/io/import/import_fields.h"
#include "core/io/import/import_geojson.h"
#include "core/io/import/import_xml.h"
#include "core/io/import/json_members.h"
#include "core/io/import/map_shapes_kml.h"
#include "core/io/text/zip_file.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace berg {

namespace {

constexpr std::uint32_t kIceOpacity = 0x99; // the sea and its graticule are seen through it

/** A number, or a text that is one. */
std::optional<double> numberOf(const Json* value)
{
    if (value != nullptr && value->is_number())
        return value->get<double>();
    return decimalOf(textOf(value));
}

/** "#rrggbb" with an opacity beside it. */
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
 * Of a polygon of an ice chart by its codes (SIGRID-3): the colour of the WMO for the total
 * concentration. None: it has no such code.
 */
std::optional<std::uint32_t> iceColour(const Json* properties)
{
    constexpr int kFastIce = 8;
    constexpr int kIceFree = 55;
    const auto code = [&](const char* name) -> std::optional<int> {
        const std::optional<double> value = numberOf(memberOf(properties, name));
        return value && *value >= 0 && *value < 99 ? std::optional(static_cast<int>(*value))
                                                   : std::nullopt;
    };
    const std::optional<int> total = code("CT");
    if (!total)
        return std::nullopt;
    const int tenths = *total / 10; // of a range its lower end
    std::uint32_t rgb = 0xFF0000;
    if (code("FA") == kFastIce)
        rgb = 0x969696;
    else if (*total == 0 || *total == kIceFree)
        rgb = 0x0064FF;
    else if (tenths == 0) // open and bergy water
        rgb = 0x96C8FF;
    else if (tenths <= 3)
        rgb = 0x8CFFA0;
    else if (tenths <= 6)
        rgb = 0xFFFF00;
    else if (tenths <= 8)
        rgb = 0xFF7D07;
    return kIceOpacity << 24U | rgb;
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
        m_budget.goOn();
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
        if (const Json* geometries = arrayOf(&geometry, "geometries"))
            for (const Json& one : *geometries)
                addGeometry(one);
        const Json* coordinates = arrayOf(&geometry, "coordinates");
        if (coordinates == nullptr)
            return;
        const std::string type = textOf(memberOf(&geometry, "type"));
        const std::span<const Json> entries(coordinates->get_ref<const Json::array_t&>());
        if (type == "Point")
            addPlace(*coordinates);
        else if (type == "MultiPoint")
            std::ranges::for_each(entries, [this](const Json& place) { addPlace(place); });
        else if (type == "LineString")
            add(Kind::Line, {coordinates, 1});
        else if (type == "MultiLineString")
            std::ranges::for_each(entries, [this](const Json& line) {
                add(Kind::Line, {&line, 1});
            });
        else if (type == "Polygon")
            add(Kind::Polygon, entries);
        else if (type == "MultiPolygon")
            for (const Json& rings : entries)
                if (rings.is_array())
                    add(Kind::Polygon, rings.get_ref<const Json::array_t&>());
    }

    void addPlace(const Json& position)
    {
        if (const std::optional<LatLon> place = placeOf(&position, AxisOrder::LongitudeFirst))
            keep(MapShape::Kind::Place, {{*place}}, m_model.name);
    }

    /** Nothing when one of the places is none. */
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
            keep(kind, std::move(parts), {});
    }

    void keep(MapShape::Kind kind, std::vector<std::vector<LatLon>> parts, const std::string& name)
    {
        m_shapes.push_back({.kind = kind,
                            .parts = std::move(parts),
                            .name = name,
                            .fill = m_model.fill,
                            .line = m_model.line});
        m_budget.takeRow(memoryOf(m_shapes.back()));
    }

    ReadBudget& m_budget;
    MapShape m_model; ///< name and colours of the feature
    std::vector<MapShape> m_shapes;
};

std::vector<MapShape> shapesOf(std::string_view bytes, ReadBudget& budget)
{
    if (isKml(bytes))
        return readKmlShapes(bytes, budget);
    if (isUtf8(bytes) && isGeoJson(bytes))
        return GeoJsonShapes(budget).take(bytes);
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
