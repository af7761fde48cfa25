#pragma once

#include "core/base/index.h"
#include "core/geometry/enclosing_circle.h"
#include "core/tracking/observer.h"
#include "core/vehicle/dubins.h"

#include <span>
#include <vector>

namespace berg {

/**
 * A UAV that flies a plan ahead along straight legs at its airspeed in the wind. Each leg is aimed
 * at the predicted position of its drifting target: flight time t = d / (w_par + sqrt(U^2 - w_n^2))
 * with wind minus drift in place of the wind. Turns take no time. Every prediction of arrival times
 * uses this class.
 */
class LegFlight
{
public:
    /** Starts at `from_m` at time 0. */
    LegFlight(const Point& from_m, double airspeed_mps, const Point& wind_mps)
        : m_airspeed_mps(airspeed_mps), m_wind_mps(wind_mps), m_position_m(from_m)
    {
    }

    /** Returns the time since the start, s. */
    [[nodiscard]] double time_s() const { return m_time_s; }
    [[nodiscard]] const Point& position_m() const { return m_position_m; }

    /**
     * Flies to a target that is at `place_m` at the start and drifts with `drift_mps`; returns the
     * meeting point. If the relative wind is not below the airspeed, the UAV cannot be sure to
     * catch up, and the target is taken as standing still from the start of its leg, as in
     * planning.
     */
    Point flyTo(const Point& place_m, const Point& drift_mps)
    {
        const Point now_m = place_m + drift_mps * m_time_s;
        const Point relativeWind_mps = m_wind_mps - drift_mps;
        const bool sure = relativeWind_mps.norm() < m_airspeed_mps;
        const double flight_s = flightTime_s(now_m - m_position_m, m_airspeed_mps,
                                             sure ? relativeWind_mps : m_wind_mps);
        m_time_s += flight_s;
        m_position_m = sure ? Point(now_m + drift_mps * flight_s) : now_m;
        return m_position_m;
    }

    /**
     * Flies to the track's estimate, whose time at the start of the flight is `start_s`, s; returns
     * the meeting point.
     */
    Point flyTo(const Track& track, double start_s)
    {
        if (track.velocityTime_s == 0)
            return flyTo(track.estimate_m(start_s), track.velocity_mps);
        return flyTo([&](double after_s) {
                   return Circle{.centre_m = track.estimate_m(start_s + after_s)};
               })
            .centre_m;
    }

    /**
     * Flies to the centre of a moving circle, which must be slower than the UAV's ground speed.
     * `circleAt` returns the circle at a time since the start, s. Returns the circle on arrival.
     */
    template <class CircleAt>
    Circle flyTo(const CircleAt& circleAt)
    {
        constexpr int kRounds = 20; // each reduces the error by the ratio of speeds
        double arrival_s = m_time_s;
        for (int round = 0; round < kRounds; ++round)
            arrival_s = m_time_s + flightTime_s(circleAt(arrival_s).centre_m - m_position_m,
                                                m_airspeed_mps, m_wind_mps);
        Circle met = circleAt(arrival_s);
        m_time_s = arrival_s;
        m_position_m = met.centre_m;
        return met;
    }

private:
    double m_airspeed_mps;
    Point m_wind_mps;
    Point m_position_m;
    double m_time_s = 0;
};

struct ForecastStart;

/**
 * Flies the order of UAV `uav` from `start` as `forecastPlan` does and returns the flight at its
 * end.
 */
[[nodiscard]] LegFlight flyAhead(const ForecastStart& start, std::size_t uav,
                                 std::span<const IcebergIndex> order,
                                 std::span<const IcebergList> clusters);

} // namespace berg
