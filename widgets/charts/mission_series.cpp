#include "widgets/charts/mission_series.h"

#include "core/base/number_text.h"
#include "core/io/results/result_csv.h"
#include "widgets/theme/quantity_text.h"

#include <QCoreApplication>

#include <algorithm>

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

} // namespace

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
        const QString unit = line.role == LineRole::Sigma ? u"_sigma_m2"_s : QString();
        text += ',' + csvField((line.key + unit).toStdString());
    }
    text += '\n';
    std::vector<std::size_t> next(content.lines.size(), 0);
    for (const double time_s : m_times_s) {
        appendNumber(text, time_s);
        for (std::size_t i = 0; i < content.lines.size(); ++i) {
            text += ',';
            if (const auto own = pointAt(content.lines[i].points, time_s))
                appendNumber(text, own->y());
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
    CellSheet values{.titles = {MissionSeriesText::tr("Time")},
                     .rows = static_cast<int>(m_times_s.size()),
                     .text = {}};
    std::vector<std::vector<QPointF>> lines;
    std::vector<QList<QPointF>> own;
    for (std::size_t i = 0; i < content.lines.size(); ++i) {
        values.titles << headerOf(content.lines[i]);
        lines.push_back(m_lines[i].points());
        own.push_back(content.lines[i].points);
    }
    values.text = [clock = content.clock, times_s = m_times_s, lines = std::move(lines),
                   own = std::move(own), locale](int row, int column) {
        const double time_s = times_s[static_cast<std::size_t>(row)];
        if (column == 0)
            return clock.text(time_s);
        if (const auto at = pointAt(own[static_cast<std::size_t>(column - 1)], time_s))
            return significantText(at->y(), kDigits, locale);
        const std::vector<QPointF>& line = lines[static_cast<std::size_t>(column - 1)];
        const auto at = std::lower_bound(line.begin(), line.end(), time_s,
                                         [](const QPointF& p, double x_s) { return p.x() < x_s; });
        return at != line.end() && at->x() == time_s ? significantText(at->y(), kDigits, locale)
                                                     : QString();
    };
    return values;
}

} // namespace berg
