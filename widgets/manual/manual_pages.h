#pragma once

#include <QString>
#include <QStringList>

namespace berg {

/** What `writeManual` writes: web pages, of which index.html is the first, and manual.pdf. */
[[nodiscard]] QStringList manualFileNames();

/**
 * Writes the manual in the language of the program into the folder, all files or none; the
 * pictures are those that are there. Returns the paths. Throws `Error` FileUnwritable.
 */
QStringList writeManual(const QString& folder);

} // namespace berg
