#include "widgets/words/issue_text.h"

#include "widgets/words/field_names.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <optional>
#include <system_error>
#include <utility>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

struct IssueText
{
    Q_DECLARE_TR_FUNCTIONS(IssueText)
};

// The words of findings, for lupdate.
#define ISSUE(id, words)
#include "core/base/issues.inc"
#undef ISSUE

constexpr std::pair<int, const char*> kRefusals[] = {
#define REFUSAL(number, words) {number, words},
#include "core/base/refusals.inc"
#undef REFUSAL
};

/** Why the system refuses, in the words of the window where it knows them. */
std::string refusalText(const std::string& words)
{
    for (const auto& [number, text] : kRefusals)
        if (words == std::generic_category().message(number))
            return IssueText::tr(text).toStdString();
    return words;
}

bool isRefusal(IssueId id)
{
    return id == IssueId::CannotOpen || id == IssueId::CannotRead || id == IssueId::CannotWrite;
}

/** Returns K of a path that begins with `list[K]`; nullopt for other paths. */
std::optional<std::size_t> entryIn(std::string_view path, std::string_view list)
{
    if (!path.starts_with(list) || path.substr(list.size()).substr(0, 1) != "[")
        return std::nullopt;
    const std::string_view number = path.substr(list.size() + 1);
    std::size_t index = 0;
    const auto read = std::from_chars(number.data(), number.data() + number.size(), index);
    return read.ec == std::errc() ? std::optional(index) : std::nullopt;
}

/** The label of a field in quotes; of an object its place in the list as people count. */
QString pathText(const std::string& path)
{
    if (const QString label = fieldName(path); !label.isEmpty())
        return u'"' + label + u'"';
    if (const auto iceberg = entryIn(path, "icebergs"))
        return IssueText::tr("iceberg %1").arg(*iceberg + 1);
    if (const auto uav = entryIn(path, "uavs"))
        return IssueText::tr("UAV %1").arg(*uav + 1);
    return QString::fromStdString(path);
}

QString argumentText(const IssueArgument& argument, const std::string& field, const QLocale& locale)
{
    if (const auto* const kind = std::get_if<ValueKind>(&argument))
        return coreWords(std::string(englishWords(*kind)));
    if (const auto* const path = std::get_if<FieldPath>(&argument))
        return pathText(path->path);
    return fieldValue(field, argument, locale);
}

/** Returns the sentence with `texts` in place of `%1`, `%2`, …; place holders in texts are kept. */
QString filledIn(const QString& sentence, const QStringList& texts)
{
    QString filled;
    for (qsizetype i = 0; i < sentence.size(); ++i)
        if (sentence[i] == u'%' && i + 1 < sentence.size() && sentence[i + 1].isDigit())
            filled += texts.value(sentence[++i].digitValue() - 1);
        else
            filled += sentence[i];
    return filled;
}

/** The translation with the arguments; `field` gives the unit of those that are its values. */
QString textOf(std::string_view english, const std::vector<IssueArgument>& arguments,
               const std::string& field, const QLocale& locale)
{
    QStringList texts;
    for (const IssueArgument& argument : arguments)
        texts << argumentText(argument, field, locale);
    const bool hasDetail = !texts.empty() && english.find('%') == std::string_view::npos;
    return filledIn(coreWords(std::string(english)), texts) +
           (hasDetail ? u": \"%1\""_s.arg(texts[0]) : QString());
}

/** Returns the finding's words without its field. */
QString findingWords(const Issue& issue, const QLocale& locale)
{
    std::vector<IssueArgument> arguments = issue.reason.arguments;
    if (isRefusal(issue.reason.id))
        for (IssueArgument& argument : arguments)
            if (const auto* const words = std::get_if<std::string>(&argument))
                argument = refusalText(*words);
    return textOf(englishWords(issue.reason.id), arguments, issue.field, locale);
}

template <class Object>
QString nameOfEntry(const Issue& issue, std::string_view list, const std::vector<Object>& objects)
{
    const std::optional<std::size_t> index = issueIndex(issue, list);
    if (!index || *index >= objects.size())
        return {};
    const Object& object = objects[*index];
    return QString::fromStdString(object.name.empty() ? object.id : object.name);
}

QString capitalised(const QString& words)
{
    return words.first(std::min(words.size(), qsizetype(1))).toUpper() + words.mid(1);
}

} // namespace

QString coreText(std::string_view english, const std::vector<IssueArgument>& arguments,
                 const QLocale& locale)
{
    return capitalised(textOf(english, arguments, {}, locale));
}

QString issueSentence(IssueId id, const std::vector<IssueArgument>& arguments)
{
    return coreText(englishWords(id), arguments, QLocale());
}

QString issueText(const Issue& issue, const QLocale& locale)
{
    const QString label = fieldName(issue.field);
    const QString words = findingWords(issue, locale);
    return label.isEmpty() ? capitalised(words) : u"%1: %2"_s.arg(label, words);
}

QString coreWords(const std::string& english)
{
    return IssueText::tr(english.c_str());
}

QString coreWords(const std::string& english, std::size_t count)
{
    return IssueText::tr(english.c_str(), nullptr, static_cast<int>(count));
}

QString issueWords(IssueId id)
{
    return IssueText::tr(englishWords(id).data());
}

QString placedIssueText(const Issue& issue)
{
    QString place = QString::fromStdString(issue.field);
    for (const auto& [start, text] :
         {std::pair("line ", QT_TRANSLATE_NOOP("IssueText", "line %1")),
          std::pair("feature ", QT_TRANSLATE_NOOP("IssueText", "feature %1")),
          std::pair("packet ", QT_TRANSLATE_NOOP("IssueText", "packet %1")),
          std::pair("photograph ", QT_TRANSLATE_NOOP("IssueText", "photograph %1"))})
        if (issue.field.starts_with(start)) {
            place = IssueText::tr(text).arg(place.section(u' ', 1));
            break;
        }
    const QString words = findingWords(issue, QLocale());
    return place.isEmpty() ? words : u"%1: %2"_s.arg(place, words);
}

QStringList issueLines(const Error& error)
{
    QStringList lines;
    for (const Issue& issue : error.issues())
        lines << placedIssueText(issue);
    return lines;
}

QStringList optionIssueLines(const Error& error, const std::string& dialog)
{
    QStringList lines;
    for (Issue issue : error.issues()) {
        issue.field = dialog + '.' + (error.subject() == dialog ? issue.field : error.subject());
        if (fieldName(issue.field).isEmpty())
            return {};
        for (IssueArgument& argument : issue.reason.arguments)
            if (auto* const other = std::get_if<FieldPath>(&argument))
                other->path = dialog + '.' + other->path;
        lines << issueText(issue);
    }
    return lines;
}

QString issueOwner(const Issue& issue, const Scenario& scenario)
{
    const QString iceberg = nameOfEntry(issue, "icebergs", scenario.icebergs);
    return iceberg.isEmpty() ? nameOfEntry(issue, "uavs", scenario.uavs) : iceberg;
}

QString issueLine(const Issue& issue, const Scenario& scenario)
{
    const QString owner = issueOwner(issue, scenario);
    const QString label = fieldName(issue.field);
    if (owner.isEmpty())
        return issueText(issue);
    return (label.isEmpty() ? owner : owner + u", "_s + label) + u": "_s +
           findingWords(issue, QLocale());
}

IssueCounts countIssues(const std::vector<Issue>& issues)
{
    IssueCounts counts;
    for (const Issue& issue : issues)
        ++(issue.severity == Severity::Error     ? counts.errors
           : issue.severity == Severity::Warning ? counts.warnings
                                                 : counts.hints);
    return counts;
}

QString countsText(const IssueCounts& counts)
{
    QStringList parts;
    if (counts.errors > 0)
        parts << IssueText::tr("%n errors", nullptr, counts.errors);
    if (counts.warnings > 0)
        parts << IssueText::tr("%n warnings", nullptr, counts.warnings);
    if (parts.isEmpty() && counts.hints > 0)
        parts << IssueText::tr("%n hints", nullptr, counts.hints);
    return parts.join(u", "_s);
}

std::optional<std::size_t> issueIndex(const Issue& issue, std::string_view list)
{
    return entryIn(issue.field, list);
}

} // namespace berg
