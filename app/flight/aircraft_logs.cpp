#include "app/dialogs/interaction.h"
#include "app/flight/aircraft_controller.h"
#include "app/flight/flight_view.h"
#include "app/layout/panels.h"
#include "core/link/logs/log_replay.h"
#include "widgets/map/paint/graticule.h"
#include "widgets/panels/aircraft/aircraft_panel.h"
#include "widgets/workspace/workspace.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QMainWindow>
#include <QSettings>
#include <QStandardPaths>

#include <Eigen/Geometry>

#include <cmath>

using namespace Qt::StringLiterals;

namespace berg {

namespace {

constexpr double kHour_s = 3600;
constexpr const char* kLogKey = "link/log";
constexpr const char* kLogFolderKey = "link/logFolder";

} // namespace

void AircraftController::connectShipsAndLogs()
{
    const AircraftPanel* panel = panels().aircraft;
    connect(panel, &AircraftPanel::assetShipEdited, this, [this](quint64 key) {
        m_assetShip = {.ship = key};
        workspace().stopAssetMotion();
        followAssetShip();
    });
    connect(panel, &AircraftPanel::homeShipEdited, this, [this](quint64 key) {
        m_homeShip = {.ship = key};
        workspace().stopHomeMotion();
        followHomeShip();
    });
    connect(panel, &AircraftPanel::iceReported, this, &AircraftController::reportIce);
    connect(panel, &AircraftPanel::logEdited, this, &AircraftController::setLog);
    connect(panel, &AircraftPanel::openLogRequested, this, &AircraftController::chooseLog);
    connect(panel, &AircraftPanel::replaySpeedEdited, &workspace().link(),
            &LinkMonitor::setReplaySpeed);
    setLog(settings().value(kLogKey, false).toBool());
}

QString AircraftController::logFolder() const
{
    const QString documents =
        QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation) + u"/Bergwatch"_s;
    return settings().value(kLogFolderKey, documents).toString();
}

void AircraftController::setLog(bool isOn)
{
    settings().setValue(kLogKey, isOn);
    workspace().link().setLogFolder(isOn ? logFolder() : QString());
    panels().aircraft->setLogChoice(isOn, QDir::toNativeSeparators(logFolder()));
}

void AircraftController::chooseLog()
{
    const QString path =
        interaction().openPath(&window(), tr("Telemetry logs (*.tlog *.nmea);;All files (*)"));
    if (!path.isEmpty())
        replay(path);
}

void AircraftController::replay(const QString& path)
{
    LinkMonitor& link = workspace().link();
    if (link.isListening() && !link.status().replay) {
        showMessage(tr("Stop listening before you play a log."), kLongMessage_ms);
        return;
    }
    auto opened = LogReplay::open(QFile::encodeName(path).toStdString());
    if (const auto* fault = std::get_if<LogFault>(&opened)) {
        const QString name = QFileInfo(path).fileName();
        interaction().showError(
            &window(),
            fault->kind == LogFault::Kind::NotALog
                ? tr("%1 is not a telemetry log, or its beginning is damaged.").arg(name)
                : tr("%1 cannot be read: %2").arg(name, QString::fromStdString(fault->reason)));
        return;
    }
    m_rehearsal.reset();
    m_aircraft.clear();
    m_assetShip.moved_s = m_homeShip.moved_s = -kHour_s; // the clock of the log begins anew
    link.replay({.log = std::get<std::unique_ptr<LogReplay>>(std::move(opened)),
                 .path = path.toStdString(),
                 .speed = panels().aircraft->replaySpeed()});
}

/** In the wind of the aircraft, else of the scenario; a home on a ship moves meanwhile. */
std::optional<double> AircraftController::wayHome_s(const LinkVehicle& vehicle,
                                                    const Aircraft& aircraft) const
{
    const Scenario& scenario = workspace().document().scenario();
    const LocalFrame frame(scenario.origin);
    const std::optional<int> uav = uavIndex(aircraft);
    const AircraftState& state = vehicle.state;
    if (!state.position || !vehicle.state.isFlying.value_or(true) || (!uav && !state.home))
        return std::nullopt;
    const Point place_m = frame.toPlane(state.position->place);
    const Point home_m =
        uav ? homes_m()[static_cast<std::size_t>(*uav)] : frame.toPlane(*state.home);
    const double airspeed_mps =
        uav ? scenario.uavs[static_cast<std::size_t>(*uav)].spec.airspeed_mps
            : state.airspeed_mps.value_or(0);
    Point wind_mps = workspace().wind_mps();
    if (const std::optional<AircraftWind>& wind = state.wind) {
        const Eigen::Rotation2D<double> toPlane(-northAngle_rad(frame, place_m));
        wind_mps = toPlane * Point(wind->meanEast_mps, wind->meanNorth_mps);
    }
    if (const std::optional<LinkShip> ship = shipOf(workspace().link().status(), m_homeShip.ship);
        ship && ship->course_rad) {
        const double psi_rad = poseAt(ship->place, *ship->course_rad).psi_rad;
        wind_mps -= ship->speed_mps * Point(std::cos(psi_rad), std::sin(psi_rad));
    }
    if (wind_mps.norm() >= airspeed_mps)
        return std::nullopt; // it may not get there at all
    return flightTime_s(home_m - place_m, airspeed_mps, wind_mps);
}

void AircraftController::watchBattery(const LinkVehicle& vehicle, Aircraft& aircraft)
{
    const std::optional<AircraftBattery>& battery = vehicle.state.battery;
    if (!battery)
        return;
    aircraft.battery.add(*battery);
    BatteryReadout readout{.battery = *battery,
                           .left_s = aircraft.battery.left_s(workspace().link().status().now_s),
                           .isComputed = aircraft.battery.isComputed(),
                           .wayHome_s = wayHome_s(vehicle, aircraft)};
    const FlightRecord& record = workspace().record();
    if (const std::optional<int> uav = uavIndex(aircraft); uav && record.inFlight()) {
        const auto k = static_cast<std::size_t>(*uav);
        const UavSpec& spec = record.scenario.uavs[k].spec;
        if (spec.endurance_s > 0)
            readout.endurance_s =
                std::max(0.0, usableEndurance_s(spec) - record.now.world.uavs[k].aloft_s);
    }
    aircraft.readout = readout;
}

} // namespace berg
