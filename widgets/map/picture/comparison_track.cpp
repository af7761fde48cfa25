#include "widgets/map/picture/comparison_track.h"

namespace berg {

void addComparison(MapPicture& picture, const ComparedRun& run, double until_s,
                   const QLocale& locale)
{
    picture.comparisonName = runName(run, locale);
    picture.comparisonTracks.assign(run.scenario.uavs.size(), {});
    for (const Sample& sample : run.samples) {
        if (sample.time_s > until_s)
            break;
        for (std::size_t uav = 0; uav < picture.comparisonTracks.size(); ++uav)
            picture.comparisonTracks[uav].push_back(
                {.position_m = sample.uavs[uav].pose.position_m, .time_s = sample.time_s});
    }
}

} // namespace berg
