#include "core/base/error.h"

namespace berg {

namespace {

std::string joined(const std::string& subject, const std::vector<Issue>& issues)
{
    std::string text;
    for (const Issue& issue : issues) {
        if (!text.empty())
            text += '\n';
        text += subject;
        if (!issue.field.empty())
            text += ": " + issue.field;
        text += ": " + issue.message;
    }
    return text;
}

} // namespace

Error::Error(ErrorCode code, std::string subject, const std::string& message)
    : std::runtime_error(subject.empty() ? message : subject + ": " + message)
    , m_code(code)
    , m_subject(std::move(subject))
    , m_issues{{Severity::Error, "", message}}
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
