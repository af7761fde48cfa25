#pragma once

#include "core/io/export/content/export_content.h"
#include "core/mission/sortie_outlook.h"

#include <QLocale>
#include <QStringList>

#include <vector>

namespace berg {

/** Returns, by iceberg of the content, true if any UAV visits it. */
[[nodiscard]] std::vector<bool> visitedIcebergs(const ExportContent& content);

/**
 * Returns a text about the quality of the plan: "Proven optimal", "Within 0.8 % of optimal", ...
 */
[[nodiscard]] QString planWords(const ExportContent& content, const QLocale& locale);

/** Returns the warnings for the crew, most important first, for example findings about the exported
 * scenario, icebergs left out, the endurance, the geofence and the required separation. */
[[nodiscard]] QStringList briefWarnings(const ExportContent& content, const QLocale& locale);

/** Returns the planned path of a UAV up to its last visit. The export must not be a track. */
[[nodiscard]] PlannedPath plannedPath(const ExportContent& content, const ExportUav& uav);

} // namespace berg
