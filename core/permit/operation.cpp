#include "core/permit/operation.h"

#include "core/base/angles.h"
#include "core/geometry/outline.h"
#include "core/scenario/flight_weather.h"

#include <algorithm>
#include <cmath>

namespace berg {

namespace {

std::vector<Point> placesToFly_m(const Scenario& scenario)
{
    std::vector<Point> places_m;
    for (const Uav& uav : scenario.uavs) {
        places_m.push_back(uav.position_m);
        places_m.push_back(uav.home_m.value_or(uav.position_m));
    }
    for (const Iceberg& iceberg : scenario.icebergs)
        for (const double time_s : {iceberg.appears_s, scenario.duration_s}) {
            const Point place_m =
                iceberg.position_m +
                (iceberg.velocity_mps + meanDrift_mps(scenario, iceberg)) * time_s;
            const bool isFlownTo = scenario.area_m.empty() || // icebergs outside are not visited
                                   insidePolygon(scenario.area_m, place_m);
            if (iceberg.appears_s <= scenario.duration_s && isFlownTo)
                places_m.push_back(place_m);
        }
    return places_m;
}

} // namespace

OperationVolume operationVolume(const Scenario& scenario, const Operation& operation)
{
    OperationVolume volume;
    const std::shared_ptr<const FlightWeather> weather = weatherOf(scenario);
    const double wind_mps = weather ? weather->strongestWind_mps() : scenario.wind_mps.norm();
    for (const Uav& uav : scenario.uavs) {
        volume.speed_mps = std::max(volume.speed_mps, uav.spec.airspeed_mps + wind_mps);
        volume.height_m = std::max(volume.height_m, uav.spec.altitude_m);
    }
    const double v_mps = volume.speed_mps;
    const double vSquaredByG_m = v_mps * v_mps / kGravity_mps2;
    volume.outside_m = operation.positionError_m + operation.pathError_m + operation.mapError_m +
                       v_mps * operation.reaction_s +
                       vSquaredByG_m / std::tan(radFromDeg(operation.turnBank_deg));
    volume.ceiling_m = volume.height_m + operation.heightError_m +
                       operation.climbPart * v_mps * operation.reaction_s +
                       operation.pullUpPart * vSquaredByG_m;
    volume.buffer_m = operation.bufferRatio * volume.ceiling_m + operation.span_m / 2;
    volume.adjacent_m = std::min(std::max(v_mps * operation.adjacent_s, operation.adjacentLeast_m),
                                 std::max(operation.adjacentMost_m, operation.adjacentLeast_m));

    std::vector<Point>& geography_m = volume.outlines_m[0];
    if (scenario.geofence && scenario.area_m.size() >= 3) {
        geography_m = scenario.area_m;
        if (signedArea(geography_m) < 0)
            std::reverse(geography_m.begin(), geography_m.end());
    } else {
        geography_m = grownOutline(convexHull(placesToFly_m(scenario)), operation.margin_m);
    }
    const auto grow = [&](VolumePart part, double by_m) {
        volume.outlines_m[static_cast<std::size_t>(part)] =
            by_m > 0 ? grownOutline(geography_m, by_m) : geography_m;
    };
    grow(VolumePart::Contingency, volume.outside_m);
    grow(VolumePart::Buffer, volume.outside_m + volume.buffer_m);
    grow(VolumePart::Adjacent, volume.outside_m + volume.adjacent_m);
    return volume;
}

} // namespace berg
