#pragma once

namespace berg {

/** Returns true if the command line is `bergwatch export ...`. */
[[nodiscard]] bool asksForExport(int argc, char** argv);

/**
 * Runs the command `export` of bergwatch-cli with all formats, including the painted ones, and
 * returns the exit code. Opens no window and needs no display.
 */
[[nodiscard]] int runExport(int argc, char** argv);

} // namespace berg
