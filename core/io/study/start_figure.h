#pragma once

#include "core/io/study/study_figures.h"
#include "core/study/start_scan.h"

#include <functional>
#include <string>

namespace berg {

/** Names and numbers of the figure of start times; by default those of a report. */
struct StartFigureFormat
{
    StudyFigureFormat study = {};
    /** Returns the reason of the weather in words. */
    std::function<std::string(const WeatherReason&)> reason = defaultReason;

    static std::string defaultReason(const WeatherReason& reason);
};

/** Returns the English name of a state, marked for translation in context Report. */
[[nodiscard]] std::string_view weatherWords(WeatherState state);

/**
 * Returns the figure of zeta against start time: a bar for each start, faint if its weather is
 * marginal or unknown and hatched if it is no-go, with a mark above the best one. Items are the
 * starts, also those without a flight. Times are UTC.
 */
[[nodiscard]] Figure startFigure(const StartScan& scan, const StartFigureFormat& format = {});

} // namespace berg
