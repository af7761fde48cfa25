#include "app/cli/language.h"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <iterator>
#include <span>
#include <system_error>
#include <utility>

namespace berg::cli {

namespace {

using Translation = std::pair<std::string_view, std::string_view>;

constexpr Translation kDanish[] = {
#include "app/cli/catalogue_da.inc"
};
constexpr Translation kFrench[] = {
#include "app/cli/catalogue_fr.inc"
};
constexpr Translation kNorwegian[] = {
#include "app/cli/catalogue_nb.inc"
};

std::span<const Translation> translations()
{
    std::string_view locale;
    for (const char* const name : {"LC_ALL", "LC_MESSAGES", "LANG"})
        if (const char* const value = std::getenv(name); // NOLINT(concurrency-mt-unsafe): not set
            locale.empty() && value != nullptr)
            locale = value;
    const std::string_view language = locale.substr(0, locale.find_first_of("_.@"));
    if (language == "da")
        return kDanish;
    if (language == "fr")
        return kFrench;
    if (language == "nb" || language == "no")
        return kNorwegian;
    return {};
}

constexpr std::pair<int, std::string_view> kRefusals[] = {
#define REFUSAL(number, words) {number, words},
#include "core/base/refusals.inc"
#undef REFUSAL
};

/** Words for a kind of value, or for why the system refuses; anything else is as it is. */
IssueArgument saidArgument(const IssueArgument& argument)
{
    if (const auto* const kind = std::get_if<ValueKind>(&argument))
        return std::string(said(englishWords(*kind)));
    if (const auto* const words = std::get_if<std::string>(&argument))
        for (const auto& [number, refusal] : kRefusals)
            if (*words == std::generic_category().message(number) && said(refusal) != refusal)
                return std::string(said(refusal));
    return argument;
}

} // namespace

std::string_view said(std::string_view english)
{
    static const std::span<const Translation> known = translations();
    const auto found = std::ranges::find(known, english, &Translation::first);
    return found == known.end() ? english : found->second;
}

std::string said(std::string_view pattern, const std::vector<IssueArgument>& arguments)
{
    std::vector<IssueArgument> texts;
    std::ranges::transform(arguments, std::back_inserter(texts), saidArgument);
    return filledIn(said(pattern), texts);
}

std::string said(const IssueReason& reason)
{
    return said(englishWords(reason.id), reason.arguments);
}

std::string said(const Issue& issue)
{
    constexpr std::string_view kLine = "line ";
    if (issue.field.empty())
        return said(issue.reason);
    const std::string place =
        issue.field.starts_with(kLine)
            ? said(QT_TRANSLATE_NOOP("IssueText", "line %1"), {issue.field.substr(kLine.size())})
            : issue.field;
    return place + ": " + said(issue.reason);
}

std::string said(const Error& error)
{
    std::string text;
    for (const Issue& issue : error.issues())
        text += (text.empty() ? "" : "\n") + error.subject() +
                (error.subject().empty() ? "" : ": ") + said(issue);
    return text;
}

ReportWords reportLanguage()
{
    return ReportWords([](std::string_view english) { return std::string(said(english)); });
}

Sentence sentence(std::string_view pattern, const std::vector<IssueArgument>& arguments)
{
    return {.english = filledIn(pattern, arguments), .said = said(pattern, arguments)};
}

} // namespace berg::cli
