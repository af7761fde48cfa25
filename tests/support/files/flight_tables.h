#pragma once

#include "core/io/results/result_csv.h"

#include <string>

namespace berg::test {

/** Returns the table that one of the writers makes of a mission. */
inline std::string written(void (*write)(const Mission&, const TextSink&), const Mission& mission)
{
    std::string text;
    write(mission, [&text](std::string_view piece) { text += piece; });
    return text;
}

/** Returns the samples of a mission as in trajectory.csv. */
inline std::string trajectoryCsv(const Mission& mission)
{
    const SampleTables tables(mission.scenario(), mission.icebergs(),
                              mission.simulation().world().asset().has_value());
    std::string text = tables.trajectoryHeader();
    for (const Sample& sample : mission.recorder().samples())
        tables.addTrajectory(text, sample);
    return text;
}

} // namespace berg::test
