#include "app/flight/aircraft_controller.h"
#include "app/layout/panels.h"
#include "widgets/aircraft/link_text.h"
#include "widgets/map/paint/graticule.h"
#include "widgets/panels/aircraft/aircraft_panel.h"
#include "widgets/workspace/workspace.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <utility>

namespace berg {

namespace {

constexpr double kLinkDelay_s = 2;
constexpr double kLoiterRadius_m = 150; ///< asked for; autopilots fly a larger one if they must
constexpr double kMoved_m = 100;        ///< the iceberg has moved: the point is sent again

bool isRunning(const LinkVehicle& vehicle)
{
    return vehicle.sync && (vehicle.sync->phase == SyncPhase::Uploading ||
                            vehicle.sync->phase == SyncPhase::ReadingBack);
}

bool isEqual(const std::vector<MissionPart>& a, const std::vector<MissionPart>& b)
{
    return std::ranges::equal(a, b, [](const MissionPart& x, const MissionPart& y) {
        return x.type == y.type && missionDifferences(x.items, y.items).empty();
    });
}

} // namespace

std::vector<std::string> AircraftController::orderInForce(int uav) const
{
    const MissionSnapshot& now = workspace().record().now;
    std::vector<std::string> ids;
    if (const UavPlan* plan = planOf(now, uav))
        for (const IcebergIndex iceberg : plan->order)
            ids.push_back(now.icebergs[toIndex(iceberg)].id);
    return ids;
}

void AircraftController::requestMission(Purpose purpose)
{
    const std::optional<LinkAddress> chosen = panels().aircraft->chosen();
    if (!chosen)
        return;
    m_aircraft[*chosen].purpose = purpose;
    workspace().runner().requestMissions();
}

void AircraftController::acceptMissions(const std::vector<UavMission>& missions)
{
    for (auto& [address, aircraft] : m_aircraft) {
        const Purpose purpose = std::exchange(aircraft.purpose, Purpose::None);
        const auto mission = std::ranges::find(missions, aircraft.uav, &UavMission::uav);
        if (purpose == Purpose::None || mission == missions.end())
            continue;
        if (purpose == Purpose::Check) {
            if (aircraft.upload)
                aircraft.upload->isPlanChanged = !isEqual(aircraft.upload->parts, mission->parts);
            continue;
        }
        aircraft.upload = Upload{.parts = mission->parts, .order = mission->order};
        workspace().link().startSync(address, mission->parts,
                                     purpose == Purpose::Upload
                                         ? MissionSync::Task::UploadAndCompare
                                         : MissionSync::Task::Compare);
    }
    showPanel();
}

QString AircraftController::onBoardText(const Aircraft& aircraft, const LinkVehicle& vehicle) const
{
    if (isRunning(vehicle))
        return syncText(*vehicle.sync);
    if (!aircraft.upload || aircraft.upload->time.isEmpty())
        return vehicle.sync && vehicle.sync->phase != SyncPhase::Equal ? syncText(*vehicle.sync)
                                                                       : QString();
    const Upload& upload = *aircraft.upload;
    if (upload.isChangedOnBoard)
        return tr("Differs: the mission on board has changed since %1").arg(upload.time);
    if (upload.isPlanChanged)
        return tr("Differs: the plan has changed since %1").arg(upload.time);
    return tr("On board: same as the plan of %1").arg(upload.time);
}

/** Notes whether plan or mission on board have changed since they were equal. */
void AircraftController::watchMission(const LinkVehicle& vehicle, Aircraft& aircraft)
{
    if (!aircraft.upload || aircraft.upload->time.isEmpty() || !vehicle.state.mission)
        return;
    Upload& upload = *aircraft.upload;
    const AircraftMission& mission = *vehicle.state.mission;
    if (mission.received_s < upload.found_s + kLinkDelay_s)
        return; // it may have been sent before the upload
    if (!upload.total && !upload.missionId) {
        upload.total = mission.total;
        upload.missionId = mission.missionId;
    }
    upload.isChangedOnBoard = upload.isChangedOnBoard || upload.total != mission.total ||
                              upload.missionId != mission.missionId;
}

/** In flight the order ahead counts, because places of waypoints follow the estimates. */
void AircraftController::flightChanged()
{
    bool mustCheck = false;
    for (auto& [address, aircraft] : m_aircraft) {
        if (!aircraft.upload || aircraft.upload->time.isEmpty())
            continue;
        const std::optional<int> uav = uavIndex(aircraft);
        if (!workspace().inFlight()) {
            if (workspace().record().now.phase != RunPhase::Ready)
                continue;
            if (aircraft.purpose != Purpose::None)
                continue; // it will compare, too
            aircraft.purpose = Purpose::Check;
            mustCheck = true;
        } else if (uav) {
            aircraft.upload->isPlanChanged =
                !agreesAhead(aircraft.upload->order, orderInForce(*uav));
            replaceMission(address, aircraft);
        }
    }
    if (mustCheck)
        workspace().runner().requestMissions();
    if (!m_aircraft.empty())
        showPanel();
}

void AircraftController::replaceMission(LinkAddress address, Aircraft& aircraft)
{
    const LinkVehicle* vehicle = vehicleOf(address);
    if (!aircraft.upload->isPlanChanged || vehicle == nullptr || vehicle->isLost ||
        isRunning(*vehicle) || aircraft.purpose != Purpose::None ||
        aircraft.steering.kind() != SteeringKind::Mission ||
        aircraft.steering.state() != SteeringState::Active)
        return;
    aircraft.purpose = Purpose::Upload;
    workspace().runner().requestMissions();
}

void AircraftController::setSteering(SteeringKind kind)
{
    const std::optional<LinkAddress> chosen = panels().aircraft->chosen();
    const LinkVehicle* vehicle = chosen ? vehicleOf(*chosen) : nullptr;
    if (vehicle == nullptr)
        return;
    Aircraft& aircraft = m_aircraft[*chosen];
    aircraft.guidedTo.reset();
    aircraft.steering.begin(kind, vehicle->autopilot, vehicle->mode);
    showStatus();
}

/**
 * Sends the point beyond the next iceberg on the line from the aircraft: an autopilot circles its
 * point, and so must be sent past the iceberg to fly over it.
 */
void AircraftController::guide(const LinkVehicle& vehicle, Aircraft& aircraft)
{
    const MissionSnapshot& now = workspace().record().now;
    const std::optional<int> uav = uavIndex(aircraft);
    const SteeringState state = aircraft.steering.state();
    if (aircraft.steering.kind() != SteeringKind::Guided || !uav || vehicle.isLost || !now.isLive ||
        (state != SteeringState::Waiting && state != SteeringState::Active))
        return;
    const UavState& flown = now.world.uavs[static_cast<std::size_t>(*uav)];
    if (!flown.target)
        return;
    const Point iceberg_m = workspace().record().estimate_m(*flown.target);
    if (aircraft.guidedTo == flown.target && (aircraft.guidedTo_m - iceberg_m).norm() < kMoved_m)
        return;
    const Point path_m = iceberg_m - flown.pose.position_m;
    const double past_m =
        beyond_m(kLoiterRadius_m, vehicle.state.groundSpeed_mps.value_or(0), kLinkDelay_s);
    const Point beyond =
        iceberg_m + (path_m.norm() > 1 ? Point(past_m * path_m.normalized()) : Point::Zero());
    const Scenario& scenario = workspace().record().scenario;
    const std::optional<LinkCommand> command =
        guidedCommand(vehicle.autopilot,
                      {.place = LocalFrame(scenario.origin).toGeographic(beyond),
                       .aboveHome_m = scenario.uavs[static_cast<std::size_t>(*uav)].spec.altitude_m,
                       .radius_m = kLoiterRadius_m},
                      vehicle.state.homeAltitude_m);
    if (!command)
        return; // the altitude of its home is not known yet
    aircraft.guidedTo = flown.target;
    aircraft.guidedTo_m = iceberg_m;
    workspace().link().sendCommand(vehicle.address, *command);
}

void AircraftController::useWind()
{
    const std::optional<LinkAddress> chosen = panels().aircraft->chosen();
    const LinkVehicle* vehicle = chosen ? vehicleOf(*chosen) : nullptr;
    if (vehicle == nullptr || !vehicle->state.wind)
        return;
    const AircraftWind& wind = *vehicle->state.wind;
    const double north_rad =
        northAngle_rad(LocalFrame(workspace().document().scenario().origin), Point::Zero());
    const Point mean_mps(wind.meanEast_mps, wind.meanNorth_mps);
    workspace().setWind(Eigen::Rotation2D<double>(-north_rad) * mean_mps);
}

/** Each move costs a plan, so that small deviations wait. */
void AircraftController::followShip()
{
    constexpr double kDeviation_m = 50;
    constexpr double kDeviation_mps = 0.5;
    constexpr double kPause_s = 10;
    const LinkStatus& status = workspace().link().status();
    const auto ship = std::ranges::find_if(status.traffic, [this](const TrafficTarget& target) {
        return target.kind == TrafficTarget::Kind::Ship && target.id == m_assetShip;
    });
    const bool inFlight = workspace().inFlight();
    const std::optional<Asset>& asset =
        inFlight ? workspace().record().now.asset : workspace().document().scenario().asset;
    if (m_assetShip == 0 || ship == status.traffic.end() || !asset ||
        status.now_s - m_assetMoved_s < kPause_s)
        return;
    const DubinsState pose = poseAt(ship->place, ship->course_rad.value_or(0));
    const Point velocity_mps =
        ship->speed_mps * Point(std::cos(pose.psi_rad), std::sin(pose.psi_rad));
    const Point place_m = pose.position_m + velocity_mps * (status.now_s - ship->received_s);
    const double now_s = inFlight ? workspace().record().now.time_s : 0;
    if ((asset->position_m + now_s * asset->velocity_mps - place_m).norm() < kDeviation_m &&
        (asset->velocity_mps - velocity_mps).norm() < kDeviation_mps)
        return;
    m_assetMoved_s = status.now_s;
    workspace().setAssetMotion(place_m, velocity_mps);
}

} // namespace berg
