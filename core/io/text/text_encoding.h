#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace berg {

/** Returns true if the bytes begin as UTF-16 text: with its byte order mark, or with a `<` in two
 * bytes. */
[[nodiscard]] bool isUtf16(std::string_view bytes);

/**
 * Converts UTF-16 text to UTF-8 without its mark. Returns nullopt if it holds half a character or a
 * zero.
 */
[[nodiscard]] std::optional<std::string> utf8FromUtf16(std::string_view bytes);

/** Converts Windows-1252 text to UTF-8; bytes that it leaves undefined are read as ISO 8859-1. */
[[nodiscard]] std::string utf8FromWindows(std::string_view bytes);

} // namespace berg
