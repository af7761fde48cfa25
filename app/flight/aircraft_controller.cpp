#include "app/flight/aircraft_controller.h"

#include "app/flight/flight_view.h"
#include "app/layout/panels.h"
#include "core/base/angles.h"
#include "widgets/aircraft/link_text.h"
#include "widgets/map/paint/graticule.h"
#include "widgets/panels/aircraft/aircraft_panel.h"
#include "widgets/workspace/workspace.h"

#include <QCoreApplication>
#include <QLabel>
#include <QMainWindow>
#include <QSettings>
#include <QStatusBar>
#include <QTime>

#include <Eigen/Geometry>

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
        return uploaded.empty();
    const auto first = std::ranges::find(uploaded, planned.front());
    const auto count = std::min(kAhead, std::ssize(planned));
    const std::ptrdiff_t left = uploaded.end() - first;
    return (std::ssize(planned) < kAhead ? left == count : left >= count) &&
           std::equal(planned.begin(), planned.begin() + count, first);
}

AircraftController::AircraftController(WindowContext& context, FlightView& flightView)
    : WindowPart(context), m_flightView(flightView), m_mark(new QLabel)
{
    m_mark->setObjectName(u"linkMark"_s);
    window().statusBar()->addPermanentWidget(m_mark);
    panels().aircraft->setAddress(
        settings().value(kAddressKey, QLatin1String(kListenHere)).toString());
    connectPanel();
    connectShipsAndLogs();
    connect(&workspace().link(), &LinkMonitor::updated, this, &AircraftController::receiveStatus);
    connect(&workspace().runner(), &MissionRunner::missionsReady, this,
            [this](const std::shared_ptr<const std::vector<UavMission>>& missions) {
                acceptMissions(*missions);
            });
    connect(&workspace().runner(), &MissionRunner::begun, this, &AircraftController::endRequests);
    connect(&workspace(), &Workspace::flightChanged, this, &AircraftController::flightChanged);
    connect(&workspace().document(), &ScenarioDocument::replaced, this,
            &AircraftController::scenarioReplaced);
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
    m_isRehearsalLink = other.m_isRehearsalLink;
    showUavs();
    showStatus();
    panels().aircraft->takeOver(*other.panels().aircraft);
}

/** The ship belonged to the former scenario. */
void AircraftController::scenarioReplaced()
{
    m_assetShip = {};
    m_homeShip = {};
    panels().aircraft->chooseNoShip();
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
        showUavs();
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
    m_isRehearsalLink = false;
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
    const auto& to = std::get<LinkEndpoint>(endpoint);
    if (to.kind == LinkEndpoint::Kind::UdpListen && !isLocal(to)) {
        const QString warning = tr("%1 can be reached from the network, and MAVLink does not "
                                   "check who sends.")
                                    .arg(address);
        panels().aircraft->addEvent(nowText(), warning, true);
        showMessage(warning, kLongMessage_ms);
    }
    link.listen([to] { return openLink(to); });
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
        m_isRehearsalLink = true;
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
        options.wind_mps =
            Eigen::Rotation2D<double>(northAngle_rad(frame, uav.position_m)) * scenario.wind_mps;
        options.loiterRadius_m = uav.aircraft.loiterRadius_m.value_or(0);
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

/** Events are new once; the state may be shown again. */
void AircraftController::receiveStatus()
{
    if (workspace().link().isListening()) {
        matchAircraft();
        reportEvents();
    } else {
        m_aircraft.clear(); // nothing goes on by itself when the link is opened again
    }
    showStatus();
}

void AircraftController::showStatus()
{
    if (workspace().link().isListening()) {
        matchAircraft();
        passPoses();
        for (auto& [address, aircraft] : m_aircraft)
            if (const LinkVehicle* vehicle = vehicleOf(address)) {
                endUnsent(address, aircraft, *vehicle);
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

/**
 * A new aircraft flies as the UAV at the place of its id, from 1, in the scenario, or if that one
 * has an aircraft, as the first UAV that is still free; a tracker may be on a ship.
 */
void AircraftController::matchAircraft()
{
    const std::vector<Uav>& uavs = workspace().document().scenario().uavs;
    const auto isFree = [this](const Uav& uav) {
        return std::ranges::none_of(m_aircraft,
                                    [&](const auto& entry) { return entry.second.uav == uav.id; });
    };
    bool isNew = false;
    for (const LinkVehicle& vehicle : workspace().link().status().vehicles) {
        if (m_aircraft.contains(vehicle.address))
            continue;
        isNew = true;
        if (isTracker(vehicle.address)) {
            m_aircraft[vehicle.address].uav.clear();
            continue;
        }
        const std::size_t place = vehicle.address.system - std::size_t{1};
        const auto free = place < uavs.size() && isFree(uavs[place])
                              ? uavs.begin() + static_cast<std::ptrdiff_t>(place)
                              : std::ranges::find_if(uavs, isFree);
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
        if (isAlarm && event.kind != LinkEvent::Kind::VehicleLost) // that is a notice, too
            showMessage(text, kLongMessage_ms);
        retryGuidance(event);
        if (event.kind == LinkEvent::Kind::SyncEnded)
            endSync(event.vehicle);
    }
}

void AircraftController::endSync(LinkAddress address)
{
    const LinkVehicle* vehicle = vehicleOf(address);
    const auto found = m_aircraft.find(address);
    if (vehicle == nullptr || found == m_aircraft.end() || !vehicle->sync)
        return;
    Aircraft& aircraft = found->second;
    const bool isDifferent = vehicle->sync->phase == SyncPhase::Different;
    if (vehicle->sync->isRecheck) {
        if (aircraft.upload)
            aircraft.upload->isChangedOnBoard = aircraft.upload->isChangedOnBoard || isDifferent;
        return;
    }
    std::optional<Transfer> ended = std::exchange(aircraft.transfer, std::nullopt);
    if (!ended)
        return;
    if (vehicle->sync->phase != SyncPhase::Equal) {
        if (ended->isUpload)
            loseUpload(address, aircraft);
        else if (isDifferent && aircraft.upload &&
                 isSameMission(aircraft.upload->parts, ended->upload.parts))
            aircraft.upload->isChangedOnBoard = true;
        return;
    }
    aircraft.upload = std::move(ended->upload);
    if (aircraft.upload->time.isEmpty())
        aircraft.upload->time = QTime::currentTime().toString(u"HH:mm"_s);
    aircraft.upload->found_s = workspace().link().status().now_s;
    // ArduPilot flies on to the old item, also after an upload; PX4 begins with the first.
    if (ended->isUpload && aircraft.steering.state() == SteeringState::Active &&
        aircraft.steering.kind() == SteeringKind::Mission &&
        vehicle->autopilot == AutopilotKind::ArduPilot)
        workspace().link().sendCommand(address, itemCommand(vehicle->autopilot, 0));
}

/** A point that did not arrive is sent again after a pause; contact that returns needs none. */
void AircraftController::retryGuidance(const LinkEvent& event)
{
    constexpr double kRetry_s = 5;
    const auto found = m_aircraft.find(event.vehicle);
    if (found == m_aircraft.end())
        return;
    const bool hasFailed = event.kind == LinkEvent::Kind::CommandEnded && event.command &&
                           event.command->command.command == LinkCommandId::kReposition &&
                           event.command->result != 0;
    if (!hasFailed && event.kind != LinkEvent::Kind::VehicleReturned)
        return;
    found->second.guidedTo.reset();
    if (!hasFailed)
        return;
    found->second.guideFrom_s = workspace().link().status().now_s + kRetry_s;
    found->second.steering.setTargetSent(false);
}

void AircraftController::report(LinkAddress address, const QString& text)
{
    const QString named = u"%1: %2"_s.arg(aircraftName(address), text);
    panels().aircraft->addEvent(nowText(), named, true);
    showMessage(named, kLongMessage_ms);
}

/** The mission on board is unknown: without a mission of ours nothing is steered. */
void AircraftController::loseUpload(LinkAddress address, Aircraft& aircraft)
{
    aircraft.upload.reset();
    if (aircraft.steering.kind() != SteeringKind::Mission)
        return;
    aircraft.steering = {};
    report(address, tr("the mission was not replaced. Steering is off"));
}

/** Nothing goes on by itself after sending was off, and no transfer is waited for then. */
void AircraftController::endUnsent(LinkAddress address, Aircraft& aircraft,
                                   const LinkVehicle& vehicle)
{
    constexpr double kStarted_s = 2; // by then the link shows the transfer
    const LinkStatus& status = workspace().link().status();
    if (aircraft.transfer && !isSyncRunning(vehicle) &&
        (!status.isSending || status.now_s > aircraft.transfer->since_s + kStarted_s)) {
        const bool wasUpload = aircraft.transfer->isUpload;
        aircraft.transfer.reset();
        if (wasUpload)
            loseUpload(address, aircraft);
    }
    if (status.isSending || aircraft.steering.kind() == SteeringKind::None)
        return;
    aircraft.steering = {};
    report(address, tr("steering is off, because sending is"));
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

} // namespace berg
