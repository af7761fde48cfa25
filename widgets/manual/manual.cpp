#include "widgets/manual/manual.h"

#include "core/base/error.h"
#include "core/base/number_text.h"
#include "core/scenario/fields.h"

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

/** Exact number, with exponent if that is shorter: 1e6. */
QString shortNumber(double number)
{
    const QString digits = QString::fromStdString(numberText(number));
    const QString power = QString::number(number, 'g', QLocale::FloatingPointShortest)
                              .replace(u"e+0"_s, u"e"_s)
                              .replace(u"e+"_s, u"e"_s);
    return power.size() < digits.size() ? power : digits;
}

/** Rows with path, smallest and largest value of each number of a scenario. */
std::vector<QStringList> limitRows()
{
    std::vector<QStringList> rows;
    forEachObject([&rows](const std::string& object, const auto& fields) {
        for (const auto& field : fields)
            if (field.limits && field.limits->high < std::numeric_limits<double>::max())
                rows.push_back({QString::fromStdString(object + field.name),
                                (field.limits->above ? u"above "_s : QString()) +
                                    shortNumber(field.limits->low),
                                shortNumber(field.limits->high)});
    });
    return rows;
}

/** Rows of the scenario page that describe the fields; the chapter's `own` translations replace
 * them. */
std::vector<QStringList> fieldRows(const std::vector<QStringList>& own)
{
    for (const MarkdownBlock& block : blocksOf(u"scenarios/README.md"_s)) {
        if (block.rows.empty())
            continue;
        std::vector<QStringList> rows(block.rows.begin() + 1, block.rows.end());
        for (QStringList& row : rows) {
            const auto it = std::ranges::find(own, row.front(),
                                              [](const QStringList& one) { return one.front(); });
            if (it != own.end())
                row = *it;
        }
        return rows;
    }
    return {};
}

/** Fills the tables of the chapter about fields, which contains their headers only. */
void fillTables(std::vector<MarkdownBlock>& blocks)
{
    bool isFirst = true;
    for (MarkdownBlock& block : blocks)
        if (!block.rows.empty()) {
            std::vector<QStringList> rows = isFirst ? fieldRows(block.rows) : limitRows();
            rows.insert(rows.begin(), block.rows.front());
            block.rows = std::move(rows);
            isFirst = false;
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
