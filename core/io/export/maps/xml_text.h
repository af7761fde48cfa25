#pragma once

#include "core/io/export/content/export_content.h"

#include <string>
#include <string_view>
#include <vector>

namespace berg {

// Pieces of the XML of exports. Texts are escaped by `htmlText`, so any name is allowed in them.

/** Returns `<name>text</name>` with the text escaped. */
[[nodiscard]] std::string xmlElement(std::string_view name, std::string_view text);

/**
 * Latitude and longitude in [-180, 180) as texts with at most nine decimals, without an exponent.
 */
struct XmlPlace
{
    std::string latitude;
    std::string longitude;
};
/** Returns the texts of a place, rounded by `roundedPlace`. */
[[nodiscard]] XmlPlace placeText(const LatLon& place);

/** Returns the ISO 8601 text of an instant of the content; empty if it has no start time. */
[[nodiscard]] std::string timeText(const ExportContent& content, double time_s);

/**
 * Returns the data of an iceberg as an English text for people, such as "berg-1: tracked, sigma 5.0
 * m2, radius 20 m, drift east 0.10 m/s, north 0.00 m/s". The text is not escaped for XML.
 */
[[nodiscard]] std::string aboutText(const ExportContent& content, const ExportIceberg& iceberg);

/** Value for programs for which the format has no element of its own. */
struct XmlData
{
    std::string_view name;
    std::string value;
};

// Values that imports read back. Velocities are true east and north.

/**
 * Returns the data of an iceberg; `appears_in_s` counts from the time of the export, for icebergs
 * not yet there.
 */
[[nodiscard]] std::vector<XmlData> dataOf(const ExportContent& content,
                                          const ExportIceberg& iceberg);
/** Returns the data of a UAV at the start of its path. */
[[nodiscard]] std::vector<XmlData> dataOf(const ExportContent& content, const ExportUav& uav);
/** Returns the data of the asset, which the content must have. */
[[nodiscard]] std::vector<XmlData> assetData(const ExportContent& content);
/** Returns name and heights of a no-fly area. */
[[nodiscard]] std::vector<XmlData> dataOf(const NoFlyArea& area);

} // namespace berg
