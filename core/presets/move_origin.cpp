#include "core/presets/move_origin.h"

#include "core/base/angles.h"
#include "core/base/error.h"
#include "core/checks/validate.h"

#include <cmath>
#include <set>
#include <utility>

namespace berg {
namespace {

// Short on the scale of the Earth, long compared with rounding errors.
constexpr double kTurnArm_m = 100;

/** Conversion from the plane around one origin to that around another. */
class PlaneChange
{
public:
    PlaneChange(const LatLon& from, const LatLon& to) : m_from(from), m_to(to) {}

    [[nodiscard]] Point operator()(const Point& p_m) const
    {
        return m_to.toPlane(m_from.toGeographic(p_m));
    }

    /** Returns the counter-clockwise turn of directions at a place of the old plane. */
    [[nodiscard]] double turn_rad(const Point& p_m) const
    {
        const Point east =
            (*this)(p_m + Point(kTurnArm_m, 0)) - (*this)(p_m - Point(kTurnArm_m, 0));
        const Point north =
            (*this)(p_m + Point(0, kTurnArm_m)) - (*this)(p_m - Point(0, kTurnArm_m));
        // This is the rotation nearest to the linear map with these columns.
        return std::atan2(east.y() - north.x(), east.x() + north.y());
    }

private:
    LocalFrame m_from;
    LocalFrame m_to;
};

/** Returns the centre of icebergs and UAVs, where wind and current are taken to apply. */
Point middleOfScene_m(const Scenario& scenario)
{
    Point sum_m = Point::Zero();
    for (const Uav& uav : scenario.uavs)
        sum_m += uav.position_m;
    for (const Iceberg& iceberg : scenario.icebergs)
        sum_m += iceberg.position_m;
    const std::size_t count = scenario.uavs.size() + scenario.icebergs.size();
    return count == 0 ? sum_m : Point(sum_m / static_cast<double>(count));
}

void keepPlaces(Scenario& scenario, const PlaneChange& change)
{
    const double turn_rad = change.turn_rad(middleOfScene_m(scenario));
    const Point current_mps =
        std::exchange(scenario.current_mps, turned(scenario.current_mps, turn_rad));
    scenario.wind_mps = turned(scenario.wind_mps, turn_rad);
    for (Point& corner_m : scenario.area_m)
        corner_m = change(corner_m);
    for (NoFlyArea& area : scenario.noFly)
        for (Point& corner_m : area.corners_m)
            corner_m = change(corner_m);
    for (AirspaceArea& area : scenario.airspace)
        for (Point& corner_m : area.corners_m)
            corner_m = change(corner_m);
    if (scenario.iceChart)
        for (IceArea& area : scenario.iceChart->areas)
            for (std::vector<Point>& outline_m : area.outlines_m)
                for (Point& corner_m : outline_m)
                    corner_m = change(corner_m);
    if (scenario.groundStation)
        scenario.groundStation->position_m = change(scenario.groundStation->position_m);
    for (Uav& uav : scenario.uavs) {
        const double heading_deg = uav.heading_deg - degFromRad(change.turn_rad(uav.position_m));
        uav.heading_deg = heading_deg - 360 * std::floor(heading_deg / 360);
        uav.position_m = change(uav.position_m);
        if (uav.home_m)
            uav.home_m = change(*uav.home_m);
    }
    for (Iceberg& iceberg : scenario.icebergs) {
        const Point overGround_mps =
            turned(iceberg.velocity_mps + current_mps, change.turn_rad(iceberg.position_m));
        iceberg.velocity_mps = overGround_mps - scenario.current_mps;
        iceberg.position_m = change(iceberg.position_m);
        for (Point& p_m : iceberg.track.position_m)
            p_m = change(p_m);
    }
    if (!scenario.asset)
        return;
    Asset& asset = *scenario.asset;
    asset.velocity_mps = turned(asset.velocity_mps, change.turn_rad(asset.position_m));
    asset.position_m = change(asset.position_m);
}

/** Throws the errors of `after` in fields that had no findings before. */
void refuseNewFaults(const Scenario& before, const Scenario& after)
{
    std::set<std::string> known;
    for (const Issue& issue : validate(before))
        known.insert(issue.field);
    std::vector<Issue> faults;
    for (Issue& issue : validate(after))
        if (issue.severity == Severity::Error && known.count(issue.field) == 0)
            faults.push_back(std::move(issue));
    if (!faults.empty())
        throw Error(ErrorCode::InvalidInput, "origin", std::move(faults));
}

} // namespace

Scenario movedTo(const Scenario& scenario, const LatLon& origin, MoveMode mode)
{
    if (!(std::abs(origin.latitude_deg) <= 90) || !(std::abs(origin.longitude_deg) <= 180))
        throw Error(ErrorCode::InvalidInput, "origin", {IssueId::NotOnEarth});
    Scenario moved = scenario;
    moved.origin = origin;
    if (mode == MoveMode::KeepPlaces && origin != scenario.origin)
        keepPlaces(moved, PlaneChange(scenario.origin, origin));
    refuseNewFaults(scenario, moved);
    return moved;
}

} // namespace berg
