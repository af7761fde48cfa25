#pragma once

#include "core/earth/geodesy.h"
#include "core/link/logs/telemetry_log.h"

#include <map>
#include <vector>

namespace berg {

/** A position of an aircraft in a telemetry log. */
struct RecordedPosition
{
    std::int64_t unix_us = 0;
    LatLon place;
    double altitude_m = 0; ///< Above mean sea level.
};

/**
 * Follows the positions of every vehicle of a telemetry log, with the checks of `updateState`. At
 * most 32 vehicles are followed.
 */
class FlightRecorder
{
public:
    /** Adds a frame; returns false for frames without a position, which are ignored. */
    bool add(const LoggedFrame& logged);

    /** Returns the positions of each vehicle in the order of the log. */
    [[nodiscard]] const std::map<LinkAddress, std::vector<RecordedPosition>>& flights() const
    {
        return m_flights;
    }

private:
    std::map<LinkAddress, std::vector<RecordedPosition>> m_flights;
};

} // namespace berg
