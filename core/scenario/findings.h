#pragma once

// Private to core/scenario.

#include "core/base/issue.h"
#include "core/scenario/checks.h"
#include "core/scenario/limits.h"
#include "core/scenario/scenario.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace berg {

/** Gathers the findings of `validate` and `advice`, whose checks call it field by field. */
class Findings
{
public:
    enum class Kind
    {
        All,
        Unreadable ///< errors of single fields only
    };
    explicit Findings(Kind kind) : m_kind(kind) {}

    using Arguments = std::vector<IssueArgument>;

    /** Of fields that are each in range but do not fit together. */
    void conflict(std::string field, IssueId id, Arguments arguments = {})
    {
        if (m_kind == Kind::All)
            error(std::move(field), id, std::move(arguments));
    }
    void error(std::string field, IssueId id, Arguments arguments = {})
    {
        if (++m_errors <= kMostStored)
            add(Severity::Error, std::move(field), id, std::move(arguments));
    }
    void warn(std::string field, IssueId id, Arguments arguments = {})
    {
        if (m_kind == Kind::All)
            add(Severity::Warning, std::move(field), id, std::move(arguments));
    }
    void hint(std::string field, IssueId id, Arguments arguments = {})
    {
        if (m_kind == Kind::All)
            add(Severity::Hint, std::move(field), id, std::move(arguments));
    }

    /**
     * False, with an error noted, when the number is not in the limits (NaN never is). What is only
     * less than the least that is flown can be read.
     */
    bool inRange(double value, const Limits& limits, const std::string& field)
    {
        const bool reads = m_kind == Kind::Unreadable && limits.low > 0;
        const Limits positive{.low = 0, .high = limits.high, .above = true};
        std::optional<IssueReason> fault = outOfLimits(value, reads ? positive : limits);
        if (fault)
            error(field, fault->id, std::move(fault->arguments));
        return !fault;
    }

    bool inRange(const std::optional<double>& value, const Limits& limits, const std::string& field)
    {
        return !value || inRange(*value, limits, field);
    }

    bool inRange(const Point& value, const Limits& limits, const std::string& field)
    {
        const bool first = inRange(value.x(), limits, entryPath(field, 0));
        return inRange(value.y(), limits, entryPath(field, 1)) && first;
    }

    void utf8(const std::string& text, const std::string& field)
    {
        if (!isUtf8(text))
            error(field, IssueId::NotUtf8);
    }

    [[nodiscard]] std::vector<Issue> take()
    {
        if (m_errors > kMostStored)
            add(Severity::Error, "", IssueId::MoreFaults, {countOf(m_errors - kMostStored)});
        return std::move(m_issues);
    }

private:
    static constexpr std::size_t kMostStored = 1000; ///< nobody reads more

    void add(Severity severity, std::string field, IssueId id, Arguments arguments)
    {
        m_issues.push_back(
            Issue{severity, std::move(field), {.id = id, .arguments = std::move(arguments)}});
    }

    Kind m_kind;
    std::size_t m_errors = 0;
    std::vector<Issue> m_issues;
};

} // namespace berg
