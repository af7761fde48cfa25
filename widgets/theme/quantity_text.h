#pragma once

#include "core/base/geodesy.h"

#include <QLocale>
#include <QString>

#include <optional>

namespace berg {

// How quantities are written on screen: decimal sign of the locale, narrow no-break spaces between
// thousands (ISO 80000-1), digits that mean something, always a unit. Files never use these.

/** Fixed number of decimals, e.g. "84 420" or "0.25". */
[[nodiscard]] QString fixedText(double value, int decimals, const QLocale& locale);

/** `digits` significant digits without an exponent: 84 423 with four is "84 420". */
[[nodiscard]] QString significantText(double value, int digits, const QLocale& locale);

/** mm:ss, from one hour on h:mm:ss; rounded to whole seconds, negative times as zero. */
[[nodiscard]] QString clockText(double time_s);

/** Seconds of "90", "mm:ss" or "h:mm:ss", fractions with either decimal sign; none: no time. */
[[nodiscard]] std::optional<double> clockValue(const QString& text);

/** "850 m", "1.85 km" with so many significant digits. */
[[nodiscard]] QString distanceText(double distance_m, const QLocale& locale, int digits = 3);

/** "8.12 m²": three digits. */
[[nodiscard]] QString sigmaText(double sigma_m2, const QLocale& locale);

/** "30 s", "10 min", "2 h": a whole number of the largest unit that fits. */
[[nodiscard]] QString durationText(double time_s, const QLocale& locale);

/**
 * Degrees and minutes with the hemisphere, as navigators write them: 47° 03.2′ N.
 * `decimals` of the minutes, 0..4; -1: whole degrees only.
 */
[[nodiscard]] QString latitudeText(double latitude_deg, int decimals, const QLocale& locale);
[[nodiscard]] QString longitudeText(double longitude_deg, int decimals, const QLocale& locale);

} // namespace berg
