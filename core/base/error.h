#pragma once

#include "core/base/issue.h"

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace berg {

/** What kind of failure an `Error` is; the interface maps each code to a translated text. */
enum class ErrorCode
{
    FileNotFound,
    FileUnreadable,
    FileUnwritable,
    FileTooLarge,
    SyntaxError,        ///< not well-formed JSON
    WrongFormat,        ///< well-formed, but not the kind of file asked for
    UnsupportedVersion, ///< made by a newer program
    InvalidInput,       ///< fields out of range, missing, contradictory: see `issues()`
    Unsupported,        ///< asks for something this build cannot do
    SolverFailed,
    ReplayMismatch ///< a run file does not reproduce what it recorded
};

/**
 * Failure of input, file or back end (bugs throw `std::logic_error`, see `require`).
 * `subject` names the file, field or option; `what()` is "subject: message", one line per issue.
 */
class Error : public std::runtime_error
{
public:
    Error(ErrorCode code, std::string subject, IssueReason reason);
    /** In words of another program that nobody translates. */
    Error(ErrorCode code, std::string subject, std::string words);
    /** `issues` not empty; `what()` has one line "subject: field: message" for each. */
    Error(ErrorCode code, std::string subject, std::vector<Issue> issues);

    [[nodiscard]] ErrorCode code() const { return m_code; }
    [[nodiscard]] const std::string& subject() const { return m_subject; }
    [[nodiscard]] const std::vector<Issue>& issues() const { return m_issues; }

private:
    ErrorCode m_code;
    std::string m_subject;
    std::vector<Issue> m_issues;
};

/** Throws `std::logic_error` when a condition that only a bug can break is false. */
void require(bool condition, std::string_view what);

} // namespace berg
