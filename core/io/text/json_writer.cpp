#include "core/io/text/json_writer.h"

#include "core/base/error.h"
#include "core/base/number_text.h"
#include "core/plan/solve/names.h"
#include "core/scenario/text_checks.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace berg {

namespace {

using Tree = nlohmann::ordered_json;

/** Appends the character as \u00XX. */
void appendCode(std::string& json, unsigned char code)
{
    constexpr std::string_view kHex = "0123456789abcdef";
    json += "\\u00";
    json += kHex[code >> 4U];
    json += kHex[code & 0xFU];
}

void appendEscaped(std::string& json, char c)
{
    const auto code = static_cast<unsigned char>(c);
    switch (c) {
    case '"':
    case '\\':
        json += '\\';
        json += c;
        return;
    case '\n':
        json += "\\n";
        return;
    case '\t':
        json += "\\t";
        return;
    case '\r':
        json += "\\r";
        return;
    default:
        break;
    }
    if (code >= 0x20U && code != 0x7FU) {
        json += c;
        return;
    }
    appendCode(json, code);
}

std::string lines(const std::vector<std::string>& parts, int indent, char open, char close)
{
    if (parts.empty())
        return {open, close};
    const std::string outer = '\n' + std::string(static_cast<std::size_t>(indent), ' ');
    return open + outer + ' ' + joined(parts, ',' + outer + ' ') + outer + close;
}

class TreeText
{
public:
    explicit TreeText(int indent) : m_indent(indent) {}

    void add(const Tree& value)
    {
        if (value.is_object())
            addEntries(value.get_ref<const Tree::object_t&>(), '{', '}');
        else if (value.is_array())
            addEntries(value.get_ref<const Tree::array_t&>(), '[', ']');
        else if (value.is_string())
            m_text += jsonText(value.get_ref<const std::string&>());
        else if (value.is_number_float())
            addDouble(value.get<double>());
        else if (value.is_number_unsigned())
            m_text += jsonText(value.get<std::uint64_t>());
        else if (value.is_number())
            m_text += jsonText(value.get<std::int64_t>());
        else
            m_text += value.is_null() ? "null" : jsonText(value.get<bool>());
    }
    [[nodiscard]] std::string take() { return std::move(m_text); }

private:
    void add(const Tree::object_t::value_type& member)
    {
        m_text += jsonText(member.first) + (m_indent < 0 ? ":" : ": ");
        add(member.second);
    }

    template <class Entries>
    void addEntries(const Entries& entries, char open, char close)
    {
        m_text += open;
        ++m_depth;
        for (const auto& entry : entries) {
            if (&entry != &entries.front())
                m_text += ',';
            startLine();
            add(entry);
        }
        --m_depth;
        if (!entries.empty())
            startLine();
        m_text += close;
    }

    void addDouble(double value)
    {
        const std::string text = jsonText(value);
        const bool isWhole = text.find_first_not_of("-0123456789") == std::string::npos;
        m_text += text + (isWhole ? ".0" : "");
    }

    void startLine()
    {
        if (m_indent >= 0)
            m_text += '\n' + std::string(static_cast<std::size_t>(m_indent * m_depth), ' ');
    }

    int m_indent;
    int m_depth = 0;
    std::string m_text;
};

} // namespace

std::string jsonText(double value)
{
    if (!std::isfinite(value))
        return "null";
    if (value == 0 && std::signbit(value))
        return "-0.0"; // "-0" would be read as a whole number
    return numberText(value);
}

std::string jsonText(bool value)
{
    return value ? "true" : "false";
}

std::string jsonText(std::string_view value)
{
    std::string json = "\"";
    while (!value.empty()) {
        const std::size_t size = characterSize(value);
        if (size == 0)
            json += "\xEF\xBF\xBD"; // U+FFFD, the replacement character
        else if (size == 1)
            appendEscaped(json, value.front());
        else if (value.front() == '\xC2' && static_cast<unsigned char>(value[1]) < 0xA0U)
            appendCode(json, static_cast<unsigned char>(value[1])); // terminals act on it
        else
            json += value.substr(0, size);
        value.remove_prefix(std::max<std::size_t>(size, 1));
    }
    json += '"';
    return json;
}

std::string jsonText(const std::string& value)
{
    return jsonText(std::string_view(value));
}

std::string jsonText(const char* value)
{
    return jsonText(std::string_view(value));
}

std::string jsonText(const Point& value)
{
    return jsonArray({jsonText(value.x()), jsonText(value.y())});
}

std::string jsonText(const Tree& tree, int indent)
{
    TreeText text(indent);
    text.add(tree);
    return text.take();
}

JsonTreeGuard::~JsonTreeGuard()
{
    if (auto* list = m_tree.get_ptr<Tree::array_t*>())
        for (; !list->empty(); list->pop_back())
            JsonTreeGuard entry(list->back());
    if (auto* members = m_tree.get_ptr<Tree::object_t*>())
        for (; !members->empty(); members->pop_back())
            JsonTreeGuard member(members->back().second);
}

std::size_t characterSize(std::string_view text)
{
    constexpr std::size_t kLongest = 4;
    for (std::size_t size = 1; size <= kLongest && size <= text.size(); ++size)
        if (isUtf8(text.substr(0, size)))
            return size;
    return 0;
}

std::string jsonArray(const std::vector<std::string>& entries)
{
    return '[' + joined(entries, ", ") + ']';
}

std::string jsonLines(const std::vector<std::string>& entries, int indent)
{
    return lines(entries, indent, '[', ']');
}

void JsonObject::addText(std::string_view name, const std::string& json)
{
    m_members.push_back(jsonText(name) + ": " + json);
}

void JsonObject::addExtra(const std::string& object)
{
    if (object.empty())
        return;
    require(object.size() > 2 && object.front() == '{' && object.back() == '}',
            "extraJson must be the text of a JSON object");
    m_members.push_back(object.substr(1, object.size() - 2));
}

std::string JsonObject::inLine() const
{
    return '{' + joined(m_members, ", ") + '}';
}

std::string JsonObject::inLines(int indent) const
{
    return lines(m_members, indent, '{', '}');
}

} // namespace berg
