#include "core/io/study/start_figure.h"

#include "core/io/results/weather_result.h"
#include "core/scenario/utc_time.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace berg {

namespace {

constexpr double kPlotWidth_px = 620; // of the usual figure, for the width of bars

Ink inkOf(WeatherState state)
{
    switch (state) {
    case WeatherState::Go:
        return {.of = InkOf::Plan};
    case WeatherState::Marginal:
        return {.of = InkOf::Caution};
    case WeatherState::Unknown:
        return {.of = InkOf::Muted};
    case WeatherState::NoGo:
        break;
    }
    return {.of = InkOf::Danger};
}

/** Builds the figure of a scan with starts. */
class StartFigureBuilder
{
public:
    StartFigureBuilder(const StartScan& scan, const StartFigureFormat& format)
        : m_scan(scan)
        , m_format(format)
        , m_first(parseUtc(scan.starts.front().startUtc).value_or(UtcTime()))
    {
    }

    [[nodiscard]] Figure figure();

private:
    [[nodiscard]] std::string text(std::string_view english,
                                   const std::vector<std::string>& arguments = {}) const
    {
        return m_format.study.words.text(english, arguments);
    }
    void addAxes();
    void addTitles();
    void addStart(std::size_t index);
    [[nodiscard]] std::vector<std::string> readout(const StartOutcome& start) const;

    const StartScan& m_scan;
    const StartFigureFormat& m_format;
    UtcTime m_first;
    double m_half_px = 0; ///< half width of a bar
    Figure m_figure;
};

void StartFigureBuilder::addAxes()
{
    using namespace std::chrono;
    const double last_s = m_scan.starts.back().delay_s;
    m_figure.x = {.ends = AxisEnds::Exact,
                  .least = 0,
                  .largest = std::max(1.0, last_s),
                  .spacing_px = 64,
                  .text =
                      [first = m_first](double value, int) {
                          constexpr std::size_t kClock = 11; // after the date
                          return minuteText(first, value).substr(kClock);
                      },
                  .title = text(QT_TRANSLATE_NOOP("Report", "Start, UTC")),
                  .isTime = true,
                  .midnight = -duration<double>(m_first - floor<days>(m_first)).count(),
                  .hasGrid = false};
    const auto count = static_cast<double>(m_scan.starts.size());
    m_half_px = std::clamp(0.38 * kPlotWidth_px / count, 0.75, 14.0);
    m_figure.x.inset_px = m_half_px + 3;
    PlotAxis& y = m_figure.y;
    y = {.ends = AxisEnds::Around0,
         .least = 0,
         .largest = 0,
         .spacing_px = 36,
         .text = m_format.study.number};
    for (const StartOutcome& start : m_scan.starts)
        y.include(start.zeta_m2s.value_or(0));
    if (y.largest == 0)
        y.largest = 1;
    const FigureUnit unit = m_format.study.unit(y.largest);
    y.inUnit = unit.inSi;
    m_figure.leftTitles = {text(QT_TRANSLATE_NOOP("Report", "Zeta ζ, %1"), {unit.name})};
}

void StartFigureBuilder::addTitles()
{
    const std::string legend =
        text(QT_TRANSLATE_NOOP("Report", "Faint: marginal or unknown weather. Hatched: no-go."));
    const std::string best =
        m_scan.best ? text(QT_TRANSLATE_NOOP("Report", "Best start: %1 UTC."),
                           {minuteText(m_first, m_scan.starts[*m_scan.best].delay_s)})
                    : text(QT_TRANSLATE_NOOP("Report", "No start has weather within all limits."));
    m_figure.rightTitles = {best + "  " + legend, best};
    m_figure.description = best;
}

std::vector<std::string> StartFigureBuilder::readout(const StartOutcome& start) const
{
    std::vector<std::string> lines{minuteText(m_first, start.delay_s) + " UTC"};
    lines.push_back(start.zeta_m2s ? text(QT_TRANSLATE_NOOP("Report", "ζ %1 m² s"),
                                          {m_format.study.zeta(*start.zeta_m2s)})
                                   : text(QT_TRANSLATE_NOOP("Report", "cannot be flown")));
    lines.push_back(text(QT_TRANSLATE_NOOP("Report", "weather: %1"),
                         {text(weatherWords(start.weather.state()))}));
    if (const std::optional<std::size_t> worst = start.weather.worstUav()) {
        const WeatherReason& reason = *start.weather.uavs[*worst].reason;
        lines.push_back(m_scan.uavs.at(*worst) + ": " + m_format.reason(reason));
    }
    return lines;
}

void StartFigureBuilder::addStart(std::size_t index)
{
    constexpr double kFaintBar = 0.55;
    constexpr double kHatchedBar = 0.7;
    const StartOutcome& start = m_scan.starts[index];
    const WeatherState state = start.weather.state();
    const double top = start.zeta_m2s.value_or(0);
    const double x = start.delay_s;
    m_figure.items.push_back({.id = index, .at = {x, top}, .readout = readout(start)});
    std::string tip;
    for (const std::string& line : m_figure.items.back().readout)
        tip += (tip.empty() ? "" : ", ") + line;
    const Ink ink = inkOf(state);
    if (!start.zeta_m2s) {
        m_figure.marks.push_back(
            {.at = {x, 0, 0, -6}, .radius_px = 3, .ink = ink, .isHollow = true, .tip = tip});
        return;
    }
    double opacity = 1;
    if (state == WeatherState::NoGo)
        opacity = kHatchedBar;
    else if (state != WeatherState::Go)
        opacity = kFaintBar;
    m_figure.areas.push_back({.outline = {{x, 0, -m_half_px},
                                          {x, top, -m_half_px},
                                          {x, top, m_half_px},
                                          {x, 0, m_half_px}},
                              .ink = ink,
                              .isHatched = state == WeatherState::NoGo,
                              .opacity = opacity,
                              .key = std::string(nameOf(state)),
                              .tip = std::move(tip)});
    if (m_scan.best == index)
        m_figure.marks.push_back({.at = {x, top, 0, -8},
                                  .radius_px = 4.5,
                                  .ink = {.of = InkOf::Text},
                                  .shape = MarkShape::TriangleDown});
}

Figure StartFigureBuilder::figure()
{
    m_figure.name = text(QT_TRANSLATE_NOOP("Report", "Zeta by start time"));
    addAxes();
    addTitles();
    for (std::size_t i = 0; i < m_scan.starts.size(); ++i)
        addStart(i);
    return std::move(m_figure);
}

} // namespace

std::string StartFigureFormat::defaultReason(const WeatherReason& reason)
{
    return reasonText(reason);
}

std::string_view weatherWords(WeatherState state)
{
    switch (state) {
    case WeatherState::Go:
        return QT_TRANSLATE_NOOP("Report", "go");
    case WeatherState::Marginal:
        return QT_TRANSLATE_NOOP("Report", "marginal");
    case WeatherState::Unknown:
        return QT_TRANSLATE_NOOP("Report", "not known");
    case WeatherState::NoGo:
        break;
    }
    return QT_TRANSLATE_NOOP("Report", "no-go");
}

Figure startFigure(const StartScan& scan, const StartFigureFormat& format)
{
    if (scan.starts.empty())
        return {};
    return StartFigureBuilder(scan, format).figure();
}

} // namespace berg
