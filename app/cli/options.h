#pragma once

#include "core/plan/names.h"

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

namespace berg::cli {

/** Option whose value is one of a table of names; anything else is wrong usage that lists them. */
template <class Enum, std::size_t Size>
CLI::Option* addNamed(CLI::App& command, const std::string& option, std::optional<Enum>& value,
                      const std::array<Named<Enum>, Size>& table, const std::string& help)
{
    const auto assign = [&value, &table, option](const std::string& text) {
        value = valueOf(table, text);
        if (!value)
            throw CLI::ValidationError(option, text + " is none of " + allowedNames(table));
    };
    return command.add_option_function<std::string>(option, assign,
                                                    help + ": " + allowedNames(table));
}

} // namespace berg::cli
