#include "core/io/geojson.h"

#include "core/io/export_numbers.h"
#include "core/io/geo_shapes.h"
#include "core/io/utc_time.h"
#include "core/io/visits.h"
#include "core/plan/names.h"

#include <nlohmann/json.hpp>

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

/** Builds the features of one source. */
class Collection
{
public:
    explicit Collection(const ExportSource& source)
        : m_source(source)
        , m_icebergs(icebergsOf(source))
        , m_visits(visitsOf(source))
        , m_frame(source.scenario.origin)
        , m_start(parseUtc(source.scenario.startUtc))
    {
    }

    std::string text()
    {
        addUav();
        addIcebergs();
        addVisits();
        addLine();
        addArea();
        return "{\"type\":\"FeatureCollection\",\"features\":[\n" + m_features + "\n]}\n";
    }

private:
    void add(Json geometry, Json properties)
    {
        Json feature;
        feature["type"] = "Feature";
        feature["geometry"] = std::move(geometry);
        feature["properties"] = std::move(properties);
        if (!m_features.empty())
            m_features += ",\n";
        // Names may hold bytes that are not UTF-8 when they come from elsewhere than a file.
        m_features += feature.dump(-1, ' ', false, Json::error_handler_t::replace);
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
        return shape("Point", coordinates(roundedPlace(m_frame.toGeographic(position_m))));
    }

    void addTime(Json& properties, double time_s) const
    {
        properties["time_s"] = roundedSeconds(time_s);
        if (m_start)
            properties["time"] = utcText(*m_start, time_s);
    }

    [[nodiscard]] const Iceberg& iceberg(int index) const
    {
        return m_icebergs.at(static_cast<std::size_t>(index));
    }

    /** Ids in the order of the visits. */
    [[nodiscard]] Json order() const
    {
        Json ids = Json::array();
        for (const Visit& visit : m_visits)
            if (visit.iceberg >= 0)
                for (const int index : icebergsOf(visit))
                    ids.push_back(iceberg(index).id);
        return ids;
    }

    void addUav()
    {
        const Uav& uav = m_source.scenario.uavs.at(0);
        Json properties;
        properties["kind"] = "uav";
        properties["id"] = uav.id;
        properties["name"] = uav.name;
        addTime(properties, 0);
        properties["heading_deg"] = uav.heading_deg;
        properties["airspeed_mps"] = uav.spec.airspeed_mps;
        properties["altitude_m"] = uav.spec.altitude_m;
        add(point(uav.position_m), std::move(properties));
    }

    void addIcebergs()
    {
        for (std::size_t i = 0; i < m_icebergs.size(); ++i) {
            const Iceberg& iceberg = m_icebergs[i];
            Json properties;
            properties["kind"] = "iceberg";
            properties["id"] = iceberg.id;
            properties["name"] = iceberg.name;
            Point position_m = iceberg.position_m;
            if (m_source.mission) {
                const Simulation& simulation = m_source.mission->simulation();
                const int index = static_cast<int>(i);
                if (!simulation.active(index))
                    continue;
                position_m = simulation.truth_m(index);
                addTime(properties, simulation.time_s());
                properties["sigma_m2"] = simulation.track(index).sigma_m2;
            } else {
                addTime(properties, 0);
                properties["sigma_m2"] = initialSigma_m2(iceberg);
            }
            properties["q_m2ps"] = iceberg.q_m2ps;
            properties["velocity_mps"] = pair(iceberg.velocity_mps);
            properties["drift_mps"] = pair(iceberg.velocity_mps + m_source.scenario.current_mps);
            properties["radius_m"] = iceberg.radius_m;
            properties["appears_s"] = iceberg.appears_s;
            add(point(position_m), std::move(properties));
        }
    }

    void addVisits()
    {
        int sequence = 0;
        for (const Visit& visit : m_visits) {
            if (visit.iceberg < 0)
                continue;
            Json properties;
            properties["kind"] = "visit";
            properties["sequence"] = ++sequence;
            properties["iceberg"] = iceberg(visit.iceberg).id;
            properties["name"] = iceberg(visit.iceberg).name;
            for (const int member : visit.members)
                properties["cluster"].push_back(iceberg(member).id);
            addTime(properties, visit.time_s);
            add(point(visit.position_m), std::move(properties));
        }
    }

    void addLine()
    {
        const Scenario& scenario = m_source.scenario;
        std::vector<TimedPoint> points;
        Json properties;
        properties["kind"] = m_source.mission ? "track" : "plan";
        properties["uav"] = scenario.uavs.at(0).id;
        properties["order"] = order();
        if (m_source.mission) {
            for (const Sample& sample : m_source.mission->recorder().samples())
                points.push_back({.position_m = sample.uav.position_m, .time_s = sample.time_s});
            const Metrics metrics = m_source.mission->metrics();
            properties["flown_m"] = metrics.flown_m;
            properties["zeta_m2s"] = metrics.zeta_m2s;
        } else {
            points.push_back({.position_m = scenario.uavs[0].position_m});
            for (const Visit& visit : m_visits)
                points.push_back({.position_m = visit.position_m, .time_s = visit.time_s});
            properties["policy"] = nameOf(kPolicyNames, scenario.planner.policy);
            properties["tau"] = scenario.planner.tau;
        }
        const std::vector<std::vector<TimedPlace>> parts = geographicLine(m_frame, points);
        if (!parts.empty())
            addParts(parts, std::move(properties));
    }

    /** A LineString, or a MultiLineString with nested times. */
    void addParts(const std::vector<std::vector<TimedPlace>>& parts, Json properties)
    {
        Json lines = Json::array();
        Json times = Json::array();
        for (const std::vector<TimedPlace>& part : parts) {
            Json line = Json::array();
            Json lineTimes = Json::array();
            for (const TimedPlace& vertex : part) {
                line.push_back(coordinates(vertex.place));
                lineTimes.push_back(m_start ? Json(utcText(*m_start, vertex.time_s))
                                            : Json(roundedSeconds(vertex.time_s)));
            }
            lines.push_back(std::move(line));
            times.push_back(std::move(lineTimes));
        }
        const bool single = parts.size() == 1;
        properties["coordinateProperties"][m_start ? "times" : "times_s"] =
            single ? std::move(times[0]) : std::move(times);
        if (single)
            add(shape("LineString", std::move(lines[0])), std::move(properties));
        else
            add(shape("MultiLineString", std::move(lines)), std::move(properties));
    }

    void addArea()
    {
        if (m_source.scenario.area_m.empty())
            return;
        Json polygons = Json::array();
        for (const std::vector<LatLon>& ring :
             geographicPolygon(m_frame, m_source.scenario.area_m)) {
            Json exterior = Json::array();
            for (const LatLon& place : ring)
                exterior.push_back(coordinates(place));
            polygons.push_back(Json::array({std::move(exterior)}));
        }
        Json properties;
        properties["kind"] = "area";
        if (polygons.size() == 1)
            add(shape("Polygon", std::move(polygons[0])), std::move(properties));
        else
            add(shape("MultiPolygon", std::move(polygons)), std::move(properties));
    }

    const ExportSource& m_source;
    const std::vector<Iceberg>& m_icebergs;
    std::vector<Visit> m_visits;
    LocalFrame m_frame;
    std::optional<UtcTime> m_start;
    std::string m_features;
};

} // namespace

std::string geoJson(const ExportSource& source)
{
    return Collection(source).text();
}

} // namespace berg
