#include "widgets/manual/manual.h"

#include "core/base/error.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>

#include <algorithm>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

struct ManualText
{
    Q_DECLARE_TR_FUNCTIONS(ManualText)
};

/** All that can be read of a block, in lines: of a table each row is one. */
QStringList linesOf(const MarkdownBlock& block)
{
    QStringList lines;
    for (const QStringList& row : block.rows)
        lines << plainText(row.join(u" · "_s));
    const QStringList written =
        block.kind == MarkdownBlock::Kind::Code ? block.text.split(u'\n') : QStringList{block.text};
    for (const QString& line : written)
        if (!line.isEmpty())
            lines << (block.kind == MarkdownBlock::Kind::Code ? line : plainText(line));
    return lines;
}

/** As one types it: "tau" finds τ too. */
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

/** The tables of the page about scenario files, which the chapter has in its own words as far as it
 * has. */
void fillTables(std::vector<MarkdownBlock>& blocks)
{
    std::vector<MarkdownBlock> page = blocksOf(u"scenarios/README.md"_s);
    std::erase_if(page, [](const MarkdownBlock& block) { return block.rows.empty(); });
    auto source = page.begin();
    for (MarkdownBlock& block : blocks) {
        if (block.rows.empty() || source == page.end())
            continue;
        std::vector<QStringList> rows{block.rows.front()};
        for (auto row = source->rows.begin() + 1; row != source->rows.end(); ++row) {
            const auto own =
                std::find_if(block.rows.begin(), block.rows.end(),
                             [&](const auto& one) { return one.front() == row->front(); });
            rows.push_back(own == block.rows.end() ? *row : *own);
        }
        block.rows = std::move(rows);
        ++source;
    }
}

} // namespace

QString ManualChapter::title() const
{
    return blocks.empty() ? name : plainText(blocks.front().text);
}

QString ManualChapter::html(const QString& pictureFolder, bool anchors) const
{
    std::vector<MarkdownBlock> shown = blocks;
    for (MarkdownBlock& block : shown) // numbers of blocks are part of the anchors: none is removed
        if (block.kind == MarkdownBlock::Kind::Picture &&
            !QFile::exists(QDir(pictureFolder).filePath(block.info)))
            block = {.kind = MarkdownBlock::Kind::Text};
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
            if (block.kind == MarkdownBlock::Kind::Heading)
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
            fillTables(manual.chapters.back().blocks);
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
