#include "widgets/flight/asset_approach.h"

#include "widgets/flight/mission_snapshot.h"
#include "widgets/theme/quantity_text.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace berg {
namespace {

struct AssetText
{
    Q_DECLARE_TR_FUNCTIONS(AssetText)
};

/** `velocity_mps` over ground, current included. */
AssetApproach approachOf(const Asset& asset, double time_s, const Point& iceberg_m,
                         const Point& velocity_mps)
{
    const RelativeMotion motion = relativeToAsset(asset, time_s, iceberg_m, velocity_mps);
    return {.closest = closestApproach(motion, kApproachHorizon_s),
            .entry_s = entryTime_s(motion, alarmRadius_m(asset), kApproachHorizon_s)};
}

} // namespace

std::optional<AssetApproach> approachOf(const Scenario& scenario, const Iceberg& iceberg)
{
    if (!scenario.asset)
        return std::nullopt;
    return approachOf(*scenario.asset, 0, iceberg.position_m,
                      iceberg.velocity_mps + scenario.current_mps);
}

std::optional<AssetApproach> approachOf(const MissionSnapshot& snapshot, IcebergIndex iceberg)
{
    const Track& track = snapshot.world.tracks[toIndex(iceberg)];
    if (!snapshot.asset || !snapshot.active[toIndex(iceberg)] || track.left)
        return std::nullopt;
    return approachOf(*snapshot.asset, snapshot.time_s, track.estimate_m(snapshot.time_s),
                      track.velocity_mps);
}

QString ringEntryText(const QString& iceberg, double entry_s, const QLocale& locale,
                      const TimesAhead& times)
{
    if (entry_s <= 0)
        return AssetText::tr("%1 is inside the inner ring").arg(iceberg);
    return AssetText::tr("%1 enters the inner ring in %2")
        .arg(iceberg, roughDurationText(entry_s, locale) + times.minuteInBrackets(entry_s));
}

QString roughDurationText(double time_s, const QLocale& locale)
{
    constexpr double kMinute_s = 60;
    constexpr double kStep_s = 10;
    const double unit_s = time_s < kMinute_s - kStep_s / 2 ? kStep_s : kMinute_s;
    return durationText(std::max(kStep_s, std::round(time_s / unit_s) * unit_s), locale);
}

} // namespace berg
