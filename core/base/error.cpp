#include "core/base/error.h"

namespace berg {

namespace {

std::string joined(const std::string& subject, const std::vector<Issue>& issues)
{
    std::string text;
    for (const Issue& issue : issues) {
        if (!text.empty())
            text += '\n';
        for (const std::string& part : {subject, issue.field})
            if (!part.empty())
                text += part + ": ";
        text += issue.message();
    }
    return text;
}

} // namespace

Error::Error(ErrorCode code, std::string subject, IssueReason reason)
    : Error(code, std::move(subject), {{Severity::Error, "", std::move(reason)}})
{
}

Error::Error(ErrorCode code, std::string subject, std::string words)
    : Error(code, std::move(subject), IssueReason{IssueId::Verbatim, {std::move(words)}})
{
}

Error::Error(ErrorCode code, std::string subject, std::vector<Issue> issues)
    : std::runtime_error(joined(subject, issues))
    , m_code(code)
    , m_subject(std::move(subject))
    , m_issues(std::move(issues))
{
}

void require(bool condition, std::string_view what)
{
    if (!condition)
        throw std::logic_error(std::string(what));
}

} // namespace berg
