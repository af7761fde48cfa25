#include "core/io/results/drift_tracks_result.h"

#include "core/base/number_text.h"
#include "core/io/results/result_csv.h"
#include "core/io/results/result_parts.h"
#include "core/scenario/utc_time.h"

#include <cmath>

namespace berg {

namespace {

using Json = ResultJson;

/** Returns the number as it is worth, so that files do not differ in the last bits. */
Json worth(double value, int decimals)
{
    const double step = std::pow(10, decimals);
    return std::round(value * step) / step;
}

Json pointJson(const DriftTrackPoint& point, const std::optional<ForecastTime>& start)
{
    Json json;
    if (start)
        json["time"] = utcText(*start, point.time_s);
    json["hours"] = point.time_s / 3600;
    json["latitude_deg"] = worth(point.place.latitude_deg, 5);
    json["longitude_deg"] = worth(point.place.longitude_deg, 5);
    json["speed_mps"] = worth(point.velocity_mps.norm(), 4);
    json["direction_deg"] = worth(directionTo_deg(point.velocity_mps), 1);
    json["sd_m"] = worth(point.sd_m, 1);
    json["aground"] = point.isAground;
    if (point.error_m)
        json["error_m"] = worth(*point.error_m, 1);
    return json;
}

Json errorJson(const DriftLeadError& error)
{
    const auto km = [&](double distance_m) {
        return error.starts > 0 ? worth(distance_m / 1000, 3) : Json(nullptr);
    };
    return {{"lead_h", error.lead_s / 3600},
            {"starts", error.starts},
            {"moved_km", km(error.moved_m)},
            {"drift_km", km(error.drift_m)},
            {"last_velocity_km", km(error.lastVelocity_m)}};
}

Json trackJson(const DriftTracksReport& report, std::size_t index)
{
    const DriftTrack& track = report.tracks[index];
    const Iceberg& iceberg = report.scenario.icebergs[track.iceberg];
    const std::optional<ForecastTime> start = startTime(report.scenario);
    Json json{{"id", iceberg.id}};
    if (iceberg.length_m) {
        json["length_m"] = *iceberg.length_m;
        json["draft_m"] = worth(dimensionsOfLength(*iceberg.length_m).draft_m, 1);
    }
    json["end"] = nameOf(track.end);
    if (track.grounded_s)
        json["grounded_h"] = worth(*track.grounded_s / 3600, 2);
    json["points"] = Json::array();
    for (const DriftTrackPoint& point : track.points)
        json["points"].push_back(pointJson(point, start));
    if (!report.errors[index].empty()) {
        json["errors"] = Json::array();
        for (const DriftLeadError& error : report.errors[index])
            json["errors"].push_back(errorJson(error));
    }
    return json;
}

Json coordinates(const LatLon& place)
{
    return Json::array({worth(place.longitude_deg, 5), worth(place.latitude_deg, 5)});
}

} // namespace

std::string driftTracksJson(const DriftTracksReport& report)
{
    Json json{{"tracks", Json::array()}};
    for (std::size_t i = 0; i < report.tracks.size(); ++i)
        json["tracks"].push_back(trackJson(report, i));
    return resultText(json);
}

std::string driftTracksCsv(const DriftTracksReport& report)
{
    const std::optional<ForecastTime> start = startTime(report.scenario);
    std::string text = "iceberg,time,hours,latitude_deg,longitude_deg,speed_mps,direction_deg,"
                       "sd_m,aground,error_m\n";
    for (const DriftTrack& track : report.tracks)
        for (const DriftTrackPoint& point : track.points)
            text += csvField(report.scenario.icebergs[track.iceberg].id) + ',' +
                    (start ? utcText(*start, point.time_s) : std::string()) + ',' +
                    numberText(point.time_s / 3600) + ',' + fixedText(point.place.latitude_deg, 5) +
                    ',' + fixedText(point.place.longitude_deg, 5) + ',' +
                    fixedText(point.velocity_mps.norm(), 4) + ',' +
                    fixedText(directionTo_deg(point.velocity_mps), 1) + ',' +
                    fixedText(point.sd_m, 1) + (point.isAground ? ",1," : ",0,") +
                    (point.error_m ? fixedText(*point.error_m, 1) : std::string()) + '\n';
    return text;
}

std::string driftTracksGeoJson(const DriftTracksReport& report)
{
    const std::optional<ForecastTime> start = startTime(report.scenario);
    Json features = Json::array();
    for (const DriftTrack& track : report.tracks) {
        const std::string& id = report.scenario.icebergs[track.iceberg].id;
        Json line = Json::array();
        for (const DriftTrackPoint& point : track.points)
            line.push_back(coordinates(point.place));
        if (line.size() > 1) // a line has at least two positions
            features.push_back(
                {{"type", "Feature"},
                 {"geometry", {{"type", "LineString"}, {"coordinates", line}}},
                 {"properties", {{"role", "drift"}, {"iceberg", id}, {"end", nameOf(track.end)}}}});
        for (const DriftTrackPoint& point : track.points) {
            Json properties{{"role", "drift time"}, {"iceberg", id}};
            properties.update(pointJson(point, start));
            features.push_back(
                {{"type", "Feature"},
                 {"geometry", {{"type", "Point"}, {"coordinates", coordinates(point.place)}}},
                 {"properties", std::move(properties)}});
        }
    }
    return resultText({{"type", "FeatureCollection"}, {"features", std::move(features)}});
}

} // namespace berg
