#include "core/io/export/content/geo_shapes.h"
#include "core/io/export/maps/map_json.h"
#include "core/io/export/maps/map_writers.h"
#include "core/io/text/export_numbers.h"
#include "core/io/text/file_backed_buffer.h"
#include "core/io/text/json_writer.h"

#include <utility>

namespace berg {

namespace {

using Json = nlohmann::ordered_json;

Json coordinates(const LatLon& place)
{
    return {roundedDegrees(place.longitude_deg), roundedDegrees(place.latitude_deg)};
}

Json shape(const char* type, Json coordinates)
{
    Json geometry;
    geometry["type"] = type;
    geometry["coordinates"] = std::move(coordinates);
    return geometry;
}

/** Writes the features of one content. */
class Collection
{
public:
    /** With `flat`, properties are those that programs without lists can hold. */
    Collection(const ExportContent& content, const TextSink& put,
               std::optional<FlatProperties> flat = {})
        : m_content(content), m_put(put), m_flat(flat)
    {
    }

    void write()
    {
        m_put("{\"type\":\"FeatureCollection\",\"features\":[\n");
        for (const MapFeature& feature : mapFeatures(m_content))
            if (!feature.isAtStart)
                std::visit([&](const auto& geometry) { add(feature, geometry); }, feature.geometry);
        m_put("\n]}\n");
    }

private:
    [[nodiscard]] Json propertiesOf(const MapFeature& feature) const
    {
        Json properties;
        if (m_flat == FlatProperties::Layer) {
            properties["Layer"] = feature.kind;
            return properties;
        }
        if (m_flat) {
            addProperties(properties, flatProperties(feature));
            return properties;
        }
        properties["kind"] = feature.kind;
        addProperties(properties, feature.properties);
        return properties;
    }

    void addGeometry(Json geometry, const MapFeature& of)
    {
        Json feature;
        const JsonTreeGuard later(feature);
        feature["type"] = "Feature";
        feature["geometry"] = std::move(geometry);
        feature["properties"] = propertiesOf(of);
        addText(jsonText(feature));
    }

    void addText(const std::string& begin)
    {
        m_put(m_isFirst ? begin : ",\n" + begin);
        m_isFirst = false;
    }

    void add(const MapFeature& feature, const Point& place_m)
    {
        const LatLon place = roundedPlace(m_content.frame.toGeographic(place_m));
        addGeometry(shape("Point", coordinates(place)), feature);
    }

    void add(const MapFeature& feature, const MapOutline& outline)
    {
        Json polygons = Json::array();
        for (const auto& ring : geographicPolygon(m_content.frame, outline.corners_m)) {
            Json exterior = Json::array();
            for (const LatLon& place : ring)
                exterior.push_back(coordinates(place));
            polygons.push_back(Json::array({std::move(exterior)}));
        }
        addGeometry(polygons.size() == 1 ? shape("Polygon", std::move(polygons[0]))
                                         : shape("MultiPolygon", std::move(polygons)),
                    feature);
    }

    /**
     * Writes a LineString, or a MultiLineString with nested times; the times follow after the last
     * place.
     */
    void add(const MapFeature& feature, const ExportUav* uav)
    {
        const std::size_t parts = partsOf(m_content, *uav);
        if (parts == 0)
            return;
        const bool several = parts > 1;
        addText(std::string(R"({"type":"Feature","geometry":{"type":")") +
                (several ? "MultiLineString" : "LineString") + R"(","coordinates":)" +
                (several ? "[" : ""));
        FileBackedBuffer times;
        bool isOpen = false;
        eachPlace(m_content, *uav, [&](const TimedPlace& vertex, bool isFirst) {
            const char* const before = !isFirst ? "," : isOpen ? "],[" : "[";
            isOpen = true;
            m_put(before + jsonText(coordinates(vertex.place)));
            times.append(before + jsonText(m_content.start
                                               ? Json(utcText(*m_content.start, vertex.time_s))
                                               : Json(roundedSeconds(vertex.time_s))));
        });
        std::string properties = jsonText(propertiesOf(feature));
        if (m_flat) {
            m_put((several ? "]]}" : "]}") + std::string(R"(,"properties":)") + properties + '}');
            return;
        }
        properties.pop_back();
        m_put((several ? "]]}" : "]}") + std::string(R"(,"properties":)") + properties +
              R"(,"coordinateProperties":{")" + (m_content.start ? "times" : "times_s") +
              "\":" + (several ? "[" : ""));
        times.putAll(m_put);
        m_put(several ? "]]}}}" : "]}}}");
    }

    const ExportContent& m_content;
    const TextSink& m_put;
    std::optional<FlatProperties> m_flat;
    bool m_isFirst = true;
};

} // namespace

void writeGeoJson(const ExportContent& content, const TextSink& put)
{
    Collection(content, put).write();
}

void writeFlatGeoJson(const ExportContent& content, FlatProperties properties, const TextSink& put)
{
    Collection(content, put, properties).write();
}

} // namespace berg
