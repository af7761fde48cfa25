#include "core/io/export/maps/xml_text.h"

#include "core/base/number_text.h"
#include "core/io/text/export_numbers.h"
#include "core/io/text/html_text.h"

namespace berg {

std::string xmlElement(std::string_view name, std::string_view text)
{
    const std::string tag(name);
    return "<" + tag + ">" + htmlText(text) + "</" + tag + ">";
}

XmlPlace placeText(const LatLon& place)
{
    const LatLon rounded = roundedPlace(place);
    return {.latitude = decimalText(rounded.latitude_deg),
            .longitude = decimalText(rounded.longitude_deg)};
}

std::string timeText(const ExportContent& content, double time_s)
{
    return content.start ? utcText(*content.start, time_s) : std::string();
}

std::string aboutText(const ExportContent& content, const ExportIceberg& iceberg)
{
    const Point drift_mps = eastNorth_mps(content, iceberg.drift_mps, iceberg.position_m);
    return iceberg.iceberg.id + ": " + nameOf(kIcebergStateNames, iceberg.state) + ", sigma " +
           fixedText(iceberg.sigma_m2, 1) + " m2, radius " +
           fixedText(iceberg.iceberg.radius_m, 0) + " m, drift east " +
           fixedText(drift_mps.x(), 2) + " m/s, north " + fixedText(drift_mps.y(), 2) + " m/s";
}

std::vector<XmlData> dataOf(const ExportContent& content, const ExportIceberg& iceberg)
{
    const Point drift_mps = eastNorth_mps(content, iceberg.drift_mps, iceberg.position_m);
    std::vector<XmlData> data{{"id", iceberg.iceberg.id},
                              {"state", nameOf(kIcebergStateNames, iceberg.state)},
                              {"sigma_m2", decimalText(iceberg.sigma_m2)},
                              {"q_m2ps", decimalText(iceberg.iceberg.q_m2ps)},
                              {"radius_m", decimalText(iceberg.iceberg.radius_m)},
                              {"drift_east_mps", decimalText(drift_mps.x())},
                              {"drift_north_mps", decimalText(drift_mps.y())}};
    for (const auto& [name, value] : driftData(content, iceberg))
        data.push_back({name, decimalText(value)});
    if (const double in_s = iceberg.iceberg.appears_s - content.now_s; in_s > 0)
        data.push_back({"appears_in_s", decimalText(in_s)});
    return data;
}

std::vector<XmlData> dataOf(const ExportContent& content, const ExportUav& uav)
{
    const XmlPlace start = placeText(content.frame.toGeographic(uav.uav.position_m));
    return {{"id", uav.uav.id},
            {"name", uav.uav.name},
            {"start_latitude_deg", start.latitude},
            {"start_longitude_deg", start.longitude},
            {"heading_deg",
             decimalText(trueHeading_deg(content, uav.uav.heading_deg, uav.uav.position_m))},
            {"airspeed_mps", decimalText(uav.uav.spec.airspeed_mps)},
            {"altitude_m", decimalText(uav.uav.spec.altitude_m)}};
}

std::vector<XmlData> assetData(const ExportContent& content)
{
    const Asset& asset = *content.asset;
    const Point velocity_mps = eastNorth_mps(content, asset.velocity_mps, assetPlace_m(content));
    std::vector<XmlData> data{{"name", asset.name},
                              {"velocity_east_mps", decimalText(velocity_mps.x())},
                              {"velocity_north_mps", decimalText(velocity_mps.y())},
                              {"range_m", decimalText(asset.range_m)}};
    if (asset.standoff_m > 0)
        data.push_back({"standoff_m", decimalText(asset.standoff_m)});
    if (asset.standoff_m > 0 && asset.standoffCeiling_m)
        data.push_back({"standoff_ceiling_m", decimalText(*asset.standoffCeiling_m)});
    return data;
}

std::vector<XmlData> dataOf(const NoFlyArea& area)
{
    std::vector<XmlData> data{{"name", area.name}, {"floor_m", decimalText(area.floor_m)}};
    if (area.ceiling_m)
        data.push_back({"ceiling_m", decimalText(*area.ceiling_m)});
    return data;
}

} // namespace berg
