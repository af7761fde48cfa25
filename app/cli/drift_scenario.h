#pragma once

#include "core/study/drift_tracks.h"

#include <stop_token>
#include <string>

namespace berg::cli {

/** Arguments of `drift SCENARIO`. */
struct DriftScenarioArguments
{
    std::string file;
    DriftTrackSpec spec;
    std::string outputFile; ///< GeoJSON if its name ends so, else CSV; empty means none
    bool force = false;
    bool json = false;
};

/** Predicts the drift of the icebergs of a scenario; returns the exit code. */
int driftOfScenario(const DriftScenarioArguments& arguments, const std::stop_token& stop);

} // namespace berg::cli
