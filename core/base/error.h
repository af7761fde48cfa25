#pragma once

#include "core/base/issue.h"

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace berg {

/** Kind of failure of an `Error`; the interface maps each code to a translated text. */
enum class ErrorCode
{
    FileNotFound,
    FileUnreadable,
    FileUnwritable,
    FileTooLarge,
    SyntaxError,        ///< the text is not well-formed JSON
    WrongFormat,        ///< the file is well-formed, but of another kind than requested
    UnsupportedVersion, ///< the file was made by a newer program
    InvalidInput,       ///< fields are out of range, missing or contradictory: see `issues()`
    Unsupported,        ///< the request is beyond the abilities of this build
    SolverFailed,
    ReplayMismatch ///< a run file does not reproduce the run it recorded
};

/**
 * Failure of input, file or back end (bugs throw `std::logic_error`, see `require`). `subject`
 * names the file, field or option; `what()` is "subject: message" with one line per issue.
 */
class Error : public std::runtime_error
{
public:
    Error(ErrorCode code, std::string subject, IssueReason reason);
    /** Makes an error with a text of another program, which is not translated. */
    Error(ErrorCode code, std::string subject, std::string words);
    /**
     * Makes an error with a list of issues, which must not be empty. `what()` has one line
     * "subject: field: message" for each; an empty subject or field is left out with its colon.
     */
    Error(ErrorCode code, std::string subject, std::vector<Issue> issues);

    [[nodiscard]] ErrorCode code() const { return m_code; }
    [[nodiscard]] const std::string& subject() const { return m_subject; }
    [[nodiscard]] const std::vector<Issue>& issues() const { return m_issues; }

private:
    ErrorCode m_code;
    std::string m_subject;
    std::vector<Issue> m_issues;
};

/**
 * Throws `std::logic_error` with the text `what` if the condition is false, which only a bug can
 * cause.
 */
void require(bool condition, std::string_view what);

} // namespace berg
