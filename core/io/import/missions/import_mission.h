#pragma once

// Private to core/io: places in mission files for autopilots.

#include "core/io/import/fields/import_source.h"

#include <cstdint>
#include <set>
#include <string>

namespace berg {

/** An item of a mission, from any format. */
struct MissionItem
{
    std::size_t line = 0;
    std::int64_t command = 0; ///< MAV_CMD
    std::int64_t frame = 0;   ///< MAV_FRAME
    std::string param1;
    std::string param2;
    std::string latitude; ///< degrees; empty if there is none
    std::string longitude;
    std::string altitude; ///< metres
    std::string name;
};

/**
 * Collects the places of a mission and the UAV that flies it: its home, the speed of the first
 * speed change and the altitude of the first place. Take-off, landing, course changes and other
 * items without a place to fly to are ignored, as are items at home or at the place of an earlier
 * item (the circles at the end of a mission).
 */
class MissionPlaces
{
public:
    /** Borrows the budget of `source`; that budget must outlive the object. */
    explicit MissionPlaces(const ImportText& source) : m_budget(source.budget) {}

    /** Sets the home; 0, 0 stands for an unknown home. One that is no place is a rejected row. */
    void setHome(const MissionItem& home);
    /** Sets the landing place, which is also the start if no home was set. */
    void setRally(const LatLon& place);
    /**
     * Adds an item. A speed change sets the airspeed; other commands that lead to no place are
     * ignored. A place that cannot be read, at 0, 0 or in a local frame becomes a rejected row.
     */
    void add(const MissionItem& item);
    /** Rejects an item that has no single place. */
    void reject(std::size_t line, const std::string& what);
    /** Sets the airspeed, unless the mission has set one already. */
    void setCruise(double airspeed_mps);
    [[nodiscard]] FileScene& scene() { return m_table.scene; }
    /**
     * Returns the sightings and the scene, with the UAV if anything is known of it; call it once.
     */
    [[nodiscard]] SightingTable take();

private:
    [[nodiscard]] bool isNew(const LatLon& place);
    void setSpeed(const MissionItem& item);
    void setAltitude(const MissionItem& item);

    ReadBudget& m_budget;
    SightingTable m_table;
    SceneUav m_uav;
    double m_homeAltitude_m = 0;                             ///< above mean sea level
    std::set<std::pair<std::int64_t, std::int64_t>> m_known; ///< places in 1e-7 degrees
};

} // namespace berg
