#pragma once

#include "core/base/error.h"

#include <QString>

#include <optional>

namespace berg {

/** The reason for which work was not completed. */
struct WorkFailure
{
    Error error;    ///< error of the core, or SolverFailed for any other exception
    QString report; ///< text for the user
    /**
     * True for an `Error` of the core, which leaves the data unchanged; otherwise they may be half
     * changed.
     */
    bool isExpected = false;
};

/** Returns the failure of the exception that is being handled. */
[[nodiscard]] WorkFailure presentFailure();

/**
 * Runs the work and returns its failure, if any: every exception becomes a value, also lack of
 * memory and internal errors. All work on other threads than the GUI's runs through this: an
 * exception that leaves such a thread ends the program and loses unsaved data. Thread: any.
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
