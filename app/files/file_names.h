#pragma once

#include <QString>

namespace berg {

/** A name for a file from the name of a scenario or study, which may hold anything. */
[[nodiscard]] QString fileNameOf(const QString& name);

/** `path`, with the extension when it has none. */
[[nodiscard]] QString withExtension(const QString& path, const QString& extension);

} // namespace berg
