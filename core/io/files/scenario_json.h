#pragma once

#include "core/scenario/scenario.h"

#include <stop_token>
#include <string>
#include <string_view>

namespace berg {

/** What a scenario is read for. */
enum class ScenarioUse
{
    Flying, ///< errors of `validate` are faults
    Editing ///< of them only those that make it `unreadable`
};

/**
 * Scenario of a `.berg` text. `subject` (usually the path) names it in errors. Throws `Error`:
 * SyntaxError (with line and column), WrongFormat, UnsupportedVersion, InvalidInput with every
 * fault found: wrong types, missing and duplicate members, and what is wrong for its use;
 * FileTooLarge (`ReadBudget`); `Stopped` when asked to stop.
 */
[[nodiscard]] Scenario scenarioFromJson(std::string_view text, const std::string& subject,
                                        ScenarioUse use = ScenarioUse::Flying,
                                        const std::stop_token& stop = {});

/** Text of the `.berg` file: stable member order, numbers that read back exactly, final newline. */
[[nodiscard]] std::string scenarioToJson(const Scenario& scenario);

[[nodiscard]] Scenario loadScenario(const std::string& path, ScenarioUse use = ScenarioUse::Flying);

} // namespace berg
