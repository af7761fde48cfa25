#pragma once

// Private to core/io: runs another program on data that may be faulty or hostile.

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <stop_token>
#include <string>
#include <vector>

namespace berg {

/** Limits of a child process; the program is killed at the first that it exceeds. */
struct ChildLimits
{
    std::size_t memory = std::size_t{2} << 30U; ///< address space, bytes
    std::chrono::seconds cpu{120};
    std::chrono::milliseconds wall{180'000};
    std::size_t output = std::size_t{64} << 20U;    ///< bytes of standard output
    std::size_t fileSize = std::size_t{512} << 20U; ///< bytes of each file that it writes
};

/** Program, arguments and surroundings of a child process. */
struct ChildCommand
{
    std::filesystem::path program; ///< absolute path
    std::vector<std::string> arguments{};
    std::vector<std::string> environment{}; ///< "NAME=value"; the child has no other variables
    std::filesystem::path folder;           ///< working folder
};

/** How a child process ended, and what it wrote. */
struct ChildResult
{
    enum class End
    {
        Exited,       ///< by itself; see `code`
        Signalled,    ///< by a signal, also that of an exceeded limit of CPU time; see `code`
        TooSlow,      ///< killed at `ChildLimits::wall`
        TooMuchOutput ///< killed at `ChildLimits::output`
    };
    End end = End::Exited;
    int code = 0;       ///< exit status or number of the signal
    std::string output; ///< standard output
    std::string errors; ///< the last 4 KiB of standard error
};

/**
 * Runs a program without input until it ends and returns its result. The program and all that it
 * starts form a process group, which is killed when this function returns, and when this process
 * dies. Throws `Stopped` if a stop is requested, and `std::system_error` if the system has no pipe
 * or process left. If the program cannot be executed, it exits with 127.
 */
[[nodiscard]] ChildResult runChild(const ChildCommand& command, const ChildLimits& limits = {},
                                   const std::stop_token& stop = {});

} // namespace berg
