#pragma once

#include "core/io/export/export_content.h"

#include <QLocale>
#include <QString>

namespace berg {

// Words on exported pages.

/** Name of the scenario. */
[[nodiscard]] QString pageTitle(const ExportContent& content);

/** What the page shows, as it was chosen: "Flown until 16:40". */
[[nodiscard]] QString pathsText(const ExportContent& content);

/** `what`, how it was planned, and when it starts, if that is known. */
[[nodiscard]] QString pageSubtitle(const ExportContent& content, const QString& what,
                                   const QLocale& locale);

} // namespace berg
