#pragma once

#include <string>

namespace berg {

/**
 * Processor, cores and system of this machine for reports, e.g. "AMD EPYC 7B13, 2 cores, Linux
 * 6.1.0 x86_64"; what cannot be found is left out. Names neither machine nor user.
 */
[[nodiscard]] std::string machineText();

} // namespace berg
