#pragma once

#include "core/geometry/geometry.h"
#include "core/vehicle/tangent_turn.h"

#include <array>
#include <limits>
#include <optional>
#include <vector>

namespace berg {

// A patrol visits all icebergs repeatedly, farther ahead than aimed legs are worth planning. Times
// are seconds since the plan is made, and positions are in the air's frame.

/** Sigma of an iceberg that has been out of view for `gap_s`, as base + rate gap + bend gap^2. */
struct PatrolGrowth
{
    double base_m2 = 0;
    double rate_m2ps = 0;
    double bend_m2ps2 = 0;

    /** Returns sigma after the gap. */
    [[nodiscard]] double sigma_m2(double gap_s) const
    {
        return base_m2 + gap_s * (rate_m2ps + gap_s * bend_m2ps2);
    }
    /** Returns the derivative of sigma at the end of the gap. */
    [[nodiscard]] double slope_m2ps(double gap_s) const
    {
        return rate_m2ps + 2 * gap_s * bend_m2ps2;
    }
    /** Returns the integral of sigma over the gap. */
    [[nodiscard]] double cost_m2s(double gap_s) const
    {
        return gap_s * (base_m2 + gap_s * (rate_m2ps / 2 + gap_s * bend_m2ps2 / 3));
    }
};

/** A place that moves through the air. */
struct DriftingPlace
{
    Point place_m = Point::Zero(); ///< Position at time 0.
    Point velocity_mps = Point::Zero();

    /** Returns the position at a time. */
    [[nodiscard]] Point at(double time_s) const { return place_m + velocity_mps * time_s; }
};

/** One iceberg of a patrol, with its weight in the growth of sigma. */
struct PatrolIceberg
{
    /** There is one growth before the first visit, one after it, and one after all later visits. */
    static constexpr std::size_t kStages = 3;

    DriftingPlace place;
    std::array<PatrolGrowth, kStages> growth;

    /** Returns the growth of the variance in the gap that follows this number of visits. */
    [[nodiscard]] const PatrolGrowth& after(std::size_t visits) const
    {
        return growth[visits < kStages ? visits : kStages - 1];
    }
};

/** Limits of the sorties of a UAV with a limited endurance. */
struct PatrolSorties
{
    DriftingPlace home;
    double left_s = 0;   ///< Rest of the sortie under way, at whose end the UAV must be home.
    double length_s = 0; ///< Length of each later sortie.
    double ground_s = 0; ///< Time between landing and take-off.
};

/** One UAV of a patrol. */
struct PatrolUav
{
    Pose start;
    double speed_mps = 22;
    double radius_m = 106; ///< Radius of a turn at the limit.
    double reach_m = 300;  ///< An iceberg within this distance is in view.
    double until_s = std::numeric_limits<double>::infinity(); ///< End of the UAV's flight.
    std::optional<PatrolSorties> sorties; ///< Sorties; nullopt with unlimited endurance.
    /** Icebergs to which the first visit may go, and any visit at all; empty lists allow all. */
    std::vector<bool> first = {};
    std::vector<bool> any = {};

    /** Returns whether the UAV may visit an iceberg, as its first visit if `isFirst`. */
    [[nodiscard]] bool mayVisit(int iceberg, bool isFirst) const
    {
        const auto i = static_cast<std::size_t>(iceberg);
        return (any.empty() || any[i]) && (!isFirst || first.empty() || first[i]);
    }
};

/** Input of `PatrolSearch`. */
struct PatrolProblem
{
    std::vector<PatrolIceberg> icebergs;
    std::vector<PatrolUav> uavs;
    double length_s = 0; ///< Length of the patrol; later visits do not count.
};

/** State of a UAV at the end of a visit. */
struct PatrolStop
{
    Point place_m = Point::Zero();
    Point ahead = Point(1, 0);
    double time_s = 0;
    /** End of the sortie, by which the UAV must be home. */
    double sortieEnd_s = std::numeric_limits<double>::infinity();
    bool tookOff = false; ///< The UAV has been home since the stop before.
    /**
     * Time between coming home from here and the end of the sortie; where much is left, less than
     * that.
     */
    double spare_s = std::numeric_limits<double>::infinity();
    /** Time for which the sortie before was too short for this visit, if the UAV took off for it.
     */
    double missing_s = std::numeric_limits<double>::infinity();
};

/** Returns the state of a UAV at the beginning of its patrol. */
[[nodiscard]] PatrolStop patrolStart(const PatrolUav& uav);

/**
 * Returns the flight time home in seconds, a turn at the limit included. The UAV must have sorties.
 */
[[nodiscard]] double patrolTimeHome_s(const PatrolUav& uav, const PatrolStop& from);

/**
 * Returns the state after a flight to a visit, via home if the endurance would end before. Its time
 * is infinite if no sortie is long enough. The iceberg is seen where the UAV comes within reach of
 * it on the shortest path to `next`, which is null if no visit follows. A turn takes the time that
 * a turn at the limit adds to the straight line. One step of a fixed-point iteration accounts for
 * the drift of the iceberg during the flight.
 */
[[nodiscard]] PatrolStop patrolLeg(const PatrolUav& uav, const PatrolStop& from,
                                   const DriftingPlace& to, const DriftingPlace* next);

} // namespace berg
