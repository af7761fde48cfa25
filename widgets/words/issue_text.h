#pragma once

#include "core/base/error.h"
#include "core/scenario/scenario.h"

#include <QLocale>
#include <QStringList>

namespace berg {

/**
 * A finding in the user's language and units, fields called as the inputs are: of a scenario a
 * sentence, of a reader what follows the field.
 */
[[nodiscard]] QString issueText(const Issue& issue, const QLocale& locale = QLocale());

/** The words of a reader's fault, without arguments. */
[[nodiscard]] QString issueWords(IssueId id);

/** A finding about a file after its place there: `icebergs[3].q_m2ps: ...`. */
[[nodiscard]] QString placedIssueText(const Issue& issue);
[[nodiscard]] QStringList issueLines(const Error& error);

/**
 * Faults of the options of a dialog, called as it calls them (`fieldName` of `dialog`.option): the
 * fields of an error whose subject is the dialog, or the subject itself. Empty: of something else.
 */
[[nodiscard]] QStringList optionIssueLines(const Error& error, const std::string& dialog);

/** The finding after the name of the iceberg or UAV it is about, where it is about one. */
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
