#include "widgets/model/flight_record.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace berg {

void FlightRecord::begin(const Scenario& flown)
{
    const std::uint64_t rewrites = history.rewrites;
    *this = FlightRecord{.scenario = flown};
    history.rewrites = rewrites + 1;
}

void FlightRecord::take(MissionSnapshot snapshot)
{
    if (snapshot.generation != now.generation) {
        history = {.rewrites = history.rewrites + 1};
        instant.reset();
    }
    append(history, std::exchange(snapshot.news, {}));
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
    return shown().world.tracks[iceberg].estimate_m(shown().time_s);
}

std::size_t FlightRecord::eventsShown() const
{
    constexpr double kRounding_s = 1e-6; // times are whole steps
    const double until_s = shown().time_s + kRounding_s;
    const auto end =
        std::upper_bound(history.events.begin(), history.events.end(), until_s,
                         [](double t, const MissionEvent& event) { return t < event.time_s; });
    return static_cast<std::size_t>(end - history.events.begin());
}

FlightRecord recordOf(const Mission& mission)
{
    FlightRecord record{.scenario = mission.scenario(), .now = snapshotOf(mission)};
    MissionHistory& history = record.history;
    history.samples = mission.recorder().samples();
    for (std::size_t row = 0; row < history.samples.size(); ++row) {
        const auto icebergs = mission.recorder().icebergs(row);
        history.rows.emplace_back(icebergs.begin(), icebergs.end());
    }
    history.plans = mission.plans();
    history.events = mission.events();
    return record;
}

MissionOptions recordingOf(const Scenario& scenario)
{
    constexpr double kSamples = 18000;
    constexpr double kIcebergSamples = 2e6; // 64 MB
    constexpr double kLongest_s = 5;
    constexpr double kKeyframe_samples = 60;
    const double icebergs = static_cast<double>(scenario.icebergs.size());
    const double share = std::max(1 / kSamples, icebergs / kIcebergSamples);
    const double interval_s = std::clamp(std::ceil(scenario.duration_s * share), 1.0, kLongest_s);
    return {.sampleInterval_s = interval_s, .keyframeInterval_s = kKeyframe_samples * interval_s};
}

} // namespace berg
