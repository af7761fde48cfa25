#include "widgets/manual/manual.h"

#include "core/base/error.h"
#include "core/io/files/field_rows.h"
#include "core/scenario/fields.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QTranslator>

#include <algorithm>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

struct ManualText
{
    Q_DECLARE_TR_FUNCTIONS(ManualText)
};

/** Readable text of a block in lines; each row of a table is one line. */
QStringList linesOf(const MarkdownBlock& block)
{
    QStringList lines;
    for (const QStringList& row : block.rows)
        lines << plainText(row.join(u" · "_s));
    const QStringList written =
        block.kind == MarkdownKind::Code ? block.text.split(u'\n') : QStringList{block.text};
    for (const QString& line : written)
        if (!line.isEmpty())
            lines << (block.kind == MarkdownKind::Code ? line : plainText(line));
    return lines;
}

/** Replaces Greek letters by their names, so that "tau" finds τ as well. */
QString typed(QString text)
{
    const std::array<std::pair<QChar, const char*>, 4> letters{
        {{u'σ', "sigma"}, {u'τ', "tau"}, {u'ζ', "zeta"}, {u'μ', "mu"}}};
    for (const auto& [letter, name] : letters)
        text.replace(letter, QLatin1String(name));
    return text;
}

std::vector<MarkdownBlock> blocksOf(const QString& path)
{
    QFile file(u":/manual/"_s + path);
    require(file.open(QIODevice::ReadOnly), "readManual: chapters are part of the program");
    return markdownBlocks(QString::fromUtf8(file.readAll()));
}

/**
 * Fills the table of the chapter about fields, which has only its header, in the language of the
 * chapter, which need not be the window's.
 */
void fillTable(std::vector<MarkdownBlock>& blocks, const QString& language)
{
    QTranslator translator;
    const bool isTranslated = translator.load(u":/i18n/bergwatch_%1.qm"_s.arg(language));
    const auto said = [&](const char* english) {
        const QString own = isTranslated ? translator.translate(kFieldContext, english) : QString();
        return own.isEmpty() ? std::string(english) : own.toStdString();
    };
    const auto table = std::ranges::find_if(
        blocks, [](const MarkdownBlock& block) { return !block.rows.empty(); });
    require(table != blocks.end(), "readManual: the chapter has a table");
    for (const FieldRow& row : fieldRows(said))
        table->rows.push_back(
            {QString::fromStdString(row.field), QString::fromStdString(row.standard),
             QString::fromStdString(row.values), QString::fromStdString(row.meaning)});
}

} // namespace

QString ManualChapter::title() const
{
    return blocks.empty() ? name : plainText(blocks.front().text);
}

QString ManualChapter::html(const QString& pictureFolder, bool anchors) const
{
    std::vector<MarkdownBlock> shown = blocks;
    for (MarkdownBlock& block : shown) // blocks are not removed: anchors use their numbers
        if (block.kind == MarkdownKind::Picture &&
            !QFile::exists(QDir(pictureFolder).filePath(block.info)))
            block = {.kind = MarkdownKind::Text};
    return markdownHtml(shown, anchors);
}

const ManualChapter* Manual::chapterAt(const QString& place) const
{
    const QString name = place.section(u'#', 0, 0).section(u'.', 0, 0);
    const auto found = std::find_if(chapters.begin(), chapters.end(),
                                    [&](const ManualChapter& one) { return one.name == name; });
    return found == chapters.end() ? nullptr : &*found;
}

std::vector<ManualHit> Manual::search(const QString& words) const
{
    const QStringList wanted = typed(words).split(u' ', Qt::SkipEmptyParts);
    std::vector<ManualHit> hits;
    if (wanted.isEmpty())
        return hits;
    for (const ManualChapter& chapter : chapters) {
        QString heading;
        for (std::size_t i = 0; i < chapter.blocks.size(); ++i) {
            const MarkdownBlock& block = chapter.blocks[i];
            if (block.kind == MarkdownKind::Heading)
                heading = plainText(block.text);
            for (const QString& line : linesOf(block))
                if (std::all_of(wanted.begin(), wanted.end(), [&](const QString& word) {
                        return typed(line).contains(word, Qt::CaseInsensitive);
                    }))
                    hits.push_back({.place = u"%1.html#block-%2"_s.arg(chapter.name).arg(i),
                                    .heading = heading,
                                    .line = line});
        }
    }
    return hits;
}

QString manualLanguage()
{
    return ManualText::tr("en", "folder of the manual in this language");
}

Manual readManual(const QString& language)
{
    Manual manual;
    for (const char* name : kManualChapters) {
        const QString chapter = QLatin1String(name);
        manual.chapters.push_back(
            {.name = chapter, .blocks = blocksOf(u"%1/%2.md"_s.arg(language, chapter))});
        if (chapter == u"fields"_s)
            fillTable(manual.chapters.back().blocks, language);
    }
    return manual;
}

QString manualPictures(const QString& language)
{
    const QDir program(QCoreApplication::applicationDirPath());
    const QString installed = program.filePath(u"../share/doc/bergwatch/manual/"_s + language);
    return QDir(installed).exists() ? installed : program.filePath(u"../manual/"_s + language);
}

} // namespace berg
