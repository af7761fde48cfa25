#pragma once

// Private to core/io: places in mission files for autopilots.

#include "core/io/import/import_formats.h"

#include <cstdint>
#include <set>
#include <string>

namespace berg {

/** One item of a mission, of any file. */
struct MissionItem
{
    std::size_t line = 0;
    std::int64_t command = 0; ///< MAV_CMD
    std::int64_t frame = 0;   ///< MAV_FRAME
    std::string param1;
    std::string param2;
    std::string latitude; ///< degrees; empty: none
    std::string longitude;
    std::string altitude; ///< metres
    std::string name;
};

/**
 * Gathers the places of a mission and the UAV that flies it: its home, the speed of the first
 * change of speed and the altitude of the first place. Take-off, landing, changes of course and
 * everything else that is no place to fly to is passed over, and so is what is at home or where an
 * earlier item is: the circles at the end of a mission.
 */
class MissionPlaces
{
public:
    explicit MissionPlaces(const ImportText& source) : m_budget(source.budget) {}

    /** 0, 0 stands for a home that is not known. */
    void setHome(const MissionItem& home);
    /** Where it lands, if that is not where it starts. */
    void setRally(const LatLon& place);
    void add(const MissionItem& item);
    /** An item that holds no single place. */
    void reject(std::size_t line, const std::string& what);
    /** Speed of a UAV whose mission does not change it. */
    void setCruise(double airspeed_mps);
    [[nodiscard]] FileScene& scene() { return m_table.scene; }
    [[nodiscard]] SightingTable take();

private:
    [[nodiscard]] bool isNew(const LatLon& place);
    void setSpeed(const MissionItem& item);
    void setAltitude(const MissionItem& item);

    ReadBudget& m_budget;
    SightingTable m_table;
    SceneUav m_uav;
    double m_homeAltitude_m = 0;                             ///< above mean sea level
    std::set<std::pair<std::int64_t, std::int64_t>> m_known; ///< in 1e-7 degrees, a centimetre
};

} // namespace berg
