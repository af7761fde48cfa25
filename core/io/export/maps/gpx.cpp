#include "core/io/export/maps/map_writers.h"
#include "core/io/export/maps/map_xml.h"
#include "core/io/text/export_numbers.h"

#include <cmath>

namespace berg {

namespace {

constexpr const char* kHead =
    "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
    "<gpx version=\"1.1\" creator=\"Bergwatch\" xmlns=\"http://www.topografix.com/GPX/1/1\" "
    "xmlns:berg=\"urn:bergwatch:gpx:1\">\n";

/** A point of GPX; the schema requires its children in this order. */
struct GpxPoint
{
    const char* tag = "";
    Point position_m = Point::Zero();
    std::optional<double> altitude_m = {};
    std::optional<double> time_s = {};
    std::string name = {};
    std::string description = {};
    std::string type = {};
    std::string extensions = {}; ///< XML
};

std::string extensionsOf(const MapFeature& feature)
{
    std::string text = "<extensions>";
    for (const MapProperty& property : flatProperties(feature))
        text += xmlElement("berg:" + property.name, valueText(property.value));
    return text + "</extensions>";
}

class GpxWriter
{
public:
    GpxWriter(const ExportContent& content, const TextSink& put) : m_content(content), m_put(put) {}

    void write()
    {
        m_put(kHead);
        m_put("<metadata>");
        if (!m_content.name.empty())
            m_put(xmlElement("name", m_content.name));
        if (m_content.start)
            m_put(xmlElement("time", timeText(m_content, m_content.now_s)));
        m_put("</metadata>\n");
        const std::vector<MapFeature> features = mapFeatures(m_content);
        for (const MapFeature& feature : features)
            if (const auto* place_m = std::get_if<Point>(&feature.geometry))
                addWaypoint(feature, *place_m);
        for (const ExportUav& uav : m_content.uavs)
            if (m_content.what != ExportScope::Track)
                addRoute(uav);
        for (const MapFeature& feature : features)
            if (const auto* uav = std::get_if<const ExportUav*>(&feature.geometry))
                addTrack(feature, **uav);
        m_put("</gpx>\n");
    }

private:
    void add(const GpxPoint& point)
    {
        const LatLon place = roundedPlace(m_content.frame.toGeographic(point.position_m));
        m_put(std::string("<") + point.tag + " lat=\"" + decimalText(place.latitude_deg) +
              "\" lon=\"" + decimalText(place.longitude_deg) + "\">");
        if (point.altitude_m)
            m_put(xmlElement("ele", decimalText(*point.altitude_m)));
        if (point.time_s && m_content.start)
            m_put(xmlElement("time", timeText(m_content, *point.time_s)));
        if (!point.name.empty())
            m_put(xmlElement("name", point.name));
        if (!point.description.empty())
            m_put(xmlElement("desc", point.description));
        if (!point.type.empty())
            m_put(xmlElement("type", point.type));
        m_put(point.extensions + "</" + point.tag + ">\n");
    }

    /** Adds a place that the routes do not show. */
    void addWaypoint(const MapFeature& feature, const Point& place_m)
    {
        if (feature.kind != "uav" && feature.kind != "visit")
            add({.tag = "wpt",
                 .position_m = place_m,
                 .altitude_m = feature.altitude_m,
                 .time_s = feature.time_s,
                 .name = feature.title,
                 .description = feature.about,
                 .type = feature.kind,
                 .extensions = extensionsOf(feature)});
    }

    void addRoute(const ExportUav& uav)
    {
        m_put("<rte>" + xmlElement("name", titleOf(uav.uav)) + "\n");
        add({.tag = "rtept",
             .position_m = uav.uav.position_m,
             .altitude_m = uav.uav.spec.altitude_m,
             .time_s = uav.start_s,
             .name = titleOf(uav.uav),
             .type = "start"});
        for (const Visit& visit : uav.visits)
            add({.tag = "rtept",
                 .position_m = visit.position_m,
                 .altitude_m = uav.uav.spec.altitude_m,
                 .time_s = visit.time_s,
                 .name = titleOf(m_content, visit),
                 .type = visit.iceberg ? "visit" : "home"});
        m_put("</rte>\n");
    }

    void addTrack(const MapFeature& feature, const ExportUav& uav)
    {
        if (uav.track.empty())
            return;
        m_put("<trk>" + xmlElement("name", feature.title) + xmlElement("type", feature.kind) +
              extensionsOf(feature) + "<trkseg>\n");
        std::optional<double> last_deg;
        for (const TrackPoint& point : uav.track) {
            const double here_deg =
                m_content.frame.toGeographic(point.state.position_m).longitude_deg;
            if (last_deg && std::abs(here_deg - *last_deg) > 180)
                m_put("</trkseg><trkseg>\n");
            last_deg = here_deg;
            add({.tag = "trkpt",
                 .position_m = point.state.position_m,
                 .altitude_m = uav.uav.spec.altitude_m,
                 .time_s = point.time_s});
        }
        m_put("</trkseg></trk>\n");
    }

    const ExportContent& m_content;
    const TextSink& m_put;
};

} // namespace

void writeGpx(const ExportContent& content, const TextSink& put)
{
    GpxWriter(content, put).write();
}

} // namespace berg
