#include "core/tracking/drift_path.h"

#include "core/base/error.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

namespace berg {

namespace {

constexpr double kLongestStep_s = 900;

/** Moves the place over one interval; returns nullopt if the forcing is unknown within it. */
std::optional<LatLon> movedBy(LatLon place, double from_s, double interval_s, const DriftLaw& law,
                              const ForcingAt& forcing)
{
    const double steps = std::max(1.0, std::ceil(interval_s / kLongestStep_s));
    const double step_s = interval_s / steps;
    for (double k = 0; k < steps; ++k) {
        const std::optional<Forcing> now = forcing(from_s + (k + 0.5) * step_s);
        if (!now)
            return std::nullopt;
        const Point velocity_mps = driftVelocity_mps(law, *now, place.latitude_deg);
        place = LocalFrame(place).toGeographic(velocity_mps * step_s);
    }
    return place;
}

} // namespace

ForcingAt forcingOf(Forecast forecast, const Forcing& constant)
{
    const bool hasWind = gives(forecast, ForecastQuantity::Wind);
    const bool hasCurrent = gives(forecast, ForecastQuantity::Current);
    return [forecast = std::move(forecast), constant, hasWind,
            hasCurrent](double time_s) -> std::optional<Forcing> {
        const ForecastEntry entry =
            entryAt(forecast, ForecastTime(std::chrono::milliseconds(std::llround(time_s * 1e3))));
        if ((hasWind && !entry.wind_mps) || (hasCurrent && !entry.current_mps))
            return std::nullopt;
        return Forcing{.wind_mps = entry.wind_mps.value_or(constant.wind_mps),
                       .current_mps = entry.current_mps.value_or(constant.current_mps)};
    };
}

std::vector<DriftPoint> driftPath(const DriftSpan& span, const DriftLaw& law,
                                  const ForcingAt& forcing)
{
    require(span.duration_s >= 0 && span.every_s > 0, "driftPath: duration or interval");
    constexpr double kRounding = 1e-9;
    const double intervals = std::floor(span.duration_s / span.every_s + kRounding);
    std::vector<DriftPoint> path;
    std::optional<LatLon> place = span.place;
    for (double k = 0; place && k <= intervals; ++k) {
        const double time_s = span.start_s + k * span.every_s;
        const std::optional<Forcing> now = forcing(time_s);
        if (!now)
            break;
        path.push_back({.time_s = time_s,
                        .place = *place,
                        .velocity_mps = driftVelocity_mps(law, *now, place->latitude_deg)});
        if (k < intervals)
            place = movedBy(*place, time_s, span.every_s, law, forcing);
    }
    return path;
}

} // namespace berg
