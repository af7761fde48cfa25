#pragma once

#include "core/io/export/content/export_content.h"
#include "widgets/print/printed_document.h"

#include <QLocale>

namespace berg {

/** Returns the page about the operation volume, which the export must have: its derivation, limits
 * of the UAVs, crew and checklist. Empty entries are lines to fill in by hand. Checklist items that
 * do not fit are left out, and a line gives their number. */
[[nodiscard]] PrintedDocument operationDocument(const ExportContent& content,
                                                const QLocale& locale);

} // namespace berg
