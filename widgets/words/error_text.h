#pragma once

#include "core/base/error.h"

#include <QString>

namespace berg {

/** Returns what went wrong and what to do about it, as translated sentences. */
[[nodiscard]] QString errorText(ErrorCode code);
/** Returns the same about a file to be imported, which need not be one of ours. */
[[nodiscard]] QString importErrorText(ErrorCode code);

/**
 * Returns the full report of a failure: the file or field concerned, the sentence of its code, then
 * one line for each finding with its field.
 */
[[nodiscard]] QString errorReport(const Error& error);

} // namespace berg
