#pragma once

#include "core/base/error.h"

#include <QString>

namespace berg {

/**
 * A finding about a scenario that can be edited, as a translated sentence. Those that the ranges
 * of the inputs rule out come in the core's own words, after their field.
 */
[[nodiscard]] QString issueText(const Issue& issue);

/** What a finding is about: the K of `icebergs[K]...` or `uavs[K]...`; -1: neither. */
[[nodiscard]] int issueIndex(const Issue& issue, std::string_view list);

} // namespace berg
