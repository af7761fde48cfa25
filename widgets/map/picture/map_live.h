#pragma once

#include "core/geometry/geometry.h"

#include <QString>

#include <optional>
#include <vector>

namespace berg {

/** An aircraft on the live link as the map shows it. */
struct MapAircraft
{
    Point position_m = Point::Zero();
    double psi_rad = 0;   ///< from the x = east axis, counter-clockwise
    QString label;        ///< its name and the age of its position
    int place = 0;        ///< index of its UAV in the scenario; sets its colour
    bool isGhost = false; ///< without contact, drawn hollow where it should be now
    bool isFlown = false; ///< the UAV of the scenario flies its path, so its symbol is not repeated
    std::vector<Point> track_m;
    std::optional<Point> contact_m; ///< where contact should return
    QString contactLabel;           ///< time until then
};

/** Another aircraft, a ship or tracked ice nearby. */
struct MapTraffic
{
    Point position_m = Point::Zero();
    std::optional<double> psi_rad; ///< course
    QString label;
    bool isShip = false;
    bool isIce = false;
};

/** Additions of the live link to a picture. */
struct MapLive
{
    std::vector<MapAircraft> aircraft;
    std::vector<MapTraffic> traffic;
};

} // namespace berg
