#include "core/io/export/maps/map_writers.h"
#include "core/io/export/maps/map_xml.h"
#include "core/io/text/export_numbers.h"
#include "core/io/text/file_backed_buffer.h"
#include "core/io/text/zip_file.h"

#include <set>

namespace berg {

namespace {

constexpr const char* kHead = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
                              "<kml xmlns=\"http://www.opengis.net/kml/2.2\" "
                              "xmlns:gx=\"http://www.google.com/kml/ext/2.2\">\n<Document>\n";

/** Colour as `aabbggrr`; `alpha` is two digits. */
std::string colourElement(const char* alpha, const Rgb& colour)
{
    constexpr std::string_view kDigits = "0123456789abcdef";
    std::string text = alpha;
    for (const unsigned part :
         {unsigned{colour.blue}, unsigned{colour.green}, unsigned{colour.red}})
        (text += kDigits[part / 16U]) += kDigits[part % 16U];
    return xmlElement("color", text);
}

std::string styleId(const MapFeature& feature)
{
    return feature.uav ? "uav-" + std::to_string(*feature.uav) : feature.kind;
}

std::string styleElement(const MapFeature& feature)
{
    const FeatureKind style = styleOf(feature);
    const std::string colour = colourElement("ff", style.colour);
    std::string text = "<Style id=\"" + styleId(feature) + "\">";
    if (!std::holds_alternative<MapOutline>(feature.geometry))
        text += "<IconStyle>" + colour + (feature.uav ? "<scale>0.6" : "<scale>0.8") +
                "</scale></IconStyle>";
    if (feature.uav)
        text += "<LineStyle>" + colour + "<width>3</width></LineStyle>";
    if (std::holds_alternative<MapOutline>(feature.geometry))
        text += "<LineStyle>" + colour + "<width>2</width></LineStyle><PolyStyle>" +
                (style.drawn == KindDrawing::Filled ? colourElement("40", style.colour)
                                                    : "<fill>0</fill>") +
                "</PolyStyle>";
    return text + "</Style>\n";
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

std::string extendedData(const MapFeature& feature)
{
    std::string text = "<ExtendedData>";
    for (const MapProperty& property : flatProperties(feature))
        text += "<Data name=\"" + property.name + "\">" +
                xmlElement("value", valueText(property.value)) + "</Data>";
    return text + "</ExtendedData>";
}

class KmlWriter
{
public:
    KmlWriter(const ExportContent& content, const TextSink& put) : m_content(content), m_put(put) {}

    void write()
    {
        m_put(kHead);
        m_put(xmlElement("name", m_content.name.empty() ? "Bergwatch" : m_content.name) + "\n");
        const std::vector<MapFeature> features = mapFeatures(m_content);
        std::set<std::string> styles;
        for (const MapFeature& feature : features)
            if (styles.insert(styleId(feature)).second)
                m_put(styleElement(feature));
        std::string folder;
        for (const MapFeature& feature : features) {
            if (feature.folder != folder && !folder.empty())
                m_put("</Folder>\n");
            if (feature.folder != folder && !feature.folder.empty())
                m_put("<Folder>" + xmlElement("name", feature.folder) + "\n");
            folder = feature.folder;
            std::visit([&](const auto& geometry) { add(feature, geometry); }, feature.geometry);
        }
        m_put(folder.empty() ? "</Document>\n</kml>\n" : "</Folder>\n</Document>\n</kml>\n");
    }

private:
    /** Writes a Placemark with the geometry that `putGeometry` writes. */
    template <class Put>
    void addPlacemark(const MapFeature& feature, const Put& putGeometry)
    {
        m_put("<Placemark>" + xmlElement("name", feature.title));
        if (!feature.about.empty())
            m_put(xmlElement("description", feature.about));
        if (feature.time_s && m_content.start)
            m_put("<TimeStamp>" + xmlElement("when", timeText(m_content, *feature.time_s)) +
                  "</TimeStamp>");
        m_put(xmlElement("styleUrl", "#" + styleId(feature)) + extendedData(feature));
        putGeometry();
        m_put("</Placemark>\n");
    }

    void add(const MapFeature& feature, const Point& place_m)
    {
        if (feature.kind == "uav") // its path shows the start
            return;
        const LatLon place = roundedPlace(m_content.frame.toGeographic(place_m));
        addPlacemark(feature, [&] {
            m_put("<Point>" + altitudeMode(feature.altitude_m) + "<coordinates>" +
                  coordinates(place, feature.altitude_m, ',') + "</coordinates></Point>");
        });
    }

    /**
     * Adds an area that extends from the sea to its ceiling; one with a floor is drawn at its
     * floor, and so is airspace, which may be high.
     */
    void add(const MapFeature& feature, const MapOutline& outline)
    {
        const bool isLow = outline.floor_m <= 0 && feature.kind != "airspace";
        const double height_m = isLow ? outline.ceiling_m.value_or(0) : outline.floor_m;
        std::string mode = "<tessellate>1</tessellate>";
        if (height_m > 0)
            mode = (isLow ? "<extrude>1</extrude>" : "") + altitudeMode(height_m);
        addPlacemark(feature, [&] {
            m_put("<MultiGeometry>");
            for (const auto& ring : geographicPolygon(m_content.frame, outline.corners_m)) {
                m_put("<Polygon>" + mode + "<outerBoundaryIs><LinearRing><coordinates>");
                for (const LatLon& corner : ring)
                    m_put(coordinates(corner, height_m, ',') + "\n");
                m_put("</coordinates></LinearRing></outerBoundaryIs></Polygon>");
            }
            m_put("</MultiGeometry>");
        });
    }

    void add(const MapFeature& feature, const ExportUav* uav)
    {
        const std::size_t parts = partsOf(m_content, *uav);
        if (parts == 0)
            return;
        const bool timed = m_content.start && !uav->track.empty();
        addPlacemark(feature, [&] {
            if (parts > 1)
                m_put(timed ? "<gx:MultiTrack><gx:interpolate>0</gx:interpolate>"
                            : "<MultiGeometry>");
            timed ? addTracks(*uav) : addLines(*uav);
            if (parts > 1)
                m_put(timed ? "</gx:MultiTrack>" : "</MultiGeometry>");
        });
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
