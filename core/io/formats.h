#pragma once

#include "core/sim/mission.h"

#include <span>
#include <string>
#include <string_view>

namespace berg {

/**
 * What an exporter is given: the scenario, the plan from its start and, for a run, the mission
 * flown. A plan is exported as the way to fly; a run as what was flown.
 */
struct ExportSource
{
    const Scenario& scenario;
    const PlanAnswer& plan;           ///< of `planFromStart`
    const Mission* mission = nullptr; ///< null: nothing flown, export the plan
};

/** One row of the table that the command line and the file dialog share. */
struct ExportFormat
{
    std::string_view id;        ///< e.g. "plan"
    std::string_view extension; ///< without dot
    std::string_view reader;    ///< the tool it is meant for
    std::string (*write)(const ExportSource&);
};

[[nodiscard]] std::span<const ExportFormat> exportFormats();
/** Null when there is no such format. */
[[nodiscard]] const ExportFormat* findExportFormat(std::string_view id);

} // namespace berg
