#pragma once

// Private to core/io: properties of features as JSON.

#include "core/io/export/maps/map_features.h"

#include <nlohmann/json.hpp>

#include <span>

namespace berg {

/** Adds each property to an object; vectors and lists become arrays. */
inline void addProperties(nlohmann::ordered_json& object, std::span<const MapProperty> properties)
{
    for (const MapProperty& property : properties)
        std::visit(
            [&](const auto& value) {
                if constexpr (std::is_same_v<std::decay_t<decltype(value)>, Point>)
                    object[property.name] = {value.x(), value.y()};
                else
                    object[property.name] = value;
            },
            property.value);
}

} // namespace berg
