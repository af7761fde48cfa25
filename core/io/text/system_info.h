#pragma once

#include <string>

namespace berg {

/**
 * Returns processor, cores and system of this machine for reports, e.g. "AMD EPYC 7B13, 2 cores,
 * Linux 6.1.0 x86_64"; leaves out what cannot be found. Names neither machine nor user.
 */
[[nodiscard]] std::string systemInfo();

} // namespace berg
