#include "widgets/words/export_text.h"

#include "core/base/error.h"
#include "widgets/words/error_text.h"
#include "widgets/words/issue_text.h"

#include <QCoreApplication>

#include <stdexcept>

using namespace Qt::StringLiterals;

namespace berg {

namespace {

struct ExportText
{
    Q_DECLARE_TR_FUNCTIONS(ExportText)
};

/** Returns the translation of a text of a format's row. */
QString formatWords(const char* english)
{
    return QCoreApplication::translate("ExportText", english);
}

} // namespace

QString exportGroupText(ExportGroup group)
{
    switch (group) {
    case ExportGroup::Autopilots:
        return ExportText::tr("Autopilots");
    case ExportGroup::Maps:
        return ExportText::tr("Maps and globes");
    case ExportGroup::Pages:
        return ExportText::tr("Pictures and print");
    case ExportGroup::Tables:
        return ExportText::tr("Tables");
    }
    throw std::logic_error("exportGroupText: unknown group");
}

ExportFormatText exportFormatText(const ExportFormat& format)
{
    const ExportWords& words = format.words;
    QString name = formatWords(words.name);
    if (name.contains(u"%1"_s))
        name = name.arg(QString::fromStdString(std::string(format.extension)).toUpper());
    return {.group = words.group,
            .name = name,
            .tool = formatWords(words.tool),
            .about = formatWords(words.about)};
}

QString exportEffectText(ExportEffect effect)
{
    switch (effect) {
    case ExportEffect::Check:
        return ExportText::tr("Check before the flight");
    case ExportEffect::Note:
        return ExportText::tr("Good to know");
    case ExportEffect::Changed:
        return ExportText::tr("Changed");
    case ExportEffect::LeftOut:
        return ExportText::tr("Left out");
    }
    throw std::logic_error("exportEffectText: unknown effect");
}

QString exportNoteText(const ExportNote& note, const QLocale& locale)
{
    std::vector<IssueArgument> arguments = noteArguments(note);
    if (note.kind == ExportNoteKind::OptionNotUsed)
        arguments = {FieldPath{"export." + std::string(note.tool)}};
    return coreText(notePattern(note.kind), arguments, locale);
}

QString exportRefusalText(const Error& error)
{
    const QStringList lines = optionIssueLines(error, "export");
    return lines.empty() ? errorReport(error) : lines.join(u'\n');
}

} // namespace berg
