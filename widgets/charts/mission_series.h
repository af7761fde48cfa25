#pragma once

#include "widgets/charts/mission_charts.h"
#include "widgets/charts/time_series.h"
#include "widgets/model/cell_model.h"

#include <string>

namespace berg {

/**
 * The points of one chart of a mission that is being flown: takes from the record what is new, and
 * starts anew when the record does or when an end that was known is given up.
 */
class MissionSeries
{
public:
    explicit MissionSeries(ChartKind kind) : m_kind(kind) {}

    [[nodiscard]] ChartKind kind() const { return m_kind; }

    /** Whether the record holds what was taken and perhaps more. */
    [[nodiscard]] bool isContinuedBy(const FlightRecord& record) const;

    /** For `lines` lines, those of `emptyChart`. Cost: linear in the samples that are new. */
    void update(const FlightRecord& record, std::size_t lines);

    /** `content` of `emptyChart` with all points of that stretch of time, thinned. */
    void fill(TimeChartContent& content, const DecimationWindow& window) const;

    /**
     * Every sample as a table: RFC 4180, UTF-8, '.' decimals, a header row with units, the time
     * first; no value: an empty field. `content` names the columns.
     */
    [[nodiscard]] std::string csv(const TimeChartContent& content) const;

    /** The same to be read on screen. */
    [[nodiscard]] CellSheet values(const TimeChartContent& content, const QLocale& locale) const;

private:
    ChartKind m_kind;
    std::uint64_t m_generation = 0;
    std::uint64_t m_rewrites = 0;
    std::vector<double> m_times_s;
    std::vector<TimeSeries> m_lines;
};

} // namespace berg
