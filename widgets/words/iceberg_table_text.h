#pragma once

#include <QLocale>
#include <QString>

#include <optional>
#include <vector>

namespace berg {

// Tables as spreadsheets put them on the clipboard.

/**
 * Returns the cells of a text, line by line; a final line break does not begin another line. Cells
 * are separated by tabs, else by semicolons, else by commas. If the locale uses a decimal comma, at
 * most one comma in a line and no point in the text means decimal signs. A quoted cell may contain
 * separators and line breaks.
 */
[[nodiscard]] std::vector<std::vector<QString>> cellsOf(const QString& text, const QLocale& locale);

/**
 * Returns the finite number of a text, with a point or the locale's decimal sign, with or without
 * spaces or the locale's group separators; a lone point is always a decimal sign. Returns nullopt
 * for any other text.
 */
[[nodiscard]] std::optional<double> numberOf(const QString& text, const QLocale& locale);

/**
 * Returns the shortest text with the locale's decimal sign that reads back as exactly this number.
 */
[[nodiscard]] QString exactText(double value, const QLocale& locale);

/**
 * Returns an angle like `exactText`, but with at most 15 decimals, which coordinate readers accept
 * near zero.
 */
[[nodiscard]] QString copiedAngle(double angle_deg, const QLocale& locale);

/** Returns the lines with tabs between the cells; cells that would not read back are quoted. */
[[nodiscard]] QString tabSeparated(const std::vector<std::vector<QString>>& cells);

} // namespace berg
