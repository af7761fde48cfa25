#pragma once

#include "core/plan/fleet/certificate.h"

#include <string>

namespace berg {

/** The file that `tests/checker` checks; says in `claim` what it proves. */
[[nodiscard]] std::string certificateJson(const Certificate& certificate);

} // namespace berg
