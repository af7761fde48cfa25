#include "widgets/model/flight_record.h"

#include <iterator>

namespace berg {

void FlightRecord::begin(const Scenario& flown)
{
    *this = FlightRecord{.scenario = flown};
}

void FlightRecord::take(MissionSnapshot snapshot)
{
    if (snapshot.generation != now.generation) {
        samples.clear();
        rows.clear();
    }
    // What came with snapshots that were never taken is in this one: nothing is missing or twice.
    samples.resize(std::min(samples.size(), snapshot.firstSample));
    rows.resize(samples.size());
    samples.insert(samples.end(), snapshot.newSamples.begin(), snapshot.newSamples.end());
    std::move(snapshot.newRows.begin(), snapshot.newRows.end(), std::back_inserter(rows));
    snapshot.newSamples.clear();
    snapshot.newRows.clear();
    now = std::move(snapshot);
}

bool FlightRecord::inFlight() const
{
    switch (now.phase) {
    case RunPhase::Planning:
    case RunPhase::Ready:
    case RunPhase::Failed:
        return false;
    case RunPhase::Flying:
    case RunPhase::Paused:
    case RunPhase::Finished:
        return true;
    }
    return false;
}

Point FlightRecord::estimate_m(std::size_t iceberg) const
{
    return now.world.tracks[iceberg].estimate_m(now.time_s);
}

FlightRecord recordOf(const Mission& mission)
{
    FlightRecord record{.scenario = mission.scenario(), .now = snapshotOf(mission)};
    record.samples = mission.recorder().samples();
    for (std::size_t row = 0; row < record.samples.size(); ++row) {
        const auto icebergs = mission.recorder().icebergs(row);
        record.rows.emplace_back(icebergs.begin(), icebergs.end());
    }
    return record;
}

} // namespace berg
