#pragma once

#include <cstddef>
#include <functional>
#include <stop_token>
#include <string>

namespace berg {

/** Limits of `runIsolated`. */
struct IsolationLimits
{
    std::size_t memory = 0;    ///< bytes beyond those of this process
    unsigned processor_s = 60; ///< time of the processor
};

/**
 * Runs `work` in a copy of this process and returns its result, so that a foreign library which
 * reads hostile bytes can neither end this process nor take its memory. `work` gets a function that
 * passes a number between 0 and 1 on to `progress`. It sees the values of this process, but nothing
 * that it changes comes back except its result. `subject` names the file.
 *
 * Throws the `Error` that `work` throws (whose issues must hold no `Amount`); FileUnreadable if the
 * copy ends otherwise, such as by a signal; FileTooLarge if its memory is used up; `Stopped` at
 * once, and ends the copy, if a stop is requested. Any thread may call it.
 */
[[nodiscard]] std::string
runIsolated(const std::string& subject,
            const std::function<std::string(const std::function<void(double)>&)>& work,
            const IsolationLimits& limits, const std::function<void(double)>& progress,
            const std::stop_token& stop);

} // namespace berg
