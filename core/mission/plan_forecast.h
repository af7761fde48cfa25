#pragma once

#include "core/plan/policy/plan.h"
#include "core/sim/simulation.h"

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace berg {

/** The instant from which orders are predicted, with a copy of the world's state. */
struct ForecastStart
{
    WorldState world;
    std::vector<bool> active; ///< by iceberg: monitored at that instant
    /** Run time of that instant, s. */
    double time_s = 0;
    std::vector<double> airspeeds_mps; ///< by UAV
    WindAhead wind_mps;                ///< from that instant on
    /** By iceberg: its changing mean velocity, or null; empty if none changes. */
    std::vector<std::shared_ptr<const DriftForcing>> forcings = {};
};

/** Visiting order of each UAV as iceberg indices; empty if it visits nothing. */
using OrdersByUav = std::vector<IcebergList>;

/** Predicted visit of one iceberg. */
struct ForecastVisit
{
    IcebergIndex iceberg;          ///< index
    Point place_m = Point::Zero(); ///< meeting point
    double leg_m = 0;              ///< length over ground, from the previous visit or the UAV
    double arrival_s = 0;          ///< time since the start
    double arrivalSigma_m2 = 0;    ///< sigma just before the sighting
    /** For a cluster: distance of the farthest member from the meeting point. */
    double spread_m = 0;
};

/** Predicted flight of one UAV. */
struct RouteForecast
{
    std::vector<ForecastVisit> visits; ///< visits of the whole order, also beyond the horizon
    double distance_m = 0;             ///< length over ground up to the last visit
};

/** Predicted flights and zeta. */
struct PlanForecast
{
    std::vector<RouteForecast> uavs; ///< by UAV
    double zeta_m2s = 0;             ///< increase of Eq. (24) within the horizon
};

/**
 * Predicts arrivals, sigmas, Eq. (22), and the increase of zeta, Eq. (24), if `orders` are flown
 * for `horizon_s` seconds from the start, in closed form. Assumptions:
 * - the estimates drift on from the start, and each leg is aimed ahead of them (`LegFlight`);
 * - legs are straight and flown at the airspeed in the wind of the moment; turns take no time;
 * - an iceberg is seen for one instant, when the UAV is over its estimate: sigma falls to 0 and
 *   grows again. In a flight it is seen half a field of view earlier, and for longer;
 * - nothing is seen by chance on the path; icebergs outside the order grow from their present
 *   sigma;
 * - the members of a cluster, consecutive in the order, are all seen at the centre of the circle
 *   around them; the first of them has the length of the leg;
 * - no iceberg appears and nothing is replanned: after the last visit all sigmas grow.
 * The result suits comparisons of orders and the near future. Over many rounds the flight, which
 * continues visiting, stays below it. Throws `std::logic_error` if an index does not exist
 * or `ForecastStart::active` has not one entry for each iceberg.
 */
[[nodiscard]] PlanForecast forecastPlan(const ForecastStart& start, const OrdersByUav& orders,
                                        double horizon_s,
                                        std::span<const IcebergList> clusters = {});

/** Clusters before and after a change of plan. */
struct ChangedClusters
{
    std::span<const IcebergList> before;
    std::span<const IcebergList> after;
};

/**
 * Compares the orders `before` and `after` by UAV, both flown from the same start for `horizon_s`
 * (`forecastPlan`). Icebergs that only the new orders visit are appended to the old order of the
 * same UAV, and for several UAVs vice versa, so that both visit the same. An element is nullopt if
 * nothing was left for the UAV or if its new order begins with the rest of the old one.
 */
[[nodiscard]] std::vector<std::optional<PlanChange>>
planChanges(const ForecastStart& start, const OrdersByUav& before, const OrdersByUav& after,
            double horizon_s, const ChangedClusters& clusters = {});

} // namespace berg
