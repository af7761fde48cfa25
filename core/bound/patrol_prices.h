#pragma once

#include "core/bound/frequency_bound.h"
#include "core/bound/visit_zones.h"

#include <span>
#include <stop_token>
#include <vector>

namespace berg {

/**
 * The multipliers of visits and seconds in each slice of a run, in the symbols of `frequencyBound`.
 */
class PatrolPrices
{
public:
    /**
     * Calculates the zones, multipliers and losses of all slices. `icebergs` are at least two
     * indices in the scenario of icebergs whose sigma grows; the run is cut into `slices` parts.
     * The scenario and motion are borrowed. A requested stop leaves the object unusable, so callers
     * check the token afterwards.
     */
    PatrolPrices(const Scenario& scenario, const TrueMotion& motion, std::span<const int> icebergs,
                 int slices, const std::stop_token& stop);

    /**
     * Returns the bound with every mu and R multiplied by `scale`. Every positive scale gives a
     * valid bound.
     */
    [[nodiscard]] FrequencyBound bound(double scale) const;

private:
    struct Slice
    {
        EdgeRange range;
        VisitZones zones;
        double mu_m2 = 0;                   ///< Multiplier of one second of one UAV.
        std::vector<double> groupVisit_m2s; ///< Multipliers R_G.
        std::vector<double> visit_m2s;      ///< Multipliers R_i.
        std::vector<double> share;          ///< Weights w_i.
        double mostVisit_m2s = 0;
    };

    /** Adds a slice with its zones and mu. */
    void addSlice(EdgeRange range, const std::stop_token& stop);
    /** Sets R of all groups and icebergs, no higher than nearly all slices can pay. */
    void priceVisits();
    /** Returns the duration of a slice. */
    [[nodiscard]] double length_s(const Slice& slice) const;
    /**
     * Returns the greatest loss at the edge after a slice, over legs and stays between it and the
     * next one.
     */
    [[nodiscard]] double lossAfter_m2s(std::size_t slice, const std::stop_token& stop) const;
    /**
     * Stores the greatest loss at the edge after a slice, over all legs and stays; `nextTo_m2s` is
     * that of `lossAfter_m2s`.
     */
    void addLoss(std::size_t slice, double nextTo_m2s);
    /** Returns the loss of the first visits, summed over the UAVs. */
    [[nodiscard]] double lossAtStart_m2s() const;
    /** Cuts the run into cells of time, none of which lies in two slices. */
    void cut();
    /** Returns the sum of V_i at each edge of the cells. */
    [[nodiscard]] std::vector<double> costs_m2s(double scale) const;
    [[nodiscard]] const Iceberg& iceberg(std::size_t i) const
    {
        return m_scenario.icebergs[static_cast<std::size_t>(m_icebergs[i])];
    }

    const Scenario& m_scenario;
    const TrueMotion& m_motion;
    std::vector<int> m_icebergs;
    std::vector<double> m_growth_m2ps;
    std::vector<Slice> m_slices;
    std::vector<double> m_lossAfter_m2s; ///< Loss after each slice except the last.
    double m_lossAtStart_m2s = 0;        ///< Loss at the start, summed over the UAVs.
    std::vector<double> m_edges_s;       ///< Edges of the cells of time.
    std::vector<std::size_t> m_sliceOf;  ///< Slice of each cell.
};

} // namespace berg
