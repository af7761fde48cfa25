#pragma once

#include "core/base/quantity.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace berg {

enum class Severity
{
    Error,
    Warning,
    Hint
};

/** Kind of a finding; `issues.inc` has its English words and arguments. */
enum class IssueId
{
#define ISSUE(id, words) id,
#include "core/base/issues.inc"
#undef ISSUE
};
inline constexpr int kIssueIds = static_cast<int>(IssueId::PolicyNotFlown) + 1;

/** Type of a value in a file. */
enum class ValueKind
{
    Null,
    Object,
    Array,
    String,
    True,
    False,
    Number,
    Boolean,    ///< true or false
    TwoNumbers, ///< an array of them
    Pairs       ///< an array of an even count of numbers
};

/** Name of a field, or path of an object, in a file. */
struct FieldPath
{
    std::string path;
    bool operator==(const FieldPath&) const = default;
};

/** A `double` is a value of the finding's field, in SI as in the file; `Amount` has its unit. */
using IssueArgument = std::variant<double, std::int64_t, std::string, ValueKind, Amount, FieldPath>;

[[nodiscard]] inline IssueArgument countOf(std::size_t number)
{
    return static_cast<std::int64_t>(number);
}

struct IssueReason
{
    IssueId id = IssueId::Verbatim;
    std::vector<IssueArgument> arguments = {};
    bool operator==(const IssueReason&) const = default;
};

/** Returns the English words of an id, in which %1, %2, ... stand for its arguments. */
[[nodiscard]] std::string_view englishWords(IssueId id);
/** Returns the English words for a type of value, such as "an array". */
[[nodiscard]] std::string_view englishWords(ValueKind kind);

/**
 * Returns the pattern, in any language, with %1 to %9 replaced by the arguments. A missing argument
 * becomes empty text. If the pattern has no %, the first argument follows it as `: "argument"`.
 */
[[nodiscard]] std::string filledIn(std::string_view pattern,
                                   const std::vector<IssueArgument>& arguments);

/** Returns the reason in English, without the names of field and file. */
[[nodiscard]] std::string englishText(const IssueReason& reason);

/** One finding about a scenario or a file. */
struct Issue
{
    Severity severity = Severity::Error;
    /** Path such as `icebergs[3].q_m2ps`, or `line 3` of a table; empty for the whole. */
    std::string field;
    IssueReason reason = {};

    [[nodiscard]] std::string message() const { return englishText(reason); }
    bool operator==(const Issue&) const = default;
};

/** Returns true if at least one finding is an error. */
[[nodiscard]] bool hasErrors(const std::vector<Issue>& issues);

} // namespace berg
