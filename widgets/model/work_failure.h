#pragma once

#include "core/base/error.h"

#include <QString>

#include <optional>

namespace berg {

/** Why work did not come to its end. */
struct WorkFailure
{
    Error error;    ///< of the core, or SolverFailed in place of anything else that was thrown
    QString report; ///< in the user's words
    /** An `Error` of the core: what was worked on is as it was. Else it may be half changed. */
    bool isExpected = false;
};

/** Of the exception that is being handled. */
[[nodiscard]] WorkFailure presentFailure();

/**
 * Does the work; whatever it throws becomes a value, memory that has run out and faults of our own
 * too. All that is done on other threads than that of the GUI is done through this: an exception
 * that leaves such a thread ends the program, and what is unsaved with it. Thread: any.
 */
template <class Work>
[[nodiscard]] std::optional<WorkFailure> failureOf(const Work& work)
{
    try {
        work();
        return std::nullopt;
    } catch (...) {
        return presentFailure();
    }
}

} // namespace berg
