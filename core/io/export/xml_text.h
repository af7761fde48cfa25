#pragma once

#include "core/io/export/export_content.h"

#include <string>
#include <string_view>
#include <vector>

namespace berg {

// Pieces of the XML that exports are made of. Texts go through `htmlText`, so that any name may
// stand in them.

/** `<name>text</name>`, the text escaped. */
[[nodiscard]] std::string xmlElement(std::string_view name, std::string_view text);

/** Latitude and longitude in [-180, 180) with nine decimals at most, never with an exponent. */
struct XmlPlace
{
    std::string latitude;
    std::string longitude;
};
[[nodiscard]] XmlPlace placeText(const LatLon& place);

/** ISO 8601 of an instant of the content; empty when it has no start. */
[[nodiscard]] std::string timeText(const ExportContent& content, double time_s);

/** What is known of an iceberg, for people: "berg-1: sigma 5.0 m2, ...". English. */
[[nodiscard]] std::string aboutText(const ExportContent& content, const ExportIceberg& iceberg);

/** A value for programs, for which the format has no element of its own. */
struct XmlData
{
    std::string_view name;
    std::string value;
};

// What imports read back. Velocities are true east and north.

/** `appears_in_s`: from the time of the iceberg on, for those to come. */
[[nodiscard]] std::vector<XmlData> dataOf(const ExportContent& content,
                                          const ExportIceberg& iceberg);
/** Of a UAV as its way begins. */
[[nodiscard]] std::vector<XmlData> dataOf(const ExportContent& content, const ExportUav& uav);
/** Of the asset; there must be one. */
[[nodiscard]] std::vector<XmlData> assetData(const ExportContent& content);
/** Heights of a no-fly area. */
[[nodiscard]] std::vector<XmlData> dataOf(const NoFlyArea& area);

} // namespace berg
