#pragma once

#include "core/base/index.h"
#include "core/geometry/enclosing_circle.h"
#include "core/sim/drift_ahead.h"
#include "core/vehicle/dubins.h"
#include "core/vehicle/wind_series.h"

#include <span>
#include <utility>
#include <vector>

namespace berg {

/**
 * A UAV that flies a plan ahead along straight legs at its airspeed in the wind. Each leg is aimed
 * at the predicted position of its drifting target: flight time t = d / (w_par + sqrt(U^2 - w_n^2))
 * with wind minus drift in place of the wind; a wind that changes along the leg is integrated.
 * Turns take no time. Every prediction of arrival times
 * uses this class.
 */
class LegFlight
{
public:
    /** Starts at `from_m` at time 0. */
    LegFlight(const Point& from_m, double airspeed_mps, WindAhead wind)
        : m_airspeed_mps(airspeed_mps), m_wind(std::move(wind)), m_position_m(from_m)
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
        const bool sure = (m_wind.at_mps(m_time_s) - drift_mps).norm() < m_airspeed_mps;
        const double flight_s =
            flightTime_s(now_m - m_position_m, m_airspeed_mps,
                         sure ? drift_mps : Point(Point::Zero()), m_wind, m_time_s);
        m_time_s += flight_s;
        m_position_m = sure ? Point(now_m + drift_mps * flight_s) : now_m;
        return m_position_m;
    }

    /**
     * Flies to the predicted place of an iceberg; the flight starts at run time `start_s`, as the
     * prediction does. Returns the meeting point.
     */
    Point flyTo(DriftAhead& iceberg, double start_s)
    {
        if (iceberg.isSteady())
            return flyTo(iceberg.track().estimate_m(start_s), iceberg.track().velocity_mps);
        return flyTo([&](double after_s) { return Circle{.centre_m = iceberg.at_m(after_s)}; })
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
                                                m_airspeed_mps, Point::Zero(), m_wind, m_time_s);
        Circle met = circleAt(arrival_s);
        m_time_s = arrival_s;
        m_position_m = met.centre_m;
        return met;
    }

private:
    double m_airspeed_mps;
    WindAhead m_wind;
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
