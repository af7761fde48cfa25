#pragma once

// Private to core/io: members of files of others, which may be missing or of any type.

#include "core/base/geodesy.h"
#include "core/io/text/json_reader.h"

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace berg {

/** A member of an object; null when it is not there or `value` is no object. */
[[nodiscard]] const Json* memberOf(const Json* value, const char* name);
/** A member that is an array; null otherwise. */
[[nodiscard]] const Json* arrayOf(const Json* value, const char* name);
/** Empty when it is no text. */
[[nodiscard]] std::string textOf(const Json* value);
/** Its member that is a number. */
[[nodiscard]] std::optional<double> numberAt(const Json* value, const char* name);

/** The `kind` of a GeoJSON feature of ours by its properties (may be null); empty without. */
[[nodiscard]] std::string kindOf(const Json* properties);
/** Whether a feature with these properties makes a file one of our own. */
[[nodiscard]] bool isOwnGeoJson(const Json* properties);

/** Calls `use` for each entry, whose memory then is free for what was made of it. */
template <class Use>
void forEachReleased(std::span<Json> entries, ReadBudget& budget, Use use)
{
    const std::size_t each = entries.empty() ? 0 : budget.memory() / entries.size();
    for (Json& entry : entries) {
        use(std::as_const(entry));
        release(entry);
        budget.giveBack(each);
    }
}

enum class AxisOrder
{
    LongitudeFirst, ///< GeoJSON
    LatitudeFirst   ///< QGroundControl
};

/** A place, `scenePlace`; none when it is anything else. */
[[nodiscard]] std::optional<LatLon> placeOf(const Json* position, AxisOrder order);
/** All of them; none when one is no place. */
[[nodiscard]] std::optional<std::vector<LatLon>> placesOf(const Json* positions, AxisOrder order);

} // namespace berg
