#pragma once

// Private to core/io: helpers of the readers of KML and GPX.

#include "core/io/import/fields/import_fields.h"
#include "core/io/import/fields/import_source.h"
#include "core/io/text/xml_reader.h"

#include <map>

namespace berg {

/** Returns the name of the element's parent, or an empty text for the root. */
[[nodiscard]] std::string_view parentName(XmlPath path);
/** Adds the name to the candidates for the id, and sets it as the name unless it is the id. */
void setName(FieldTexts& texts, const std::string& name);
/** Returns the place of the texts, or nullopt if they are not one. */
[[nodiscard]] std::optional<LatLon> placeOf(const FieldTexts& texts);
/**
 * Reads the `coordinates` of KML: tuples of longitude, latitude and optional height, separated by
 * blanks. Returns nullopt if one of them is not a place.
 */
[[nodiscard]] std::optional<std::vector<LatLon>> placesOfTuples(std::string_view tuples);

/** Values for programs in a Bergwatch export, by their names. */
using OwnData = std::map<std::string, std::string, std::less<>>;
/** Returns true if a value of this name is a component of a vector to true east and north. */
[[nodiscard]] bool isVectorPart(std::string_view name);
/** Returns the row with drift, appearance and change of drift of the data, if it has them. */
[[nodiscard]] std::variant<Sighting, RejectedRow>
withData(SightingTable& table, std::variant<Sighting, RejectedRow> row, const OwnData& data);

/** A placemark of a Bergwatch export other than an iceberg. */
struct OwnPlacemark
{
    const std::string& title;
    std::optional<LatLon> place;
    std::optional<UtcTime> time = {};
    const OwnData& data;
};
/** Adds the UAV whose home the placemark is; too many of them become a finding. */
void addOwnUav(FileScene& scene, const OwnPlacemark& home);
/** Adds the asset; it becomes a finding if it has no place. */
void addOwnAsset(FileScene& scene, const OwnPlacemark& asset);
/** Returns the area of the data without its outline. */
[[nodiscard]] SceneArea ownArea(const OwnData& data, bool isNoFly);

/** Returns true if `name` is the first element of the text, with any prefix. */
[[nodiscard]] bool rootIs(std::string_view text, std::string_view name);

/**
 * Returns KML or GPX in UTF-16 as UTF-8, and any other text that is not UTF-8 as `textOfBytes`
 * does, unless it is XML that declares an encoding which `readXml` may support. An empty result
 * means that the bytes are read as they are. Throws as `textOfBytes`.
 */
[[nodiscard]] std::string textOfXml(std::string_view bytes, const std::string& subject);

} // namespace berg
