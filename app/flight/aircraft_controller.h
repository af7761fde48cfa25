#pragma once

#include "app/layout/window_part.h"
#include "core/base/index.h"
#include "core/link/battery_trend.h"
#include "core/sim/steering.h"
#include "widgets/aircraft/battery_text.h"
#include "widgets/aircraft/link_ships.h"
#include "widgets/aircraft/link_status.h"
#include "widgets/aircraft/rehearsal_fleet.h"
#include "widgets/flight/mission_runner.h"
#include "widgets/map/picture/map_live.h"

#include <QString>

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

class QLabel;

namespace berg {

class FlightView;
struct AircraftNotes;

/**
 * Real aircraft in the window: the live link in its panel and on the map, flights that follow the
 * aircraft, uploads of the plan, and rehearsals with simulated aircraft.
 */
class AircraftController : public WindowPart
{
    Q_OBJECT

public:
    AircraftController(WindowContext& context, FlightView& flightView);

    /** Takes over what another window of the same workspace has begun. */
    void takeOver(AircraftController& other);

    /** Plays a telemetry log in place of the link; shows why if it is none. */
    void replay(const QString& path);

private:
    /** A plan that was found on board of an aircraft. */
    struct Upload
    {
        std::vector<MissionPart> parts;
        std::vector<std::string> order;
        QString time;             ///< when it was found on board
        double found_s = 0;       ///< the same on the clock of the link
        std::optional<int> total; ///< number of items that the aircraft reports since
        std::optional<std::uint32_t> missionId;
        bool isChangedOnBoard = false; ///< the aircraft reports another mission since
        bool isPlanChanged = false;
        Point home_m = Point::Zero(); ///< where it returns to
        bool isHomeMoved = false;     ///< home has left that place since
    };
    /** Reason for which the plans were requested as uploads. */
    enum class Purpose
    {
        None,
        Upload,
        Replace, ///< an upload, if the aircraft is still being steered
        Compare,
        Check ///< whether the uploads still equal the plans
    };
    /** An upload or comparison that has not ended. */
    struct Transfer
    {
        Upload upload;
        bool isUpload = false;
        double since_s = 0; ///< clock of the link
    };
    /** Everything that belongs to one aircraft. */
    struct Aircraft
    {
        std::string uav; ///< id of the UAV that it flies as; empty for none
        std::optional<Upload> upload;
        std::optional<Transfer> transfer;
        Steering steering;
        std::optional<IcebergIndex> guidedTo; ///< iceberg of the last guided point
        Point guidedTo_m = Point::Zero();
        double guideFrom_s = 0; ///< clock of the link: no point is sent before
        double lastPose_s = 0;  ///< of the last pose passed on
        Purpose purpose = Purpose::None;
        double nextRecheck_s = 0; ///< clock of the link
        int rechecks = 0;
        BatteryTrend battery;
        std::optional<BatteryReadout> readout;
        std::vector<Point> track_m; ///< in the plane of `trackOrigin`
        LatLon trackOrigin;
    };
    /** A ship that something in the scenario follows. */
    struct Followed
    {
        quint64 ship = 0;   ///< key; 0 for none
        double moved_s = 0; ///< clock of the link at its last move
    };

    void connectPanel();
    void connectShipsAndLogs();
    void listen(bool isOn);
    void rehearse(bool isOn);
    void flyLive();
    void receiveStatus();
    void showStatus();
    void matchAircraft();
    void reportEvents();
    void report(LinkAddress address, const QString& text);
    void endSync(LinkAddress address);
    void endUnsent(LinkAddress address, Aircraft& aircraft, const LinkVehicle& vehicle);
    void loseUpload(LinkAddress address, Aircraft& aircraft);
    void retryGuidance(const LinkEvent& event);
    void endRequests();
    void passPoses();
    void showOnMap();
    void showPanel();
    void showNotices();
    void showUavs();
    void scenarioReplaced();
    void extendTrack(LinkAddress address, Aircraft& aircraft) const;
    void flightChanged();
    void watchMission(const LinkVehicle& vehicle, Aircraft& aircraft);
    void replaceMission(LinkAddress address, Aircraft& aircraft);
    void guide(const LinkVehicle& vehicle, Aircraft& aircraft);
    void requestMission(Purpose purpose);
    void acceptMissions(const std::vector<UavMission>& missions);
    void startTransfer(LinkAddress address, Aircraft& aircraft, const Transfer& transfer);
    void setSteering(SteeringKind kind);
    void useWind();
    void recheckMission(const LinkVehicle& vehicle, Aircraft& aircraft);
    void followAssetShip();
    void followHomeShip();
    void reportIce(std::uint32_t id);
    [[nodiscard]] std::vector<Point> homes_m() const;
    void watchBattery(const LinkVehicle& vehicle, Aircraft& aircraft);
    [[nodiscard]] std::optional<double> wayHome_s(const LinkVehicle& vehicle,
                                                  const Aircraft& aircraft) const;
    void setLog(bool isOn);
    [[nodiscard]] QString logFolder() const;
    void chooseLog();
    [[nodiscard]] const LinkVehicle* vehicleOf(LinkAddress address) const;
    [[nodiscard]] std::optional<int> uavIndex(const Aircraft& aircraft) const;
    [[nodiscard]] QString onBoardText(const Aircraft& aircraft, const LinkVehicle& vehicle) const;
    [[nodiscard]] std::optional<DubinsState> poseOf(const LinkVehicle& vehicle) const;
    [[nodiscard]] DubinsState poseAt(const LatLon& place, double heading_rad) const;
    [[nodiscard]] Point windInForce_mps() const;

    FlightView& m_flightView;
    QLabel* m_mark; ///< in the status bar, as long as the link is on
    std::map<LinkAddress, Aircraft> m_aircraft;
    std::unique_ptr<RehearsalFleet> m_rehearsal;
    Followed m_assetShip;
    Followed m_homeShip;
    std::vector<std::string> m_uavIds;    ///< as the panel offers them
    Point m_dataWind_mps = Point::Zero(); ///< as the link predicts with
    bool m_isRehearsalLink = false;       ///< the link was opened for a rehearsal
};

/** Returns whether all lists of two missions are equal. */
[[nodiscard]] bool isSameMission(const std::vector<MissionPart>& a,
                                 const std::vector<MissionPart>& b);

/**
 * Returns whether the next three icebergs of a plan are those that an uploaded order has ahead,
 * too: icebergs at its beginning may have been visited since. If fewer are planned, the uploaded
 * order must end with them.
 */
[[nodiscard]] bool agreesAhead(const std::vector<std::string>& uploaded,
                               const std::vector<std::string>& planned);

} // namespace berg
