#pragma once

#include "core/link/tracker_list.h"
#include "widgets/aircraft/link_status.h"

#include <QString>

#include <optional>
#include <vector>

namespace berg {

/** A ship that reports its place over the link: by AIS, or with a tracker on board (NMEA). */
struct LinkShip
{
    quint64 key = 0; ///< identifies the ship while the program runs; never 0
    QString name;
    LatLon place;
    std::optional<double> course_rad; ///< clockwise from true north
    double speed_mps = 0;             ///< over ground
    double received_s = 0;            ///< clock of the link
};

/** Returns the key of a tracker as a ship; 0 for an address that is no tracker's. */
[[nodiscard]] quint64 shipKey(LinkAddress tracker);

/** Returns the ships of AIS and all trackers, which may be on an aircraft instead. */
[[nodiscard]] std::vector<LinkShip> shipsOf(const LinkStatus& status);

/** Returns the ship with this key; nullopt if it is not heard. */
[[nodiscard]] std::optional<LinkShip> shipOf(const LinkStatus& status, quint64 key);

} // namespace berg
