#include "core/io/xml_text.h"

#include "core/io/export_numbers.h"
#include "core/io/html_text.h"
#include "core/io/number_text.h"

namespace berg {

std::string xmlElement(std::string_view name, std::string_view text)
{
    const std::string tag(name);
    return "<" + tag + ">" + htmlText(text) + "</" + tag + ">";
}

PlaceText placeText(const LatLon& place)
{
    const LatLon rounded = roundedPlace(place);
    return {.latitude = decimalText(rounded.latitude_deg),
            .longitude = decimalText(rounded.longitude_deg)};
}

std::string timeText(const ExportContent& content, double time_s)
{
    return content.start ? utcText(*content.start, time_s) : std::string();
}

std::string aboutText(const ExportIceberg& iceberg)
{
    return iceberg.iceberg.id + ": " + nameOf(kIcebergStateNames, iceberg.state) + ", sigma " +
           fixedText(iceberg.sigma_m2, 1) + " m2, radius " +
           fixedText(iceberg.iceberg.radius_m, 0) + " m, drift east " +
           fixedText(iceberg.drift_mps.x(), 2) + " m/s, north " +
           fixedText(iceberg.drift_mps.y(), 2) + " m/s";
}

} // namespace berg
