#include "core/base/error.h"
#include "core/io/export/content/feature_kinds.h"
#include "core/io/import/fields/feature_scene.h"
#include "core/io/import/fields/import_scene.h"
#include "core/io/import/maps/feature_parsers.h"

#include <algorithm>
#include <initializer_list>

namespace berg {

namespace {

constexpr std::size_t kPlaceNumbers = 3;  ///< longitude, latitude, height
constexpr std::size_t kSampleNumbers = 4; ///< a time before them

/** Returns the place whose longitude is at the index, or nullopt if there is none. */
std::optional<LatLon> placeAt(const Json& degrees, std::size_t longitude)
{
    if (longitude + 1 >= degrees.size() || !degrees[longitude].is_number() ||
        !degrees[longitude + 1].is_number())
        return std::nullopt;
    return scenePlace(degrees[longitude + 1].get<double>(), degrees[longitude].get<double>());
}

/** Returns a shape of all places of a list, each of `step` numbers. */
FileShape shapeOf(FileShape::Kind kind, const Json* degrees, std::size_t step = kPlaceNumbers)
{
    return {.kind = kind,
            .placesOf = [degrees, step](std::size_t) -> std::optional<std::vector<LatLon>> {
                std::vector<LatLon> places;
                for (std::size_t i = step - kPlaceNumbers; degrees && i < degrees->size();
                     i += step)
                    if (const std::optional<LatLon> place = placeAt(*degrees, i))
                        places.push_back(*place);
                if (degrees == nullptr || places.size() * step != degrees->size())
                    return std::nullopt;
                return places;
            }};
}

std::vector<FileShape> shapesOfPacket(const Json& packet, bool isArea)
{
    using Kind = FileShape::Kind;
    std::vector<FileShape> shapes;
    if (const Json* line = memberOf(memberOf(&packet, "polyline"), "positions"))
        shapes.push_back(shapeOf(isArea ? Kind::Area : Kind::Line, czmlDegrees(line)));
    if (const Json* outline = memberOf(memberOf(&packet, "polygon"), "positions"))
        shapes.push_back(shapeOf(Kind::Area, czmlDegrees(outline)));
    const Json* const degrees = czmlDegrees(memberOf(&packet, "position"));
    if (degrees != nullptr && degrees->size() > kPlaceNumbers)
        shapes.push_back(shapeOf(Kind::Line, degrees, kSampleNumbers));
    else if (degrees != nullptr && shapes.empty())
        shapes.push_back({.placesOf = [degrees](std::size_t) -> std::optional<std::vector<LatLon>> {
            const std::optional<LatLon> place = placeAt(*degrees, 0);
            return place ? std::optional(std::vector{*place}) : std::nullopt;
        }});
    return shapes;
}

/** Returns the member at the end of a path, or null. */
const Json* memberAt(const Json* value, std::initializer_list<const char*> path)
{
    for (const char* name : path)
        value = memberOf(value, name);
    return value;
}

/** Returns a colour of four numbers from 0 to 255, or nullopt. */
std::optional<std::uint32_t> colourIn(const Json* colour)
{
    const Json* const rgba = arrayOf(colour, "rgba");
    if (rgba == nullptr || rgba->size() != 4 ||
        !std::ranges::all_of(*rgba, [](const Json& part) { return part.is_number(); }))
        return std::nullopt;
    const auto part = [rgba](std::size_t i) {
        return static_cast<std::uint32_t>(std::clamp((*rgba)[i].get<double>(), 0.0, 255.0));
    };
    return part(3) << 24U | part(0) << 16U | part(1) << 8U | part(2);
}

void setColours(CzmlFeature& feature, const Json& packet)
{
    const Json* const polygon = memberOf(&packet, "polygon");
    const Json* const isFilled = memberOf(polygon, "fill");
    feature.fill = colourIn(memberAt(polygon, {"material", "solidColor", "color"}));
    if (isFilled != nullptr && isFilled->is_boolean() && !isFilled->get<bool>())
        feature.fill = 0;
    feature.stroke = colourIn(memberOf(polygon, "outlineColor"));
    for (const char* line : {"polyline", "path"})
        if (!feature.stroke)
            feature.stroke = colourIn(memberAt(&packet, {line, "material", "solidColor", "color"}));
}

} // namespace

const Json* czmlDegrees(const Json* positions)
{
    return arrayOf(positions, "cartographicDegrees");
}

void readCzmlFeatures(std::string_view text, ReadBudget& budget,
                      const std::function<void(const CzmlFeature&)>& use)
{
    ParsedJson file = parseJson(text, budget);
    if (!file.root.is_array())
        throw Error(ErrorCode::WrongFormat, budget.subject(),
                    {IssueId::WrongType, {ValueKind::Array, kindOf(file.root)}});
    const bool isOwn = isOwnExport(text);
    std::size_t number = 0;
    forEachReleased(file.root.get_ref<Json::array_t&>(), budget, [&](const Json& packet) {
        budget.throwIfStopped();
        CzmlFeature feature;
        feature.line = ++number;
        feature.isOwn = isOwn;
        feature.id = textOf(memberOf(&packet, "id"));
        feature.name = textOf(memberOf(&packet, "name"));
        feature.properties = memberOf(&packet, "properties");
        feature.position = memberOf(&packet, "position");
        if (isOwn)
            feature.kind = featureKind(feature.properties, feature.id);
        const FeatureKind* const kind = findKind(feature.kind);
        feature.shapes = [&packet, isArea = kind != nullptr && kind->isArea] {
            return shapesOfPacket(packet, isArea);
        };
        setColours(feature, packet);
        if (feature.id != "document")
            use(feature);
    });
}

} // namespace berg
