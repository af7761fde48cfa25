#pragma once

#include "core/io/export_files.h"

#include <span>

namespace berg {

/**
 * Writes all of the files or none: those of several UAVs belong together. Throws `Error` as
 * `writeFileAtomically` and, of a file that is there already and cannot be put back, as `readFile`;
 * then every file is as it was before.
 */
void writeExport(std::span<const ExportFile> files);

} // namespace berg
