#pragma once

#include "core/sim/mission.h"
#include "core/study/parallel.h"
#include "core/study/statistics.h"

#include <optional>
#include <string>
#include <vector>

namespace berg {

/** zeta against tau and policy over many scenarios. */
struct SweepSpec
{
    std::vector<Scenario> scenarios;
    std::vector<double> taus;         ///< for the policy visitation
    std::vector<PolicyKind> policies; ///< the others give one row each
    int runs = 1;                     ///< noise seeds per scenario, the scenario's own first
    MissionOptions options;           ///< `record` is not read: nothing is kept but the numbers
};

/** One way to fly, over all cases. */
struct SweepRow
{
    PolicyKind policy = PolicyKind::Visitation;
    std::optional<double> tau;    ///< none for policies that do not use it
    std::vector<double> zeta_m2s; ///< by case: scenario-major, then run
    std::vector<double> visits;   ///< by case
    Summary summary;              ///< of zeta
    double stuckShare = 0; ///< cases that fly to two icebergs at most in the last half of the run
};

struct SweepResult
{
    std::vector<SweepRow> rows; ///< visitation by tau as given, then the other policies as given
    bool complete = false;      ///< false when stopped; then rows are empty
};

/**
 * Flies every case with every setting: paired, a case has the same icebergs and noise in every
 * row. The result does not depend on the number of threads. Progress counts missions.
 */
[[nodiscard]] SweepResult sweep(const SweepSpec& spec, const ParallelOptions& parallel);

/** Missions that `sweep` will fly. */
[[nodiscard]] std::size_t missionCount(const SweepSpec& spec);

/** Seed of the noise of run `run` of a scenario: its own for 0, within 0 .. 2^53. */
[[nodiscard]] std::int64_t seedOfRun(std::int64_t seed, int run);

} // namespace berg
