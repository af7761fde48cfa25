#include "widgets/sightings/flight_sightings.h"

#include "core/base/find_by_id.h"
#include "core/scenario/utc_time.h"
#include "core/tracking/position_error.h"

#include <algorithm>
#include <cmath>

namespace berg {

namespace {

/** Returns the iceberg with the estimate and uncertainty of its track. */
Iceberg asEstimated(Iceberg iceberg, const Track& track, double time_s)
{
    iceberg.position_m = track.estimate_m(time_s);
    iceberg.observed_s = std::max(0.0, time_s - track.seen_s);
    iceberg.sigma0_m2 = std::max(0.0, track.sigma_m2 - iceberg.q_m2ps * iceberg.observed_s);
    iceberg.appears_s = 0;
    iceberg.track = {}; // the flight keeps its own true motion
    return iceberg;
}

/** Returns the intervention of an imported iceberg, or nullopt if it was left out. */
std::optional<Intervention> reportOf(const ImportedIceberg& report, const Scenario& result)
{
    if (report.outcome == ImportOutcome::LeftOut)
        return std::nullopt;
    Intervention change;
    if (report.outcome == ImportOutcome::Added) {
        change.appears = *findById(result.icebergs, report.id);
    } else {
        change.seen = report.id;
        change.seenAge_s = report.age_s;
    }
    return change;
}

/** Returns the id of the nearest iceberg that may be at the place, or nullopt if there is none. */
std::optional<std::string> icebergAt(const Scenario& now, const LatLon& place, double sigma_m2)
{
    const Point place_m = LocalFrame(now.origin).toPlane(place);
    std::optional<std::string> nearest;
    double nearest_m = 0;
    for (const Iceberg& iceberg : now.icebergs) {
        const double distance_m = (iceberg.position_m - place_m).norm();
        const double reach_m = radius95_m(iceberg.sigma0_m2 + iceberg.q_m2ps * iceberg.observed_s) +
                               radius95_m(sigma_m2);
        if (distance_m > reach_m || (nearest && distance_m >= nearest_m))
            continue;
        nearest = iceberg.id;
        nearest_m = distance_m;
    }
    return nearest;
}

} // namespace

Scenario scenarioNow(const FlightRecord& record)
{
    const MissionSnapshot& now = record.now;
    Scenario scenario = record.scenario;
    if (const std::optional<UtcTime> start = parseUtc(scenario.startUtc))
        scenario.startUtc = utcText(*start, now.time_s);
    scenario.icebergs.clear();
    for (std::size_t i = 0; i < now.icebergs.size(); ++i)
        if (now.active[i])
            scenario.icebergs.push_back(
                asEstimated(now.icebergs[i], now.world.tracks[i], now.time_s));
    for (std::size_t i = 0; i < scenario.uavs.size(); ++i)
        scenario.uavs[i].position_m = now.world.uavs[i].pose.position_m;
    scenario.asset = now.asset;
    if (scenario.asset)
        scenario.asset->position_m += now.time_s * scenario.asset->velocity_mps;
    return scenario;
}

ImportOptions optionsInFlight(ImportOptions options, const Scenario& now)
{
    options.at = parseUtc(now.startUtc);
    options.moveOrigin = false;
    options.withTracks = false;
    if (now.observer.model == ObserverModel::Simple)
        options.track.drift.velocitySpread_mps = 0; // the simple observer takes velocities as known
    return options;
}

std::vector<Intervention> reportsOf(const ImportPreview& preview)
{
    std::vector<Intervention> reports;
    for (const ImportRow& row : preview.rows) {
        std::optional<Intervention> change = reportOf(row.report, preview.result.scenario);
        if (change)
            reports.push_back(std::move(*change));
    }
    return reports;
}

std::vector<Intervention> reportsOfIce(const FlightRecord& record, const TrafficTarget& ice,
                                       double age_s)
{
    const Scenario now = scenarioNow(record);
    const double sigma_m2 = errorOf(SightingSource::Radar).sigma_m2();
    if (const std::optional<std::string> known = icebergAt(now, ice.place, sigma_m2)) {
        Intervention seen;
        seen.seen = *known;
        seen.seenAge_s = age_s;
        return {seen};
    }
    SightingTable table;
    Sighting sighting{.id = "radar " + std::to_string(ice.id),
                      .name = ice.name,
                      .place = ice.place,
                      .sigma_m2 = sigma_m2};
    // The number may have been that of another iceberg.
    for (int next = 2; findById(now.icebergs, sighting.id) != nullptr; ++next)
        sighting.id = "radar " + std::to_string(ice.id) + " (" + std::to_string(next) + ')';
    if (const std::optional<UtcTime> time = parseUtc(now.startUtc))
        sighting.time = *time - std::chrono::milliseconds(std::llround(1000 * age_s));
    table.sightings.push_back(std::move(sighting));
    const ImportResult result = importSightings(now, table, optionsInFlight({}, now));
    std::vector<Intervention> reports;
    for (const ImportedIceberg& iceberg : result.icebergs)
        if (std::optional<Intervention> change = reportOf(iceberg, result.scenario))
            reports.push_back(std::move(*change));
    return reports;
}

} // namespace berg
