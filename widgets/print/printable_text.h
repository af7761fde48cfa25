#pragma once

#include <QString>

#include <string>

namespace berg {

/**
 * Makes a user's text printable on one line: control characters and line ends become single blanks,
 * characters that change the writing direction of following text are removed, and marks are limited
 * to two per letter. Right-to-left text is isolated from its surroundings.
 */
[[nodiscard]] QString printable(const QString& text);
[[nodiscard]] QString printable(const std::string& utf8);

/** Returns a text of several names with at most two marks per letter. */
[[nodiscard]] std::string withFewMarks(const std::string& utf8);

/**
 * Makes the names in HTML (`htmlName`) `printable`: Qt's documents ignore the element bdi, which
 * keeps names from turning the text around them elsewhere.
 */
[[nodiscard]] std::string withPrintableNames(const std::string& html);

} // namespace berg
