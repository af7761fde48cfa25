#pragma once

#include "widgets/study/study_runner.h"

namespace berg::test {

/** Returns a scenario of which a few missions take a millisecond. */
inline Scenario quickScenario(int seed = 3)
{
    Scenario scenario = randomScenario(seed, {.icebergs = 5});
    scenario.name = "Quick";
    scenario.duration_s = 120;
    return scenario;
}

/** Returns cases of a scenario with three values of tau and the shortest path. */
inline StudySpec quickStudy(int runs = 4)
{
    return {.name = "Quick study",
            .scenarios = {quickScenario()},
            .taus = {0, 1, 2},
            .policies = {PolicyKind::Visitation, PolicyKind::Path},
            .runs = runs};
}

/** Returns a study that would take hours. */
inline StudySpec endlessStudy()
{
    return {.name = "Endless study",
            .random = 100'000,
            .taus = {0, 1},
            .policies = {PolicyKind::Visitation}};
}

/** Returns a flown study with these values of zeta for each case and setting. */
inline StudyPointer studyOf(StudySpec spec, const std::vector<std::vector<double>>& zeta_m2s)
{
    spec.scenarios = {quickScenario()};
    spec.runs = static_cast<int>(zeta_m2s.size());
    Study study{.spec = spec, .outcomes = {}};
    for (const std::vector<double>& ofCase : zeta_m2s)
        for (const double zeta : ofCase)
            study.outcomes.push_back(
                MissionOutcome{.metrics = {.zeta_m2s = zeta, .visits = 7}, .stuck = zeta > 150});
    return std::make_shared<const StudyResult>(resultOf(std::move(study), usualReference(spec)));
}

/** Returns four cases of tau 0, 1, 2 and the shortest path; the reference is tau 1. */
inline StudyPointer fourCases()
{
    return studyOf(
        quickStudy(),
        {{100, 80, 90, 110}, {200, 160, 150, 190}, {120, 100, 104, 100}, {90, 95, 99, 70}});
}

/** Returns a study in which tau = 2 is lowest in each of four cases and tau = 1 second. */
inline StudyPointer clearWinner()
{
    return studyOf(
        quickStudy(),
        {{100, 80, 60, 110}, {200, 160, 121, 190}, {120, 100, 74, 105}, {90, 84, 64, 98}});
}

} // namespace berg::test
