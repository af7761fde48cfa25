#pragma once

#include <QString>
#include <QStringList>

namespace berg {

/** Files of `writeManual`: web pages, starting with index.html, and manual.pdf. */
[[nodiscard]] QStringList manualFileNames();

/**
 * Writes the manual in the program's language into a folder, all files or none, with the pictures
 * that exist there. Returns the paths. Throws `Error` FileUnwritable.
 */
QStringList writeManual(const QString& folder);

} // namespace berg
