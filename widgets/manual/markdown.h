#pragma once

#include <QString>
#include <QStringList>

#include <vector>

namespace berg {

/** A paragraph, heading, row of a list and so on of a chapter. */
struct MarkdownBlock
{
    enum class Kind
    {
        Heading, ///< `## Title {#id}`
        Text,
        Formula,  ///< `> ...`: set apart
        Bullet,   ///< `- ...`
        Numbered, ///< `1. ...`
        Table,    ///< `| a | b |`, the first row names the columns
        Code,     ///< between lines of ```
        Picture   ///< `![caption](file)` alone on a line
    };
    Kind kind = Kind::Text;
    int level = 0;                      ///< of a heading, from 1
    QString id = {};                    ///< of a heading: what links name
    QString text = {};                  ///< title, text, caption, or the code
    QString info = {};                  ///< language of code, file of a picture
    std::vector<QStringList> rows = {}; ///< cells of a table
};

/** The part of Markdown that the manual is written in: see resources/manual/README.md. */
[[nodiscard]] std::vector<MarkdownBlock> markdownBlocks(const QString& text);

/** Without marks of bold, code and links, and without `<sub>` and `<sup>`. */
[[nodiscard]] QString plainText(const QString& inlineText);

/**
 * HTML that both browsers and QTextDocument read. Links to chapters (.md) become links to pages
 * (.html). Before block k is an anchor "block-k", for search, where `anchors` asks for it.
 */
[[nodiscard]] QString markdownHtml(const std::vector<MarkdownBlock>& blocks, bool anchors);

} // namespace berg
