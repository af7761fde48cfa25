#pragma once

#include "core/sim/simulation.h"

#include <optional>
#include <span>
#include <vector>

namespace berg {

/** The instant from which orders are thought flown. The world is borrowed. */
struct ForecastStart
{
    WorldState world;
    std::vector<bool> active; ///< by iceberg: it has appeared
    double time_s = 0;
    std::vector<double> airspeeds_mps; ///< by UAV
    Point wind_mps = Point::Zero();
};

/** An order for each UAV, as iceberg indices; empty: it visits nothing. */
using OrdersByUav = std::vector<std::vector<int>>;

/** One iceberg of the order. */
struct ForecastVisit
{
    int iceberg = -1;              ///< index
    Point place_m = Point::Zero(); ///< where the UAV meets it
    double leg_m = 0;              ///< over ground, from the one before or the UAV
    double arrival_s = 0;          ///< from the start
    double arrivalSigma_m2 = 0;    ///< just before it is seen
    double spread_m = 0;           ///< of a cluster: how far the farthest member is from the place
};

/** What one UAV does. */
struct RouteForecast
{
    std::vector<ForecastVisit> visits; ///< all of its order, also those after the horizon
    double distance_m = 0;             ///< over ground, until the last of them
};

struct PlanForecast
{
    std::vector<RouteForecast> uavs; ///< by UAV
    double zeta_m2s = 0;             ///< added to Eq. (24) within the horizon
};

/**
 * What becomes of flying `orders` for `horizon_s` from the start: arrivals and sigmas, Eq. (22),
 * and the zeta, Eq. (24), that they add, in closed form. It is assumed that
 * - the estimates of the start drift on, and each leg is aimed ahead of them (`LegFlight`);
 * - legs are straight and flown at the airspeed in the wind, without the time that turns take;
 * - an iceberg is seen for an instant, when the UAV is over its estimate: sigma falls to 0 and
 *   grows again. In a flight it is seen earlier, by half the field of view, and for longer;
 * - nothing is seen by chance on the way, and what is not in the order grows from what it is now;
 * - the members of one of `clusters`, which follow each other in the order, are all seen at the
 *   middle of the circle round them; the leg there is told of the first of them;
 * - no iceberg appears, and nothing is planned again: after the last visit all sigmas grow.
 * So it is good for comparing orders and for the near future; over many rounds the flight, which
 * goes on visiting, stays below it. Throws `std::logic_error` for an index that is not there.
 */
[[nodiscard]] PlanForecast forecastPlan(const ForecastStart& start, const OrdersByUav& orders,
                                        double horizon_s,
                                        std::span<const std::vector<int>> clusters = {});

/** What is flown to as one point before and after a change. */
struct ChangedClusters
{
    std::span<const std::vector<int>> before;
    std::span<const std::vector<int>> after;
};

/** Another order took the place of what was left of the one before. */
struct PlanChange
{
    std::vector<int> before; ///< what was left of it, iceberg indices
    double distance_m = 0;   ///< by which the new order is longer
    double zeta_m2s = 0;     ///< by which the new orders are predicted to add more, of all UAVs
    bool operator==(const PlanChange&) const = default;
};

/**
 * The changes from `before` to `after`, both flown from the same start for the same time
 * (`forecastPlan`), by UAV. Icebergs that only the new orders visit come last in the old one of the
 * same UAV and the other way round, so that both visit the same. None: nothing was left for the
 * UAV, or its new order begins with all that was.
 */
[[nodiscard]] std::vector<std::optional<PlanChange>>
planChanges(const ForecastStart& start, const OrdersByUav& before, const OrdersByUav& after,
            double horizon_s, const ChangedClusters& clusters = {});

} // namespace berg
