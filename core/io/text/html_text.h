#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace berg {

// Pieces of a document that is HTML and well-formed XML at once.

/**
 * Any text as content or quoted attribute: marks of the markup escaped, bytes and characters that
 * no document may hold (broken UTF-8, controls) replaced by U+FFFD, line ends by spaces.
 */
[[nodiscard]] std::string htmlText(std::string_view text);

/** A name that somebody typed: `htmlText`, its writing direction kept to itself. */
[[nodiscard]] std::string htmlName(std::string_view name);

/** JSON text that may stand in a script element: the same value, without any mark of the markup. */
[[nodiscard]] std::string scriptJson(std::string_view json);

/** A table of rows that each have a name; cells are HTML already. */
class HtmlTable
{
public:
    HtmlTable(std::string_view caption, const std::vector<std::string>& header);

    void addRow(const std::vector<std::string>& cells, bool marked = false);
    [[nodiscard]] std::string html() const;

private:
    std::string m_head;
    std::string m_body;
};

} // namespace berg
