#pragma once

#include <string>
#include <string_view>

namespace berg {

// All the ways in which numbers are written, independent of the locale.

/**
 * Shortest text that reads back as the same double: digits from 1e-5 to 1e15, which 1e+05 is not
 * easier to read than, and else with an exponent. For files, tables and messages.
 */
[[nodiscard]] std::string numberText(double value);

/** The same without a string of its own, for tables of many rows. */
void appendNumber(std::string& text, double value);

/** The same, never with an exponent: for XML decimals. */
[[nodiscard]] std::string decimalText(double value);

// For people to read in reports and on terminals.

/** `decimals` after the point, rounded; never "-0". */
[[nodiscard]] std::string fixedText(double value, int decimals);

/** As `fixedText`, thousands apart: 84213.4 -> "84 213" with decimals = 0 and separator = " ". */
[[nodiscard]] std::string groupedText(double value, int decimals, std::string_view separator);

/** As `groupedText` with thin spaces that do not break, and a true minus sign: for documents. */
[[nodiscard]] std::string printedNumber(double value, int decimals);

/** As `printedNumber`, with the sign of a difference: "+2.9", "0.0". */
[[nodiscard]] std::string signedNumber(double value, int decimals);

/** Decimals that show `digits` significant digits of values of this size, 0 .. 9. */
[[nodiscard]] int decimalsFor(double size, int digits);

} // namespace berg
