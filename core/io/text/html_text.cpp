#include "core/io/text/html_text.h"

#include "core/io/text/json_writer.h"

#include <algorithm>

namespace berg {

namespace {

constexpr std::string_view kReplacement = "\uFFFD";

bool isSpace(char c)
{
    return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

std::string escaped(char c)
{
    switch (c) {
    case '&':
        return "&amp;";
    case '<':
        return "&lt;";
    case '>':
        return "&gt;";
    case '"':
        return "&quot;";
    case '\'':
        return "&#39;";
    default:
        break;
    }
    if (isSpace(c))
        return " ";
    const auto code = static_cast<unsigned char>(c);
    return code < 0x20U || code == 0x7FU ? std::string(kReplacement) : std::string(1, c);
}

/** Whether a character of several bytes is not text: C1 controls, U+FFFE and U+FFFF. */
bool isNoText(std::string_view character)
{
    if (character.size() == 2 && character[0] == '\xC2')
        return static_cast<unsigned char>(character[1]) < 0xA0U;
    return character == "\xEF\xBF\xBE" || character == "\xEF\xBF\xBF";
}

} // namespace

std::string htmlText(std::string_view text)
{
    std::string html;
    html.reserve(text.size());
    while (!text.empty()) {
        const std::size_t size = characterSize(text);
        const std::string_view character = text.substr(0, std::max<std::size_t>(size, 1));
        if (size == 1)
            html += escaped(character.front());
        else
            html += size == 0 || isNoText(character) ? kReplacement : character;
        text.remove_prefix(character.size());
    }
    return html;
}

std::string htmlName(std::string_view name)
{
    return "<bdi>" + htmlText(name) + "</bdi>";
}

std::string scriptJson(std::string_view json)
{
    std::string text;
    text.reserve(json.size() + json.size() / 64);
    while (!json.empty()) {
        const std::size_t size = std::max<std::size_t>(characterSize(json), 1);
        const std::string_view character = json.substr(0, size);
        if (character == "<")
            text += "\\u003c";
        else if (character == ">")
            text += "\\u003e";
        else if (character == "&")
            text += "\\u0026";
        else if (character == "\xEF\xBF\xBE")
            text += "\\ufffe";
        else if (character == "\xEF\xBF\xBF")
            text += "\\uffff";
        else
            text += character;
        json.remove_prefix(size);
    }
    return text;
}

std::string factsHtml(const std::vector<HtmlFact>& facts, std::size_t columns)
{
    std::string html = "<table class=\"facts\" width=\"100%\">\n";
    for (std::size_t i = 0; i < facts.size(); ++i) {
        html += i % columns == 0 ? "<tr>" : "";
        html += "<td><span class=\"muted\">" + facts[i].caption + "</span><br/><b>" +
                facts[i].value + "</b></td>";
        html += i % columns + 1 == columns || i + 1 == facts.size() ? "</tr>\n" : "";
    }
    return html + "</table>\n";
}

HtmlTable::HtmlTable(std::string_view caption, const std::vector<std::string>& header)
{
    m_head = "<table width=\"100%\">\n";
    if (!caption.empty())
        m_head += "<caption>" + std::string(caption) + "</caption>\n";
    m_head += "<thead><tr>";
    for (std::size_t i = 0; i < header.size(); ++i)
        m_head += (i == 0 ? "<th scope=\"col\" class=\"text\">" : "<th scope=\"col\">") +
                  header[i] + "</th>";
    m_head += "</tr></thead>\n<tbody>\n";
}

void HtmlTable::addRow(const std::vector<std::string>& cells, bool marked)
{
    m_body += marked ? "<tr class=\"marked\">" : "<tr>";
    for (std::size_t i = 0; i < cells.size(); ++i)
        m_body += i == 0 ? "<th scope=\"row\">" + cells[i] + "</th>" : "<td>" + cells[i] + "</td>";
    m_body += "</tr>\n";
}

std::string HtmlTable::html() const
{
    return "<div class=\"wide\">" + m_head + m_body + "</tbody>\n</table></div>\n";
}

} // namespace berg
