#pragma once

#include "widgets/flight/compared_run.h"
#include "widgets/flight/flight_record.h"
#include "widgets/map/picture/map_picture.h"

#include <QLocale>

namespace berg {

/**
 * Cache of the poses of a flight, and of the forecast of the minute shown. It only adds new poses,
 * so that pictures late in a flight cost no more than early ones. GUI thread.
 */
class SweptPaths
{
public:
    /** Returns the poses of UAV `uav` at each sample up to the time shown, and at that time. */
    [[nodiscard]] SweptPointer of(const FlightRecord& record, std::size_t uav);
    /** Returns the forecast at the time shown. */
    [[nodiscard]] MapWeatherPointer weatherOf(const FlightRecord& record);

private:
    struct Path
    {
        std::shared_ptr<std::vector<MapPose>> poses;
        std::size_t samples = 0; ///< how many of `poses` are recorded samples
    };
    std::uint64_t m_generation = 0;
    std::uint64_t m_rewrites = 0;
    std::vector<Path> m_paths; ///< by UAV
    MapWeatherCache m_weather;
};

/**
 * Returns the picture of a mission at the time shown: flown tracks (thinned for the older part of
 * long flights), current plans and estimates of the icebergs that are present. The cost is linear
 * in the icebergs and in the few thousand points of a track.
 */
[[nodiscard]] MapPicture missionPicture(const FlightRecord& record, const QLocale& locale,
                                        SweptPaths& swept);
/**
 * Returns the picture of the window: in flight that of the mission, before it the scenario with the
 * newest plan, which may be of the scenario before the last edits (`withScenario`).
 */
[[nodiscard]] MapPicture mapPicture(const FlightRecord& record, const QLocale& locale,
                                    SweptPaths& swept);
/** Returns the picture of a mission without a pose cache, which suits a single one. */
[[nodiscard]] MapPicture missionPicture(const FlightRecord& record, const QLocale& locale);

/** Removes what only the simulation knows, so that the picture shows an operator's information. */
void hideTruth(MapPicture& picture);

/** Adds the tracks of another run, up to `until_s`, to the picture. */
void addComparison(MapPicture& picture, const ComparedRun& run, double until_s,
                   const QLocale& locale);

} // namespace berg
