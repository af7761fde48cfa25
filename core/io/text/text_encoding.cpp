#include "core/io/text/text_encoding.h"

#include <array>

namespace berg {

namespace {

constexpr char32_t kMark = 0xFEFF;

void appendUtf8(std::string& text, char32_t code)
{
    const auto byte = [&](char32_t value) { text += static_cast<char>(value); };
    const auto tail = [&](unsigned shift) { byte(0x80U | ((code >> shift) & 0x3FU)); };
    if (code < 0x80U) {
        byte(code);
    } else if (code < 0x800U) {
        byte(0xC0U | (code >> 6U));
        tail(0);
    } else if (code < 0x10000U) {
        byte(0xE0U | (code >> 12U));
        tail(6);
        tail(0);
    } else {
        byte(0xF0U | (code >> 18U));
        tail(12);
        tail(6);
        tail(0);
    }
}

/** Whether the high byte of each pair comes first; nullopt if the bytes are not UTF-16. */
std::optional<bool> isHighFirst(std::string_view bytes)
{
    using namespace std::string_view_literals;
    if (bytes.starts_with("\xFE\xFF"sv) || bytes.starts_with("\0<"sv))
        return true;
    if (bytes.starts_with("\xFF\xFE"sv) || bytes.starts_with("<\0"sv))
        return false;
    return std::nullopt;
}

} // namespace

bool isUtf16(std::string_view bytes)
{
    return isHighFirst(bytes).has_value();
}

std::optional<std::string> utf8FromUtf16(std::string_view bytes)
{
    if (bytes.size() % 2 != 0)
        return std::nullopt;
    const std::size_t high = isHighFirst(bytes).value_or(false) ? 0 : 1;
    const auto unit = [&](std::size_t at) {
        return static_cast<char32_t>(static_cast<unsigned char>(bytes[at + high]) << 8U |
                                     static_cast<unsigned char>(bytes[at + 1 - high]));
    };
    std::string text;
    text.reserve(bytes.size() / 2);
    for (std::size_t at = 0; at < bytes.size(); at += 2) {
        char32_t code = unit(at);
        if (code == kMark && at == 0)
            continue;
        if (code >= 0xDC00U && code < 0xE000U)
            return std::nullopt;
        if (code >= 0xD800U && code < 0xDC00U) {
            at += 2;
            const char32_t low = at < bytes.size() ? unit(at) : 0;
            if (low < 0xDC00U || low >= 0xE000U)
                return std::nullopt;
            code = 0x10000U + ((code - 0xD800U) << 10U) + (low - 0xDC00U);
        }
        if (code == 0)
            return std::nullopt;
        appendUtf8(text, code);
    }
    return text;
}

std::string utf8FromWindows(std::string_view bytes)
{
    static constexpr std::array<char16_t, 32> kOwn = {
        0x20AC, 0x81,   0x201A, 0x0192, 0x201E, 0x2026, 0x2020, 0x2021, 0x02C6, 0x2030, 0x0160,
        0x2039, 0x0152, 0x8D,   0x017D, 0x8F,   0x90,   0x2018, 0x2019, 0x201C, 0x201D, 0x2022,
        0x2013, 0x2014, 0x02DC, 0x2122, 0x0161, 0x203A, 0x0153, 0x9D,   0x017E, 0x0178};
    std::string text;
    text.reserve(bytes.size() + bytes.size() / 8);
    for (const char c : bytes) {
        const auto byte = static_cast<unsigned char>(c);
        appendUtf8(text, byte >= 0x80U && byte < 0xA0U ? kOwn.at(byte - 0x80U) : byte);
    }
    return text;
}

} // namespace berg
