#pragma once

#include "core/io/results/result_csv.h"

#include <string>

namespace berg::test {

/** What one of the writers of tables writes of a mission. */
inline std::string written(void (*write)(const Mission&, const TextSink&), const Mission& mission)
{
    std::string text;
    write(mission, [&text](std::string_view piece) { text += piece; });
    return text;
}

/** The samples of a mission as trajectory.csv has them. */
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
