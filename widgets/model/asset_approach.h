#pragma once

#include "core/scenario/priority.h"
#include "widgets/theme/mission_clock.h"

#include <QLocale>
#include <QString>

#include <optional>

namespace berg {

struct MissionSnapshot;

/** How an iceberg passes what is to be protected, both on straight courses from now on. */
struct AssetApproach
{
    ClosestApproach closest;       ///< until `kApproachHorizon_s`: then it still comes nearer
    std::optional<double> entry_s; ///< from now, into the inner ring, 0: it is inside; none: not
                                   ///< until the horizon
};

/** By the estimate at the start; none without an asset. */
[[nodiscard]] std::optional<AssetApproach> approachOf(const Scenario& scenario,
                                                      const Iceberg& iceberg);

/** By the estimate; none without an asset, before it has appeared and when it has left the area. */
[[nodiscard]] std::optional<AssetApproach> approachOf(const MissionSnapshot& snapshot,
                                                      std::size_t iceberg);

/** "berg-3 enters the inner ring in 12 min (12:40Z)", "berg-3 is inside the inner ring". */
[[nodiscard]] QString ringEntryText(const QString& iceberg, double entry_s, const QLocale& locale,
                                    const TimesAhead& times = {});

/** Rounded to minutes, below one to ten seconds: "40 s", "12 min". */
[[nodiscard]] QString roughDurationText(double time_s, const QLocale& locale);

} // namespace berg
