#include "widgets/charts/mission_charts.h"

#include "widgets/charts/uav_charts.h"
#include "widgets/charts/weather_chart.h"
#include "widgets/flight/sigma_end.h"
#include "widgets/theme/quantity_text.h"
#include "widgets/words/object_names.h"

#include <QCoreApplication>

#include <algorithm>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

struct MissionCharts
{
    Q_DECLARE_TR_FUNCTIONS(MissionCharts)
};

struct ChartKindNames
{
    const char* inLists; ///< English text
    const char* inFiles;
};

constexpr std::array<ChartKindNames, kChartKinds.size()> kKindNames{{
    // in the order of `ChartKind`
    {QT_TRANSLATE_NOOP("MissionCharts", "Zeta and sum of σ"), "zeta"},
    {QT_TRANSLATE_NOOP("MissionCharts", "Rate of zeta"), "zeta-rate"},
    {QT_TRANSLATE_NOOP("MissionCharts", "σ of each iceberg"), "sigma"},
    {QT_TRANSLATE_NOOP("MissionCharts", "Distance flown"), "distance"},
    {QT_TRANSLATE_NOOP("MissionCharts", "Turn rate"), "turn-rate"},
    {QT_TRANSLATE_NOOP("MissionCharts", "Cross-track error"), "cross-track"},
    {QT_TRANSLATE_NOOP("MissionCharts", "Wind and current"), "weather"},
}};

std::vector<double> visitTimes_s(const FlightRecord& record)
{
    std::vector<double> times_s;
    for (const MissionEvent& event : record.history.events)
        if (event.kind == EventKind::Reached)
            times_s.push_back(event.time_s);
    return times_s;
}

QString squareMetres()
{
    return MissionCharts::tr("m²");
}

QString squareMetreSeconds()
{
    return MissionCharts::tr("m² s");
}

TimeLine sumOfSigma()
{
    return {.label = MissionCharts::tr("Sum of σ"),
            .points = {},
            .role = LineRole::Momentary,
            .unit = squareMetres(),
            .key = u"sigma_sum_m2"_s};
}

constexpr std::size_t kWeightedLine = 2; // index in the chart of zeta, with an asset

bool hasAsset(const FlightRecord& record)
{
    return record.now.asset.has_value();
}

/** Line of the planning objective; zeta remains the integral of the unweighted sum. */
TimeLine weightedSum()
{
    return {.label = MissionCharts::tr("Weighted"),
            .points = {},
            .role = LineRole::Weighted,
            .name = MissionCharts::tr("Weighted by priority"),
            .unit = squareMetres(),
            .key = u"weighted_sum_m2"_s};
}

std::optional<TimeLine> boundOfZeta(const FlightRecord& record)
{
    const KnownBound bound = record.boundOfFlight();
    const double time_s = record.shown().time_s;
    const bool isUseless =
        bound.whole && record.isOver() &&
        !isUsefulBound(bound.whole->by_m2s(time_s), record.shown().metrics.zeta_m2s);
    if (!bound.whole || !bound.zeta_m2s || isUseless)
        return std::nullopt;
    TimeLine line{.label = MissionCharts::tr("Lower bound on ζ"),
                  .points = {},
                  .role = LineRole::Bound,
                  .onRightAxis = true,
                  .unit = squareMetreSeconds(),
                  .key = u"zeta_bound_m2s"_s};
    for (const BoundPoint& point : bound.whole->curve)
        line.points.emplace_back(point.time_s, point.zeta_m2s);
    return line;
}

QString atTime(const FlightRecord& record)
{
    return clockOf(record.scenario).text(record.now.time_s);
}

void fillZeta(TimeChartContent& content, const FlightRecord& record, const QLocale& locale)
{
    content.title = MissionCharts::tr("Uncertainty now and accumulated");
    content.leftTitle = MissionCharts::tr("Sum of σ, m²");
    content.rightTitle = MissionCharts::tr("Zeta ζ, %1");
    if (!hasFlown(record))
        return;
    const QString zeta = zetaText(record.shown().metrics.zeta_m2s, locale);
    content.lines.push_back({.label = MissionCharts::tr("Zeta %1").arg(zeta),
                             .points = {},
                             .role = LineRole::Accumulated,
                             .onRightAxis = true,
                             .name = MissionCharts::tr("Zeta"),
                             .unit = squareMetreSeconds(),
                             .key = u"zeta_m2s"_s});
    content.lines.push_back(sumOfSigma());
    if (hasAsset(record))
        content.lines.push_back(weightedSum());
    if (std::optional<TimeLine> bound = boundOfZeta(record))
        content.lines.push_back(*std::move(bound));
    const Sample& last = record.history.samples.back();
    content.summary = MissionCharts::tr("At %1 zeta is %2 and the sum of σ %3 m².")
                          .arg(atTime(record), zetaText(last.zeta_m2s, locale),
                               significantText(last.sigmaSum_m2, 3, locale));
    if (hasAsset(record))
        content.summary += u' ' + MissionCharts::tr("Weighted by priority the sum is %1 m².")
                                      .arg(significantText(last.weightedSum_m2, 3, locale));
}

double meanSigma_m2(const Sample& sample)
{
    return sample.time_s > 0 ? sample.zeta_m2s / sample.time_s : sample.sigmaSum_m2;
}

void fillMeanSigma(TimeChartContent& content, const FlightRecord& record, const QLocale& locale)
{
    content.title = MissionCharts::tr("Rate of zeta, now and on average");
    content.leftTitle = MissionCharts::tr("Sum of σ = dζ/dt, m²");
    if (!hasFlown(record))
        return;
    content.lines.push_back({.label = MissionCharts::tr("Mean since take-off"),
                             .points = {},
                             .role = LineRole::Accumulated,
                             .name = MissionCharts::tr("Mean"),
                             .unit = squareMetres(),
                             .key = u"mean_sigma_sum_m2"_s});
    content.lines.push_back(sumOfSigma());
    content.lines.back().label = MissionCharts::tr("Now");
    const Sample& last = record.history.samples.back();
    content.summary = MissionCharts::tr("At %1 zeta grows by %2 m² s per second; the mean since "
                                        "take-off is %3.")
                          .arg(atTime(record), significantText(last.sigmaSum_m2, 3, locale),
                               significantText(meanSigma_m2(last), 3, locale));
}

void fillSigma(TimeChartContent& content, const FlightRecord& record, const QLocale& locale)
{
    content.title = MissionCharts::tr("Uncertainty of each iceberg");
    content.leftTitle = MissionCharts::tr("σ, m²");
    content.sigmaFull_m2 = sigmaEnd_m2(record.scenario);
    if (!hasFlown(record))
        return;
    for (const Iceberg& iceberg : record.now.icebergs)
        content.lines.push_back({.label = shownName(iceberg),
                                 .points = {},
                                 .role = LineRole::Sigma,
                                 .unit = squareMetres(),
                                 .key = QString::fromStdString(iceberg.id)});
    const std::vector<IcebergSample>& last = record.history.rows.back();
    const auto most = std::max_element(last.begin(), last.end(), [](const auto& a, const auto& b) {
        return (a.active ? a.sigma_m2 : -1) < (b.active ? b.sigma_m2 : -1);
    });
    if (most == last.end() || !most->active)
        return;
    const auto inView = std::count_if(last.begin(), last.end(), [](const IcebergSample& iceberg) {
        return iceberg.active && iceberg.inView;
    });
    content.summary =
        MissionCharts::tr("At %1 the most uncertain iceberg is %2: %3; %n in view.", nullptr,
                          static_cast<int>(inView))
            .arg(atTime(record), content.lines[static_cast<std::size_t>(most - last.begin())].label,
                 uncertaintyText(most->sigma_m2, locale));
}

} // namespace

bool hasFlown(const FlightRecord& record)
{
    return record.history.samples.size() > 1;
}

QString chartKindName(ChartKind kind)
{
    return MissionCharts::tr(kKindNames[static_cast<std::size_t>(kind)].inLists);
}

QString chartFileStem(ChartKind kind)
{
    return QString::fromLatin1(kKindNames[static_cast<std::size_t>(kind)].inFiles);
}

TimeChartContent emptyChart(ChartKind kind, const FlightRecord& record, const QLocale& locale)
{
    TimeChartContent content;
    content.duration_s = record.now.time_s;
    content.clock = clockOf(record.scenario);
    if (record.instant)
        content.cursor_s = record.instant->time_s;
    content.emptyText = MissionCharts::tr("Nothing flown yet. Press Space to fly the plan");
    // Sigma drops to zero at each visit, so marks would repeat that.
    if (kind != ChartKind::Sigma) {
        content.marks_s = visitTimes_s(record);
        content.marksTitle = MissionCharts::tr("iceberg reached");
    }
    switch (kind) {
    case ChartKind::Zeta:
        fillZeta(content, record, locale);
        break;
    case ChartKind::MeanSigma:
        fillMeanSigma(content, record, locale);
        break;
    case ChartKind::Sigma:
        fillSigma(content, record, locale);
        break;
    case ChartKind::Distance:
        fillDistance(content, record, locale);
        break;
    case ChartKind::TurnRate:
        fillTurnRate(content, record, locale);
        break;
    case ChartKind::CrossTrack:
        fillCrossTrack(content, record, locale);
        break;
    case ChartKind::Weather:
        fillWeather(content, record, locale);
        break;
    }
    return content;
}

std::optional<double> chartValue(ChartKind kind, const FlightRecord& record, std::size_t row,
                                 std::size_t line)
{
    const Sample& sample = record.history.samples[row];
    const bool isFirst = line == 0;
    switch (kind) {
    case ChartKind::Zeta:
        if (line == kWeightedLine && hasAsset(record))
            return sample.weightedSum_m2;
        if (line > 1) // the bound has its own points
            return std::nullopt;
        return isFirst ? sample.zeta_m2s : sample.sigmaSum_m2;
    case ChartKind::MeanSigma:
        return isFirst ? meanSigma_m2(sample) : sample.sigmaSum_m2;
    case ChartKind::Sigma: {
        const std::vector<IcebergSample>& icebergs = record.history.rows[row];
        if (line >= icebergs.size() || !icebergs[line].active)
            return std::nullopt;
        return icebergs[line].sigma_m2;
    }
    case ChartKind::Distance:
    case ChartKind::TurnRate:
    case ChartKind::CrossTrack:
        return uavChartValue(kind, sample, line);
    case ChartKind::Weather: // has its own points
        return std::nullopt;
    }
    return std::nullopt;
}

TimeChartContent missionChart(ChartKind kind, const FlightRecord& record, const QLocale& locale)
{
    TimeChartContent content = emptyChart(kind, record, locale);
    for (std::size_t row = 0; row < record.history.samples.size(); ++row)
        for (std::size_t i = 0; i < content.lines.size(); ++i)
            if (const std::optional<double> value = chartValue(kind, record, row, i))
                content.lines[i].points.emplace_back(record.history.samples[row].time_s, *value);
    return content;
}

} // namespace berg
