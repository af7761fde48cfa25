#include "core/mission/policy_forecast.h"

#include "core/base/random.h"
#include "core/scenario/limits.h"

namespace berg {

Scenario withoutUnknowns(const Scenario& scenario, PolicyKind policy)
{
    Scenario expected = scenario;
    expected.planner.policy = policy;
    expected.noise = false;
    for (Iceberg& iceberg : expected.icebergs)
        iceberg.track = {};
    return expected;
}

std::optional<double> drawnZeta_m2s(const Scenario& scenario, PolicyKind policy, int number,
                                    const std::stop_token& stop)
{
    Scenario drawn = withoutUnknowns(scenario, policy);
    drawn.noise = true;
    Random random(static_cast<std::uint64_t>(scenario.seed),
                  stableHash("drawn flight") + static_cast<std::uint64_t>(number));
    do {
        drawn.seed = static_cast<std::int64_t>(random.below(kLargestSeed));
    } while (drawn.seed == scenario.seed);
    Mission mission(drawn, {.record = false});
    if (mission.advance(drawn.duration_s, stop) == AdvanceStatus::Cancelled)
        return std::nullopt;
    return mission.metrics().zeta_m2s;
}

} // namespace berg
