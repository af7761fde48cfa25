#include "core/checks/drift_advice.h"

#include "core/checks/findings.h"
#include "core/tracking/position_error.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace berg {

namespace {

/** More samples per visit hardly improve the estimate. */
constexpr double kMostSamples = 100;

SensorSpec sensorOf(const Scenario& scenario, const Uav& uav)
{
    return {.fov_m = uav.fov_m, .shape = scenario.fovShape};
}

/** Returns the smaller extent of the field of view, m. */
double width_m(const Scenario& scenario, const Uav& uav)
{
    return 2 * surelySeen_m(sensorOf(scenario, uav));
}

const Uav& widestView(const Scenario& scenario)
{
    return *std::ranges::max_element(scenario.uavs, {},
                                     [&](const Uav& uav) { return width_m(scenario, uav); });
}

std::int64_t atLeastOne(double value)
{
    return std::max<std::int64_t>(1, std::llround(value));
}

/** Rounds to two digits, since the value is an estimate. */
std::int64_t roughly(double value)
{
    const double digit = std::pow(10, std::max(0.0, std::floor(std::log10(value)) - 1));
    return atLeastOne(value / digit) * std::llround(digit);
}

/** Returns hours and minutes, such as "0:35". */
std::string hoursAndMinutes(double time_s)
{
    constexpr int kMinutes = 60;
    const std::int64_t minutes = atLeastOne(time_s / kMinutes);
    const std::string rest = std::to_string(minutes % kMinutes);
    return std::to_string(minutes / kMinutes) + (rest.size() < 2 ? ":0" : ":") + rest;
}

/**
 * Returns the time of one UAV's share of a tour of all icebergs present at the start, s; 0 with
 * fewer than two icebergs.
 */
double round_s(const Scenario& scenario)
{
    std::vector<Point> left_m;
    for (const Iceberg& iceberg : scenario.icebergs)
        if (iceberg.appears_s == 0)
            left_m.push_back(iceberg.position_m);
    if (left_m.size() < 2)
        return 0;
    const Point first_m = left_m.back();
    Point at_m = first_m;
    double round_m = 0;
    for (left_m.pop_back(); !left_m.empty(); left_m.pop_back()) {
        const auto next = std::ranges::min_element(
            left_m, {}, [&](const Point& p_m) { return (p_m - at_m).norm(); });
        round_m += (*next - at_m).norm();
        at_m = *next;
        std::swap(*next, left_m.back());
    }
    round_m += (first_m - at_m).norm();
    double speed_mps = 0;
    for (const Uav& uav : scenario.uavs)
        speed_mps += uav.spec.airspeed_mps;
    return round_m / speed_mps;
}

/**
 * Returns the standard deviation of the position one round after a visit in which the filter takes
 * as many samples as the view allows.
 */
double sdAfterRound_m(const Scenario& scenario, const Iceberg& iceberg, const Uav& uav,
                      double round_s)
{
    const ObserverSpec& observer = scenario.observer;
    const double interval_s = std::max(observer.interval_s, scenario.dt_s);
    const double inView_s = width_m(scenario, uav) / uav.spec.airspeed_mps;
    Track track = initialTrack(iceberg, observer.model);
    const double samples =
        std::clamp(observer.detection * inView_s / interval_s, 1.0, kMostSamples);
    for (int sample = 0; sample < static_cast<int>(samples); ++sample) {
        track.grow(sample == 0 ? 0 : inView_s / samples);
        track.measured(track.anchor_m, observer.positionSd_m * observer.positionSd_m,
                       track.anchor_s);
    }
    return std::sqrt(track.sigmaAfter_m2(round_s));
}

} // namespace

double chanceInView(const SensorSpec& sensor, double sd_m, double spread_m)
{
    if (!(sd_m > 0))
        return 1;
    const Point half = (sensor.fov_m.array() - 2 * spread_m).max(0).matrix() / (2 * sd_m);
    if (sensor.shape == FovShape::Disk)
        return -std::expm1(-half.x() * half.x() / 2);
    return std::erf(half.x() / std::numbers::sqrt2) * std::erf(half.y() / std::numbers::sqrt2);
}

void adviseDrift(const Scenario& scenario, Findings& findings)
{
    const Uav& uav = widestView(scenario);
    const double view_m = width_m(scenario, uav);
    for (std::size_t i = 0; i < scenario.icebergs.size(); ++i) {
        const Iceberg& iceberg = scenario.icebergs[i];
        const double sigma_m2 = initialSigma_m2(iceberg);
        const double within_m = radius95_m(sigma_m2);
        if (iceberg.observed_s > 0 && std::sqrt(sigma_m2) > view_m / 2)
            findings.warn(entryPath("icebergs", i) + ".observed_s", IssueId::SeenLongAgo,
                          {hoursAndMinutes(iceberg.observed_s),
                           Amount{static_cast<double>(roughly(within_m)), Quantity::Distance},
                           atLeastOne(within_m / view_m)});
    }
    const double next_s = round_s(scenario);
    if (scenario.observer.model == ObserverModel::Simple || next_s <= 0 ||
        next_s > scenario.duration_s)
        return;
    double out = 0;
    std::int64_t count = 0;
    for (const Iceberg& iceberg : scenario.icebergs) {
        if (iceberg.appears_s > 0)
            continue;
        ++count;
        out += 1 - chanceInView(sensorOf(scenario, uav),
                                sdAfterRound_m(scenario, iceberg, uav, next_s));
    }
    if (out >= 0.5)
        findings.hint("icebergs", IssueId::OutOfViewNext,
                      {roughly(next_s / 60), std::int64_t{std::llround(out)}, count});
}

} // namespace berg
