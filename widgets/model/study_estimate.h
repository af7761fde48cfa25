#pragma once

#include "core/study/study.h"

namespace berg {

/**
 * How long a study may take on all cores of an ordinary machine: flying by steps and icebergs,
 * planning by policy and icebergs (tests/bench/RESULTS.md). Right within a factor of a few;
 * to be scaled by what a study really took.
 */
[[nodiscard]] double estimatedTime_s(const StudySpec& spec);

} // namespace berg
