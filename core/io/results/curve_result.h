#pragma once

#include "core/plan/policy/tau_curve.h"
#include "core/scenario/scenario.h"

#include <string>
#include <vector>

namespace berg {

/** The plans of a scenario for every tau. */
struct CurveReport
{
    const TauCurve& curve;
    const Scenario& scenario;
    const std::vector<int>& ids;  ///< index of the iceberg that is node k+1 of the curve's orders
    const std::vector<int>& uavs; ///< index of the UAV of each order of a plan
    std::span<const std::vector<int>> clusters = {}; ///< whose first ones are nodes for them all
};

/** One JSON document: intervals with tau, figures and orders (1-based numbers, and ids), those of
 * several UAVs one after another, and by UAV as well. */
[[nodiscard]] std::string curveJson(const CurveReport& report, double elapsed_s);

/**
 * `tau_from,tau_to,distance_m,reward_m2,proven,order,icebergs`, RFC 4180: `order` holds 1-based
 * numbers with blanks between, `icebergs` ids with semicolons; those of several UAVs are parted by
 * `kBetweenOrders`.
 */
[[nodiscard]] std::string curveCsv(const CurveReport& report);

inline constexpr std::string_view kBetweenOrders = "|";

/** Icebergs of an order as 1-based numbers of the scenario, those of a cluster side by side. */
[[nodiscard]] std::vector<int> icebergNumbers(const CurveReport& report, const VisitOrder& order);

} // namespace berg
