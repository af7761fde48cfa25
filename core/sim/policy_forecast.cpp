#include "core/sim/policy_forecast.h"

namespace berg {

Scenario foreseen(const Scenario& scenario, PolicyKind policy)
{
    Scenario expected = scenario;
    expected.planner.policy = policy;
    expected.noise = false;
    for (Iceberg& iceberg : expected.icebergs)
        iceberg.track = {};
    return expected;
}

std::optional<Metrics> forecastOf(const Scenario& scenario, PolicyKind policy,
                                  const std::stop_token& stop,
                                  const std::function<void(double)>& onProgress)
{
    Mission mission(foreseen(scenario, policy), {.record = false});
    std::function<void(double)> progress;
    if (onProgress)
        progress = [&](double time_s) { onProgress(time_s / scenario.duration_s); };
    if (mission.advance(scenario.duration_s, stop, progress) == AdvanceStatus::Cancelled)
        return std::nullopt;
    return mission.metrics();
}

} // namespace berg
