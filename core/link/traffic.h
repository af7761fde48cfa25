#pragma once

#include "core/earth/geodesy.h"
#include "core/link/link_message.h"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace berg {

/** Another aircraft or a ship nearby, as receivers report it over the link. */
struct TrafficTarget
{
    enum class Kind
    {
        Aircraft, ///< From ADS-B.
        Ship      ///< From AIS.
    };
    Kind kind = Kind::Aircraft;
    std::uint32_t id = 0; ///< ICAO address or MMSI.
    std::string name;     ///< Call sign or name of the sender: any bytes.
    LatLon place;
    std::optional<double> altitude_m;
    std::optional<double> course_rad; ///< Clockwise from true north.
    double speed_mps = 0;             ///< Over ground.
    double received_s = 0;            ///< Receiver's clock.
};

/**
 * Traffic heard over a link. A target disappears when it has been silent for a minute, a ship after
 * ten. At most 250 aircraft and 250 ships are kept; further ones are ignored.
 */
class TrafficList
{
public:
    /**
     * Processes ADSB_VEHICLE and AIS_VESSEL, received at `now_s` of the receiver's clock; other
     * messages and targets without a position are ignored.
     */
    void receive(const LinkMessage& message, double now_s);
    /** Forgets silent targets. */
    void advance(double now_s);
    /** Returns the targets, aircraft first, by id. */
    [[nodiscard]] std::vector<TrafficTarget> targets() const;

private:
    std::map<std::pair<TrafficTarget::Kind, std::uint32_t>, TrafficTarget> m_targets;
};

} // namespace berg
