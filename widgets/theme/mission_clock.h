#pragma once

#include "core/scenario/utc_time.h"

#include <QString>

#include <optional>

namespace berg {

struct Scenario;

/**
 * Formats times of one run: in UTC if the scenario has a start and `Units::times` selects UTC,
 * otherwise as time elapsed since the start. Durations always use `clockText`. Any thread.
 */
struct MissionClock
{
    std::optional<UtcTime> start; ///< nullopt if times are relative to the start of the run
    bool operator==(const MissionClock&) const = default;

    /** Returns whether times are shown in UTC. */
    [[nodiscard]] bool isUtc() const;
    /** Time of the last midnight before the start, s (not positive); zero without a start. */
    [[nodiscard]] double midnight_s() const;
    /** "12:03:20Z", on a later day "00:03:20Z +1"; elapsed time "03:20". */
    [[nodiscard]] QString text(double time_s) const;
    /** Like `text` but without the Z, for columns with UTC in their title. */
    [[nodiscard]] QString columnText(double time_s) const;
    /** "2026-11-29 12:03:20 UTC"; elapsed time "03:20". */
    [[nodiscard]] QString dateText(double time_s) const;
    /** Tool tip with UTC date and time, local time and elapsed time; empty without a start. */
    [[nodiscard]] QString details(double time_s) const;
    /** Same as `details`, but the elapsed time without a start. */
    [[nodiscard]] QString toolTip(double time_s) const;
};

/** Clock of a scenario. */
[[nodiscard]] MissionClock clockOf(const Scenario& scenario);

/** Formats times that are counted from `now_s` of a run. */
struct TimesAhead
{
    MissionClock clock;
    double now_s = 0;
    bool operator==(const TimesAhead&) const = default;

    /** "12:03:20Z"; elapsed time "in 01:26". */
    [[nodiscard]] QString text(double ahead_s) const;
    /** Placeholder as wide as the texts of all times up to `last_s`. */
    [[nodiscard]] QString widest(double last_s) const;
    /** " (12:03Z)" to the nearest minute, to follow a duration in words; empty if elapsed. */
    [[nodiscard]] QString minuteInBrackets(double ahead_s) const;
    /** "in 01:26" and the details of the clock; empty without a start. */
    [[nodiscard]] QString toolTip(double ahead_s) const;
};

} // namespace berg
