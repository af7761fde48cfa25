#pragma once

namespace berg {

/** True when the command line says `bergwatch export ...`. */
[[nodiscard]] bool asksForExport(int argc, char** argv);

/**
 * The command `export` of bergwatch-cli with all formats of the table, also those that are painted;
 * the exit code. Opens no window and needs no display.
 */
[[nodiscard]] int runExport(int argc, char** argv);

} // namespace berg
