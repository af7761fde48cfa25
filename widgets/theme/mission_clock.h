#pragma once

#include "core/io/text/utc_time.h"

#include <QString>

#include <optional>

namespace berg {

struct Scenario;

/**
 * Writes the instants of one run: in UTC if the scenario has a start and `Units::times` says so,
 * else as time elapsed since the start. Durations are `clockText` in any case. Any thread.
 */
struct MissionClock
{
    std::optional<UtcTime> start; ///< nullopt if times only count from the start of the run
    bool operator==(const MissionClock&) const = default;

    [[nodiscard]] bool isUtc() const;
    /** Of the day of the start, <= 0; 0 without a start. */
    [[nodiscard]] double midnight_s() const;
    /** "12:03:20Z", on a later day than the start "00:03:20Z +1"; elapsed "03:20". */
    [[nodiscard]] QString text(double time_s) const;
    /** The same without the Z, for columns whose title says UTC. */
    [[nodiscard]] QString columnText(double time_s) const;
    /** "2026-11-29 12:03:20 UTC"; elapsed "03:20". */
    [[nodiscard]] QString dateText(double time_s) const;
    /**
     * For tool tips: UTC with its date, local time of this computer and elapsed time. Empty without
     * a start.
     */
    [[nodiscard]] QString details(double time_s) const;
    /** The details; without a start the elapsed time. */
    [[nodiscard]] QString toolTip(double time_s) const;
};

[[nodiscard]] MissionClock clockOf(const Scenario& scenario);

/** Writes instants that are counted from `now_s` of a run. */
struct TimesAhead
{
    MissionClock clock;
    double now_s = 0;
    bool operator==(const TimesAhead&) const = default;

    /** "12:03:20Z", elapsed "in 01:26". */
    [[nodiscard]] QString text(double ahead_s) const;
    /** As wide as the texts of all instants until then, with digits that are not theirs. */
    [[nodiscard]] QString widest(double last_s) const;
    /** " (12:03Z)" to the nearest minute, to follow a duration in words; elapsed empty. */
    [[nodiscard]] QString minuteInBrackets(double ahead_s) const;
    /** "in 01:26" below the details of the clock; empty without a start. */
    [[nodiscard]] QString toolTip(double ahead_s) const;
};

} // namespace berg
