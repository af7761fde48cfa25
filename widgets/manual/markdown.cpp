#include "widgets/manual/markdown.h"

#include <QRegularExpression>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

const QRegularExpression& linkPattern()
{
    static const QRegularExpression pattern(u"\\[([^\\]]+)\\]\\(([^)]+)\\)"_s);
    return pattern;
}

MarkdownBlock headingOf(const QString& line)
{
    static const QRegularExpression pattern(u"^(#+) (.*?)(?: \\{#([a-z0-9-]+)\\})?$"_s);
    const QRegularExpressionMatch match = pattern.match(line);
    return {.kind = MarkdownKind::Heading,
            .level = static_cast<int>(match.capturedLength(1)),
            .id = match.captured(3),
            .text = match.captured(2)};
}

QStringList cellsOf(const QString& line)
{
    QStringList cells = line.trimmed().mid(1).chopped(1).split(u'|');
    for (QString& cell : cells)
        cell = cell.trimmed();
    return cells;
}

/** Block started by a line, without its mark; text if it has no mark. */
MarkdownBlock beginningOf(const QString& line)
{
    static const QRegularExpression picture(u"^!\\[(.*)\\]\\((.*)\\)$"_s);
    static const QRegularExpression numbered(u"^\\d+\\. "_s);
    if (line.startsWith(u'#'))
        return headingOf(line);
    if (const QRegularExpressionMatch match = picture.match(line); match.hasMatch())
        return {
            .kind = MarkdownKind::Picture, .text = match.captured(1), .info = match.captured(2)};
    if (line.startsWith(u"- "_s))
        return {.kind = MarkdownKind::Bullet, .text = line.mid(2)};
    if (line.startsWith(u"> "_s))
        return {.kind = MarkdownKind::Formula, .text = line.mid(2)};
    if (const QRegularExpressionMatch match = numbered.match(line); match.hasMatch())
        return {.kind = MarkdownKind::Numbered, .text = line.mid(match.capturedLength())};
    return {.kind = MarkdownKind::Text, .text = line};
}

bool canContinue(const MarkdownBlock& block)
{
    return block.kind == MarkdownKind::Text || block.kind == MarkdownKind::Bullet ||
           block.kind == MarkdownKind::Numbered;
}

/** Converts `**bold**`, `*italic*` and links; keeps `<sub>` and `<sup>`. */
QString styled(const QString& text)
{
    static const QRegularExpression escapedTags(u"&lt;(/?su[bp])&gt;"_s);
    static const QRegularExpression bold(u"\\*\\*(.+?)\\*\\*"_s);
    static const QRegularExpression italic(u"\\*([^ *][^*]*)\\*"_s);
    QString html = text.toHtmlEscaped();
    html.replace(escapedTags, u"<\\1>"_s);
    html.replace(bold, u"<b>\\1</b>"_s);
    html.replace(italic, u"<i>\\1</i>"_s);
    html.replace(linkPattern(), u"<a href=\"\\2\">\\1</a>"_s);
    static const QRegularExpression chapter(u"(<a href=\"[a-z-]*)\\.md"_s);
    return html.replace(chapter, u"\\1.html"_s);
}

/** Converts inline marks, except in code between backquotes. */
QString inlineHtml(const QString& text)
{
    QString html;
    const QStringList parts = text.split(u'`');
    for (qsizetype i = 0; i < parts.size(); ++i)
        html +=
            i % 2 == 0 ? styled(parts[i]) : u"<code>"_s + parts[i].toHtmlEscaped() + u"</code>"_s;
    return html;
}

QString tableHtml(const MarkdownBlock& block)
{
    QString html = u"<table border=\"0\" cellspacing=\"0\" cellpadding=\"4\">\n"_s;
    for (std::size_t row = 0; row < block.rows.size(); ++row) {
        const QString tag = row == 0 ? u"th"_s : u"td"_s;
        html += u"<tr>"_s;
        for (const QString& cell : block.rows[row])
            html += u"<%1 align=\"left\">%2</%1>"_s.arg(tag, inlineHtml(cell));
        html += u"</tr>\n"_s;
    }
    return html + u"</table>\n"_s;
}

QString blockHtml(const MarkdownBlock& block, const QString& anchor)
{
    switch (block.kind) {
    case MarkdownKind::Heading: {
        const QString id = block.id.isEmpty() ? QString() : u"<a name=\"%1\"></a>"_s.arg(block.id);
        return u"<h%1>%2%3%4</h%1>\n"_s.arg(block.level).arg(anchor, id, inlineHtml(block.text));
    }
    case MarkdownKind::Text:
        return u"<p>%1%2</p>\n"_s.arg(anchor, inlineHtml(block.text));
    case MarkdownKind::Formula:
        return u"<p class=\"formula\" style=\"margin-left:24px\">%1%2</p>\n"_s.arg(
            anchor, inlineHtml(block.text));
    case MarkdownKind::Bullet:
    case MarkdownKind::Numbered:
        return u"<li>%1%2</li>\n"_s.arg(anchor, inlineHtml(block.text));
    case MarkdownKind::Table:
        return (anchor.isEmpty() ? QString() : u"<p>%1</p>\n"_s.arg(anchor)) + tableHtml(block);
    case MarkdownKind::Code:
        return u"<pre>%1%2</pre>\n"_s.arg(anchor, block.text.toHtmlEscaped());
    case MarkdownKind::Picture:
        return u"<p class=\"picture\">%1<img src=\"%2\" width=\"640\" alt=\"%3\"></p>\n"
               "<p class=\"caption\"><i>%4</i></p>\n"_s.arg(
                   anchor, block.info, block.text.toHtmlEscaped(), inlineHtml(block.text));
    }
    return {};
}

QString listTag(const MarkdownBlock& block)
{
    return block.kind == MarkdownKind::Bullet     ? u"ul"_s
           : block.kind == MarkdownKind::Numbered ? u"ol"_s
                                                  : QString();
}

} // namespace

std::vector<MarkdownBlock> markdownBlocks(const QString& text)
{
    std::vector<MarkdownBlock> blocks;
    bool inCode = false;
    bool afterBlank = true;
    for (const QString& line : text.split(u'\n')) {
        if (line.startsWith(u"```"_s)) {
            inCode = !inCode;
            if (inCode)
                blocks.push_back({.kind = MarkdownKind::Code, .info = line.mid(3).trimmed()});
            afterBlank = true;
        } else if (inCode) {
            blocks.back().text += line + u'\n';
        } else if (line.trimmed().isEmpty()) {
            afterBlank = true;
        } else if (line.startsWith(u'|')) {
            if (afterBlank || blocks.back().kind != MarkdownKind::Table)
                blocks.push_back({.kind = MarkdownKind::Table});
            if (!line.startsWith(u"|--"_s) && !line.startsWith(u"| --"_s))
                blocks.back().rows.push_back(cellsOf(line));
            afterBlank = false;
        } else {
            const MarkdownBlock begun = beginningOf(line);
            if (begun.kind == MarkdownKind::Text && !afterBlank && canContinue(blocks.back()))
                blocks.back().text += u' ' + line.trimmed();
            else
                blocks.push_back(begun);
            afterBlank = false;
        }
    }
    return blocks;
}

QString plainText(const QString& inlineText)
{
    static const QRegularExpression marks(u"</?su[bp]>|\\*\\*|`"_s);
    static const QRegularExpression italic(u"\\*([^ *][^*]*)\\*"_s);
    QString text = inlineText;
    return text.replace(linkPattern(), u"\\1"_s).remove(marks).replace(italic, u"\\1"_s);
}

QString markdownHtml(const std::vector<MarkdownBlock>& blocks, bool anchors)
{
    QString html;
    QString list; // tag of the open list
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        const QString wanted = listTag(blocks[i]);
        if (wanted != list) {
            if (!list.isEmpty())
                html += u"</%1>\n"_s.arg(list);
            if (!wanted.isEmpty())
                html += u"<%1>\n"_s.arg(wanted);
            list = wanted;
        }
        html += blockHtml(blocks[i], anchors ? u"<a name=\"block-%1\"></a>"_s.arg(i) : QString());
    }
    return list.isEmpty() ? html : html + u"</%1>\n"_s.arg(list);
}

} // namespace berg
