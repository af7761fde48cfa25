#pragma once

// Private to core/io: helpers of the readers of KML and GPX.

#include "core/earth/geodesy.h"
#include "core/io/text/xml_reader.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace berg {

/** Returns the name of the element's parent, or an empty text for the root. */
[[nodiscard]] std::string_view parentName(XmlPath path);
/**
 * Reads the `coordinates` of KML: tuples of longitude, latitude and optional height, separated by
 * blanks. Returns nullopt if one of them is not a place.
 */
[[nodiscard]] std::optional<std::vector<LatLon>> placesOfTuples(std::string_view tuples);

/** Returns true if `name` is the first element of the text, with any prefix. */
[[nodiscard]] bool rootIs(std::string_view text, std::string_view name);

/**
 * Returns KML or GPX in UTF-16 as UTF-8, and any other text that is not UTF-8 as `textOfBytes`
 * does, unless it is XML that declares an encoding which `readXml` may support. An empty result
 * means that the bytes are read as they are. Throws as `textOfBytes`.
 */
[[nodiscard]] std::string textOfXml(std::string_view bytes, const std::string& subject);

} // namespace berg
