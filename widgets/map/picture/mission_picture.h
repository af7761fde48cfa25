#pragma once

#include "widgets/map/picture/map_picture.h"
#include "widgets/model/compared_run.h"
#include "widgets/model/flight_record.h"

#include <QLocale>

namespace berg {

/**
 * Poses of a flight, taken over as it grows: a picture of a long one costs no more than that of a
 * short one. GUI thread.
 */
class SweptPaths
{
public:
    /** Where the UAV was at each sample until the time shown, and is. */
    [[nodiscard]] SweptPointer of(const FlightRecord& record, std::size_t uav);

private:
    struct Path
    {
        std::shared_ptr<std::vector<MapPose>> poses;
        std::size_t samples = 0; ///< so many of them are samples
    };
    std::uint64_t m_generation = 0;
    std::uint64_t m_rewrites = 0;
    std::vector<Path> m_paths; ///< by UAV
};

/**
 * The map of a mission at the time shown: the ways flown, of long flights the older the coarser,
 * the plans in force, the estimates of the icebergs that have appeared. Cost: linear in the
 * icebergs and in the few thousand points of the way.
 */
[[nodiscard]] MapPicture missionPicture(const FlightRecord& record, const QLocale& locale,
                                        SweptPaths& swept);
[[nodiscard]] MapPicture missionPicture(const FlightRecord& record, const QLocale& locale);

/** Leaves only what an operator would see. */
void hideTruth(MapPicture& picture);

/** Lays the tracks of another run over the map, up to `until_s`. */
void addComparison(MapPicture& picture, const ComparedRun& run, double until_s,
                   const QLocale& locale);

} // namespace berg
