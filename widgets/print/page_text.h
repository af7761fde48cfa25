#pragma once

#include "core/io/export/content/export_content.h"

#include <QLocale>
#include <QString>

namespace berg {

// Texts on exported pages.

/** Returns the printable name of the scenario, or "Untitled". */
[[nodiscard]] QString pageTitle(const ExportContent& content);

/** Returns the kind and time of the export, for example "Flown until 16:40". */
[[nodiscard]] QString pathsText(const ExportContent& content);

/** Joins `what`, the policy, and the start of the run if it is known. */
[[nodiscard]] QString pageSubtitle(const ExportContent& content, const QString& what,
                                   const QLocale& locale);

} // namespace berg
