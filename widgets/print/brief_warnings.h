#pragma once

#include "core/io/export/export_content.h"
#include "core/sim/sortie_outlook.h"

#include <QLocale>
#include <QStringList>

#include <vector>

namespace berg {

/** By iceberg of the content: visited by one of its ways. */
[[nodiscard]] std::vector<bool> visitedIcebergs(const ExportContent& content);

/** "Proven optimal", "Within 0.8 % of optimal", ...: how good the plan is known to be. */
[[nodiscard]] QString planWords(const ExportContent& content, const QLocale& locale);

/** What the crew must know, the most important first: findings about the scenario as it is
 * exported, the plan, icebergs left out, the fence and the distance to be kept. */
[[nodiscard]] QStringList briefWarnings(const ExportContent& content, const QLocale& locale);

/** What the UAV is to fly, home left out; not for what was flown. */
[[nodiscard]] PlannedPath plannedPath(const ExportContent& content, const ExportUav& uav);

} // namespace berg
