#include "core/io/export/maps/czml.h"

#include "core/io/export/maps/uav_colours.h"
#include "core/io/export/maps/xml_text.h"
#include "core/io/text/export_numbers.h"
#include "core/io/text/json_writer.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <charconv>

namespace berg {

namespace {

using Json = nlohmann::ordered_json;

Json colour(const Rgb& rgb, int alpha = 255)
{
    Json json;
    json["rgba"] = {rgb.red, rgb.green, rgb.blue, alpha};
    return json;
}

constexpr Rgb kIceColour{120, 200, 240};
constexpr Rgb kAssetColour{220, 60, 60};
constexpr Rgb kAreaColour{128, 128, 128};
constexpr Rgb kClosedColour{200, 40, 40};
/** Height up to which an area without a ceiling is drawn. */
constexpr double kDrawnCeiling_m = 1000;

Json solid(const Rgb& rgb, int alpha = 255)
{
    Json material;
    material["solidColor"]["color"] = colour(rgb, alpha);
    return material;
}

class CzmlWriter
{
public:
    CzmlWriter(const ExportContent& content, const TextSink& put) : m_content(content), m_put(put)
    {
    }

    void write()
    {
        m_put("[\n");
        addDocument();
        for (const ExportIceberg& now : m_content.icebergs)
            if (now.isListed)
                addIceberg(now);
        addArea();
        for (std::size_t i = 0; i < m_content.noFly.size(); ++i)
            addClosed("no-fly/" + std::to_string(i), m_content.noFly[i]);
        if (m_content.standoff)
            addClosed("stand-off", *m_content.standoff);
        if (m_content.asset) {
            Json packet =
                marker("asset", m_content.asset->name.empty() ? "Asset" : m_content.asset->name,
                       assetPlace_m(m_content), kAssetColour);
            addProperties(packet, assetData(m_content));
            add(std::move(packet));
        }
        for (const ExportUav& uav : m_content.uavs) {
            Json packet = marker("home/" + uav.uav.id, "Home of " + titleOf(uav.uav), uav.home_m,
                                 uavColour(uav.row));
            addProperties(packet, dataOf(m_content, uav));
            add(std::move(packet));
            addUav(uav);
        }
        m_put("\n]\n");
    }

private:
    void add(Json packet)
    {
        const JsonTreeGuard later(packet);
        addText(jsonText(packet));
    }

    void addText(const std::string& begin)
    {
        m_put(m_isFirst ? begin : ",\n" + begin);
        m_isFirst = false;
    }

    void append(Json& list, const Point& position_m, double altitude_m) const
    {
        const LatLon place = roundedPlace(m_content.frame.toGeographic(position_m));
        list.push_back(place.longitude_deg);
        list.push_back(place.latitude_deg);
        list.push_back(altitude_m);
    }

    /** ISO 8601 interval of the paths; the content must have a start time. */
    [[nodiscard]] std::string interval(double from_s, double to_s) const
    {
        return utcText(*m_content.start, from_s) + '/' + utcText(*m_content.start, to_s);
    }

    void addDocument()
    {
        Json packet;
        packet["id"] = "document";
        packet["name"] = m_content.name.empty() ? "Bergwatch" : m_content.name;
        packet["version"] = "1.0";
        if (m_content.start) {
            double from_s = m_content.now_s;
            double to_s = m_content.now_s + 1; // an interval is never empty
            for (const ExportUav& uav : m_content.uavs) {
                from_s = std::min(from_s, uav.start_s);
                to_s = std::max(to_s, endOf(uav).time_s);
            }
            Json& clock = packet["clock"];
            clock["interval"] = interval(from_s, to_s);
            clock["currentTime"] = utcText(*m_content.start, from_s);
            clock["multiplier"] = 10;
        }
        add(std::move(packet));
    }

    [[nodiscard]] Json marker(const std::string& id, const std::string& name,
                              const Point& position_m, const Rgb& rgb) const
    {
        Json packet;
        packet["id"] = id;
        packet["name"] = name;
        Json place = Json::array();
        append(place, position_m, 0);
        packet["position"]["cartographicDegrees"] = std::move(place);
        packet["point"]["pixelSize"] = 8;
        packet["point"]["color"] = colour(rgb);
        packet["label"]["text"] = name;
        packet["label"]["font"] = "12px sans-serif";
        packet["label"]["horizontalOrigin"] = "LEFT";
        packet["label"]["pixelOffset"]["cartesian2"] = {10, 0};
        return packet;
    }

    /** Adds the values that imports read back, numbers as such, and the time they apply to. */
    void addProperties(Json& packet, const std::vector<XmlData>& data) const
    {
        constexpr std::array<std::string_view, 3> kTexts{"id", "name", "state"};
        Json& properties = packet["properties"];
        for (const XmlData& item : data) {
            const bool isText = std::ranges::find(kTexts, item.name) != kTexts.end();
            properties[std::string(item.name)] = isText ? Json(item.value) : numberOf(item.value);
        }
        if (m_content.start)
            properties["time"] = utcText(*m_content.start, m_content.now_s);
    }

    static Json numberOf(const std::string& text)
    {
        double value = 0;
        std::from_chars(text.data(), text.data() + text.size(), value);
        return value;
    }

    void addIceberg(const ExportIceberg& now)
    {
        Json packet =
            marker("iceberg/" + now.iceberg.id, titleOf(now.iceberg), now.position_m, kIceColour);
        addProperties(packet, dataOf(m_content, now));
        add(std::move(packet));
    }

    void addArea()
    {
        if (m_content.area_m.empty())
            return;
        Json outline = Json::array();
        for (const Point& corner_m : m_content.area_m)
            append(outline, corner_m, 0);
        append(outline, m_content.area_m.front(), 0);
        Json packet;
        packet["id"] = "area";
        packet["name"] = "Area";
        packet["properties"]["geofence"] = m_content.geofence;
        packet["polyline"]["positions"]["cartographicDegrees"] = std::move(outline);
        packet["polyline"]["width"] = 2;
        packet["polyline"]["material"] = solid(kAreaColour);
        add(std::move(packet));
    }

    void addClosed(const std::string& id, const NoFlyArea& area)
    {
        Json corners = Json::array();
        for (const Point& corner_m : area.corners_m)
            append(corners, corner_m, 0);
        Json packet;
        packet["id"] = id;
        packet["name"] = area.name.empty() ? "No-fly area" : area.name;
        addProperties(packet, dataOf(area));
        Json& polygon = packet["polygon"];
        polygon["positions"]["cartographicDegrees"] = std::move(corners);
        polygon["height"] = area.floor_m;
        polygon["extrudedHeight"] =
            area.ceiling_m.value_or(std::max(kDrawnCeiling_m, 2 * area.floor_m));
        polygon["material"] = solid(kClosedColour, 64);
        polygon["outline"] = true;
        polygon["outlineColor"] = colour(kClosedColour);
        add(std::move(packet));
    }

    void addUav(const ExportUav& uav)
    {
        TimedPoint start;
        std::size_t points = 0;
        eachPoint(uav, [&](const TimedPoint& point) { start = points++ == 0 ? point : start; });
        const double end_s = endOf(uav).time_s;
        const bool isMoving = m_content.start && points > 1 && end_s > start.time_s;
        const double altitude_m = uav.uav.spec.altitude_m;
        const Rgb rgb = uavColour(uav.row);
        Json packet;
        packet["id"] = "uav/" + uav.uav.id;
        packet["name"] = titleOf(uav.uav);
        packet["point"]["pixelSize"] = 10;
        packet["point"]["color"] = colour(rgb);
        packet["properties"]["airspeed_mps"] = uav.uav.spec.airspeed_mps;
        packet["properties"]["altitude_m"] = altitude_m;
        if (isMoving) {
            packet["availability"] = interval(start.time_s, end_s);
        } else {
            Json place = Json::array();
            append(place, start.position_m, altitude_m);
            packet["position"]["cartographicDegrees"] = std::move(place);
        }
        Json line;
        line["width"] = 3;
        line["material"] = solid(rgb);
        std::string head = jsonText(packet);
        head.pop_back(); // the closing brace
        addText(head);
        if (isMoving) {
            m_put(R"(,"position":{"epoch":)" + jsonText(utcText(*m_content.start, 0)) +
                  R"(,"cartographicDegrees":[)");
            addMoving(uav);
            m_put(R"(]},"path":)" + jsonText(line) + '}');
        } else {
            m_put(R"(,"polyline":{"positions":{"cartographicDegrees":[)");
            addNumbers(uav, [](Json&, const TimedPoint&) { return true; });
            m_put("]}," + jsonText(line).substr(1) + '}');
        }
    }

    /** Adds samples at rising times, as Cesium accepts only one sample per instant. */
    void addMoving(const ExportUav& uav) const
    {
        std::optional<double> last_s;
        addNumbers(uav, [&last_s](Json& sample, const TimedPoint& point) {
            const double time_s = roundedSeconds(point.time_s);
            if (last_s && time_s <= *last_s)
                return false;
            last_s = time_s;
            sample.push_back(time_s);
            return true;
        });
    }

    /** Adds the numbers of each point for which `begin` returns true. */
    template <class Begin>
    void addNumbers(const ExportUav& uav, const Begin& begin) const
    {
        bool isFirst = true;
        eachPoint(uav, [&](const TimedPoint& point) {
            Json sample = Json::array();
            if (!begin(sample, point))
                return;
            append(sample, point.position_m, uav.uav.spec.altitude_m);
            std::string text = jsonText(sample);
            text.front() = isFirst ? ' ' : ',';
            text.pop_back();
            m_put(std::string_view(text).substr(isFirst ? 1 : 0));
            isFirst = false;
        });
    }

    const ExportContent& m_content;
    const TextSink& m_put;
    bool m_isFirst = true;
};

} // namespace

void writeCzml(const ExportContent& content, const TextSink& put)
{
    CzmlWriter(content, put).write();
}

} // namespace berg
