#include "app/flight/aircraft_controller.h"

#include "app/flight/flight_view.h"
#include "app/layout/panels.h"
#include "core/base/angles.h"
#include "core/mission/sortie_outlook.h"
#include "widgets/aircraft/link_text.h"
#include "widgets/map/paint/graticule.h"
#include "widgets/map/view/map_view.h"
#include "widgets/panels/aircraft/aircraft_panel.h"
#include "widgets/theme/quantity_text.h"
#include "widgets/workspace/workspace.h"

#include <QCoreApplication>
#include <QLabel>
#include <QMainWindow>
#include <QSettings>
#include <QStatusBar>
#include <QTime>

#include <algorithm>
#include <cmath>
#include <utility>

using namespace Qt::StringLiterals;

namespace berg {

namespace {

constexpr const char* kAddressKey = "link/address";
constexpr const char* kListenHere = "udp:127.0.0.1:14550";

QString nowText()
{
    return QTime::currentTime().toString(u"HH:mm:ss"_s);
}

} // namespace

bool agreesAhead(const std::vector<std::string>& uploaded, const std::vector<std::string>& planned)
{
    constexpr std::ptrdiff_t kAhead = 3;
    if (planned.empty())
        return true;
    const auto first = std::ranges::find(uploaded, planned.front());
    const auto count = std::min(kAhead, static_cast<std::ptrdiff_t>(planned.size()));
    return uploaded.end() - first >= count &&
           std::equal(planned.begin(), planned.begin() + count, first);
}

AircraftController::AircraftController(WindowContext& context, FlightView& flightView)
    : WindowPart(context), m_flightView(flightView), m_mark(new QLabel)
{
    m_mark->setObjectName(u"linkMark"_s);
    m_mark->hide();
    window().statusBar()->addPermanentWidget(m_mark);
    panels().aircraft->setAddress(
        settings().value(kAddressKey, QLatin1String(kListenHere)).toString());
    connectPanel();
    connectShipsAndLogs();
    connect(&workspace().link(), &LinkMonitor::updated, this, &AircraftController::showStatus);
    connect(&workspace().runner(), &MissionRunner::missionsReady, this,
            [this](const std::shared_ptr<const std::vector<UavMission>>& missions) {
                acceptMissions(*missions);
            });
    connect(&workspace(), &Workspace::flightChanged, this, &AircraftController::flightChanged);
    connect(&workspace().document(), &ScenarioDocument::scenarioChanged, this,
            &AircraftController::showUavs);
    showUavs();
}

void AircraftController::takeOver(AircraftController& other)
{
    m_aircraft = std::move(other.m_aircraft);
    m_rehearsal = std::move(other.m_rehearsal);
    m_assetShip = other.m_assetShip;
    m_homeShip = other.m_homeShip;
    showStatus();
}

void AircraftController::connectPanel()
{
    const AircraftPanel* panel = panels().aircraft;
    connect(panel, &AircraftPanel::listenEdited, this, &AircraftController::listen);
    connect(panel, &AircraftPanel::sendEdited, &workspace().link(), &LinkMonitor::setSending);
    connect(panel, &AircraftPanel::rehearsalEdited, this, &AircraftController::rehearse);
    connect(panel, &AircraftPanel::flyLiveRequested, this, &AircraftController::flyLive);
    connect(panel, &AircraftPanel::uploadRequested, this,
            [this] { requestMission(Purpose::Upload); });
    connect(panel, &AircraftPanel::compareRequested, this,
            [this] { requestMission(Purpose::Compare); });
    connect(panel, &AircraftPanel::steeringEdited, this, &AircraftController::setSteering);
    connect(panel, &AircraftPanel::windRequested, this, &AircraftController::useWind);
    connect(panel, &AircraftPanel::uavEdited, this, [this](const std::string& id) {
        const std::optional<LinkAddress> chosen = panels().aircraft->chosen();
        if (!chosen)
            return;
        for (auto& [address, aircraft] : m_aircraft)
            if (aircraft.uav == id)
                aircraft.uav.clear(); // a UAV is one aircraft
        m_aircraft[*chosen].uav = id;
        showStatus();
    });
    connect(panel, &AircraftPanel::flyMissionRequested, this, [this] {
        const std::optional<LinkAddress> chosen = panels().aircraft->chosen();
        const LinkVehicle* vehicle = chosen ? vehicleOf(*chosen) : nullptr;
        if (vehicle != nullptr)
            workspace().link().sendCommand(
                *chosen, modeCommand(vehicle->autopilot,
                                     steeringMode(SteeringKind::Mission, vehicle->autopilot)));
    });
}

void AircraftController::listen(bool isOn)
{
    LinkMonitor& link = workspace().link();
    if (!isOn) {
        link.stop();
        m_aircraft.clear();
        return;
    }
    const QString address = panels().aircraft->address();
    const auto endpoint = readEndpoint(address.toStdString());
    if (const auto* fault = std::get_if<EndpointFault>(&endpoint)) {
        showPanel();
        const std::string_view words = englishWords(*fault);
        panels().aircraft->showFault(
            QCoreApplication::translate("IssueText", std::string(words).c_str()).arg(address));
        return;
    }
    settings().setValue(kAddressKey, address);
    link.listen([to = std::get<LinkEndpoint>(endpoint)] { return openLink(to); });
}

void AircraftController::rehearse(bool isOn)
{
    if (!isOn) {
        m_rehearsal.reset();
        showPanel();
        return;
    }
    if (!workspace().link().isListening()) {
        if (const auto typed = readEndpoint(panels().aircraft->address().toStdString());
            !std::holds_alternative<LinkEndpoint>(typed) ||
            std::get<LinkEndpoint>(typed).kind != LinkEndpoint::Kind::UdpListen)
            panels().aircraft->setAddress(QLatin1String(kListenHere));
        listen(true);
    }
    const auto endpoint = readEndpoint(panels().aircraft->address().toStdString());
    const Scenario& scenario = workspace().document().scenario();
    const LocalFrame frame(scenario.origin);
    std::vector<RehearsalOptions> fleet;
    for (const Uav& uav : scenario.uavs) {
        const bool isPx4 = uav.aircraft.firmware == AutopilotFirmware::Px4;
        RehearsalOptions& options = fleet.emplace_back();
        options.side.self.system = static_cast<std::uint8_t>(fleet.size());
        options.side.autopilot = isPx4 ? AutopilotKind::Px4 : AutopilotKind::ArduPilot;
        options.uav = uav.spec;
        options.home = frame.toGeographic(uav.home_m.value_or(uav.position_m));
        options.wind_mps = scenario.wind_mps;
        options.start = frame.toGeographic(uav.position_m);
        options.heading_deg = uav.heading_deg - degFromRad(northAngle_rad(frame, uav.position_m));
    }
    m_rehearsal =
        std::make_unique<RehearsalFleet>(std::move(fleet), std::get<LinkEndpoint>(endpoint).port);
    showPanel();
}

const LinkVehicle* AircraftController::vehicleOf(LinkAddress address) const
{
    const std::vector<LinkVehicle>& vehicles = workspace().link().status().vehicles;
    const auto found = std::ranges::find(vehicles, address, &LinkVehicle::address);
    return found == vehicles.end() ? nullptr : &*found;
}

std::optional<int> AircraftController::uavIndex(const Aircraft& aircraft) const
{
    return indexOfId(workspace().document().scenario().uavs, aircraft.uav);
}

DubinsState AircraftController::poseAt(const LatLon& place, double heading_rad) const
{
    const LocalFrame frame(workspace().document().scenario().origin);
    const Point position_m = frame.toPlane(place);
    return {.position_m = position_m,
            .psi_rad = wrapPi(kPi / 2 - heading_rad - northAngle_rad(frame, position_m))};
}

/** Without a heading the course over ground is used. */
std::optional<DubinsState> AircraftController::poseOf(const LinkVehicle& vehicle) const
{
    const std::optional<AircraftPosition>& position = vehicle.state.position;
    if (!position)
        return std::nullopt;
    const double course_rad = std::atan2(position->east_mps, position->north_mps);
    return poseAt(position->place, vehicle.state.attitude
                                       ? vehicle.state.attitude->heading_rad
                                       : position->heading_rad.value_or(course_rad));
}

void AircraftController::flyLive()
{
    const Scenario& scenario = workspace().document().scenario();
    std::vector<std::optional<DubinsState>> starts(scenario.uavs.size());
    for (auto& [address, aircraft] : m_aircraft) {
        aircraft.lastPose_s = 0;
        const LinkVehicle* vehicle = vehicleOf(address);
        if (const std::optional<int> uav = uavIndex(aircraft); uav && vehicle != nullptr)
            starts[static_cast<std::size_t>(*uav)] = poseOf(*vehicle);
    }
    workspace().flyLive(starts);
}

void AircraftController::showStatus()
{
    if (workspace().link().isListening()) {
        matchAircraft();
        reportEvents();
        passPoses();
        for (auto& [address, aircraft] : m_aircraft)
            if (const LinkVehicle* vehicle = vehicleOf(address)) {
                aircraft.steering.setMode(vehicle->mode);
                watchMission(*vehicle, aircraft);
                recheckMission(*vehicle, aircraft);
                watchBattery(*vehicle, aircraft);
                guide(*vehicle, aircraft);
            }
    }
    followAssetShip();
    followHomeShip();
    showOnMap();
    showPanel();
}

/** A new aircraft flies as the first UAV that is still free; a tracker may be on a ship. */
void AircraftController::matchAircraft()
{
    const std::vector<Uav>& uavs = workspace().document().scenario().uavs;
    bool isNew = false;
    for (const LinkVehicle& vehicle : workspace().link().status().vehicles) {
        if (m_aircraft.contains(vehicle.address))
            continue;
        isNew = true;
        if (isTracker(vehicle.address)) {
            m_aircraft[vehicle.address].uav.clear();
            continue;
        }
        const auto free = std::ranges::find_if(uavs, [this](const Uav& uav) {
            return std::ranges::none_of(
                m_aircraft, [&](const auto& entry) { return entry.second.uav == uav.id; });
        });
        m_aircraft[vehicle.address].uav = free == uavs.end() ? std::string() : free->id;
    }
    if (isNew)
        showUavs();
}

void AircraftController::reportEvents()
{
    for (const TimedLinkEvent& timed : workspace().link().status().events) {
        const LinkEvent& event = timed.event;
        const QString text = linkEventText(event, vehicleOf(event.vehicle));
        const bool isAlarm = isAlarming(event);
        if (!text.isEmpty())
            panels().aircraft->addEvent(nowText(), text, isAlarm);
        if (isAlarm && event.kind != LinkEvent::Kind::VehicleLost) { // that is a notice, too
            announce(text);
            showMessage(text, kLongMessage_ms);
        }
        if (event.kind == LinkEvent::Kind::SyncEnded)
            endSync(event.vehicle);
    }
}

void AircraftController::endSync(LinkAddress address)
{
    const LinkVehicle* vehicle = vehicleOf(address);
    const auto found = m_aircraft.find(address);
    if (vehicle == nullptr || found == m_aircraft.end() || !vehicle->sync || !found->second.upload)
        return;
    Aircraft& aircraft = found->second;
    if (vehicle->sync->isRecheck) {
        aircraft.upload->isChangedOnBoard =
            aircraft.upload->isChangedOnBoard || vehicle->sync->phase == SyncPhase::Different;
        return;
    }
    if (vehicle->sync->phase != SyncPhase::Equal) {
        aircraft.upload.reset(); // what is on board is not a plan of ours
        return;
    }
    aircraft.upload->time = QTime::currentTime().toString(u"HH:mm"_s);
    aircraft.upload->found_s = workspace().link().status().now_s;
    // ArduPilot flies on to the old item, also after an upload; PX4 begins with the first.
    if (aircraft.steering.state() == SteeringState::Active &&
        aircraft.steering.kind() == SteeringKind::Mission &&
        vehicle->autopilot == AutopilotKind::ArduPilot)
        workspace().link().sendCommand(address, itemCommand(vehicle->autopilot, 0));
}

void AircraftController::passPoses()
{
    const LinkStatus& status = workspace().link().status();
    if (!workspace().record().now.isLive)
        return;
    std::vector<LivePose> poses;
    for (auto& [address, aircraft] : m_aircraft) {
        const LinkVehicle* vehicle = vehicleOf(address);
        const std::optional<int> uav = uavIndex(aircraft);
        if (vehicle == nullptr || !uav || !vehicle->state.position)
            continue;
        const auto ghost = std::ranges::find(status.ghosts, address, &GhostReport::address);
        const bool isGhost = ghost != status.ghosts.end();
        const double clock_s = isGhost ? status.now_s : vehicle->state.position->received_s;
        if (clock_s <= aircraft.lastPose_s)
            continue;
        aircraft.lastPose_s = clock_s;
        poses.push_back({.uav = *uav,
                         .clock_s = clock_s,
                         .pose = isGhost
                                     ? poseAt(ghost->readings.place, ghost->readings.heading_rad)
                                     : *poseOf(*vehicle),
                         .isMeasured = !isGhost});
    }
    if (!poses.empty())
        workspace().runner().addPoses(poses);
}

void AircraftController::showOnMap()
{
    const LinkStatus& status = workspace().link().status();
    const LocalFrame frame(workspace().document().scenario().origin);
    const bool isLive = workspace().record().now.isLive;
    MapLive live;
    for (const LinkVehicle& vehicle : status.vehicles) {
        const std::optional<DubinsState> pose = poseOf(vehicle);
        const auto found = m_aircraft.find(vehicle.address);
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
        for (const LatLon& place : workspace().link().trackOf(vehicle.address))
            shown.track_m.push_back(frame.toPlane(place));
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
             .isShip = target.kind == TrafficTarget::Kind::Ship});
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

void AircraftController::showPanel()
{
    std::map<LinkAddress, AircraftNotes> notes;
    for (const auto& [address, aircraft] : m_aircraft)
        if (const LinkVehicle* vehicle = vehicleOf(address)) {
            const std::optional<Upload>& upload = aircraft.upload;
            notes[address] = {.uav = aircraft.uav,
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
    panels().aircraft->showFlight(workspace().record().now.isLive, m_rehearsal != nullptr);
    const LinkStatus& status = workspace().link().status();
    m_mark->setText(status.replay      ? tr("Link: replay")
                    : status.isSending ? tr("Link: sending")
                                       : tr("Link: listening"));
    m_mark->setVisible(status.isListening);
    showNotices();
}

void AircraftController::showNotices()
{
    std::vector<FlightNotice> notices;
    for (const auto& [address, aircraft] : m_aircraft) {
        const LinkVehicle* vehicle = vehicleOf(address);
        if (vehicle == nullptr)
            continue;
        const auto add = [&notices, &uav = aircraft.uav](NoticeKind kind, const QString& text) {
            notices.push_back({.kind = kind, .about = {uav}, .text = text});
        };
        const auto named = [name = aircraftName(address)](const QString& text) {
            return u"%1: %2"_s.arg(name, text);
        };
        if (vehicle->isLost)
            add(NoticeKind::ContactLost,
                linkEventText({.kind = LinkEvent::Kind::VehicleLost, .vehicle = address}, vehicle));
        if (aircraft.steering.state() == SteeringState::PilotTookOver)
            add(NoticeKind::Aircraft, named(steeringText(aircraft.steering)));
        if (aircraft.upload && (aircraft.upload->isPlanChanged ||
                                aircraft.upload->isChangedOnBoard || aircraft.upload->isHomeMoved))
            add(NoticeKind::Aircraft, named(onBoardText(aircraft, *vehicle)));
        if (aircraft.readout && isBatteryShort(*aircraft.readout))
            add(NoticeKind::Battery, named(batteryWarning(*aircraft.readout)));
    }
    m_flightView.setAircraftNotices(notices);
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
    if (!workspace().link().isListening())
        return;
    const LocalFrame frame(scenario.origin);
    std::map<LinkAddress, AircraftData> data;
    for (const auto& [address, aircraft] : m_aircraft) {
        AircraftData& one = data[address];
        one.wind_mps = scenario.wind_mps;
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
