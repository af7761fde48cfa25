#pragma once

#include "app/layout/window_part.h"
#include "core/base/index.h"
#include "core/sim/steering.h"
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

private:
    /** A plan that was uploaded to an aircraft, and found there. */
    struct Upload
    {
        std::vector<MissionPart> parts;
        std::vector<std::string> order;
        QString time;             ///< when it was found on board; empty before
        double found_s = 0;       ///< the same on the clock of the link
        std::optional<int> total; ///< number of items that the aircraft reports since
        std::optional<std::uint32_t> missionId;
        bool isChangedOnBoard = false; ///< the aircraft reports another mission since
        bool isPlanChanged = false;
    };
    /** Reason for which the plans were requested as uploads. */
    enum class Purpose
    {
        None,
        Upload,
        Compare,
        Check ///< whether the uploads still equal the plans
    };
    /** Everything that belongs to one aircraft. */
    struct Aircraft
    {
        std::string uav; ///< id of the UAV that it flies as; empty for none
        std::optional<Upload> upload;
        Steering steering;
        std::optional<IcebergIndex> guidedTo; ///< iceberg of the last guided point
        Point guidedTo_m = Point::Zero();
        double lastPose_s = 0; ///< of the last pose passed on
        Purpose purpose = Purpose::None;
    };

    void connectPanel();
    void listen(bool isOn);
    void rehearse(bool isOn);
    void flyLive();
    void showStatus();
    void matchAircraft();
    void reportEvents();
    void endSync(LinkAddress address);
    void passPoses();
    void showOnMap();
    void showPanel();
    void showNotices();
    void showUavs();
    void flightChanged();
    void watchMission(const LinkVehicle& vehicle, Aircraft& aircraft);
    void replaceMission(LinkAddress address, Aircraft& aircraft);
    void guide(const LinkVehicle& vehicle, Aircraft& aircraft);
    void requestMission(Purpose purpose);
    void acceptMissions(const std::vector<UavMission>& missions);
    void setSteering(SteeringKind kind);
    void useWind();
    void followShip();
    [[nodiscard]] const LinkVehicle* vehicleOf(LinkAddress address) const;
    [[nodiscard]] std::optional<int> uavIndex(const Aircraft& aircraft) const;
    [[nodiscard]] std::vector<std::string> orderInForce(int uav) const;
    [[nodiscard]] QString onBoardText(const Aircraft& aircraft, const LinkVehicle& vehicle) const;
    [[nodiscard]] std::optional<DubinsState> poseOf(const LinkVehicle& vehicle) const;
    [[nodiscard]] DubinsState poseAt(const LatLon& place, double heading_rad) const;

    FlightView& m_flightView;
    QLabel* m_mark; ///< in the status bar, as long as the link is on
    std::map<LinkAddress, Aircraft> m_aircraft;
    std::unique_ptr<RehearsalFleet> m_rehearsal;
    std::uint32_t m_assetShip = 0;     ///< MMSI of the ship that the asset follows; 0 for none
    double m_assetMoved_s = 0;         ///< clock of the link at its last move
    std::vector<std::string> m_uavIds; ///< as the panel offers them
};

/**
 * Returns whether the next icebergs of a plan are those that an uploaded order has ahead, too:
 * icebergs at its beginning may have been visited since.
 */
[[nodiscard]] bool agreesAhead(const std::vector<std::string>& uploaded,
                               const std::vector<std::string>& planned);

} // namespace berg
