#pragma once

#include "app/cli/commands.h"

#include <string>

namespace berg::cli {

/** A program whose first word on the command line is a command. */
struct Program
{
    std::string name;
    std::string about;
    std::string version;
    std::function<void(CLI::App&, Action&)> addCommands;
    bool isSilent = false; ///< says nothing of what goes wrong
};

/** Does what the command line asks for; the exit code. What goes wrong is told on stderr. */
[[nodiscard]] int runProgram(const Program& program, int argc, char** argv,
                             const std::stop_token& stop);

/**
 * Becomes the program `bergwatch` with the same arguments: the one in the same folder, else that of
 * the same build, else the first on the PATH. Returns only when there is none.
 */
void becomeBergwatch(char** argv);

} // namespace berg::cli
