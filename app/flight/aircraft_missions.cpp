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
constexpr double kRecheck_s = 30; ///< 40 items in this time are 1 % of a slow radio
constexpr int kWholeRecheck = 4;  ///< one of this many rechecks reads fence and rally points, too
constexpr double kQuiet_s = 3;    ///< the upload of another ground station has ended
constexpr double kLoiterRadius_m = 150; ///< asked for; autopilots fly a larger one if they must
constexpr double kHomeMoved_m = 300;    ///< a minute of a ship at 10 knots
constexpr double kMoved_m = 100;        ///< the iceberg has moved: the point is sent again

} // namespace

bool isSameMission(const std::vector<MissionPart>& a, const std::vector<MissionPart>& b)
{
    return std::ranges::equal(a, b, [](const MissionPart& x, const MissionPart& y) {
        return x.type == y.type && missionDifferences(x.items, y.items).empty();
    });
}

void AircraftController::requestMission(Purpose purpose)
{
    const std::optional<LinkAddress> chosen = panels().aircraft->chosen();
    if (!chosen)
        return;
    Aircraft& aircraft = m_aircraft[*chosen];
    if (purpose == Purpose::Compare && aircraft.upload && workspace().record().now.isLive) {
        // The present plan starts where the aircraft is now; the mission on board does not.
        Transfer transfer{.upload = *aircraft.upload};
        transfer.upload.isChangedOnBoard = false;
        transfer.upload.total.reset();
        transfer.upload.missionId.reset();
        startTransfer(*chosen, aircraft, transfer);
        return;
    }
    aircraft.purpose = purpose;
    workspace().runner().requestMissions();
}

void AircraftController::startTransfer(LinkAddress address, Aircraft& aircraft,
                                       const Transfer& transfer)
{
    if (aircraft.transfer)
        return; // that one is not over yet
    aircraft.transfer = transfer;
    aircraft.transfer->since_s = workspace().link().status().now_s;
    workspace().link().startSync(address, transfer.upload.parts,
                                 transfer.isUpload ? MissionSync::Task::UploadAndCompare
                                                   : MissionSync::Task::Compare);
}

/** Requests for the former scenario are not answered. */
void AircraftController::endRequests()
{
    for (auto& [address, aircraft] : m_aircraft) {
        const Purpose purpose = std::exchange(aircraft.purpose, Purpose::None);
        if (purpose == Purpose::Upload || purpose == Purpose::Compare)
            report(address, tr("the plan has changed meanwhile. Nothing was sent"));
    }
}

void AircraftController::acceptMissions(const std::vector<UavMission>& missions)
{
    for (auto& [address, aircraft] : m_aircraft) {
        const Purpose purpose = std::exchange(aircraft.purpose, Purpose::None);
        const auto mission = std::ranges::find(missions, aircraft.uav, &UavMission::uav);
        if (purpose == Purpose::None)
            continue;
        if (mission == missions.end()) {
            if (purpose == Purpose::Upload || purpose == Purpose::Compare)
                report(address, tr("its UAV has no plan. Nothing was sent"));
            continue;
        }
        if (purpose == Purpose::Check) {
            if (aircraft.upload)
                aircraft.upload->isPlanChanged =
                    !isSameMission(aircraft.upload->parts, mission->parts);
            continue;
        }
        if (purpose == Purpose::Replace && aircraft.steering.state() != SteeringState::Active)
            continue; // the pilot has taken over meanwhile
        Transfer transfer{.upload = {.parts = mission->parts, .order = mission->order},
                          .isUpload = purpose != Purpose::Compare};
        if (const std::optional<int> uav = uavIndex(aircraft))
            transfer.upload.home_m = homes_m()[static_cast<std::size_t>(*uav)];
        startTransfer(address, aircraft, transfer);
    }
    showPanel();
}

QString AircraftController::onBoardText(const Aircraft& aircraft, const LinkVehicle& vehicle) const
{
    if (isSyncRunning(vehicle))
        return syncText(*vehicle.sync, vehicle.autopilot);
    if (!aircraft.upload)
        return vehicle.sync && !vehicle.sync->isRecheck && vehicle.sync->phase != SyncPhase::Equal
                   ? syncText(*vehicle.sync, vehicle.autopilot)
                   : QString();
    const Upload& upload = *aircraft.upload;
    if (upload.isChangedOnBoard)
        return tr("Differs: the mission on board has changed since %1").arg(upload.time);
    if (upload.isPlanChanged)
        return tr("Differs: the plan has changed since %1").arg(upload.time);
    if (upload.isHomeMoved)
        return tr("Differs: home has moved since %1").arg(upload.time);
    const QString same = tr("On board: same as the plan of %1").arg(upload.time);
    const bool hasFence = std::ranges::any_of(
        upload.parts, [](const MissionPart& part) { return part.type == MissionType::Fence; });
    return hasFence ? same : tr("%1. The aircraft keeps its own fence").arg(same);
}

/** Notes whether plan or mission on board have changed since they were equal. */
void AircraftController::watchMission(const LinkVehicle& vehicle, Aircraft& aircraft)
{
    if (!aircraft.upload || aircraft.transfer || !vehicle.state.mission)
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

/**
 * Reads the mission back now and then, because few autopilots say that it was changed: ArduPilot
 * reports its number of items only, PX4 a number that changes with the mission, and neither the
 * fence. Contact that returns and an upload of another ground station are reasons to look at once.
 */
void AircraftController::recheckMission(const LinkVehicle& vehicle, Aircraft& aircraft)
{
    const LinkStatus& status = workspace().link().status();
    if (vehicle.isLost)
        aircraft.nextRecheck_s = status.now_s + kLinkDelay_s;
    if (!status.isSending || !aircraft.upload || aircraft.transfer || vehicle.isLost ||
        isSyncRunning(vehicle) || aircraft.purpose != Purpose::None ||
        aircraft.upload->isChangedOnBoard)
        return;
    const Upload& upload = *aircraft.upload;
    const double from_s = std::max(upload.found_s, aircraft.nextRecheck_s - kRecheck_s);
    const std::optional<double>& others_s = vehicle.othersUpload_s;
    const bool isOthers = others_s && *others_s > from_s && status.now_s > *others_s + kQuiet_s;
    if (!isOthers && status.now_s < std::max(aircraft.nextRecheck_s, upload.found_s + kRecheck_s))
        return;
    aircraft.nextRecheck_s = status.now_s + kRecheck_s;
    std::vector<MissionPart> parts = upload.parts;
    const bool isWhole = isOthers || ++aircraft.rechecks % kWholeRecheck == 0;
    if (!isWhole) // the mission alone is most likely to change
        std::erase_if(parts,
                      [](const MissionPart& part) { return part.type != MissionType::Mission; });
    workspace().link().startSync(vehicle.address, parts, MissionSync::Task::Recheck);
}

/**
 * In flight the order ahead counts, because places of waypoints follow the estimates. A simulated
 * flight says nothing about the aircraft.
 */
void AircraftController::flightChanged()
{
    const MissionSnapshot& now = workspace().record().now;
    if (windInForce_mps() != m_dataWind_mps)
        showUavs();
    bool mustCheck = false;
    for (auto& [address, aircraft] : m_aircraft) {
        if (!aircraft.upload)
            continue;
        const std::optional<int> uav = uavIndex(aircraft);
        if (!workspace().inFlight()) {
            if (now.phase != RunPhase::Ready)
                continue;
            if (aircraft.purpose != Purpose::None)
                continue; // it will compare, too
            aircraft.purpose = Purpose::Check;
            mustCheck = true;
        } else if (uav && now.isLive) {
            // Without a plan the UAV holds or flies home, and the mission ends at home, too.
            if (now.world.uavs[toIndex(*uav)].isPlanned())
                aircraft.upload->isPlanChanged =
                    !agreesAhead(aircraft.upload->order, sortieIcebergs(now, *uav));
            aircraft.upload->isHomeMoved =
                (homes_m()[static_cast<std::size_t>(*uav)] - aircraft.upload->home_m).norm() >
                kHomeMoved_m;
            if (now.world.uavs[toIndex(*uav)].isPlanned() || aircraft.upload->isHomeMoved)
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
    const bool hasChanged = aircraft.upload->isPlanChanged || aircraft.upload->isHomeMoved;
    if (!hasChanged || vehicle == nullptr || vehicle->isLost || aircraft.transfer ||
        isSyncRunning(*vehicle) || aircraft.purpose != Purpose::None ||
        aircraft.steering.kind() != SteeringKind::Mission ||
        aircraft.steering.state() != SteeringState::Active)
        return;
    aircraft.purpose = Purpose::Replace;
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
    const LinkStatus& status = workspace().link().status();
    if (aircraft.steering.kind() != SteeringKind::Guided || !uav || vehicle.isLost || !now.isLive ||
        !status.isSending || status.now_s < aircraft.guideFrom_s ||
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
    aircraft.steering.setTargetSent(true);
    workspace().link().sendCommand(vehicle.address, *command);
}

void AircraftController::useWind()
{
    const std::optional<LinkAddress> chosen = panels().aircraft->chosen();
    const LinkVehicle* vehicle = chosen ? vehicleOf(*chosen) : nullptr;
    if (vehicle == nullptr || !vehicle->state.wind)
        return;
    const AircraftWind& wind = *vehicle->state.wind;
    const LocalFrame frame(workspace().document().scenario().origin);
    const std::optional<AircraftPosition>& position = vehicle->state.position;
    const double north_rad = position ? northAngle_rad(frame, frame.toPlane(position->place)) : 0.0;
    const Point mean_mps(wind.meanEast_mps, wind.meanNorth_mps);
    workspace().setWind(Eigen::Rotation2D<double>(-north_rad) * mean_mps);
}

} // namespace berg
