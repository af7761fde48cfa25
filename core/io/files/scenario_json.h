#pragma once

#include "core/scenario/scenario.h"

#include <stop_token>
#include <string>
#include <string_view>

namespace berg {

/** Purpose for which a scenario is read. */
enum class ScenarioUse
{
    Flying, ///< errors of `validate` are faults
    Editing ///< only errors that make it `unreadable` are faults
};

/**
 * Reads the scenario of a `.berg` text. `subject` (usually the path) names it in errors. Throws
 * `Error`: SyntaxError (with line and column), WrongFormat, UnsupportedVersion, InvalidInput with
 * every fault found (wrong types, missing and duplicate members, errors for this `use`) and
 * FileTooLarge (`ReadBudget`); `Stopped` if a stop is requested.
 */
[[nodiscard]] Scenario scenarioFromJson(std::string_view text, const std::string& subject,
                                        ScenarioUse use = ScenarioUse::Flying,
                                        const std::stop_token& stop = {});

/**
 * Returns the text of a `.berg` file: stable member order, numbers that read back exactly, final
 * newline.
 */
[[nodiscard]] std::string scenarioToJson(const Scenario& scenario);

/** Reads a scenario from `path`; throws as `readFile` and `scenarioFromJson`. */
[[nodiscard]] Scenario loadScenario(const std::string& path, ScenarioUse use = ScenarioUse::Flying);

} // namespace berg
