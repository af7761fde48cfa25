#pragma once

#include <string>

namespace berg {

/** Version of the program, such as "1.0.0", from CMakeLists.txt. */
[[nodiscard]] std::string programVersion();

/** Name and version, such as "Bergwatch 1.0.0", for files and pages that say what wrote them. */
[[nodiscard]] std::string programName();

} // namespace berg
