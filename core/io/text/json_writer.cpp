#include "core/io/text/json_writer.h"

#include "core/base/error.h"
#include "core/scenario/checks.h"

#include <array>
#include <charconv>
#include <cmath>

namespace berg {

namespace {

/** As \u00XX. */
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

std::string joined(const std::vector<std::string>& parts, const std::string& separator)
{
    std::string text;
    for (const std::string& part : parts) {
        if (!text.empty())
            text += separator;
        text += part;
    }
    return text;
}

std::string lines(const std::vector<std::string>& parts, int indent, char open, char close)
{
    if (parts.empty())
        return {open, close};
    const std::string outer = '\n' + std::string(static_cast<std::size_t>(indent), ' ');
    return open + outer + ' ' + joined(parts, ',' + outer + ' ') + outer + close;
}

} // namespace

std::string jsonText(double value)
{
    if (!std::isfinite(value))
        return "null";
    if (value == 0)
        return std::signbit(value) ? "-0.0" : "0"; // "-0" would be read as a whole number
    // Plain digits as long as they are short to read; both forms read back exactly.
    constexpr double kSmallestPlain = 1e-5;
    constexpr double kLargestPlain = 1e15;
    const double size = std::abs(value);
    const bool plain = size >= kSmallestPlain && size < kLargestPlain;
    std::array<char, 64> buffer{};
    char* const end =
        std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                      plain ? std::chars_format::fixed : std::chars_format::scientific)
            .ptr;
    return {buffer.data(), end};
}

std::string jsonText(std::int64_t value)
{
    return std::to_string(value);
}

std::string jsonText(int value)
{
    return std::to_string(value);
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
            appendCode(json, static_cast<unsigned char>(value[1])); // terminals obey it
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

std::string escapedJson(std::string_view json)
{
    std::string safe;
    safe.reserve(json.size());
    for (std::size_t i = 0; i < json.size(); ++i)
        if (const auto next = static_cast<unsigned char>(i + 1 < json.size() ? json[i + 1] : 0);
            json[i] == '\xC2' && next < 0xA0U)
            appendCode(safe, static_cast<unsigned char>(json[++i]));
        else if (json[i] == '\x7F')
            appendCode(safe, 0x7F);
        else
            safe += json[i];
    return safe;
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
