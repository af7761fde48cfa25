#include "core/base/issue.h"

#include "core/base/number_text.h"
#include "core/base/translate_noop.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace berg {

namespace {

constexpr std::array<std::string_view, 10> kKinds{
    "null",
    QT_TRANSLATE_NOOP("IssueText", "an object"),
    QT_TRANSLATE_NOOP("IssueText", "an array"),
    QT_TRANSLATE_NOOP("IssueText", "a string"),
    "true",
    "false",
    QT_TRANSLATE_NOOP("IssueText", "a number"),
    QT_TRANSLATE_NOOP("IssueText", "true or false"),
    QT_TRANSLATE_NOOP("IssueText", "two numbers"),
    QT_TRANSLATE_NOOP("IssueText", "pairs of numbers")};

/** Behind a number, with a space in front where there is one. */
std::string_view unitText(Quantity quantity)
{
    switch (quantity) {
    case Quantity::Text:
    case Quantity::Utc:
    case Quantity::Number:
        break;
    case Quantity::Metres:
    case Quantity::Distance:
    case Quantity::Height:
        return " m";
    case Quantity::Speed:
        return " m/s";
    case Quantity::Seconds:
        return " s";
    case Quantity::Degrees:
        return "°";
    case Quantity::Percent:
        return " %";
    case Quantity::Celsius:
        return " °C";
    case Quantity::Variance:
        return " m²";
    case Quantity::Growth:
        return " m²/s";
    }
    return "";
}

std::string argumentText(const IssueArgument& argument)
{
    if (const auto* const amount = std::get_if<Amount>(&argument))
        return numberText(amount->value).append(unitText(amount->quantity));
    if (const auto* const field = std::get_if<FieldPath>(&argument))
        return field->path;
    if (const auto* const number = std::get_if<double>(&argument))
        return numberText(*number);
    if (const auto* const count = std::get_if<std::int64_t>(&argument))
        return std::to_string(*count);
    if (const auto* const kind = std::get_if<ValueKind>(&argument))
        return std::string(englishWords(*kind));
    return std::get<std::string>(argument);
}

constexpr std::string_view kIssueWords[] = {
#define ISSUE(id, words) words,
#include "core/base/issues.inc"
#undef ISSUE
};

} // namespace

std::string_view englishWords(IssueId id)
{
    return kIssueWords[static_cast<std::size_t>(id)];
}

std::string_view englishWords(ValueKind kind)
{
    return kKinds.at(static_cast<std::size_t>(kind));
}

std::string filledIn(std::string_view pattern, const std::vector<IssueArgument>& arguments)
{
    const auto argument = [&](char number) {
        const auto i = static_cast<std::size_t>(number - '1');
        return i < arguments.size() ? argumentText(arguments[i]) : std::string();
    };
    std::string text;
    for (std::size_t i = 0; i < pattern.size(); ++i)
        if (pattern[i] == '%' && i + 1 < pattern.size() && pattern[i + 1] >= '1' &&
            pattern[i + 1] <= '9')
            text += argument(pattern[++i]);
        else
            text += pattern[i];
    const bool hasDetail = !arguments.empty() && pattern.find('%') == pattern.npos;
    return hasDetail ? text + ": \"" + argument('1') + '"' : text;
}

std::string englishText(const IssueReason& reason)
{
    return filledIn(englishWords(reason.id), reason.arguments);
}

bool hasErrors(const std::vector<Issue>& issues)
{
    return std::any_of(issues.begin(), issues.end(),
                       [](const Issue& i) { return i.severity == Severity::Error; });
}

} // namespace berg
