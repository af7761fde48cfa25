#pragma once

#include <string>
#include <string_view>

namespace berg {

// These functions write all numbers of the program. None depends on the locale.

/**
 * Returns the shortest text that reads back as the same double, for files, tables and messages. It
 * has plain digits from 1e-5 to 1e15 and an exponent otherwise.
 */
[[nodiscard]] std::string numberText(double value);

/** Appends the text of `numberText`, without a temporary string, for tables of many rows. */
void appendNumber(std::string& text, double value);

/** Returns the shortest exact text without an exponent, for decimals in XML. */
[[nodiscard]] std::string decimalText(double value);

// The functions below serve people who read reports and terminals.

/** Returns the rounded value with `decimals` after the point; never "-0". */
[[nodiscard]] std::string fixedText(double value, int decimals);

/**
 * Returns `fixedText` with the thousands separated: 84213.4 gives "84 213" with decimals = 0 and
 * separator = " ".
 */
[[nodiscard]] std::string groupedText(double value, int decimals, std::string_view separator);

/** Returns `groupedText` with thin non-breaking spaces and a true minus sign, for documents. */
[[nodiscard]] std::string printedNumber(double value, int decimals);

/** Returns `printedNumber` with the sign of a difference: "+2.9", "0.0". */
[[nodiscard]] std::string signedNumber(double value, int decimals);

/**
 * Returns the decimals, 0 to 9, that show `digits` significant digits of values of this size; 0 if
 * the size is 0 or not finite.
 */
[[nodiscard]] int decimalsFor(double size, int digits);

} // namespace berg
