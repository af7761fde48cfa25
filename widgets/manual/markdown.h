#pragma once

#include <QString>
#include <QStringList>

#include <vector>

namespace berg {

enum class MarkdownKind
{
    Heading, ///< `## Title {#id}`
    Text,
    Formula,  ///< `> ...`: displayed
    Bullet,   ///< `- ...`
    Numbered, ///< `1. ...`
    Table,    ///< `| a | b |`, with column names in the first row
    Code,     ///< between lines of ```
    Picture   ///< `![caption](file)` alone on a line
};

/** A paragraph, heading, list item or similar element of a chapter. */
struct MarkdownBlock
{
    MarkdownKind kind = MarkdownKind::Text;
    int level = 0;                      ///< level of a heading, from 1
    QString id = {};                    ///< anchor of a heading, the target of links
    QString text = {};                  ///< title, text, caption, or the code
    QString info = {};                  ///< language of code, file of a picture
    std::vector<QStringList> rows = {}; ///< cells of a table
};

/** Parses the subset of Markdown used by the manual: see resources/manual/README.md. */
[[nodiscard]] std::vector<MarkdownBlock> markdownBlocks(const QString& text);

/** Removes marks of bold, italic, code and links, and `<sub>` and `<sup>`. */
[[nodiscard]] QString plainText(const QString& inlineText);

/**
 * HTML for browsers and QTextDocument. Links to chapters (.md) become links to pages (.html). With
 * `anchors`, block k is preceded by an anchor "block-k" for search results.
 */
[[nodiscard]] QString markdownHtml(const std::vector<MarkdownBlock>& blocks, bool anchors);

} // namespace berg
