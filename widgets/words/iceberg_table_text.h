#pragma once

#include <QLocale>
#include <QString>

#include <optional>
#include <vector>

namespace berg {

// Tables as spreadsheets put them on the clipboard.

/**
 * The cells of a text, line by line; its last line end does not begin another line. They are
 * apart by tabs, where there are none by semicolons, where there are none by commas. One comma in
 * a line without a point is a decimal sign where the locale has it so. A cell in quotes may hold
 * any of that, and lines.
 */
[[nodiscard]] std::vector<std::vector<QString>> cellsOf(const QString& text, const QLocale& locale);

/**
 * A finite number with a point or the decimal sign of the locale, with or without spaces or the
 * locale's signs between thousands; a point alone is a decimal sign everywhere.
 */
[[nodiscard]] std::optional<double> numberOf(const QString& text, const QLocale& locale);

/** Shortest text with the locale's decimal sign that reads back as the very same number. */
[[nodiscard]] QString exactText(double value, const QLocale& locale);

/** The same of an angle, but to 1e-15 degrees: near zero that is what a coordinate reader takes. */
[[nodiscard]] QString copiedAngle(double angle_deg, const QLocale& locale);

/** Lines of cells with tabs between; what would not read back gets quotes. */
[[nodiscard]] QString tabSeparated(const std::vector<std::vector<QString>>& cells);

} // namespace berg
