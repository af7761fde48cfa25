#pragma once

// Private to core/io: what the readers of KML and GPX share.

#include "core/io/import/import_fields.h"
#include "core/io/import/import_formats.h"
#include "core/io/text/xml_reader.h"

#include <map>

namespace berg {

/** Name of the element's parent, empty for the root. */
[[nodiscard]] std::string_view parentName(XmlPath path);
/** An id or, where something else is the id, the name. */
void setName(FieldTexts& texts, const std::string& name);
/** None when the texts are no place. */
[[nodiscard]] std::optional<LatLon> placeOf(const FieldTexts& texts);
/**
 * Of the `coordinates` of KML: longitude, latitude and perhaps a height, tuples set apart by
 * blanks. None when one of them is no place.
 */
[[nodiscard]] std::optional<std::vector<LatLon>> placesOfTuples(std::string_view tuples);

/** Values that an export of our own has for programs, by their names. */
using OwnData = std::map<std::string, std::string, std::less<>>;
[[nodiscard]] std::variant<Sighting, RejectedRow> withData(std::variant<Sighting, RejectedRow> row,
                                                           const OwnData& data);

/** A mark of an export of our own that is no iceberg. */
struct OwnMark
{
    const std::string& title;
    std::optional<LatLon> place;
    std::optional<UtcTime> time = {};
    const OwnData& data;
};
/** The UAV whose home it is. */
void addOwnUav(FileScene& scene, const OwnMark& home);
/** A finding when it has no place. */
void addOwnAsset(FileScene& scene, const OwnMark& asset);
/** Without its outline. */
[[nodiscard]] SceneArea ownArea(const OwnData& data, bool isNoFly);

/** Whether `name` is the first element of the text. */
[[nodiscard]] bool rootIs(std::string_view text, std::string_view name);

} // namespace berg
