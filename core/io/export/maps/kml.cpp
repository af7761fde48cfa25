#include "core/io/export/maps/kml.h"

#include "core/base/number_text.h"
#include "core/io/export/maps/uav_colours.h"
#include "core/io/export/maps/xml_text.h"
#include "core/io/text/export_numbers.h"
#include "core/io/text/file_backed_buffer.h"
#include "core/io/text/zip_file.h"
#include "core/permit/airspace.h"

#include <array>
#include <cmath>

namespace berg {

namespace {

constexpr const char* kHead = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
                              "<kml xmlns=\"http://www.opengis.net/kml/2.2\" "
                              "xmlns:gx=\"http://www.google.com/kml/ext/2.2\">\n<Document>\n";

/** Colour as `aabbggrr`. */
std::string colourText(const Rgb& colour)
{
    constexpr std::string_view kDigits = "0123456789abcdef";
    std::string text = "ff";
    for (const unsigned part :
         {unsigned{colour.blue}, unsigned{colour.green}, unsigned{colour.red}})
        (text += kDigits[part / 16U]) += kDigits[part % 16U];
    return text;
}

std::string styleId(const ExportUav& uav)
{
    return "uav-" + std::to_string(uav.row);
}

/**
 * Text `longitude,latitude,altitude`, or with another separator; +180 is kept at the end of a cut
 * line.
 */
std::string coordinates(const LatLon& place, double altitude_m, char separator)
{
    return decimalText(roundedDegrees(place.longitude_deg)) + separator +
           decimalText(roundedDegrees(place.latitude_deg)) + separator + decimalText(altitude_m);
}

std::string altitudeMode(double altitude_m)
{
    return altitude_m > 0 ? "<altitudeMode>relativeToGround</altitudeMode>" : std::string();
}

std::string extendedData(const std::vector<XmlData>& data)
{
    std::string text;
    for (const XmlData& item : data)
        text += "<Data name=\"" + std::string(item.name) + "\">" + xmlElement("value", item.value) +
                "</Data>";
    return text.empty() ? text : "<ExtendedData>" + text + "</ExtendedData>";
}

std::string closedStyle(const std::string& id)
{
    return "<Style id=\"" + id +
           "\"><LineStyle><color>ff2828c8</color><width>2</width></LineStyle>"
           "<PolyStyle><color>402828c8</color></PolyStyle></Style>\n";
}

/** Colours from the inside outwards: green, amber, red, grey. */
constexpr std::array<const char*, kVolumeParts> kVolumeColours{"ff50a028", "ff1ea0f0", "ff2828c8",
                                                               "ff787878"};

std::string outlineStyle(const std::string& id, const std::string& colour)
{
    return "<Style id=\"" + id + "\"><LineStyle><color>" + colour +
           "</color><width>2</width></LineStyle><PolyStyle><fill>0</fill></PolyStyle></Style>\n";
}

class KmlWriter
{
public:
    KmlWriter(const ExportContent& content, const TextSink& put) : m_content(content), m_put(put) {}

    void write()
    {
        m_put(kHead);
        m_put(xmlElement("name", m_content.name.empty() ? "Bergwatch" : m_content.name) + "\n");
        addStyles();
        addArea();
        for (const NoFlyArea& area : m_content.noFly)
            addClosed(area, "no-fly", area.name.empty() ? "No-fly area" : area.name);
        if (m_content.standoff)
            addClosed(*m_content.standoff, "stand-off", "Stand-off " + m_content.standoff->name);
        addAirspace();
        if (m_content.operation)
            addOperation(*m_content.operation);
        m_put("<Folder><name>Icebergs</name>\n");
        for (const ExportIceberg& now : m_content.icebergs)
            if (now.isListed)
                addIceberg(now);
        m_put("</Folder>\n");
        if (m_content.asset)
            addPoint({.name = m_content.asset->name.empty() ? "Asset" : m_content.asset->name,
                      .style = "asset",
                      .position_m = assetPlace_m(m_content),
                      .time_s = m_content.now_s,
                      .data = assetData(m_content)});
        for (const ExportUav& uav : m_content.uavs)
            addUav(uav);
        m_put("</Document>\n</kml>\n");
    }

private:
    struct Marker
    {
        std::string name;
        std::string style;
        Point position_m = Point::Zero();
        double altitude_m = 0;
        std::optional<double> time_s = {};
        std::string description = {};
        std::vector<XmlData> data = {};
    };

    void addPoint(const Marker& marker)
    {
        m_put("<Placemark>" + xmlElement("name", marker.name));
        if (!marker.description.empty())
            m_put(xmlElement("description", marker.description));
        if (marker.time_s && m_content.start)
            m_put("<TimeStamp>" + xmlElement("when", timeText(m_content, *marker.time_s)) +
                  "</TimeStamp>");
        m_put(xmlElement("styleUrl", "#" + marker.style));
        m_put(extendedData(marker.data));
        const LatLon place = roundedPlace(m_content.frame.toGeographic(marker.position_m));
        m_put("<Point>" + altitudeMode(marker.altitude_m) + "<coordinates>" +
              coordinates(place, marker.altitude_m, ',') + "</coordinates></Point></Placemark>\n");
    }

    void addStyles()
    {
        const auto point = [&](const std::string& id, const std::string& colour) {
            m_put("<Style id=\"" + id + "\"><IconStyle><color>" + colour +
                  "</color><scale>0.8</scale></IconStyle></Style>\n");
        };
        point("iceberg", "fff0c878");
        point("asset", "ff3c3cdc");
        m_put(outlineStyle("area", "ff808080"));
        if (!m_content.scenario->airspace.empty())
            m_put(outlineStyle("airspace", "ffc87830"));
        if (m_content.operation)
            for (std::size_t part = 0; part < kVolumeParts; ++part)
                m_put(outlineStyle(std::string(kVolumePartIds[part]), kVolumeColours[part]));
        if (!m_content.noFly.empty())
            m_put(closedStyle("no-fly"));
        if (m_content.standoff)
            m_put(closedStyle("stand-off"));
        for (const ExportUav& uav : m_content.uavs) {
            const std::string colour = "<color>" + colourText(uavColour(uav.row)) + "</color>";
            std::string style = "<Style id=\"" + styleId(uav) + "\"><IconStyle>";
            style.append(colour).append("<scale>0.6</scale></IconStyle><LineStyle>");
            style.append(colour).append("<width>3</width></LineStyle></Style>\n");
            m_put(style);
        }
    }

    void addIceberg(const ExportIceberg& now)
    {
        addPoint({.name = titleOf(now.iceberg),
                  .style = "iceberg",
                  .position_m = now.position_m,
                  .time_s = m_content.now_s,
                  .description = aboutText(m_content, now),
                  .data = dataOf(m_content, now)});
    }

    void addArea()
    {
        if (m_content.area_m.empty())
            return;
        m_put("<Placemark><name>Area</name><styleUrl>#area</styleUrl>" +
              extendedData({{"geofence", m_content.geofence ? "true" : "false"}}) +
              "<MultiGeometry>");
        addPolygons(m_content.area_m, "<tessellate>1</tessellate>", 0);
        m_put("</MultiGeometry></Placemark>\n");
    }

    /**
     * Adds an area that extends from the sea to its ceiling; one with a floor is drawn at its
     * floor.
     */
    void addClosed(const NoFlyArea& area, const std::string& style, const std::string& title)
    {
        const double height_m = area.floor_m > 0 ? area.floor_m : area.ceiling_m.value_or(0);
        std::string mode = "<tessellate>1</tessellate>";
        if (height_m > 0)
            mode = (area.floor_m > 0 ? "" : "<extrude>1</extrude>") + altitudeMode(height_m);
        m_put("<Placemark>" + xmlElement("name", title) + "<styleUrl>#" + style + "</styleUrl>" +
              extendedData(dataOf(area)) + "<MultiGeometry>");
        addPolygons(area.corners_m, mode, height_m);
        m_put("</MultiGeometry></Placemark>\n");
    }

    void addAirspace()
    {
        if (m_content.scenario->airspace.empty())
            return;
        m_put("<Folder><name>Airspace</name>\n");
        for (const AirspaceArea& area : m_content.scenario->airspace) {
            std::vector<XmlData> data = dataOf(
                NoFlyArea{.name = area.name, .floor_m = area.floor_m, .ceiling_m = area.ceiling_m});
            data.push_back({"class", area.kind});
            if (!area.fromUtc.empty())
                data.push_back({"from_utc", area.fromUtc});
            if (!area.untilUtc.empty())
                data.push_back({"until_utc", area.untilUtc});
            const std::string title = titleOf(area);
            addOutline({.title = title.empty() ? "Airspace" : title,
                        .style = "airspace",
                        .corners_m = area.corners_m,
                        .height_m = area.floor_m,
                        .data = std::move(data)});
        }
        m_put("</Folder>\n");
    }

    void addOperation(const OperationVolume& volume)
    {
        constexpr std::array<const char*, kVolumeParts> kTitles{
            "Flight geography", "Contingency volume", "Ground-risk buffer", "Adjacent area"};
        m_put("<Folder>" + xmlElement("name", kVolumeTitle) + "\n");
        for (std::size_t part = 0; part < kVolumeParts; ++part) {
            const auto top_m = volume.top_m(static_cast<VolumePart>(part));
            std::vector<XmlData> data;
            if (top_m)
                data.push_back({"ceiling_m", decimalText(std::round(*top_m * 10) / 10)});
            addOutline({.title = kTitles[part],
                        .style = std::string(kVolumePartIds[part]),
                        .corners_m = volume.outlines_m[part],
                        .height_m = top_m.value_or(0),
                        .isSolid = true,
                        .data = std::move(data)});
        }
        m_put("</Folder>\n");
    }

    struct Outline
    {
        std::string title;
        std::string style;
        const std::vector<Point>& corners_m;
        double height_m = 0;
        bool isSolid = false; ///< extends from the sea up to the height
        std::vector<XmlData> data = {};
    };

    void addOutline(const Outline& outline)
    {
        std::string mode = "<tessellate>1</tessellate>";
        if (outline.height_m > 0)
            mode = (outline.isSolid ? "<extrude>1</extrude>" : "") + altitudeMode(outline.height_m);
        m_put("<Placemark>" + xmlElement("name", outline.title) + "<styleUrl>#" + outline.style +
              "</styleUrl>" + extendedData(outline.data) + "<MultiGeometry>");
        addPolygons(outline.corners_m, mode, outline.height_m);
        m_put("</MultiGeometry></Placemark>\n");
    }

    void addPolygons(const std::vector<Point>& corners_m, const std::string& mode, double height_m)
    {
        for (const std::vector<LatLon>& ring : geographicPolygon(m_content.frame, corners_m)) {
            m_put("<Polygon>" + mode + "<outerBoundaryIs><LinearRing><coordinates>");
            for (const LatLon& corner : ring)
                m_put(coordinates(corner, height_m, ',') + "\n");
            m_put("</coordinates></LinearRing></outerBoundaryIs></Polygon>");
        }
    }

    void addUav(const ExportUav& uav)
    {
        m_put("<Folder>" + xmlElement("name", titleOf(uav.uav)) + "\n");
        addPoint({.name = "Home of " + titleOf(uav.uav),
                  .style = styleId(uav),
                  .position_m = uav.home_m,
                  .data = dataOf(m_content, uav)});
        for (const Visit& visit : uav.visits)
            if (visit.iceberg)
                addPoint({.name = titleOf(m_content, visit),
                          .style = styleId(uav),
                          .position_m = visit.position_m,
                          .altitude_m = uav.uav.spec.altitude_m,
                          .time_s = visit.time_s});
        if (const std::size_t parts = partsOf(m_content, uav); parts > 0)
            addPath(uav, parts);
        m_put("</Folder>\n");
    }

    void addPath(const ExportUav& uav, std::size_t parts)
    {
        const bool timed = m_content.start && !uav.track.empty();
        m_put("<Placemark>" + xmlElement("name", titleOf(uav.uav)) +
              xmlElement("styleUrl", "#" + styleId(uav)));
        if (parts > 1)
            m_put(timed ? "<gx:MultiTrack><gx:interpolate>0</gx:interpolate>" : "<MultiGeometry>");
        timed ? addTracks(uav) : addLines(uav);
        if (parts > 1)
            m_put(timed ? "</gx:MultiTrack>" : "</MultiGeometry>");
        m_put("</Placemark>\n");
    }

    /**
     * Adds a path with times. All times of a part precede its places, which are buffered meanwhile.
     */
    void addTracks(const ExportUav& uav)
    {
        const double altitude_m = uav.uav.spec.altitude_m;
        FileBackedBuffer places;
        const auto endPart = [&] {
            places.putAll(m_put);
            places.clear();
            m_put("</gx:Track>");
        };
        eachVertex(uav, "<gx:Track>" + altitudeMode(altitude_m) + "\n", endPart,
                   [&](const TimedPlace& vertex) {
                       m_put(xmlElement("when", timeText(m_content, vertex.time_s)) + "\n");
                       places.append("<gx:coord>" + coordinates(vertex.place, altitude_m, ' ') +
                                     "</gx:coord>\n");
                   });
    }

    void addLines(const ExportUav& uav)
    {
        const double altitude_m = uav.uav.spec.altitude_m;
        eachVertex(
            uav, "<LineString>" + altitudeMode(altitude_m) + "<coordinates>",
            [this] { m_put("</coordinates></LineString>"); },
            [&](const TimedPlace& vertex) {
                m_put(coordinates(vertex.place, altitude_m, ',') + "\n");
            });
    }

    template <class End, class Add>
    void eachVertex(const ExportUav& uav, const std::string& begin, const End& end, const Add& add)
    {
        bool isOpen = false;
        eachPlace(m_content, uav, [&](const TimedPlace& vertex, bool isFirst) {
            if (isFirst && isOpen)
                end();
            if (isFirst)
                m_put(begin);
            isOpen = true;
            add(vertex);
        });
        if (isOpen)
            end();
    }

    const ExportContent& m_content;
    const TextSink& m_put;
};

} // namespace

void writeKml(const ExportContent& content, const TextSink& put)
{
    KmlWriter(content, put).write();
}

void writeKmz(const ExportContent& content, const TextSink& put)
{
    writeZip(
        "doc.kml", [&content](const TextSink& putText) { writeKml(content, putText); }, put);
}

} // namespace berg
