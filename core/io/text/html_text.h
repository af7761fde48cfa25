#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace berg {

// Pieces of a document that is both HTML and well-formed XML.

/**
 * Returns any text as HTML content or quoted attribute: markup characters are escaped, bytes and
 * characters that no document may hold (broken UTF-8, controls) become U+FFFD, and line ends and
 * tabs become spaces.
 */
[[nodiscard]] std::string htmlText(std::string_view text);

/**
 * Returns a name typed by a user as HTML, isolated so that its writing direction does not affect
 * the text around it.
 */
[[nodiscard]] std::string htmlName(std::string_view name);

/**
 * Returns JSON text with the same value that can stand in a script element: markup characters are
 * escaped.
 */
[[nodiscard]] std::string scriptJson(std::string_view json);

/** A value with its caption, as HTML. */
struct HtmlFact
{
    std::string caption;
    std::string value;
};

/** Returns a table of facts, so many side by side. */
[[nodiscard]] std::string factsHtml(const std::vector<HtmlFact>& facts, std::size_t columns);

/** HTML table whose first column is a row header. Caption (may be empty) and cells must be HTML
 * already. */
class HtmlTable
{
public:
    HtmlTable(std::string_view caption, const std::vector<std::string>& header);

    /** Adds a row; `marked` highlights it. */
    void addRow(const std::vector<std::string>& cells, bool marked = false);
    [[nodiscard]] std::string html() const;

private:
    std::string m_head;
    std::string m_body;
};

} // namespace berg
