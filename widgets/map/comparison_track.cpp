#include "widgets/map/comparison_track.h"

namespace berg {

void addComparison(MapPicture& picture, const ComparedRun& run, double until_s,
                   const QLocale& locale)
{
    picture.comparisonName = runName(run, locale);
    picture.comparisonTrack.clear();
    for (const Sample& sample : run.samples) {
        if (sample.time_s > until_s)
            break;
        picture.comparisonTrack.push_back(
            {.position_m = sample.uav.position_m, .time_s = sample.time_s});
    }
}

} // namespace berg
