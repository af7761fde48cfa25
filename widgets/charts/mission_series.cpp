#include "widgets/charts/mission_series.h"

#include "core/base/number_text.h"
#include "core/io/results/result_csv.h"
#include "widgets/theme/quantity_text.h"

#include <QCoreApplication>

#include <algorithm>
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
    const auto times_s = std::make_shared<const std::vector<double>>(m_times_s);
    const auto timeOf_s = [times_s](int row) { return (*times_s)[static_cast<std::size_t>(row)]; };
    CellSheet values{.columns = {{.title = MissionSeriesText::tr("Time"),
                                  .text = [clock = content.clock, timeOf_s](
                                              int row) { return clock.text(timeOf_s(row)); }}},
                     .rows = static_cast<int>(m_times_s.size())};
    for (std::size_t i = 0; i < content.lines.size(); ++i) {
        const auto text = [timeOf_s, line = m_lines[i].points(), own = content.lines[i].points,
                           locale](int row) {
            const double time_s = timeOf_s(row);
            if (const auto at = pointAt(own, time_s))
                return significantText(at->y(), kDigits, locale);
            const auto at = std::ranges::lower_bound(line, time_s, {}, &QPointF::x);
            return at != line.end() && at->x() == time_s ? significantText(at->y(), kDigits, locale)
                                                         : QString();
        };
        values.columns.push_back({.title = headerOf(content.lines[i]), .text = text});
    }
    return values;
}

} // namespace berg
