#pragma once

#include "core/plan/policy/tau_curve.h"
#include "core/scenario/scenario.h"

#include <string>
#include <vector>

namespace berg {

/** The plans of a scenario for every tau, with the names of their UAVs and icebergs. */
struct CurveReport
{
    const TauCurve& curve;
    const Scenario& scenario;
    const IcebergList& ids;                     ///< iceberg of node k + 1 of the curve's orders
    const std::vector<int>& uavs;               ///< index of the UAV of each order of a plan
    std::span<const IcebergList> clusters = {}; ///< groups of icebergs; the first of a group
                                                ///< is the node of all its members
};

/**
 * Returns the curve as one JSON document: intervals with tau, distance, reward and orders (1-based
 * numbers, and ids), whether it is complete, and `elapsed_s` as `seconds`. The orders of several
 * UAVs follow one another, and are listed by UAV as well.
 */
[[nodiscard]] std::string curveJson(const CurveReport& report, double elapsed_s);

/**
 * Returns the curve as CSV (RFC 4180):
 * `tau_from,tau_to,distance_m,reward_m2,proven,order,icebergs`. `proven` is 1 or 0, `order` holds
 * 1-based numbers separated by blanks, `icebergs` ids separated by semicolons; the orders of
 * several UAVs are separated by `kBetweenOrders`.
 */
[[nodiscard]] std::string curveCsv(const CurveReport& report);

/** Separator of the orders of several UAVs. */
inline constexpr std::string_view kBetweenOrders = "|";

/**
 * Returns the icebergs of an order as 1-based numbers of the scenario; members of a cluster are
 * next to each other.
 */
[[nodiscard]] std::vector<int> icebergNumbers(const CurveReport& report, const VisitOrder& order);

} // namespace berg
