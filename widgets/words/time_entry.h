#pragma once

#include "widgets/theme/mission_clock.h"

#include <QString>

#include <optional>
#include <variant>

namespace berg {

/**
 * Returns the UTC time typed by the user in any form that imports read, or a sentence on what is
 * wrong. A time of day alone ("1200Z") belongs to the day of `day`, if given.
 */
[[nodiscard]] std::variant<UtcTime, QString> readTime(const QString& text,
                                                      std::optional<UtcTime> day);

/**
 * Returns the instant of a run typed by the user, in seconds since its start: elapsed time ("3:20",
 * "45 min") or, if the run has a start, UTC ("1215Z", "12:15Z", "2026-11-29 12:15"; "00:15Z +1" on
 * the day after the start). A time of day alone means the instant nearest to `near_s`. Returns
 * nullopt for any other text and for instants before the start.
 */
[[nodiscard]] std::optional<double> readInstant(const QString& text, const MissionClock& clock,
                                                double near_s);

} // namespace berg
