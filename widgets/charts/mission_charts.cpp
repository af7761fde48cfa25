#include "widgets/charts/mission_charts.h"

#include "widgets/map/mission_picture.h"
#include "widgets/theme/quantity_text.h"

#include <QCoreApplication>

namespace berg {
namespace {

struct MissionCharts
{
    Q_DECLARE_TR_FUNCTIONS(MissionCharts)
};

std::vector<double> visitTimes_s(const FlightRecord& record)
{
    std::vector<double> times_s;
    for (const MissionEvent& event : record.now.events)
        if (event.kind == EventKind::Reached)
            times_s.push_back(event.time_s);
    return times_s;
}

TimeChartContent commonContent(const FlightRecord& record)
{
    TimeChartContent content;
    content.duration_s = record.now.time_s;
    content.emptyText = MissionCharts::tr("Nothing flown yet");
    return content;
}

} // namespace

TimeChartContent zetaContent(const FlightRecord& record, const QLocale& locale)
{
    TimeChartContent content = commonContent(record);
    content.title = MissionCharts::tr("Uncertainty now and accumulated");
    content.leftTitle = MissionCharts::tr("Sum of σ, m²");
    content.marks_s = visitTimes_s(record);
    content.marksTitle = MissionCharts::tr("iceberg reached");
    content.rightTitle = MissionCharts::tr("Zeta ζ, m² s");
    TimeLine sum{.label = MissionCharts::tr("Sum of σ"), .points = {}, .role = LineRole::Momentary};
    TimeLine zeta{.label = MissionCharts::tr("Zeta %1 m² s")
                               .arg(significantText(record.now.metrics.zeta_m2s, 4, locale)),
                  .points = {},
                  .role = LineRole::Accumulated,
                  .onRightAxis = true};
    for (const Sample& sample : record.samples) {
        sum.points.emplace_back(sample.time_s, sample.sigmaSum_m2);
        zeta.points.emplace_back(sample.time_s, sample.zeta_m2s);
    }
    content.lines = {std::move(zeta), std::move(sum)};
    return content;
}

TimeChartContent sigmaContent(const FlightRecord& record, const QLocale& /*locale*/)
{
    TimeChartContent content = commonContent(record);
    content.title = MissionCharts::tr("Uncertainty of each iceberg");
    content.leftTitle = MissionCharts::tr("σ, m²");
    content.sigmaFull_m2 = sigmaScaleEnd_m2(record);
    for (const Iceberg& iceberg : record.now.icebergs)
        content.lines.push_back(
            {.label = QString::fromStdString(iceberg.name.empty() ? iceberg.id : iceberg.name),
             .points = {},
             .role = LineRole::Sigma});
    for (std::size_t row = 0; row < record.rows.size(); ++row)
        for (std::size_t i = 0; i < record.rows[row].size(); ++i)
            content.lines[i].points.emplace_back(record.samples[row].time_s,
                                                 record.rows[row][i].sigma_m2);
    return content;
}

} // namespace berg
