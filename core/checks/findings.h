#pragma once

// For core/checks and the sources that draw fields.

#include "core/base/issue.h"
#include "core/scenario/limits.h"
#include "core/scenario/scenario.h"
#include "core/scenario/text_checks.h"

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace berg {

/**
 * Collects the findings of `validate` and `scenarioWarnings`, whose checks call it for each field.
 */
class Findings
{
public:
    /** Selects the findings to collect. */
    enum class Kind
    {
        All,
        Unreadable ///< only errors of single fields
    };
    explicit Findings(Kind kind) : m_kind(kind) {}

    using Arguments = std::vector<IssueArgument>;

    /** Reports an error about fields that are each in range but do not fit together. */
    void conflict(std::string field, IssueId id, Arguments arguments = {})
    {
        if (m_kind == Kind::All)
            error(std::move(field), id, std::move(arguments));
    }
    /**
     * Reports an error. Only the first `kMostStored` errors are stored; `take` reports the number
     * of the others.
     */
    void error(std::string field, IssueId id, Arguments arguments = {})
    {
        if (++m_errors <= kMostStored)
            add(Severity::Error, std::move(field), id, std::move(arguments));
    }
    /** Reports a warning. */
    void warn(std::string field, IssueId id, Arguments arguments = {})
    {
        if (m_kind == Kind::All)
            add(Severity::Warning, std::move(field), id, std::move(arguments));
    }
    /** Reports a hint. */
    void hint(std::string field, IssueId id, Arguments arguments = {})
    {
        if (m_kind == Kind::All)
            add(Severity::Hint, std::move(field), id, std::move(arguments));
    }

    /**
     * Returns true if the number is within the limits, otherwise reports an error and returns false
     * (always for NaN). When collecting Unreadable findings, a positive number below the lower
     * limit is accepted, because an editor can show it.
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

    bool inRange(const std::optional<Point>& value, const Limits& limits, const std::string& field)
    {
        return !value || inRange(*value, limits, field);
    }

    bool inRange(const Point& value, const Limits& limits, const std::string& field)
    {
        const bool first = inRange(value.x(), limits, entryPath(field, 0));
        return inRange(value.y(), limits, entryPath(field, 1)) && first;
    }

    /** Reports an error if the text is not valid UTF-8. */
    void utf8(const std::string& text, const std::string& field)
    {
        if (!isUtf8(text))
            error(field, IssueId::NotUtf8);
    }

    /** Returns true if a stored error is about this field or a part of it. */
    [[nodiscard]] bool has(std::string_view field) const
    {
        return std::ranges::any_of(m_issues, [field](const Issue& issue) {
            if (issue.severity != Severity::Error || !issue.field.starts_with(field))
                return false;
            const std::string_view rest = std::string_view(issue.field).substr(field.size());
            return rest.empty() || rest.front() == '.' || rest.front() == '[';
        });
    }

    /** Returns the findings and leaves this object empty. */
    [[nodiscard]] std::vector<Issue> take()
    {
        if (m_errors > kMostStored)
            add(Severity::Error, "", IssueId::MoreFaults, {countOf(m_errors - kMostStored)});
        return std::move(m_issues);
    }

private:
    static constexpr std::size_t kMostStored = 1000; ///< more errors help nobody

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
