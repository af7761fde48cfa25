#pragma once

#include "core/io/figure/figure.h"
#include "widgets/theme/mission_clock.h"
#include "widgets/theme/quantity_text.h"

#include <QStringList>

#include <functional>
#include <string>
#include <vector>

namespace berg {

// Texts for figures, formatted as in the window.

/** UTF-8 text of a figure. */
[[nodiscard]] inline std::string utf8(const QString& text)
{
    return text.toStdString();
}

/** UTF-8 lines of a figure. */
[[nodiscard]] inline std::vector<std::string> utf8(const QStringList& lines)
{
    std::vector<std::string> out;
    for (const QString& line : lines)
        out.push_back(line.toStdString());
    return out;
}

/** Number format of an axis. */
[[nodiscard]] inline std::function<std::string(double, int)> numberText(const QLocale& locale)
{
    return
        [locale](double value, int decimals) { return utf8(fixedText(value, decimals, locale)); };
}

/** Time axis of a run, with `title` for UTC and `elapsedTitle` for elapsed time. */
[[nodiscard]] inline PlotAxis timeAxis(const MissionClock& clock, double from_s, double to_s,
                                       const QString& title, const QString& elapsedTitle)
{
    return {.ends = AxisEnds::Exact,
            .least = from_s,
            .largest = to_s,
            .spacing_px = 84,
            .text = [clock](double time_s, int) { return utf8(clock.text(time_s)); },
            .title = utf8(clock.isUtc() ? title : elapsedTitle),
            .isTime = true,
            .midnight = clock.isUtc() ? clock.midnight_s() : 0};
}

} // namespace berg
