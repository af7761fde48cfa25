#include "core/io/export/maps/gpx.h"

#include "core/base/number_text.h"
#include "core/io/export/maps/xml_text.h"
#include "core/io/text/export_numbers.h"
#include "core/io/text/html_text.h"

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
    std::string tag;
    Point position_m = Point::Zero();
    std::optional<double> altitude_m = {};
    std::optional<double> time_s = {};
    std::string name = {};
    std::string description = {};
    std::string type = {};
    std::string extensions = {}; ///< XML
};

std::string extensionsOf(const std::vector<XmlData>& data)
{
    std::string text;
    for (const XmlData& item : data)
        text += xmlElement("berg:" + std::string(item.name), item.value);
    return text;
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
        addWaypoints();
        for (const ExportUav& uav : m_content.uavs)
            if (m_content.what != ExportScope::Track)
                addRoute(uav);
        for (const ExportUav& uav : m_content.uavs)
            if (!uav.track.empty())
                addTrack(uav);
        m_put("</gpx>\n");
    }

private:
    void add(const GpxPoint& point)
    {
        const XmlPlace place = placeText(m_content.frame.toGeographic(point.position_m));
        m_put("<" + point.tag + " lat=\"" + place.latitude + "\" lon=\"" + place.longitude + "\">");
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
        if (!point.extensions.empty())
            m_put("<extensions>" + point.extensions + "</extensions>");
        m_put("</" + point.tag + ">\n");
    }

    void addWaypoints()
    {
        for (const ExportIceberg& now : m_content.icebergs)
            if (now.isListed)
                add({.tag = "wpt",
                     .position_m = now.position_m,
                     .altitude_m = 0,
                     .time_s = m_content.now_s,
                     .name = titleOf(now.iceberg),
                     .description = aboutText(m_content, now),
                     .type = "iceberg",
                     .extensions = extensionsOf(dataOf(m_content, now))});
        for (const ExportUav& uav : m_content.uavs)
            add({.tag = "wpt",
                 .position_m = uav.home_m,
                 .altitude_m = 0,
                 .name = "Home of " + titleOf(uav.uav),
                 .type = "home",
                 .extensions = extensionsOf(dataOf(m_content, uav))});
        if (m_content.asset)
            add({.tag = "wpt",
                 .position_m = assetPlace_m(m_content),
                 .altitude_m = 0,
                 .time_s = m_content.now_s,
                 .name = m_content.asset->name.empty() ? "Asset" : m_content.asset->name,
                 .type = "asset",
                 .extensions = extensionsOf(assetData(m_content))});
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

    void addTrack(const ExportUav& uav)
    {
        m_put("<trk>" + xmlElement("name", titleOf(uav.uav)) +
              xmlElement("type", nameOf(kExportScopeNames, m_content.what)) + "<trkseg>\n");
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
