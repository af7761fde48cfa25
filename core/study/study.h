#pragma once

#include "core/mission/mission.h"
#include "core/presets/presets.h"
#include "core/study/parallel.h"

#include <optional>
#include <string>
#include <vector>

namespace berg {

/** One policy, with `tau` for the policy visitation only. */
struct StudySetting
{
    PolicyKind policy = PolicyKind::Visitation;
    std::optional<double> tau;
    bool operator==(const StudySetting&) const = default;
};

/**
 * A comparison of zeta by tau and policy over many cases. A case is a scenario with a noise seed.
 * Every setting flies every case, so settings are compared on the same icebergs and noise.
 */
struct StudySpec
{
    std::string name;                ///< title of figures and reports
    std::vector<Scenario> scenarios; ///< scenarios flown first
    /** Number of scenarios `randomScenario(firstSeed + k, field)` flown after them. */
    int random = 0;
    std::int64_t firstSeed = 1;
    FieldSpec field;
    std::vector<double> taus; ///< values for the policy visitation
    /** Policies; each one other than visitation gives one setting. */
    std::vector<PolicyKind> policies;
    int runs = 1; ///< noise seeds per scenario, the scenario's own first
    bool operator==(const StudySpec&) const = default;
};

/** Largest number of missions of a study; keeps its file readable and its outcomes in memory. */
inline constexpr std::size_t kMostMissions = 1'000'000;

/**
 * Returns the errors in the numbers of a study, at most 1000, with fields named as in the study
 * file; its scenarios have a `validate` of their own. Without errors every count below is exact.
 */
[[nodiscard]] std::vector<Issue> validate(const StudySpec& spec);

/**
 * Returns the name in the study file of the first member in which the two differ, or an empty text
 * if they are equal.
 */
[[nodiscard]] std::string differingMember(const StudySpec& a, const StudySpec& b);

/** Result of one mission. */
struct MissionOutcome
{
    Metrics metrics;
    bool stuck = false; ///< true if the last half of the run had two icebergs at most as targets
    bool operator==(const MissionOutcome&) const = default;
};

/** A study with its results so far. */
struct Study
{
    StudySpec spec;
    /**
     * Outcomes by case and setting, at `case * settings + setting`; empty before the first flight.
     */
    std::vector<std::optional<MissionOutcome>> outcomes;
    bool operator==(const Study&) const = default;
};

/**
 * Returns the settings of a study: visitation with each tau in the given order, then the other
 * policies.
 */
[[nodiscard]] std::vector<StudySetting> settingsOf(const StudySpec& spec);
/**
 * Returns the number of settings without building them, because a file may name more than fit into
 * memory.
 */
[[nodiscard]] std::size_t settingCount(const StudySpec& spec);
/** Returns the number of cases. Cases are ordered by scenario, then by run. */
[[nodiscard]] std::size_t caseCount(const StudySpec& spec);
/** Returns the number of missions: cases times settings. */
[[nodiscard]] std::size_t missionCount(const StudySpec& spec);
/**
 * Returns the scenario of a mission as the study flies it, with seed, policy and tau set. Throws
 * `std::logic_error` if there is no such case.
 */
[[nodiscard]] Scenario scenarioOf(const StudySpec& spec, std::size_t caseIndex,
                                  const StudySetting& setting);
/**
 * Returns the noise seed of run `run` of a scenario, from 0 to 2^53; run 0 has the scenario's own
 * seed.
 */
[[nodiscard]] std::int64_t seedOfRun(std::int64_t seed, int run);

/** Part `index` of `count` of a study, from 1 on: the cases c with c mod count = index - 1. */
struct Shard
{
    int index = 1;
    int count = 1;
    bool operator==(const Shard&) const = default;
};

/** Options of flying a study. */
struct StudyOptions
{
    /** At least 1; nullopt means one per core. The result does not depend on it. */
    std::optional<int> threads = {};
    Shard shard;
    std::stop_token stop;
    /**
     * Called at the start and after each mission, never by two threads at once, with the number of
     * missions of the shard flown so far, earlier calls included, and their total. `study` may be
     * read (and saved) meanwhile. An exception from it ends the study as a failing mission does.
     */
    std::function<void(const Study& study, std::size_t done, std::size_t count)> onProgress;
};

/**
 * Flies the missing missions of the shard. Returns false if stopped. Outcomes so far are retained,
 * also after an exception, and the next call continues. Before anything is flown, throws
 * `Error{InvalidInput}` for an invalid spec or shard or a wrong number of outcomes, and `Error` as
 * the constructor of `Mission`. An exception of a mission or of `onProgress` ends the flights.
 */
bool fly(Study& study, const StudyOptions& options = {});

/** Returns the number of missions flown, of all shards. */
[[nodiscard]] std::size_t flownCount(const Study& study);

/**
 * Combines the outcomes of several shards of one study. Throws `Error{InvalidInput}` if their specs
 * differ or one mission has two different outcomes, and `std::logic_error` without parts or if a
 * part has another number of outcomes than missions.
 */
[[nodiscard]] Study merge(std::vector<Study> parts);

} // namespace berg
