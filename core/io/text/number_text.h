#pragma once

#include <string>
#include <string_view>

namespace berg {

// Numbers for people to read in reports and on terminals, independent of the locale.

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
