#include "core/io/import/fields/file_feature.h"

#include "core/io/export/content/feature_kinds.h"
#include "core/io/import/fields/import_fields.h"
#include "core/io/import/fields/import_scene.h"
#include "core/io/text/json_writer.h"

namespace berg {

std::string featureKind(const Json* properties, std::string_view mark)
{
    const Json* const given = memberOf(properties, "kind");
    if (const std::string kind = given == nullptr ? std::string() : cellText(*given); !kind.empty())
        return findKind(kind) == nullptr ? std::string() : kind;
    if (mark.starts_with('#'))
        mark.remove_prefix(1);
    if (mark.starts_with("uav-")) // style of a home, of visits and of paths
        return memberOf(properties, "airspeed_mps") == nullptr ? "path" : "home";
    const FeatureKind* const known = findKind(mark.substr(0, mark.find('/')));
    if (known == nullptr || known->inOldFiles == OldUse::None)
        return {};
    return known->inOldFiles == OldUse::Itself ? std::string(known->id) : "path";
}

std::optional<std::vector<LatLon>> placesOf(const FileShape& shape, std::size_t part)
{
    if (part >= shape.parts)
        return std::nullopt;
    if (shape.readPart)
        return shape.readPart(part);
    const bool isPlace = shape.kind == ShapeKind::Places;
    std::vector<LatLon> places;
    for (std::size_t i = isPlace ? part : 0; i < (isPlace ? part + 1 : shape.icebergs.count); ++i) {
        const FilePlace read = shape.icebergs.at(i);
        const std::optional<LatLon> place = scenePlaceOf(read.latitude, read.longitude);
        if (!place)
            return std::nullopt;
        places.push_back(*place);
    }
    return places;
}

std::optional<double> numberIn(const Json* value)
{
    if (value != nullptr && value->is_number())
        return value->get<double>();
    return decimalOf(textOf(value));
}

std::string cellText(const Json& value)
{
    if (value.is_string())
        return value.get<std::string>();
    if (value.is_number())
        return jsonText(value);
    for (const char* type : {"number", "string", "boolean"})
        if (const Json* wrapped = memberOf(&value, type); wrapped && !wrapped->is_structured())
            return wrapped->is_boolean() ? jsonText(*wrapped) : cellText(*wrapped);
    return {};
}

} // namespace berg
