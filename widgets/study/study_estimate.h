#pragma once

#include "core/study/study.h"

namespace berg {

/**
 * Returns the estimated duration of a study on all cores of an ordinary machine, s: flying by steps
 * and icebergs, planning by policy and icebergs (tests/bench/RESULTS.md). Right within a factor of
 * a few; to be scaled by measured durations.
 */
[[nodiscard]] double estimatedTime_s(const StudySpec& spec);

} // namespace berg
