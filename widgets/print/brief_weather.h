#pragma once

#include "core/io/export/content/export_content.h"

#include <QLocale>
#include <QStringList>

#include <vector>

namespace berg {

/** Forecast for a flight, in the user's language and units. */
struct BriefWeather
{
    QString source;                ///< of the forecast, with its issue; empty without one
    std::vector<QStringList> rows; ///< captions, then a row per time; all rows have equal length
    QStringList warnings;          ///< an old forecast, and parts of the flight without one
};

/**
 * Returns wind, gusts and current at the place of the flight (`flightPlace_m`), from its start to
 * its end; empty without a usable forecast. From a wind that the crew has reported on, that wind
 * applies. Directions are true.
 */
[[nodiscard]] BriefWeather briefWeather(const ExportContent& content, const QLocale& locale);

} // namespace berg
