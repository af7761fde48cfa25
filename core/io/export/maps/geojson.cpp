#include "core/io/export/maps/geojson.h"

#include "core/io/export/content/geo_shapes.h"
#include "core/io/text/export_numbers.h"
#include "core/io/text/file_backed_buffer.h"
#include "core/io/text/json_writer.h"

#include <nlohmann/json.hpp>

#include <cmath>

namespace berg {

namespace {

using Json = nlohmann::ordered_json;

Json coordinates(const LatLon& place)
{
    return {roundedDegrees(place.longitude_deg), roundedDegrees(place.latitude_deg)};
}

Json pair(const Point& vector)
{
    return {vector.x(), vector.y()};
}

const char* featureKind(ExportScope what)
{
    switch (what) {
    case ExportScope::FirstLeg:
    case ExportScope::Order:
        return "plan";
    case ExportScope::Path:
        return "path";
    case ExportScope::Track:
        return "track";
    }
    return "";
}

/** Writes the features of one content. */
class Collection
{
public:
    Collection(const ExportContent& content, const TextSink& put) : m_content(content), m_put(put)
    {
    }

    void write()
    {
        m_put("{\"type\":\"FeatureCollection\",\"features\":[\n");
        for (const ExportUav& uav : m_content.uavs)
            addUav(uav);
        for (const ExportIceberg& iceberg : m_content.icebergs)
            if (iceberg.isListed)
                addIceberg(iceberg);
        for (const ExportUav& uav : m_content.uavs) {
            addVisits(uav);
            addLine(uav);
        }
        addArea();
        for (const NoFlyArea& area : m_content.noFly)
            addClosed(area, "no-fly");
        if (m_content.standoff)
            addClosed(*m_content.standoff, "stand-off");
        for (const AirspaceArea& area : m_content.scenario->airspace)
            addAirspace(area);
        if (m_content.operation)
            addOperation(*m_content.operation);
        addAsset();
        m_put("\n]}\n");
    }

private:
    void add(Json geometry, Json properties)
    {
        Json feature;
        const JsonTreeGuard later(feature);
        feature["type"] = "Feature";
        feature["geometry"] = std::move(geometry);
        feature["properties"] = std::move(properties);
        addText(jsonText(feature));
    }

    void addText(const std::string& begin)
    {
        m_put(m_isFirst ? begin : ",\n" + begin);
        m_isFirst = false;
    }

    static Json shape(const char* type, Json coordinates)
    {
        Json geometry;
        geometry["type"] = type;
        geometry["coordinates"] = std::move(coordinates);
        return geometry;
    }

    [[nodiscard]] Json point(const Point& position_m) const
    {
        return shape("Point", coordinates(roundedPlace(m_content.frame.toGeographic(position_m))));
    }

    void addTime(Json& properties, double time_s) const
    {
        properties["time_s"] = roundedSeconds(time_s);
        if (m_content.start)
            properties["time"] = utcText(*m_content.start, time_s);
    }

    void addUav(const ExportUav& uav)
    {
        Json properties;
        properties["kind"] = "uav";
        properties["id"] = uav.uav.id;
        properties["name"] = uav.uav.name;
        addTime(properties, uav.start_s);
        properties["heading_deg"] =
            trueHeading_deg(m_content, uav.uav.heading_deg, uav.uav.position_m);
        properties["airspeed_mps"] = uav.uav.spec.airspeed_mps;
        properties["altitude_m"] = uav.uav.spec.altitude_m;
        add(point(uav.uav.position_m), std::move(properties));
        if (uav.home_m == uav.uav.position_m)
            return;
        Json home;
        home["kind"] = "home";
        home["uav"] = uav.uav.id;
        add(point(uav.home_m), std::move(home));
    }

    void addIceberg(const ExportIceberg& now)
    {
        Json properties;
        properties["kind"] = "iceberg";
        properties["id"] = now.iceberg.id;
        properties["name"] = now.iceberg.name;
        addTime(properties, m_content.now_s);
        properties["sigma_m2"] = now.sigma_m2;
        properties["q_m2ps"] = now.iceberg.q_m2ps;
        properties["velocity_mps"] =
            pair(eastNorth_mps(m_content, now.iceberg.velocity_mps, now.position_m));
        properties["drift_mps"] = pair(eastNorth_mps(m_content, now.drift_mps, now.position_m));
        for (const auto& [name, value] : driftData(m_content, now))
            properties[std::string(name)] = value;
        properties["radius_m"] = now.iceberg.radius_m;
        properties["appears_s"] = now.iceberg.appears_s;
        properties["state"] = nameOf(kIcebergStateNames, now.state);
        add(point(now.position_m), std::move(properties));
    }

    void addVisits(const ExportUav& uav)
    {
        int sequence = 0;
        for (const Visit& visit : uav.visits) {
            if (!visit.iceberg)
                continue;
            const Iceberg& iceberg =
                m_content.icebergs.at(static_cast<std::size_t>(*visit.iceberg)).iceberg;
            Json properties;
            properties["kind"] = "visit";
            properties["sequence"] = ++sequence;
            properties["iceberg"] = iceberg.id;
            properties["name"] = iceberg.name;
            if (!visit.members.empty())
                properties["cluster"] = idsOf(m_content, visit);
            properties["uav"] = uav.uav.id;
            if (const auto chance = chanceInView(m_content, uav, visit, *visit.iceberg))
                properties["chance_in_view"] = *chance;
            addTime(properties, visit.time_s);
            add(point(visit.position_m), std::move(properties));
        }
    }

    void addLine(const ExportUav& uav)
    {
        Json properties;
        properties["kind"] = featureKind(m_content.what);
        properties["uav"] = uav.uav.id;
        properties["order"] = Json::array();
        for (const Visit& visit : uav.visits)
            for (const std::string& id : idsOf(m_content, visit))
                properties["order"].push_back(id);
        if (m_content.what == ExportScope::Track) {
            properties["flown_m"] = uav.flown_m;
            properties["zeta_m2s"] = *m_content.zeta_m2s; // of all UAVs
        } else {
            properties["policy"] = nameOf(kPolicyNames, m_content.planner.policy);
            properties["tau"] = m_content.planner.tau;
        }
        if (const std::size_t parts = partsOf(m_content, uav); parts > 0)
            addParts(uav, parts > 1, jsonText(properties));
    }

    /**
     * Writes a LineString, or a MultiLineString with nested times; the times follow after the last
     * place.
     */
    void addParts(const ExportUav& uav, bool several, std::string properties)
    {
        addText(std::string(R"({"type":"Feature","geometry":{"type":")") +
                (several ? "MultiLineString" : "LineString") + R"(","coordinates":)" +
                (several ? "[" : ""));
        FileBackedBuffer times;
        bool isOpen = false;
        eachPlace(m_content, uav, [&](const TimedPlace& vertex, bool isFirst) {
            const char* const before = !isFirst ? "," : isOpen ? "],[" : "[";
            isOpen = true;
            m_put(before + jsonText(coordinates(vertex.place)));
            times.append(before + jsonText(m_content.start
                                               ? Json(utcText(*m_content.start, vertex.time_s))
                                               : Json(roundedSeconds(vertex.time_s))));
        });
        properties.pop_back();
        m_put((several ? "]]}" : "]}") + std::string(R"(,"properties":)") + properties +
              R"(,"coordinateProperties":{")" + (m_content.start ? "times" : "times_s") +
              "\":" + (several ? "[" : ""));
        times.putAll(m_put);
        m_put(several ? "]]}}}" : "]}}}");
    }

    void addArea()
    {
        if (m_content.area_m.empty())
            return;
        Json properties;
        properties["kind"] = "area";
        properties["geofence"] = m_content.geofence;
        addPolygon(m_content.area_m, std::move(properties));
    }

    void addClosed(const NoFlyArea& area, const char* kind)
    {
        Json properties;
        properties["kind"] = kind;
        properties["name"] = area.name;
        properties["floor_m"] = area.floor_m;
        if (area.ceiling_m)
            properties["ceiling_m"] = *area.ceiling_m;
        addPolygon(area.corners_m, std::move(properties));
    }

    void addAirspace(const AirspaceArea& area)
    {
        Json properties;
        properties["kind"] = "airspace";
        properties["name"] = area.name;
        properties["class"] = area.kind;
        properties["floor_m"] = area.floor_m;
        if (area.ceiling_m)
            properties["ceiling_m"] = *area.ceiling_m;
        if (!area.fromUtc.empty())
            properties["from_utc"] = area.fromUtc;
        if (!area.untilUtc.empty())
            properties["until_utc"] = area.untilUtc;
        addPolygon(area.corners_m, std::move(properties));
    }

    void addOperation(const OperationVolume& volume)
    {
        for (std::size_t part = 0; part < kVolumeParts; ++part) {
            Json properties;
            properties["kind"] = std::string(kVolumePartIds[part]);
            properties["name"] = kVolumeTitle;
            if (const auto top_m = volume.top_m(static_cast<VolumePart>(part)))
                properties["ceiling_m"] = std::round(*top_m * 10) / 10;
            addPolygon(volume.outlines_m[part], std::move(properties));
        }
    }

    void addPolygon(const std::vector<Point>& corners_m, Json properties)
    {
        Json polygons = Json::array();
        for (const std::vector<LatLon>& ring : geographicPolygon(m_content.frame, corners_m)) {
            Json exterior = Json::array();
            for (const LatLon& place : ring)
                exterior.push_back(coordinates(place));
            polygons.push_back(Json::array({std::move(exterior)}));
        }
        if (polygons.size() == 1)
            add(shape("Polygon", std::move(polygons[0])), std::move(properties));
        else
            add(shape("MultiPolygon", std::move(polygons)), std::move(properties));
    }

    void addAsset()
    {
        if (!m_content.asset)
            return;
        const Asset& asset = *m_content.asset;
        Json properties;
        properties["kind"] = "asset";
        properties["name"] = asset.name;
        addTime(properties, m_content.now_s);
        const Point place_m = assetPlace_m(m_content);
        properties["velocity_mps"] = pair(eastNorth_mps(m_content, asset.velocity_mps, place_m));
        properties["range_m"] = asset.range_m;
        if (asset.standoff_m > 0)
            properties["standoff_m"] = asset.standoff_m;
        if (asset.standoff_m > 0 && asset.standoffCeiling_m)
            properties["standoff_ceiling_m"] = *asset.standoffCeiling_m;
        add(point(place_m), std::move(properties));
    }

    const ExportContent& m_content;
    const TextSink& m_put;
    bool m_isFirst = true;
};

} // namespace

void writeGeoJson(const ExportContent& content, const TextSink& put)
{
    Collection(content, put).write();
}

} // namespace berg
