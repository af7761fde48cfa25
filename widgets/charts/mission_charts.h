#pragma once

#include "widgets/charts/time_chart.h"
#include "widgets/model/flight_record.h"

#include <QLocale>

#include <array>

namespace berg {

/** What of a mission a chart shows over time. */
enum class ChartKind
{
    Zeta,       ///< zeta and the sum of sigma, with an asset that by priority too
    MeanSigma,  ///< sum of sigma, which is the rate of zeta (Eq. (24)), and its mean since take-off
    Sigma,      ///< of each iceberg
    Distance,   ///< through the air; of several UAVs in all, and of each
    TurnRate,   ///< of each UAV, with its limits
    CrossTrack, ///< error of the path following, of each UAV
};
inline constexpr std::array kChartKinds = {ChartKind::Zeta,     ChartKind::MeanSigma,
                                           ChartKind::Sigma,    ChartKind::Distance,
                                           ChartKind::TurnRate, ChartKind::CrossTrack};

/** The instant of take-off alone is no line yet. */
[[nodiscard]] bool hasFlown(const FlightRecord& record);

/** In lists of charts. */
[[nodiscard]] QString chartKindName(ChartKind kind);
/** In names of files, ASCII: "zeta". */
[[nodiscard]] QString chartFileStem(ChartKind kind);

/**
 * Everything but the points, which `chartValue` has: titles, lines with their names and columns,
 * limits, visits as marks. No lines when nothing has been flown. The bound of zeta, the last line
 * of its chart when it is known, comes with its points, over the whole run.
 */
[[nodiscard]] TimeChartContent emptyChart(ChartKind kind, const FlightRecord& record,
                                          const QLocale& locale);

/** What line `line` of `emptyChart` shows at sample `row`, unit of its axis; none: no point. */
[[nodiscard]] std::optional<double> chartValue(ChartKind kind, const FlightRecord& record,
                                               std::size_t row, std::size_t line);

/** The whole chart with a point for every sample. Cost: linear in the record. */
[[nodiscard]] TimeChartContent missionChart(ChartKind kind, const FlightRecord& record,
                                            const QLocale& locale);

} // namespace berg
