#include "core/io/export/maps/map_json.h"
#include "core/io/export/maps/map_writers.h"
#include "core/io/text/export_numbers.h"
#include "core/io/text/json_writer.h"

#include <algorithm>

namespace berg {

namespace {

using Json = nlohmann::ordered_json;

/** Height up to which an area without a ceiling is drawn. */
constexpr double kDrawnCeiling_m = 1000;

Json colour(const Rgb& rgb, int alpha = 255)
{
    Json json;
    json["rgba"] = {rgb.red, rgb.green, rgb.blue, alpha};
    return json;
}

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
        for (const MapFeature& feature : mapFeatures(m_content))
            std::visit([&](const auto& geometry) { add(feature, geometry); }, feature.geometry);
        m_put("\n]\n");
    }

private:
    void put(Json packet)
    {
        const JsonTreeGuard later(packet);
        m_put((m_isFirst ? "" : ",\n") + jsonText(packet));
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
        put(std::move(packet));
    }

    static Json packetOf(const MapFeature& feature)
    {
        Json packet;
        packet["id"] = feature.key.empty() ? feature.kind : feature.kind + '/' + feature.key;
        packet["name"] = feature.title;
        addProperties(packet["properties"], flatProperties(feature));
        return packet;
    }

    static void addPoint(Json& packet, int size_px, const Rgb& rgb)
    {
        packet["point"]["pixelSize"] = size_px;
        packet["point"]["color"] = colour(rgb);
    }

    void add(const MapFeature& feature, const Point& place_m)
    {
        if (feature.kind == "uav") // its path shows the start
            return;
        Json packet = packetOf(feature);
        Json& place = packet["position"]["cartographicDegrees"] = Json::array();
        append(place, place_m, feature.altitude_m);
        addPoint(packet, 8, styleOf(feature).colour);
        if (feature.kind != "visit") { // whose iceberg has a label
            Json& label = packet["label"];
            label["text"] = feature.title;
            label["font"] = "12px sans-serif";
            label["horizontalOrigin"] = "LEFT";
            label["pixelOffset"]["cartesian2"] = {10, 0};
        }
        put(std::move(packet));
    }

    void add(const MapFeature& feature, const MapOutline& outline)
    {
        const FeatureKind style = styleOf(feature);
        Json corners = Json::array();
        for (const Point& corner_m : outline.corners_m)
            append(corners, corner_m, 0);
        Json packet = packetOf(feature);
        const bool hasHeights = style.drawn == KindDrawing::Filled || feature.kind == "airspace" ||
                                outline.ceiling_m.has_value();
        if (!hasHeights) {
            append(corners, outline.corners_m.front(), 0);
            packet["polyline"]["positions"]["cartographicDegrees"] = std::move(corners);
            packet["polyline"]["width"] = 2;
            packet["polyline"]["material"] = solid(style.colour);
        } else {
            Json& polygon = packet["polygon"];
            polygon["positions"]["cartographicDegrees"] = std::move(corners);
            polygon["height"] = outline.floor_m;
            polygon["extrudedHeight"] =
                outline.ceiling_m.value_or(std::max(kDrawnCeiling_m, 2 * outline.floor_m));
            if (style.drawn == KindDrawing::Filled)
                polygon["material"] = solid(style.colour, 64);
            else
                polygon["fill"] = false;
            polygon["outline"] = true;
            polygon["outlineColor"] = colour(style.colour);
        }
        put(std::move(packet));
    }

    void add(const MapFeature& feature, const ExportUav* uav)
    {
        TimedPoint start;
        std::size_t points = 0;
        eachPoint(*uav, [&](const TimedPoint& point) { start = points++ == 0 ? point : start; });
        const double end_s = endOf(*uav).time_s;
        const bool isMoving = m_content.start && points > 1 && end_s > start.time_s;
        const Rgb rgb = styleOf(feature).colour;
        Json packet = packetOf(feature);
        addPoint(packet, 10, rgb);
        if (isMoving) {
            packet["availability"] = interval(start.time_s, end_s);
        } else {
            Json& place = packet["position"]["cartographicDegrees"] = Json::array();
            append(place, start.position_m, uav->uav.spec.altitude_m);
        }
        Json line;
        line["width"] = 3;
        line["material"] = solid(rgb);
        std::string head = jsonText(packet);
        head.pop_back(); // the closing brace
        m_put(",\n" + head);
        if (isMoving) {
            m_put(R"(,"position":{"epoch":)" + jsonText(utcText(*m_content.start, 0)) +
                  R"(,"cartographicDegrees":[)");
            addMoving(*uav);
            m_put(R"(]},"path":)" + jsonText(line) + '}');
        } else {
            m_put(R"(,"polyline":{"positions":{"cartographicDegrees":[)");
            addNumbers(*uav, [](Json&, const TimedPoint&) { return true; });
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
