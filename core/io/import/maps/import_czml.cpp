#include "core/base/error.h"
#include "core/io/export/content/feature_kinds.h"
#include "core/io/import/maps/feature_parsers.h"
#include "core/io/import/maps/feature_sightings.h"
#include "core/io/import/maps/map_readers.h"
#include "core/io/text/json_writer.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

namespace berg {

namespace {

constexpr std::size_t kPlaceNumbers = 3;  ///< longitude, latitude, height
constexpr std::size_t kSampleNumbers = 4; ///< a time before them

/** Returns the list of longitude, latitude and height, or of a time before each; may be null. */
const Json* czmlDegrees(const Json* positions)
{
    return arrayOf(positions, "cartographicDegrees");
}

/** Returns the place of two numbers, which `more` others must follow. */
FilePlace icebergIn(const Json& degrees, std::size_t longitude, std::size_t more = 0)
{
    if (longitude + 1 + more >= degrees.size() || !degrees[longitude].is_number() ||
        !degrees[longitude + 1].is_number())
        return {.fault = IssueId::NoPosition};
    return {.longitude = jsonText(degrees[longitude]),
            .latitude = jsonText(degrees[longitude + 1])};
}

/** Returns a line, or an area with one outline, of a list of places (may be null). */
FileShape shapeOf(ShapeKind kind, const Json* degrees)
{
    const std::size_t size = degrees == nullptr ? 0 : degrees->size();
    return {.kind = kind,
            .parts = degrees == nullptr ? 0U : 1U,
            .icebergs = {.count = (size + kPlaceNumbers - 1) / kPlaceNumbers,
                         .at = [degrees](std::size_t i) {
                             return icebergIn(*degrees, i * kPlaceNumbers, 1);
                         }}};
}

/** Returns a place of a moving packet, whose time is a text or counts from the epoch. */
FilePlace sampleAt(const Json& degrees, std::size_t first, const std::optional<UtcTime>& epoch)
{
    constexpr double kLongest_s = 1e9;
    FilePlace place = icebergIn(degrees, first + 1);
    const Json& time = degrees[first];
    if (time.is_string())
        place.time = time.get<std::string>();
    else if (epoch && time.is_number() && std::abs(time.get<double>()) < kLongest_s)
        place.time = utcText(*epoch, time.get<double>());
    return place;
}

FileGeometry geometryOfPacket(const Json& packet, bool isArea)
{
    FileGeometry geometry{.hasIcebergAreas = false};
    std::vector<FileShape>& shapes = geometry.shapes;
    if (const Json* line = memberOf(memberOf(&packet, "polyline"), "positions"))
        shapes.push_back(shapeOf(isArea ? ShapeKind::Area : ShapeKind::Line, czmlDegrees(line)));
    if (const Json* outline = memberOf(memberOf(&packet, "polygon"), "positions"))
        shapes.push_back(shapeOf(ShapeKind::Area, czmlDegrees(outline)));
    const Json* const position = memberOf(&packet, "position");
    const Json* const degrees = czmlDegrees(position);
    if (degrees == nullptr) {
        geometry.broken = position == nullptr ? 0 : 1;
    } else if (degrees->size() > kPlaceNumbers) {
        FileShape& track = shapes.emplace_back(FileShape{.kind = ShapeKind::Track});
        track.icebergs = {
            .count = degrees->size() / kSampleNumbers,
            .at = [degrees, epoch = parseUtc(textOf(memberOf(position, "epoch")))](std::size_t i) {
                return sampleAt(*degrees, i * kSampleNumbers, epoch);
            }};
        geometry.broken = degrees->size() % kSampleNumbers == 0 ? 0 : 1;
    } else { // beside a line or an area it is the place of a label
        FileShape& place = shapes.emplace_back();
        place.parts = shapes.size() == 1 ? 1 : 0;
        place.icebergs = {.count = 1,
                          .at = [degrees](std::size_t) { return icebergIn(*degrees, 0); }};
    }
    return geometry;
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

void setColours(FileFeature& feature, const Json& packet)
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

void readCzmlFeatures(std::string_view text, ReadBudget& budget,
                      const std::function<void(const FileFeature&)>& use)
{
    ParsedJson file = parseJson(text, budget);
    if (!file.root.is_array())
        throw Error(ErrorCode::WrongFormat, budget.subject(),
                    {IssueId::WrongType, {ValueKind::Array, kindOf(file.root)}});
    const bool isOwn = isOwnExport(text);
    std::size_t number = 0;
    forEachReleased(file.root.get_ref<Json::array_t&>(), budget, [&](const Json& packet) {
        budget.throwIfStopped();
        FileFeature feature;
        feature.line = ++number;
        feature.isOwn = isOwn;
        feature.id = textOf(memberOf(&packet, "id"));
        feature.name = textOf(memberOf(&packet, "name"));
        feature.properties = memberOf(&packet, "properties");
        if (isOwn)
            feature.kind = featureKind(feature.properties, feature.id);
        const FeatureKind* const kind = findKind(feature.kind);
        feature.geometry = [&packet, isArea = kind != nullptr && kind->drawn != KindDrawing::Mark] {
            return geometryOfPacket(packet, isArea);
        };
        setColours(feature, packet);
        if (feature.id != "document")
            use(feature);
    });
}

SightingTable readCzml(const ImportText& source)
{
    FeatureSightings found(source, placeIn(MapFormat::Czml));
    readCzmlFeatures(source.text, source.budget,
                     [&found](const FileFeature& feature) { found.add(feature); });
    return found.take();
}

bool isCzml(std::string_view text)
{
    constexpr std::size_t kHead = 4096;
    return trimmed(text).starts_with('[') &&
           text.substr(0, kHead).find("\"document\"") != std::string_view::npos;
}

} // namespace berg
