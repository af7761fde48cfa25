#pragma once

#include "core/base/error.h"
#include "core/io/words/report_words.h"

#include <string>
#include <string_view>
#include <vector>

namespace berg::cli {

// Messages on stderr and reports (HTML) are in the language of LC_ALL, LC_MESSAGES or LANG: Danish,
// French or Norwegian, else English. Help, results and JSON are English, because scripts read them.
// Messages are marked with QT_TRANSLATE_NOOP, those of the command line in context CommandLine,
// findings in IssueText.

/** Returns the text in the user's language, or the English where it has no translation. Does not
 * allocate. */
[[nodiscard]] std::string_view said(std::string_view english);
/** Returns the text in the user's language with the arguments in place of %1, %2, ... */
[[nodiscard]] std::string said(std::string_view pattern,
                               const std::vector<IssueArgument>& arguments);
[[nodiscard]] std::string said(const IssueReason& reason);
/** Returns the finding in the user's language, with its field in front. */
[[nodiscard]] std::string said(const Issue& issue);
/** Returns "subject: field: reason" in the user's language, one line per issue, like
 * `Error::what()`. */
[[nodiscard]] std::string said(const Error& error);

/** Returns the words of reports in the user's language. */
[[nodiscard]] ReportWords reportLanguage();

/** A message in English, for scripts, and in the user's language. */
struct Sentence
{
    std::string english;
    std::string said;
};
[[nodiscard]] Sentence sentence(std::string_view pattern,
                                const std::vector<IssueArgument>& arguments = {});

} // namespace berg::cli
