#include "widgets/sightings/flight_sightings.h"

#include "core/base/find_by_id.h"
#include "core/io/text/utc_time.h"

#include <algorithm>

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
        const ImportedIceberg& report = row.report;
        if (report.outcome == ImportOutcome::LeftOut)
            continue;
        Intervention change;
        if (report.outcome == ImportOutcome::Added) {
            change.appears = *findById(preview.result.scenario.icebergs, report.id);
        } else {
            change.seen = report.id;
            change.seenAge_s = report.age_s;
        }
        reports.push_back(std::move(change));
    }
    return reports;
}

} // namespace berg
