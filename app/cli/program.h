#pragma once

#include "app/cli/commands.h"

#include <optional>
#include <string>

namespace berg::cli {

/** A program whose first word on the command line is a command. */
struct Program
{
    std::string name;
    std::string about;
    std::string version;
    std::function<void(CLI::App&, Action&)> addCommands;
    bool isSilent = false; ///< prints no error messages
};

/** Runs the command of the command line and returns the exit code. Reports failures on stderr. */
[[nodiscard]] int runProgram(const Program& program, int argc, char** argv,
                             const std::stop_token& stop);

/**
 * Replaces this process by the program `bergwatch` with the same arguments: the one in the same
 * folder, else the one of the same build, else the first on the PATH. Returns only if there is
 * none.
 */
void becomeBergwatch(char** argv);

/** Returns the rank of this process in an MPI program, or nullopt if it was started alone. */
[[nodiscard]] std::optional<int> mpiRank();

} // namespace berg::cli
