#pragma once

#include "core/coverage/patrol_search.h"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace berg {

/** One visit of the patrol after the aimed legs. */
struct PatrolVisit
{
    ModelPlace iceberg;
    double time_s = 0;
    Point place_m = Point::Zero(); ///< Position of the UAV in the air's frame.
};

/**
 * The patrol after the aimed legs of one UAV, from which the cost after those legs is predicted. It
 * is flown the sooner, the sooner the legs end. It includes the visits of the other UAVs.
 */
struct PatrolTail
{
    PatrolUav uav;
    std::array<std::optional<DriftingPlace>, 3> first; ///< Places of the first visits.
    /** Planned time of the second visit, or of the first one if it is the only one. */
    double planned_s = 0;
    /**
     * First visit to each iceberg by this UAV's tail and by the others' tails; infinity if there is
     * none.
     */
    std::vector<double> nextOwn_s;
    std::vector<double> nextOther_s;
    double rest_m2s = 0; ///< Integral of sigma from each iceberg's next visit on.
    /** First and half the second derivative of `rest_m2s` when all visits come later. */
    double slope_m2 = 0;
    double bend_m2ps = 0;

    /**
     * Returns the delay of the tail in seconds, compared with its plan, if it is flown from this
     * pose at this time; negative if it is early.
     */
    [[nodiscard]] double shift_s(const Pose& from, double time_s) const;
    /**
     * Returns the delay in seconds with which a UAV with this pose at this time comes home from its
     * sortie. It is 0 or less if the UAV is in time, and without sorties.
     */
    [[nodiscard]] double late_s(const Pose& from, double time_s) const;
};

/** The rests of all routes of a patrol after the aimed legs. */
class PatrolTails
{
public:
    /**
     * Copies the rests of the routes. `cuts` has, for each UAV, the index of the visit at which its
     * tail begins.
     */
    PatrolTails(const PatrolSearch& patrol, std::span<const std::size_t> cuts);

    /**
     * Returns the tail of a UAV. `shifts_s` has, for each UAV, the delay of its tail compared with
     * the plan; the UAV's own entry is not used.
     */
    [[nodiscard]] PatrolTail tailOf(std::size_t uav, std::span<const double> shifts_s) const;
    /** Returns the visits of a UAV's tail, in order. */
    [[nodiscard]] std::span<const PatrolVisit> visits(std::size_t uav) const
    {
        return m_visits[uav];
    }
    /** Replaces the growths of the icebergs. The places and the visits must be the same. */
    void setIcebergs(std::vector<PatrolIceberg> icebergs) { m_icebergs = std::move(icebergs); }

private:
    std::vector<PatrolIceberg> m_icebergs;
    std::vector<PatrolUav> m_uavs;
    std::vector<std::vector<PatrolVisit>> m_visits; ///< Visits of each UAV's tail.
    std::vector<std::size_t> m_before; ///< Number of visits before the tails, for each iceberg.
    double m_length_s;
};

} // namespace berg
