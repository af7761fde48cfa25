#include "core/base/number_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace berg {

std::string numberText(double value)
{
    std::string text;
    appendNumber(text, value);
    return text;
}

void appendNumber(std::string& text, double value)
{
    constexpr double kSmallestPlain = 1e-5;
    constexpr double kLargestPlain = 1e15;
    const double size = std::abs(value);
    const bool plain = size == 0 || (size >= kSmallestPlain && size < kLargestPlain);
    std::array<char, 40> buffer{};
    char* const end =
        std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                      plain ? std::chars_format::fixed : std::chars_format::scientific)
            .ptr;
    text.append(buffer.data(), end);
}

std::string decimalText(double value)
{
    std::array<char, 400> buffer{}; // the largest double has 309 digits, the smallest 324 decimals
    char* const end =
        std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed)
            .ptr;
    return {buffer.data(), end};
}

std::string fixedText(double value, int decimals)
{
    std::array<char, 400> buffer{}; // at most 309 digits before the point
    char* const end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                    std::chars_format::fixed, decimals)
                          .ptr;
    std::string text(buffer.data(), end);
    if (text.starts_with('-') && text.find_first_not_of("-0.") == std::string::npos)
        text.erase(0, 1);
    return text;
}

std::string groupedText(double value, int decimals, std::string_view separator)
{
    std::string text = fixedText(value, decimals);
    const std::size_t first = text.starts_with('-') ? 1 : 0;
    if (!std::isfinite(value))
        return text;
    for (std::size_t i = std::min(text.find('.'), text.size()); i > first + 3;) {
        i -= 3;
        text.insert(i, separator);
    }
    return text;
}

std::string printedNumber(double value, int decimals)
{
    std::string text = groupedText(value, decimals, "\u202f");
    if (text.starts_with('-'))
        text.replace(0, 1, "\u2212");
    return text;
}

std::string signedNumber(double value, int decimals)
{
    const std::string text = printedNumber(value, decimals);
    return value > 0 && text.find_first_not_of("0.") != std::string::npos ? '+' + text : text;
}

int decimalsFor(double size, int digits)
{
    if (!(std::abs(size) > 0) || !std::isfinite(size))
        return 0;
    const int before = static_cast<int>(std::floor(std::log10(std::abs(size)))) + 1;
    return std::clamp(digits - before, 0, 9);
}

} // namespace berg
