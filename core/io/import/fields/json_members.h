#pragma once

// Private to core/io: members of foreign files, which may be missing or of any type.

#include "core/earth/geodesy.h"
#include "core/io/text/json_reader.h"

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace berg {

/**
 * Returns the first character of a JSON text, which is '{' for an object and '[' for a list, or 0
 * if there is none. A byte order mark and the record separator of RFC 8142 in front are skipped.
 */
[[nodiscard]] char firstOfJson(std::string_view text);
/** Returns a member of an object, or null if it is missing or `value` is not an object. */
[[nodiscard]] const Json* memberOf(const Json* value, const char* name);
/** Returns a member that is an array, or null otherwise. */
[[nodiscard]] const Json* arrayOf(const Json* value, const char* name);
/** Returns the value itself if it is an array, else an empty array. */
[[nodiscard]] const Json& listOf(const Json& value);
/** Returns the text of the value; empty if it is not a text. */
[[nodiscard]] std::string textOf(const Json* value);
/** Returns the member as a number, or nullopt if it is not one. */
[[nodiscard]] std::optional<double> numberAt(const Json* value, const char* name);

/** Calls `use` for each entry and then frees its memory for the objects made from it. */
template <class Use>
void forEachReleased(std::span<Json> entries, ReadBudget& budget, Use use)
{
    const std::size_t each = entries.empty() ? 0 : budget.memory() / entries.size();
    for (Json& entry : entries) {
        use(std::as_const(entry));
        release(entry);
        budget.release(each);
    }
}

/** Order of the coordinates of a position. */
enum class AxisOrder
{
    LongitudeFirst, ///< GeoJSON
    LatitudeFirst   ///< QGroundControl
};

/** Returns the place of a position (`scenePlace`), or nullopt if it is not one. */
[[nodiscard]] std::optional<LatLon> placeOf(const Json* position, AxisOrder order);
/** Returns all places of a list, or nullopt if one of them is not a place. */
[[nodiscard]] std::optional<std::vector<LatLon>> placesOf(const Json* positions, AxisOrder order);

} // namespace berg
