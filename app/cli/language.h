#pragma once

#include "core/base/error.h"
#include "core/io/text/report_words.h"

#include <string>
#include <string_view>
#include <vector>

namespace berg::cli {

// What is told on stderr and in reports (HTML), in the language of LC_ALL, LC_MESSAGES or LANG:
// Danish, French, Norwegian, else English. Help, results and JSON are English, for scripts read
// them. Words are marked with QT_TRANSLATE_NOOP: the command line's own in context CommandLine,
// findings in IssueText.

/** The words in the user's language; the same where they have no translation. Takes no memory. */
[[nodiscard]] std::string_view said(std::string_view english);
/** The same with the arguments for %1, %2, ... */
[[nodiscard]] std::string said(std::string_view pattern,
                               const std::vector<IssueArgument>& arguments);
[[nodiscard]] std::string said(const IssueReason& reason);
/** With its field in front. */
[[nodiscard]] std::string said(const Issue& issue);
/** As `what()`: "subject: field: reason", one line per issue. */
[[nodiscard]] std::string said(const Error& error);

/** Pages for people. */
[[nodiscard]] ReportWords reportLanguage();

/** What is told to the user, and to scripts. */
struct Sentence
{
    std::string english;
    std::string said;
};
[[nodiscard]] Sentence sentence(std::string_view pattern,
                                const std::vector<IssueArgument>& arguments = {});

} // namespace berg::cli
