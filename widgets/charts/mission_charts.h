#pragma once

#include "widgets/charts/time_chart.h"
#include "widgets/flight/flight_record.h"

#include <QLocale>

#include <array>

namespace berg {

/** Quantity of a mission shown over time. */
enum class ChartKind
{
    Zeta,       ///< zeta and the sum of sigma; with an asset also the weighted sum
    MeanSigma,  ///< sum of sigma, the rate of zeta (Eq. (24)), and its mean since take-off
    Sigma,      ///< sigma of each iceberg
    Distance,   ///< distance through the air, total and per UAV
    TurnRate,   ///< turn rate of each UAV, with its limits
    CrossTrack, ///< path following error of each UAV
    Weather,    ///< wind, gusts and current over the whole run
};
/** All kinds, in their order. */
inline constexpr std::array kChartKinds = {
    ChartKind::Zeta,     ChartKind::MeanSigma,  ChartKind::Sigma,  ChartKind::Distance,
    ChartKind::TurnRate, ChartKind::CrossTrack, ChartKind::Weather};

/** Returns whether the record has more than the instant of take-off. */
[[nodiscard]] bool hasFlown(const FlightRecord& record);

/** Translated name of a chart. */
[[nodiscard]] QString chartKindName(ChartKind kind);
/** ASCII part of file names, for example "zeta". */
[[nodiscard]] QString chartFileStem(ChartKind kind);

/**
 * Chart without points, which `chartValue` supplies: titles, lines with names and columns, limits,
 * visits as marks. There are no lines before the flight, except those of the weather. The lower
 * bound on zeta, if known, is the last line. It and the lines of the weather have their points,
 * over the whole run.
 */
[[nodiscard]] TimeChartContent emptyChart(ChartKind kind, const FlightRecord& record,
                                          const QLocale& locale);

/** Value of line `line` of `emptyChart` at sample `row`, unit of its axis; nullopt if none. */
[[nodiscard]] std::optional<double> chartValue(ChartKind kind, const FlightRecord& record,
                                               std::size_t row, std::size_t line);

/** Complete chart with a point for every sample. Cost: linear in the record. */
[[nodiscard]] TimeChartContent missionChart(ChartKind kind, const FlightRecord& record,
                                            const QLocale& locale);

} // namespace berg
