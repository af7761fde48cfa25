#include "core/study/start_scan.h"

#include "core/base/error.h"
#include "core/mission/flight_places.h"
#include "core/scenario/utc_time.h"
#include "core/study/drift_tracks.h"

#include <algorithm>
#include <cmath>

namespace berg {

namespace {

/** Returns the iceberg as it is expected to be after the delay. */
Iceberg delayed(const Scenario& scenario, const ScenarioWeather& weather, const Iceberg& iceberg,
                double delay_s)
{
    const bool fades = scenario.observer.model == ObserverModel::Kalman;
    IcebergDrift drift(weather, iceberg, kCCoreDrag, fades);
    Point last_mps = drift.velocity_mps().value_or(iceberg.velocity_mps);
    bool isKnown = true;
    constexpr double kLastVelocityStep_s = 900;
    for (double time_s = 0; isKnown && time_s < delay_s;) {
        time_s = std::min(delay_s, time_s + kLastVelocityStep_s);
        isKnown = drift.advance(time_s);
        last_mps = drift.velocity_mps().value_or(last_mps);
    }
    Iceberg later = iceberg;
    later.position_m =
        drift.now().position_m + last_mps * std::max(0.0, delay_s - drift.now().time_s);
    if (fades && iceberg.velocityTime_s > 0)
        later.velocity_mps *= std::exp(-delay_s / iceberg.velocityTime_s);
    later.observed_s += delay_s;
    later.appears_s = std::max(0.0, iceberg.appears_s - delay_s);
    for (double& time_s : later.track.time_s)
        time_s -= delay_s;
    return later;
}

StartOutcome flownFrom(const Scenario& scenario, double delay_s, const std::stop_token& stop)
{
    const Scenario later = startingLater(scenario, delay_s);
    StartOutcome outcome{.delay_s = delay_s, .startUtc = later.startUtc};
    try {
        Mission mission(later, {.record = false});
        FlightPlaces places;
        places.note(mission.simulation());
        const AdvanceStatus status = mission.advance(
            later.duration_s, stop, [&](double) { places.note(mission.simulation()); });
        if (status == AdvanceStatus::Cancelled)
            return outcome;
        places.finish(mission.simulation());
        outcome.zeta_m2s = mission.metrics().zeta_m2s;
        outcome.visits = mission.metrics().visits;
        outcome.weather = weatherAlong(later, places.flights());
    } catch (const Error& error) {
        // The icebergs or the asset may have drifted to where the scenario is contradictory.
        if (delay_s == 0 || error.code() != ErrorCode::InvalidInput)
            throw;
        outcome.weather = weatherOfArea(later);
    }
    return outcome;
}

void checkSpec(const Scenario& scenario, const StartScanSpec& spec)
{
    if (!startTime(scenario))
        throw Error(ErrorCode::InvalidInput, "",
                    std::vector<Issue>{{.field = "start_utc", .reason = {IssueId::Missing}}});
    require(spec.every_s > 0 && spec.span_s >= 0 &&
                spec.span_s / spec.every_s < static_cast<double>(kMostStarts),
            "scanStarts: spec");
}

} // namespace

Scenario startingLater(const Scenario& scenario, double delay_s)
{
    require(delay_s >= 0, "startingLater: delay");
    Scenario later = scenario;
    if (delay_s == 0)
        return later;
    if (const std::optional<ForecastTime> start = startTime(scenario))
        later.startUtc = utcText(*start, delay_s);
    const ScenarioWeather weather(scenario);
    for (Iceberg& iceberg : later.icebergs)
        iceberg = delayed(scenario, weather, iceberg, delay_s);
    if (later.asset)
        later.asset->position_m += later.asset->velocity_mps * delay_s;
    return later;
}

std::optional<std::size_t> bestStart(const std::vector<StartOutcome>& starts)
{
    std::optional<std::size_t> best;
    const auto isBetter = [](const StartOutcome& a, const StartOutcome& b) {
        if (a.weather.state() != b.weather.state())
            return a.weather.state() < b.weather.state();
        return *a.zeta_m2s < *b.zeta_m2s;
    };
    for (std::size_t i = 0; i < starts.size(); ++i)
        if (starts[i].zeta_m2s && starts[i].weather.state() <= WeatherState::Marginal &&
            (!best || isBetter(starts[i], starts[*best])))
            best = i;
    return best;
}

std::optional<StartScan> scanStarts(const Scenario& scenario, const StartScanSpec& spec,
                                    const ParallelOptions& options)
{
    checkSpec(scenario, spec);
    constexpr double kRounding = 1e-9;
    const auto count =
        static_cast<std::size_t>(std::floor(spec.span_s / spec.every_s + kRounding)) + 1;
    StartScan scan;
    scan.starts.resize(count);
    const auto fly = [&](std::size_t i) {
        scan.starts[i] = flownFrom(scenario, static_cast<double>(i) * spec.every_s, options.stop);
    };
    if (!forEachIndex(count, fly, options) || options.stop.stop_requested())
        return std::nullopt;
    for (const Uav& uav : scenario.uavs)
        scan.uavs.push_back(uav.id);
    scan.best = bestStart(scan.starts);
    return scan;
}

} // namespace berg
