// Cost of refreshing a chart while a mission is flown: the record grows by a sample, the panel
// takes it and is painted, without a display. "then" is the median of refreshes that lay everything
// out, "live" the mean of those of a flight at 25 Hz and ten times real time, most of which change
// less than the eye could see.
//
// Use: bench_charts [width height]      (700 260 when not given)

#include "tests/support/window/synthetic_flight.h"
#include "widgets/charts/time_chart.h"
#include "widgets/panels/flight/chart_panel.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QPixmap>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>

using namespace berg;

namespace {

constexpr int kFrames = 40;
constexpr int kLiveFrames = 100;
constexpr double kLive_s = 0.4; ///< between frames at 25 Hz and ten times real time

double elapsed_ms(const QElapsedTimer& clock)
{
    return static_cast<double>(clock.nsecsElapsed()) * 1e-6;
}

double median_ms(std::vector<double> values)
{
    std::nth_element(values.begin(),
                     values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
    return values[values.size() / 2];
}

void measure(const test::SyntheticFlight& flight, const QSize& size_px)
{
    FlightRecord record =
        test::syntheticRecord(flight, flight.duration_s - kFrames * flight.interval_s);
    record.now.phase = RunPhase::Paused; // every frame is laid out
    const double flown_s = record.now.time_s;
    const std::size_t first = record.history.samples.size();
    for (const ChartKind kind : kChartKinds) {
        ChartPanel panel(kind, Theme::light());
        panel.resize(size_px);
        panel.setAttribute(Qt::WA_DontShowOnScreen);
        panel.show();
        QElapsedTimer clock;
        clock.start();
        panel.showRecord(record);
        const double first_ms = elapsed_ms(clock);
        std::vector<double> show_ms;
        std::vector<double> paint_ms;
        for (int frame = 1; frame <= kFrames; ++frame) {
            test::extend(record, flight, flown_s + frame * flight.interval_s);
            QPixmap picture(size_px);
            clock.restart();
            panel.showRecord(record);
            show_ms.push_back(elapsed_ms(clock));
            clock.restart();
            panel.render(&picture);
            paint_ms.push_back(elapsed_ms(clock));
        }
        record.now.phase = RunPhase::Flying;
        panel.showRecord(record);
        double live_ms = 0;
        for (int frame = 1; frame <= kLiveFrames; ++frame) {
            const double time_s = flown_s + kFrames * flight.interval_s + frame * kLive_s;
            test::extend(record, flight, time_s);
            record.now.time_s = time_s;
            QPixmap picture(size_px);
            clock.restart();
            panel.showRecord(record);
            panel.render(&picture);
            live_ms += elapsed_ms(clock) / kLiveFrames;
        }
        record.now.phase = RunPhase::Paused;
        const double most_ms = *std::max_element(show_ms.begin(), show_ms.end()) +
                               *std::max_element(paint_ms.begin(), paint_ms.end());
        std::printf("%3d x %6.0f s  %-12s first %7.1f ms, then %5.1f + %5.1f ms (most %5.1f); "
                    "live %4.1f ms\n",
                    flight.icebergs, flight.duration_s, qPrintable(chartFileStem(kind)), first_ms,
                    median_ms(show_ms), median_ms(paint_ms), most_ms, live_ms);
        record.history.samples.resize(first);
        record.history.rows.resize(first);
    }
}

} // namespace

int main(int argc, char** argv)
{
    if (!qEnvironmentVariableIsSet("QT_QPA_PLATFORM"))
        qputenv("QT_QPA_PLATFORM", "offscreen");
    const QApplication application(argc, argv);
    const QSize size_px =
        argc == 3 ? QSize(std::atoi(argv[1]), std::atoi(argv[2])) : QSize(700, 260);
    std::printf("panel %d x %d; refresh = take the record and lay out + paint, medians\n",
                size_px.width(), size_px.height());
    constexpr std::array<test::SyntheticFlight, 3> kFlights = {
        {{.icebergs = 12, .duration_s = 1000, .interval_s = 1},
         {.icebergs = 40, .duration_s = 3600, .interval_s = 1},
         {.icebergs = 100, .duration_s = 86400, .interval_s = 5}}};
    for (const test::SyntheticFlight& flight : kFlights)
        measure(flight, size_px);
    return 0;
}
