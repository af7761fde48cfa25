#pragma once

#include <string_view>

namespace berg {

/** Returns `text` without the byte order mark that some editors write in front of UTF-8. */
[[nodiscard]] inline std::string_view withoutByteOrderMark(std::string_view text)
{
    constexpr std::string_view kMark = "\xEF\xBB\xBF";
    return text.substr(text.starts_with(kMark) ? kMark.size() : 0);
}

} // namespace berg
