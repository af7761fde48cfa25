#pragma once

#include "tests/support/window/panel_test.h"
#include "tests/support/window/synthetic_flight.h"
#include "widgets/charts/time_chart.h"
#include "widgets/panels/flight/chart_panel.h"

#include <string>
#include <vector>

// Chart panels that show a flight.

namespace berg::test {

inline constexpr SyntheticFlight kFlight{.icebergs = 5, .duration_s = 1000, .interval_s = 1};

inline constexpr SyntheticFlight kFleet{
    .icebergs = 5, .duration_s = 1000, .interval_s = 1, .uavs = 3};

/** A panel with a flight of 1000 s. */
struct Shown
{
    explicit Shown(ChartKind kind, const QSize& size = {600, 260})
        : record(syntheticRecord(kFlight, 1000))
        , panel(kind, Theme::light())
        , chart(child<TimeChart>(panel, QStringLiteral("timeChart")))
    {
        panel.resize(size);
        panel.show();
        panel.showRecord(record);
    }

    FlightRecord record;
    ChartPanel panel;
    TimeChart& chart;
};

inline std::vector<std::string> linesOf(const std::string& text)
{
    std::vector<std::string> lines;
    std::size_t begin = 0;
    for (std::size_t end = text.find('\n'); end != std::string::npos;
         end = text.find('\n', begin)) {
        lines.push_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    return lines;
}

} // namespace berg::test
