#pragma once

#include "core/scenario/presets.h"
#include "core/sim/mission.h"
#include "core/study/parallel.h"

#include <optional>
#include <string>
#include <vector>

namespace berg {

/** One way to fly; `tau` for the policy visitation only. */
struct StudySetting
{
    PolicyKind policy = PolicyKind::Visitation;
    std::optional<double> tau;
    bool operator==(const StudySetting&) const = default;
};

/**
 * zeta against tau and policy over many cases. A case is a scenario with a noise seed; every
 * setting flies every case, so that settings are compared on the same icebergs and noise.
 */
struct StudySpec
{
    std::string name;                ///< title of pictures and reports
    std::vector<Scenario> scenarios; ///< flown first
    int random = 0;                  ///< then `randomScenario(firstSeed + k, field)`, so many
    std::int64_t firstSeed = 1;
    FieldSpec field;
    std::vector<double> taus;         ///< for the policy visitation
    std::vector<PolicyKind> policies; ///< the others give one setting each
    int runs = 1;                     ///< noise seeds for each scenario, the scenario's own first
    bool operator==(const StudySpec&) const = default;
};

/** Missions a study may have: its file stays readable, its outcomes fit into memory. */
inline constexpr std::size_t kMostMissions = 1'000'000;

/**
 * What cannot be flown about the numbers of a study (its scenarios aside: see `validate` of a
 * scenario), fields named as in the study file. Without errors every count below is exact.
 */
[[nodiscard]] std::vector<Issue> validate(const StudySpec& spec);

/** Name in the study file of the first member in which the two differ; empty when they are equal.
 */
[[nodiscard]] std::string differingMember(const StudySpec& a, const StudySpec& b);

/** What one mission came to. */
struct MissionOutcome
{
    Metrics metrics;
    bool stuck = false; ///< two icebergs at most as targets in the last half of the run
    bool operator==(const MissionOutcome&) const = default;
};

/** A study and what of it has been flown. */
struct Study
{
    StudySpec spec;
    /** By case, within it by setting: `case * settings + setting`. Empty: nothing flown yet. */
    std::vector<std::optional<MissionOutcome>> outcomes;
    bool operator==(const Study&) const = default;
};

/** Visitation by tau as given, then the other policies as given. */
[[nodiscard]] std::vector<StudySetting> settingsOf(const StudySpec& spec);
/** How many they are, without making them: a file may name more than fit into memory. */
[[nodiscard]] std::size_t settingCount(const StudySpec& spec);
/** Scenario-major, then run. */
[[nodiscard]] std::size_t caseCount(const StudySpec& spec);
[[nodiscard]] std::size_t missionCount(const StudySpec& spec);
/** The scenario of a mission exactly as the study flies it: seed, policy and tau set. */
[[nodiscard]] Scenario scenarioOf(const StudySpec& spec, std::size_t caseIndex,
                                  const StudySetting& setting);
/** Seed of the noise of run `run` of a scenario: its own for 0, within 0 .. 2^53. */
[[nodiscard]] std::int64_t seedOfRun(std::int64_t seed, int run);

/** Part `index` of `count` (1-based): cases c with c mod count = index - 1. */
struct Shard
{
    int index = 1;
    int count = 1;
    bool operator==(const Shard&) const = default;
};

struct StudyOptions
{
    int threads = 0; ///< 0: one per core; never changes the result
    Shard shard;
    std::stop_token stop;
    /**
     * At the start and after each mission, never by two threads at once: missions of the shard
     * flown, those of an earlier call included, of how many; `study` may be read (and saved)
     * meanwhile. What it throws ends the flying as a failing mission does.
     */
    std::function<void(const Study& study, std::size_t done, std::size_t count)> onProgress;
};

/**
 * Flies what is missing of the shard. Returns false when stopped; what has been flown is kept, also
 * when something is thrown, and the next call carries on. Throws `Error` as the constructor of
 * `Mission` before anything is flown, and `InvalidInput` for a shard or sizes that do not fit.
 */
bool fly(Study& study, const StudyOptions& options = {});

/** Missions that are flown, of all shards. */
[[nodiscard]] std::size_t flownCount(const Study& study);

/**
 * What several shards of one study have flown together. Throws `Error{InvalidInput}` when their
 * specs differ or one mission has two different outcomes.
 */
[[nodiscard]] Study merge(std::vector<Study> parts);

} // namespace berg
