#pragma once

// Files of Bergwatch as complete texts.

#include "core/io/files/run_json.h"
#include "core/io/files/scenario_json.h"
#include "core/io/text/atomic_file.h"

#include <string>
#include <string_view>

namespace berg {

inline void saveScenario(const Scenario& scenario, const std::string& path)
{
    writeFileAtomically(path, scenarioToJson(scenario));
}

[[nodiscard]] inline std::string runToJson(const RunFile& run)
{
    std::string text;
    writeRun(run, [&text](std::string_view piece) { text += piece; });
    return text;
}

} // namespace berg
