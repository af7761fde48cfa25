#include "core/io/import/fields/json_members.h"

#include "core/io/import/fields/import_fields.h"
#include "core/io/import/fields/import_scene.h"
#include "core/io/text/byte_order_mark.h"

namespace berg {

const Json* memberOf(const Json* value, const char* name)
{
    if (value == nullptr || !value->is_object())
        return nullptr;
    const auto it = value->find(name);
    return it == value->end() ? nullptr : &*it;
}

const Json* arrayOf(const Json* value, const char* name)
{
    const Json* member = memberOf(value, name);
    return member != nullptr && member->is_array() ? member : nullptr;
}

const Json& listOf(const Json& value)
{
    static const Json kEmpty = Json::array();
    return value.is_array() ? value : kEmpty;
}

std::string textOf(const Json* value)
{
    return value != nullptr && value->is_string() ? value->get<std::string>() : std::string();
}

std::optional<double> numberAt(const Json* value, const char* name)
{
    const Json* number = memberOf(value, name);
    return number != nullptr && number->is_number() ? std::optional(number->get<double>())
                                                    : std::nullopt;
}

std::optional<LatLon> placeOf(const Json* position, AxisOrder order)
{
    if (position == nullptr || !position->is_array() || position->size() < 2 ||
        !(*position)[0].is_number() || !(*position)[1].is_number())
        return std::nullopt;
    const auto first_deg = (*position)[0].get<double>();
    const auto second_deg = (*position)[1].get<double>();
    return order == AxisOrder::LongitudeFirst ? scenePlace(second_deg, first_deg)
                                              : scenePlace(first_deg, second_deg);
}

std::optional<std::vector<LatLon>> placesOf(const Json* positions, AxisOrder order)
{
    if (positions == nullptr || !positions->is_array())
        return std::nullopt;
    std::vector<LatLon> places;
    for (const Json& position : *positions) {
        const std::optional<LatLon> place = placeOf(&position, order);
        if (!place)
            return std::nullopt;
        places.push_back(*place);
    }
    return places;
}

char firstOfJson(std::string_view text)
{
    std::string_view rest = trimmed(withoutByteOrderMark(trimmed(text)));
    if (rest.starts_with('\x1E'))
        rest = trimmed(rest.substr(1));
    return rest.empty() ? '\0' : rest.front();
}

} // namespace berg
