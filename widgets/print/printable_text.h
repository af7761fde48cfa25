#pragma once

#include <QString>

#include <string>

namespace berg {

/**
 * A text of the user as one line that any page can take: without control characters, line ends and
 * characters that turn the direction of what comes after them, with at most two marks on a letter.
 * Text written from right to left keeps its direction to itself.
 */
[[nodiscard]] QString printable(const QString& text);
[[nodiscard]] QString printable(const std::string& utf8);

} // namespace berg
