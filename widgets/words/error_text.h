#pragma once

#include "core/base/error.h"

#include <QString>

namespace berg {

/** What happened and what to do about it, in one translated sentence. */
[[nodiscard]] QString errorText(ErrorCode code);

/**
 * The whole report of a failure: the file or field concerned, the sentence of its code, then one
 * line for each finding with its field.
 */
[[nodiscard]] QString errorReport(const Error& error);

} // namespace berg
