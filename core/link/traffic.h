#pragma once

#include "core/earth/geodesy.h"
#include "core/link/message/link_message.h"
#include "core/link/nmea/nmea_reader.h"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace berg {

/** Another aircraft, a ship or ice nearby, as receivers and radars report it over the link. */
struct TrafficTarget
{
    enum class Kind
    {
        Aircraft, ///< From ADS-B.
        Ship,     ///< From AIS.
        Ice       ///< Tracked by a radar, or marked by AIS.
    };
    Kind kind = Kind::Aircraft;
    std::uint32_t id = 0; ///< ICAO address, MMSI, or number of a radar target.
    std::string name;     ///< Call sign or name of the sender: any bytes.
    LatLon place;
    std::optional<double> altitude_m;
    std::optional<double> course_rad; ///< Clockwise from true north.
    double speed_mps = 0;             ///< Over ground.
    double received_s = 0;            ///< Receiver's clock.
};

/**
 * Traffic heard over a link. A target disappears when it has been silent for a minute, a ship after
 * ten, ice after two. At most 250 of each kind are kept; further ones are ignored.
 */
class TrafficList
{
public:
    /**
     * Processes ADSB_VEHICLE and AIS_VESSEL, received at `now_s` of the receiver's clock; other
     * messages and targets without a position are ignored.
     */
    void receive(const LinkMessage& message, double now_s);
    /**
     * Processes a target of NMEA: ships, and as ice radar targets and the aids whose name says ice
     * (`saysIce`); other aids are ignored, and a radar target that is one of the ships, 300 m from
     * it or less.
     */
    void receive(const NmeaTarget& target, double now_s);
    /** Returns true if a ship has been 300 m from the place, or less, within three minutes. */
    [[nodiscard]] bool isAtShip(const LatLon& place, double now_s) const;
    /** Forgets silent targets. */
    void advance(double now_s);
    /** Returns the targets, aircraft first, ice last, by id. */
    [[nodiscard]] std::vector<TrafficTarget> targets() const;

private:
    void keep(TrafficTarget target, double now_s);

    std::map<std::pair<TrafficTarget::Kind, std::uint32_t>, TrafficTarget> m_targets;
};

} // namespace berg
