#pragma once

#include "core/base/index.h"
#include "core/scenario/priority.h"
#include "widgets/theme/mission_clock.h"

#include <QLocale>
#include <QString>

#include <optional>

namespace berg {

struct MissionSnapshot;

/**
 * Motion of an iceberg relative to the protected asset; both are extrapolated on straight courses.
 */
struct AssetApproach
{
    /**
     * Closest approach within `kApproachHorizon_s`; lies at the horizon while still approaching.
     */
    ClosestApproach closest;
    /** Time until it enters the inner ring, s; 0 if inside, nullopt if not before the horizon. */
    std::optional<double> entry_s;
};

/** Returns the approach of the iceberg's estimate at the start, or nullopt if there is no asset. */
[[nodiscard]] std::optional<AssetApproach> approachOf(const Scenario& scenario,
                                                      const Iceberg& iceberg);

/**
 * Returns the approach of the iceberg's estimate at the snapshot's instant; nullopt if there is no
 * asset, or if the iceberg has not appeared yet or has left the area.
 */
[[nodiscard]] std::optional<AssetApproach> approachOf(const MissionSnapshot& snapshot,
                                                      IcebergIndex iceberg);

/**
 * Returns "berg-3 enters the inner ring in 12 min (12:40Z)" or "berg-3 is inside the inner ring".
 * `times` adds the clock time in brackets.
 */
[[nodiscard]] QString ringEntryText(const QString& iceberg, double entry_s, const QLocale& locale,
                                    const TimesAhead& times = {});

/**
 * Returns the duration rounded to minutes, or to ten seconds below one minute: "40 s", "12 min".
 */
[[nodiscard]] QString roughDurationText(double time_s, const QLocale& locale);

} // namespace berg
