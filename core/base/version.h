#pragma once

#include <string>

namespace berg {

/** Returns the version of the program, such as "1.0.0", from CMakeLists.txt. */
[[nodiscard]] std::string programVersion();

/**
 * Returns name and version, such as "Bergwatch 1.0.0", for files and pages that name their author.
 */
[[nodiscard]] std::string programName();

} // namespace berg
