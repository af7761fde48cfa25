#pragma once

#include <QLocale>
#include <QString>

#include <optional>

namespace berg {

// Parsing of quantities typed by a user. Both decimal signs are accepted if the locale's own
// parsing fails; case and spaces before a unit are ignored.

/** Parses a flight time in seconds: "90", "mm:ss", "h:mm:ss", "45 min", "1 h 30 min"; nullopt if it
 * is not a time. */
[[nodiscard]] std::optional<double> clockValue(const QString& text);

/** Parses a duration in seconds like `clockValue`, except that "h:mm" ("0:45" is 45 min) and that a
 * number without unit counts `plain_s` seconds each. Nullopt if it is not a duration. */
[[nodiscard]] std::optional<double> durationValue(const QString& text, double plain_s,
                                                  const QLocale& locale);

/** Returns whether a field with this unit accepts numbers in other units. */
[[nodiscard]] bool hasOtherUnits(const QString& unit);

/**
 * Parses a number and converts it to the unit of its field: 7.72 for "15 kn" in "m/s", 0.5 for "30
 * min" in "h"; a number without unit is in `unit`. Returns nullopt if the text is not a number or
 * its unit has another dimension.
 */
[[nodiscard]] std::optional<double> typedNumber(const QString& text, const QString& unit,
                                                const QLocale& locale);

} // namespace berg
