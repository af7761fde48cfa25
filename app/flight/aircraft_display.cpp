#include "app/flight/aircraft_controller.h"
#include "app/flight/flight_view.h"
#include "app/layout/panels.h"
#include "core/mission/sortie_outlook.h"
#include "widgets/aircraft/link_text.h"
#include "widgets/map/paint/graticule.h"
#include "widgets/map/view/map_view.h"
#include "widgets/panels/aircraft/aircraft_panel.h"
#include "widgets/theme/quantity_text.h"
#include "widgets/workspace/workspace.h"

#include <QLabel>

#include <Eigen/Geometry>

#include <algorithm>
#include <utility>

using namespace Qt::StringLiterals;

namespace berg {

void AircraftController::showOnMap()
{
    const LinkStatus& status = workspace().link().status();
    const LocalFrame frame(workspace().document().scenario().origin);
    const bool isLive = workspace().record().now.isLive;
    MapLive live;
    for (const LinkVehicle& vehicle : status.vehicles) {
        const std::optional<DubinsState> pose = poseOf(vehicle);
        auto found = m_aircraft.find(vehicle.address);
        if (!pose || found == m_aircraft.end())
            continue;
        const std::optional<int> uav = uavIndex(found->second);
        const double age_s = status.now_s - vehicle.state.position->received_s;
        if (isTracker(vehicle.address) && !uav)
            continue; // shown as a ship below
        MapAircraft& shown = live.aircraft.emplace_back(
            MapAircraft{.position_m = pose->position_m,
                        .psi_rad = pose->psi_rad,
                        .label = u"%1, %2"_s.arg(aircraftName(vehicle.address),
                                                 positionAgeText(age_s, locale())),
                        .place = uav.value_or(0),
                        .isFlown = isLive && uav.has_value()});
        extendTrack(vehicle.address, found->second);
        shown.track_m = found->second.track_m;
        const auto ghost = std::ranges::find(status.ghosts, vehicle.address, &GhostReport::address);
        if (ghost == status.ghosts.end())
            continue;
        const DubinsState predicted = poseAt(ghost->readings.place, ghost->readings.heading_rad);
        shown.position_m = predicted.position_m;
        shown.psi_rad = predicted.psi_rad;
        shown.isGhost = true;
        shown.label = tr("%1: no contact for %2")
                          .arg(aircraftName(vehicle.address), clockText(ghost->silentFor_s));
        if (ghost->expected && ghost->expected->at_s > status.now_s) {
            shown.contact_m = frame.toPlane(ghost->expected->place);
            shown.contactLabel =
                tr("contact in %1").arg(clockText(ghost->expected->at_s - status.now_s));
        }
    }
    for (const TrafficTarget& target : status.traffic)
        live.traffic.push_back(
            {.position_m = frame.toPlane(target.place),
             .psi_rad = target.course_rad
                            ? std::optional(poseAt(target.place, *target.course_rad).psi_rad)
                            : std::nullopt,
             .label = trafficName(target),
             .isShip = target.kind == TrafficTarget::Kind::Ship,
             .isIce = target.kind == TrafficTarget::Kind::Ice});
    for (const auto& [address, aircraft] : m_aircraft) {
        const std::optional<LinkShip> ship = shipOf(status, shipKey(address));
        if (!ship || uavIndex(aircraft))
            continue;
        live.traffic.push_back(
            {.position_m = frame.toPlane(ship->place),
             .psi_rad = ship->course_rad
                            ? std::optional(poseAt(ship->place, *ship->course_rad).psi_rad)
                            : std::nullopt,
             .label = u"%1, %2"_s.arg(ship->name,
                                      positionAgeText(status.now_s - ship->received_s, locale())),
             .isShip = true});
    }
    panels().map->setLive(std::move(live));
}

/** Only new places are projected, unless the track was thinned or the plane has changed. */
void AircraftController::extendTrack(LinkAddress address, Aircraft& aircraft) const
{
    const LatLon& origin = workspace().document().scenario().origin;
    const std::vector<LatLon>& track = workspace().link().trackOf(address);
    if (track.size() < aircraft.track_m.size() || !(origin == aircraft.trackOrigin))
        aircraft.track_m.clear();
    aircraft.trackOrigin = origin;
    const LocalFrame frame(origin);
    for (std::size_t i = aircraft.track_m.size(); i < track.size(); ++i)
        aircraft.track_m.push_back(frame.toPlane(track[i]));
}

void AircraftController::showPanel()
{
    std::map<LinkAddress, AircraftNotes> notes;
    for (const auto& [address, aircraft] : m_aircraft)
        if (const LinkVehicle* vehicle = vehicleOf(address)) {
            const std::optional<Upload>& upload = aircraft.upload;
            notes[address] = {.uav = uavIndex(aircraft) ? aircraft.uav : std::string(),
                              .onBoard = onBoardText(aircraft, *vehicle),
                              .isSame = upload && !upload->isChangedOnBoard &&
                                        !upload->isPlanChanged && !upload->isHomeMoved,
                              .steering = aircraft.steering};
            if (const std::optional<BatteryReadout>& readout = aircraft.readout) {
                notes[address].battery = tr("Battery: %1").arg(batteryText(*readout, locale()));
                notes[address].isBatteryShort = isBatteryShort(*readout);
            }
        }
    panels().aircraft->showStatus(workspace().link().status(), notes);
    const LinkStatus& status = workspace().link().status();
    panels().aircraft->showFlight(
        {.isLive = workspace().record().now.isLive,
         .isRehearsing = m_rehearsal != nullptr,
         .mayRehearse = m_rehearsal != nullptr || m_isRehearsalLink || !status.isListening,
         .mayReport = workspace().inFlight()});
    // Never hidden: a label that appears would lay out the whole window at once.
    m_mark->setText(!status.isListening ? QString()
                    : status.replay     ? tr("Link: replay")
                    : status.isSending  ? tr("Link: sending")
                                        : tr("Link: listening"));
    showNotices();
}

void AircraftController::showNotices()
{
    std::vector<FlightNotice> notices;
    for (const auto& [address, aircraft] : m_aircraft) {
        const LinkVehicle* vehicle = vehicleOf(address);
        if (vehicle == nullptr)
            continue;
        const std::vector<std::string> about =
            uavIndex(aircraft) ? std::vector{aircraft.uav} : std::vector<std::string>();
        const std::string subject =
            std::to_string(address.system) + '.' + std::to_string(address.component);
        const auto add = [&](NoticeKind kind, const QString& text) {
            notices.push_back({.kind = kind, .about = about, .text = text, .subject = subject});
        };
        const auto named = [name = aircraftName(address)](const QString& text) {
            return u"%1: %2"_s.arg(name, text);
        };
        if (vehicle->isLost)
            add(NoticeKind::ContactLost,
                linkEventText({.kind = LinkEvent::Kind::VehicleLost, .vehicle = address}, vehicle));
        if (aircraft.steering.state() == SteeringState::PilotTookOver)
            add(NoticeKind::PilotTookOver, named(steeringText(aircraft.steering, true)));
        if (aircraft.upload && (aircraft.upload->isPlanChanged ||
                                aircraft.upload->isChangedOnBoard || aircraft.upload->isHomeMoved))
            add(NoticeKind::OnBoard, named(onBoardText(aircraft, *vehicle)));
        if (aircraft.readout && isBatteryShort(*aircraft.readout))
            add(NoticeKind::Battery, named(batteryWarning(*aircraft.readout)));
    }
    m_flightView.setAircraftNotices(notices);
}

Point AircraftController::windInForce_mps() const
{
    const std::vector<Motion>& motions = workspace().record().now.motions;
    return workspace().inFlight() && !motions.empty() ? motions.front().wind_mps
                                                      : workspace().document().scenario().wind_mps;
}

/** The UAVs offered and what is known of them, after an edit. */
void AircraftController::showUavs()
{
    const Scenario& scenario = workspace().document().scenario();
    std::vector<std::string> ids;
    for (const Uav& uav : scenario.uavs)
        ids.push_back(uav.id);
    if (ids != m_uavIds)
        panels().aircraft->setUavs(ids);
    m_uavIds = std::move(ids);
    if (!workspace().link().isListening() || m_aircraft.empty())
        return;
    m_dataWind_mps = windInForce_mps();
    const LocalFrame frame(scenario.origin);
    std::map<LinkAddress, AircraftData> data;
    for (const auto& [address, aircraft] : m_aircraft) {
        AircraftData& one = data[address];
        const LinkVehicle* vehicle = vehicleOf(address);
        const Point place_m = vehicle != nullptr && vehicle->state.position
                                  ? frame.toPlane(vehicle->state.position->place)
                                  : Point(Point::Zero());
        one.wind_mps = Eigen::Rotation2D<double>(northAngle_rad(frame, place_m)) * m_dataWind_mps;
        if (const std::optional<int> uav = uavIndex(aircraft))
            one.uav = scenario.uavs[static_cast<std::size_t>(*uav)].spec;
        if (const std::optional<GroundStation>& station = scenario.groundStation) {
            one.station = frame.toGeographic(station->position_m);
            one.range_m = linkRange_m(*station, one.uav.altitude_m);
        }
    }
    workspace().link().setData(data);
}

} // namespace berg
