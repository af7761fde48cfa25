#pragma once

#include "widgets/theme/mission_clock.h"

#include <QString>

#include <optional>
#include <variant>

namespace berg {

/**
 * The UTC time that a user types, in every form the imports read, or a sentence why it is none. A
 * time of day alone ("1200Z") is of the day of `day`, where there is one.
 */
[[nodiscard]] std::variant<UtcTime, QString> readTime(const QString& text,
                                                      std::optional<UtcTime> day);

/**
 * The instant of a run that a user types, in seconds since its start: elapsed ("3:20", "45 min")
 * or, if it has a start, UTC ("1215Z", "12:15Z", "2026-11-29 12:15"; "00:15Z +1" on the day after
 * the start); of a time of day alone the one nearest to `near_s`. Returns nullopt for any other
 * text and for instants before the start.
 */
[[nodiscard]] std::optional<double> readInstant(const QString& text, const MissionClock& clock,
                                                double near_s);

} // namespace berg
