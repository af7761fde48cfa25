#pragma once

#include "core/plan/fleet/certificate.h"

#include <string>

namespace berg {

/**
 * Returns the text of a certificate file, which `tests/checker` verifies; its member `claim` states
 * what it proves.
 */
[[nodiscard]] std::string certificateJson(const Certificate& certificate);

} // namespace berg
