#pragma once

#include "core/sim/steering.h"
#include "widgets/aircraft/link_status.h"
#include "widgets/theme/theme.h"

#include <QWidget>

#include <map>
#include <optional>
#include <vector>

class QCheckBox;
class QComboBox;
class QLabel;
class QLineEdit;
class QPlainTextEdit;
class QPushButton;
class QTreeWidget;
class QVBoxLayout;

namespace berg {

class LogRows;
class IceRow;
class ShipRows;

/** State of one aircraft besides its telemetry. */
struct AircraftNotes
{
    std::string uav;     ///< id of the UAV that it flies as; empty for none
    QString onBoard;     ///< whether the mission on board is the plan
    bool isSame = false; ///< the mission found there last is the plan, also during an upload
    QString battery;     ///< battery, way home and endurance
    bool isBatteryShort = false;
    Steering steering;
};

/** State of the flight in the window as far as the aircraft are concerned. */
struct LiveFlightState
{
    bool isLive = false;       ///< it follows the aircraft
    bool isRehearsing = false; ///< simulated aircraft fly
    bool mayRehearse = true;   ///< they may start: no other link is open
    bool mayReport = false;    ///< a flight runs that sightings can be reported to
};

/**
 * The live link: its address, the choices to listen and to send, the aircraft heard with the age of
 * their last position, and events. Shows values and reports intents.
 */
class AircraftPanel : public QWidget
{
    Q_OBJECT

public:
    explicit AircraftPanel(QWidget* parent = nullptr);

    void setTheme(const Theme& theme);
    void setAddress(const QString& address);
    [[nodiscard]] QString address() const;
    /** Sets the UAVs of the scenario that an aircraft may fly as. */
    void setUavs(const std::vector<std::string>& ids);
    void showStatus(const LinkStatus& status, const std::map<LinkAddress, AircraftNotes>& notes);
    void showFlight(const LiveFlightState& state);
    /** Appends a line to the events. */
    void addEvent(const QString& time, const QString& text, bool isAlarm);
    /** Shows whether a telemetry log is to be written, and in which folder. */
    void setLogChoice(bool isOn, const QString& folder);
    /** Returns the speed chosen for replays, in seconds of the log in each second. */
    [[nodiscard]] double replaySpeed() const;
    /** Shows a problem with the address, until the next status. */
    void showFault(const QString& fault);

    /** Shows that neither asset nor home follows a ship. */
    void chooseNoShip();
    /** Copies choices and events from another panel, after the same status was shown. */
    void takeOver(const AircraftPanel& other);

    /** Returns the aircraft that is chosen in the list; nullopt if there is none. */
    [[nodiscard]] std::optional<LinkAddress> chosen() const;

signals:
    void listenEdited(bool isOn);
    void sendEdited(bool isOn);
    void rehearsalEdited(bool isOn);
    void flyLiveRequested();
    void uploadRequested();
    void compareRequested();
    void flyMissionRequested();
    void windRequested();
    void uavEdited(const std::string& id);
    void steeringEdited(berg::SteeringKind kind);
    /** Emitted with the key of the ship (`LinkShip`) that the asset follows; 0 for none. */
    void assetShipEdited(quint64 key);
    /** Emitted with the key of the ship that launch and home are on; 0 for none. */
    void homeShipEdited(quint64 key);
    /** Emitted with the id of the ice (`TrafficTarget`) that the crew reports as a sighting. */
    void iceReported(std::uint32_t id);
    void logEdited(bool isOn);
    void openLogRequested();
    void replaySpeedEdited(double speed);

private:
    void addConnection(QVBoxLayout& column);
    void addDetails(QVBoxLayout& column);
    void showList();
    void showDetails();
    [[nodiscard]] QString stateText() const;

    QLineEdit* m_address;
    QPushButton* m_listen;
    QCheckBox* m_send;
    QPushButton* m_rehearse;
    QLabel* m_state;
    QTreeWidget* m_list;
    QLabel* m_details;
    QComboBox* m_uav;
    QLabel* m_onBoard;
    QLabel* m_steeringState;
    QComboBox* m_steering;
    QPushButton* m_upload;
    QPushButton* m_compare;
    QPushButton* m_flyMission;
    QPushButton* m_wind;
    QPushButton* m_flyLive;
    LogRows* m_log;
    QLabel* m_battery;
    ShipRows* m_ships;
    IceRow* m_ice;
    QPlainTextEdit* m_events;
    LinkStatus m_status;
    std::map<LinkAddress, AircraftNotes> m_notes;
    Theme m_theme;
    LiveFlightState m_flight;
};

} // namespace berg
