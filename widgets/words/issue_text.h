#pragma once

#include "core/scenario/scenario.h"

#include <QLocale>
#include <QString>

namespace berg {

/**
 * A finding as a sentence in the user's language and units, fields called as the inputs are. One
 * whose reason has no id comes in the core's own words, after its field.
 */
[[nodiscard]] QString issueText(const Issue& issue, const QLocale& locale = QLocale());

/** The same after the name of the iceberg or UAV it is about, where it is about one. */
[[nodiscard]] QString issueLine(const Issue& issue, const Scenario& scenario);

struct IssueCounts
{
    int errors = 0;
    int warnings = 0;
    int hints = 0;
};
[[nodiscard]] IssueCounts countIssues(const std::vector<Issue>& issues);
/** "2 errors, 1 warning"; hints only when there is nothing worse; empty: nothing. */
[[nodiscard]] QString countsText(const IssueCounts& counts);

/** What a finding is about: the K of `icebergs[K]...` or `uavs[K]...`; -1: neither. */
[[nodiscard]] int issueIndex(const Issue& issue, std::string_view list);

} // namespace berg
