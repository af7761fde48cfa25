#include "core/io/import/maps/map_shapes.h"

#include "core/base/error.h"
#include "core/io/import/fields/import_fields.h"
#include "core/io/import/maps/feature_parsers.h"
#include "core/scenario/ice_chart.h"

namespace berg {

namespace {

constexpr std::uint32_t kIceOpacity = 0x99; // keeps the sea and its graticule visible

/**
 * Returns the WMO colour of the total concentration for a polygon of an ice chart with codes of
 * SIGRID-3, or nullopt if it has no such code.
 */
std::optional<std::uint32_t> iceColour(const Json* properties)
{
    const std::optional<int> total = chartCode(properties, "CT");
    const std::optional<double> tenths = total ? tenthsOfSigrid(*total) : std::nullopt;
    if (!tenths)
        return std::nullopt;
    const std::uint32_t rgb = wmoColour(classOf(
        {.concentration_tenths = tenths, .isFast = chartCode(properties, "FA") == kFastIce}));
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

/** Collects the shapes of one file. */
class ShapeList
{
public:
    explicit ShapeList(ReadBudget& budget) : m_budget(budget) {}

    std::vector<MapShape> take(std::string_view text, MapFormat format)
    {
        const KmlStyles styles = readMapFeatures(
            text, format, m_budget, [this](const FileFeature& feature) { add(feature); });
        for (std::size_t i = 0; i < m_shapes.size(); ++i) {
            const auto found = styles.find(m_styles[i]);
            const KmlStyle style = found == styles.end() ? KmlStyle() : found->second;
            m_shapes[i].fill = m_shapes[i].fill ? m_shapes[i].fill : style.fill;
            m_shapes[i].line = m_shapes[i].line ? m_shapes[i].line : style.stroke;
        }
        return std::move(m_shapes);
    }

private:
    void add(const FileFeature& feature)
    {
        const std::optional<std::uint32_t> fill =
            feature.fill ? feature.fill : iceColour(feature.properties);
        const std::string name = cleanText(
            feature.name.empty() ? textOf(memberOf(feature.properties, "name")) : feature.name,
            kLongestName);
        for (const FileShape& shape : feature.geometry().shapes) {
            const bool isPlaces = shape.kind == ShapeKind::Places;
            MapShape added{.kind = isPlaces                        ? MapShape::Kind::Place
                                   : shape.kind == ShapeKind::Area ? MapShape::Kind::Polygon
                                                                   : MapShape::Kind::Line,
                           .name = isPlaces ? name : std::string(),
                           .fill = fill,
                           .line = feature.stroke};
            for (std::size_t i = 0; i < shape.parts; ++i) {
                std::optional<std::vector<LatLon>> places = placesOf(shape, i);
                if (places && !places->empty())
                    added.parts.push_back(std::move(*places));
                else if (!isPlaces)
                    break;
                if (isPlaces || added.parts.size() == shape.parts)
                    store(added, feature.style);
            }
        }
    }

    void store(MapShape& added, const std::string& style)
    {
        if (added.parts.empty())
            return;
        m_shapes.push_back(added);
        added.parts.clear();
        m_styles.push_back(style);
        m_budget.takeRow(memoryOf(m_shapes.back()) + sizeof(std::string) + style.capacity());
    }

    ReadBudget& m_budget;
    std::vector<MapShape> m_shapes;
    std::vector<std::string> m_styles; ///< of the shapes
};

} // namespace

std::vector<MapShape> readMapShapes(std::string_view bytes, const std::string& subject,
                                    const std::stop_token& stop)
{
    ReadBudget budget(subject, bytes.size(), stop);
    const std::string decoded = textOfMap(bytes, budget);
    const std::string_view text = decoded.empty() ? bytes : std::string_view(decoded);
    const std::optional<MapFormat> format = mapFormatOf(text);
    if (!format)
        throw Error(ErrorCode::WrongFormat, subject,
                    {IssueId::NotFormat, {"GeoJSON, KML, KMZ or CZML"}});
    return ShapeList(budget).take(text, *format);
}

} // namespace berg
