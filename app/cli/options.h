#pragma once

#include "app/cli/commands.h"
#include "app/cli/console.h"
#include "app/cli/usage.h"
#include "core/base/number_text.h"
#include "core/plan/solve/names.h"
#include "core/scenario/text_checks.h"

#include <CLI/CLI.hpp>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

namespace berg::cli {

/** Adds an option whose value is a name from `table`. Any other value is a usage error that lists
 * the names. */
template <class Enum, std::size_t Size>
CLI::Option* addNamed(CLI::App& command, const std::string& option, std::optional<Enum>& value,
                      const std::array<Named<Enum>, Size>& table, const std::string& help)
{
    const auto assign = [&value, &table, option](const std::string& text) {
        value = valueOf(table, text);
        if (!value)
            throw CLI::ValidationError(
                option, inOne(sentence(QT_TRANSLATE_NOOP("CommandLine", "%1 is none of %2"),
                                       {word(text), allowedNames(table)})));
    };
    return command.add_option_function<std::string>(option, assign,
                                                    help + ": " + allowedNames(table));
}

/**
 * Accepts a whole decimal number from `low` to `high`, also with leading zeros. CLI11 itself reads
 * 010 as eight and accepts 0x10.
 */
inline CLI::Validator wholeFrom(std::int64_t low, std::int64_t high)
{
    const std::string range = std::to_string(low) + " to " + std::to_string(high);
    return {[low, high](std::string& text) {
                std::int64_t value = 0;
                const char* const end = text.data() + text.size();
                const auto [last, failure] = std::from_chars(text.data(), end, value);
                if (failure != std::errc() || last != end || value < low || value > high)
                    return inOne(sentence(
                        QT_TRANSLATE_NOOP("CommandLine", "%1 is not a whole number from %2 to %3"),
                        {word(text), low, high}));
                text = std::to_string(value);
                return std::string();
            },
            "(" + range + ")"};
}

/** Accepts a finite decimal number from `low` to `high`; `CLI::Range` would accept NaN. */
inline CLI::Validator numberFrom(double low, double high)
{
    return {[low, high](std::string& text) {
                double value = 0;
                const char* const end = text.data() + text.size();
                const auto [last, failure] = std::from_chars(text.data(), end, value);
                if (failure != std::errc() || last != end)
                    return inOne(sentence(QT_TRANSLATE_NOOP("CommandLine", "%1 is not a number"),
                                          {word(text)}));
                const auto fault = outOfLimits(value, {.low = low, .high = high});
                return fault ? inOne({.english = englishText(*fault), .said = said(*fault)})
                             : std::string();
            },
            "(" + numberText(low) + " to " + numberText(high) + ")"};
}

/** Returns the arguments that the options of `command` fill. If the command is chosen, `action`
 * calls `run` with them. */
template <class Arguments>
Arguments& argumentsOf(CLI::App& command, Action& action,
                       int (*run)(const Arguments&, const std::stop_token&))
{
    const auto arguments = std::make_shared<Arguments>();
    command.callback([arguments, run, &action] {
        action = [arguments, run](const std::stop_token& stop) { return run(*arguments, stop); };
    });
    return *arguments;
}

} // namespace berg::cli
