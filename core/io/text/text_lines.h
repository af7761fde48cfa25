#pragma once

#include <algorithm>
#include <string_view>

namespace berg {

/** Removes the first line from `text` and returns it without its end, which is CR, LF or both. */
[[nodiscard]] inline std::string_view takeLine(std::string_view& text)
{
    const std::size_t end = std::min(text.size(), text.find_first_of("\r\n"));
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(end);
    text.remove_prefix(text.starts_with("\r\n") ? 2 : std::min<std::size_t>(text.size(), 1));
    return line;
}

/** Removes the first word from `line` and returns it, or an empty text if no word is left. */
[[nodiscard]] inline std::string_view takeWord(std::string_view& line)
{
    constexpr std::string_view kBlanks = " \t\v\f";
    line.remove_prefix(std::min(line.size(), line.find_first_not_of(kBlanks)));
    const std::size_t end = std::min(line.size(), line.find_first_of(kBlanks));
    const std::string_view word = line.substr(0, end);
    line.remove_prefix(end);
    return word;
}

} // namespace berg
