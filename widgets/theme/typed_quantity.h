#pragma once

#include <QLocale>
#include <QString>

#include <optional>

namespace berg {

// How quantities that a user types are read. Both decimal signs are accepted where the locale's own
// reading fails; case and spaces before a unit do not matter.

/** Seconds on the clock of a flight: "90", "mm:ss", "h:mm:ss", "45 min", "1 h 30 min"; nullopt if
 * it is no time. */
[[nodiscard]] std::optional<double> clockValue(const QString& text);

/** Seconds of a duration: as `clockValue`, but "h:mm" ("0:45" is 45 min); a number without a unit
 * counts `plain_s` seconds each. */
[[nodiscard]] std::optional<double> durationValue(const QString& text, double plain_s,
                                                  const QLocale& locale);

/** Whether texts with other units can be read in a field whose unit this is. */
[[nodiscard]] bool hasOtherUnits(const QString& unit);

/**
 * A typed number converted to the unit of its field: 7.72 for "15 kn" in "m/s", 0.5 for "30 min" in
 * "h". A number alone is in `unit`. Returns nullopt if the text is no number or its unit measures
 * something else.
 */
[[nodiscard]] std::optional<double> typedNumber(const QString& text, const QString& unit,
                                                const QLocale& locale);

} // namespace berg
