#include "widgets/charts/mission_series.h"

#include "core/base/number_text.h"
#include "core/io/results/result_csv.h"
#include "widgets/charts/weather_chart.h"
#include "widgets/document/wind.h"
#include "widgets/theme/quantity_text.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <memory>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

struct MissionSeriesText
{
    Q_DECLARE_TR_FUNCTIONS(MissionSeriesText)
};

/** Column title with name and unit. */
QString headerOf(const TimeLine& line)
{
    return line.unit.isEmpty() ? line.shownName() : u"%1, %2"_s.arg(line.shownName(), line.unit);
}

/** Appends the field of a direction, in degrees to one decimal, behind a line that has one. */
void appendDirection(std::string& text, const TimeChartContent& content, LineRole role,
                     double time_s)
{
    const bool isWind = role == LineRole::Wind;
    if (!isWind && role != LineRole::Current)
        return;
    text += ',';
    const TimeDirections& directions = content.directions;
    if (const auto velocity_mps =
            velocityAt_mps(isWind ? directions.wind : directions.current, time_s);
        velocity_mps && !velocity_mps->isZero(0))
        appendNumber(text,
                     std::round(10 * windFrom_deg(isWind ? *velocity_mps : -*velocity_mps)) / 10);
}

/** Value at a time of the points of a line of the content, or of its parts after gaps. */
std::optional<double> ownValue(const std::vector<TimeLine>& lines, std::size_t line, double time_s)
{
    std::size_t part = line;
    do {
        if (const auto own = pointAt(lines[part].points, time_s))
            return own->y();
    } while (++part < lines.size() && lines[part].isContinued);
    return std::nullopt;
}

} // namespace

/** Times of the table's rows: those of the samples, or of the weather. */
std::vector<double> MissionSeries::rowTimes_s(const TimeChartContent& content) const
{
    if (m_kind != ChartKind::Weather)
        return m_times_s;
    std::vector<double> times_s;
    for (const TimeLine& line : content.lines)
        for (const QPointF& point : line.points)
            times_s.push_back(point.x());
    std::ranges::sort(times_s);
    times_s.erase(std::unique(times_s.begin(), times_s.end()), times_s.end());
    return times_s;
}

bool MissionSeries::isContinuedBy(const FlightRecord& record) const
{
    const std::vector<Sample>& samples = record.history.samples;
    const std::size_t known = m_times_s.size();
    return m_generation == record.now.generation && m_rewrites == record.history.rewrites &&
           known <= samples.size() && (known == 0 || samples[known - 1].time_s == m_times_s.back());
}

void MissionSeries::update(const FlightRecord& record, std::size_t lines)
{
    const std::vector<Sample>& samples = record.history.samples;
    if (!isContinuedBy(record)) {
        m_times_s.clear();
        m_lines.clear();
    }
    m_generation = record.now.generation;
    m_rewrites = record.history.rewrites;
    m_lines.resize(std::max(m_lines.size(), lines));
    if (lines == 0)
        return; // before the flight: the first sample is added with the second
    for (std::size_t row = m_times_s.size(); row < samples.size(); ++row) {
        m_times_s.push_back(samples[row].time_s);
        for (std::size_t i = 0; i < lines; ++i)
            if (const std::optional<double> value = chartValue(m_kind, record, row, i))
                m_lines[i].append({samples[row].time_s, *value});
    }
}

void MissionSeries::fill(TimeChartContent& content, const DecimationWindow& window) const
{
    content.isThinned = true;
    for (std::size_t i = 0; i < std::min(content.lines.size(), m_lines.size()); ++i) {
        TimeLine& line = content.lines[i];
        if (!line.hidden)
            line.points =
                line.points.empty() ? m_lines[i].thinned(window) : decimate(line.points, window);
    }
}

std::string MissionSeries::csv(const TimeChartContent& content) const
{
    std::string text = "time_s";
    for (const TimeLine& line : content.lines) {
        if (line.isContinued)
            continue;
        const QString unit = line.role == LineRole::Sigma ? u"_sigma_m2"_s : QString();
        text += ',' + csvField((line.key + unit).toStdString());
        if (line.role == LineRole::Wind)
            text += ",wind_from_deg";
        if (line.role == LineRole::Current)
            text += ",current_towards_deg";
    }
    text += '\n';
    std::vector<std::size_t> next(content.lines.size(), 0);
    for (const double time_s : rowTimes_s(content)) {
        appendNumber(text, time_s);
        for (std::size_t i = 0; i < content.lines.size(); ++i) {
            if (content.lines[i].isContinued)
                continue;
            text += ',';
            if (const auto own = ownValue(content.lines, i, time_s))
                appendNumber(text, *own);
            appendDirection(text, content, content.lines[i].role, time_s);
            const std::vector<QPointF>& points = m_lines[i].points();
            if (next[i] < points.size() && points[next[i]].x() == time_s)
                appendNumber(text, points[next[i]++].y());
        }
        text += '\n';
    }
    return text;
}

CellSheet MissionSeries::values(const TimeChartContent& content, const QLocale& locale) const
{
    constexpr int kDigits = 4;
    const auto times_s = std::make_shared<const std::vector<double>>(rowTimes_s(content));
    const auto lines = std::make_shared<const std::vector<TimeLine>>(content.lines);
    const auto directions = std::make_shared<const TimeDirections>(content.directions);
    const auto timeOf_s = [times_s](int row) { return (*times_s)[static_cast<std::size_t>(row)]; };
    CellSheet values{.columns = {{.title = MissionSeriesText::tr("Time"),
                                  .text = [clock = content.clock, timeOf_s](
                                              int row) { return clock.text(timeOf_s(row)); }}},
                     .rows = static_cast<int>(times_s->size())};
    for (std::size_t i = 0; i < content.lines.size(); ++i) {
        if (content.lines[i].isContinued)
            continue;
        const auto text = [timeOf_s, line = m_lines[i].points(), lines, directions, i,
                           locale](int row) {
            const double time_s = timeOf_s(row);
            if (const auto own = ownValue(*lines, i, time_s))
                return (significantText(*own, kDigits, locale) + u' ' +
                        directions->textAt((*lines)[i].role, time_s))
                    .trimmed();
            const auto at = std::ranges::lower_bound(line, time_s, {}, &QPointF::x);
            return at != line.end() && at->x() == time_s ? significantText(at->y(), kDigits, locale)
                                                         : QString();
        };
        values.columns.push_back({.title = headerOf(content.lines[i]), .text = text});
    }
    return values;
}

} // namespace berg
