#pragma once

#include "core/base/error.h"
#include "core/scenario/scenario.h"

#include <QLocale>
#include <QStringList>

#include <optional>

namespace berg {

/**
 * A finding in the user's language and units after the label of its field: "Airspeed: must be ...".
 * Without a label for the field the words stand alone, with a capital.
 */
[[nodiscard]] QString issueText(const Issue& issue, const QLocale& locale = QLocale());

/** The translation of words of findings and notes, which the core has in English. */
[[nodiscard]] QString coreWords(const std::string& english);
/** Returns the words with a count in place of %n. */
[[nodiscard]] QString coreWords(const std::string& english, std::size_t count);
/** A note of the core in the user's language and units, with a capital. */
[[nodiscard]] QString coreText(std::string_view english,
                               const std::vector<IssueArgument>& arguments, const QLocale& locale);
/** Returns the words of a finding as a sentence that needs no field. */
[[nodiscard]] QString issueSentence(IssueId id, const std::vector<IssueArgument>& arguments = {});
/** The words of a finding, without arguments. */
[[nodiscard]] QString issueWords(IssueId id);

/** Returns a finding about a file after its place: `icebergs[3].q_m2ps: ...`. */
[[nodiscard]] QString placedIssueText(const Issue& issue);
/** Returns all findings of an error by `placedIssueText`. */
[[nodiscard]] QStringList issueLines(const Error& error);

/**
 * Returns findings about the options of a dialog, named as in the dialog (`fieldName` of
 * `dialog`.option): the fields of an error whose subject is the dialog, or the subject itself.
 * Returns an empty list if the error is about something else.
 */
[[nodiscard]] QStringList optionIssueLines(const Error& error, const std::string& dialog);

/** The name of the iceberg or UAV that the finding is about; empty if it is about neither. */
[[nodiscard]] QString issueOwner(const Issue& issue, const Scenario& scenario);
/** The finding after that name: "UAV 1, Airspeed: must be ..." or "UAV 1: starts ...". */
[[nodiscard]] QString issueLine(const Issue& issue, const Scenario& scenario);

/** Numbers of findings by severity. */
struct IssueCounts
{
    int errors = 0;
    int warnings = 0;
    int hints = 0;
};
[[nodiscard]] IssueCounts countIssues(const std::vector<Issue>& issues);
/**
 * Returns "2 errors, 1 warning"; hints only if there is nothing worse; empty if there is no
 * finding.
 */
[[nodiscard]] QString countsText(const IssueCounts& counts);

/**
 * Returns the index K of a field `icebergs[K]...` or `uavs[K]...`, with `list` the name before it,
 * or nullopt for other fields.
 */
[[nodiscard]] std::optional<std::size_t> issueIndex(const Issue& issue, std::string_view list);

} // namespace berg
