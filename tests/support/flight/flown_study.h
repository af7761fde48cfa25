#pragma once

#include "core/study/study.h"

namespace berg::test {

/** Returns six icebergs for 300 s: short, but with several visits. */
inline Scenario smallField(std::int64_t seed)
{
    Scenario scenario = randomScenario(seed, {.icebergs = 6, .size_m = {3000, 2500}});
    scenario.duration_s = 300;
    return scenario;
}

/** Flies the study with these options as far as they allow. */
inline Study flown(StudySpec spec, const StudyOptions& options = {})
{
    Study study{.spec = std::move(spec)};
    fly(study, options);
    return study;
}

} // namespace berg::test
