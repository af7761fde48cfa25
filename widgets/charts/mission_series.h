#pragma once

#include "widgets/charts/mission_charts.h"
#include "widgets/charts/time_series.h"
#include "widgets/tables/cell_model.h"

#include <string>

namespace berg {

/**
 * Points of one chart of a mission in progress. It only adds new samples of the record, and starts
 * again if the record was replaced or its known end was revised.
 */
class MissionSeries
{
public:
    explicit MissionSeries(ChartKind kind) : m_kind(kind) {}

    [[nodiscard]] ChartKind kind() const { return m_kind; }

    /** Returns whether the record extends the samples added so far. */
    [[nodiscard]] bool isContinuedBy(const FlightRecord& record) const;

    /** Adds new samples for `lines` lines of `emptyChart`. Cost: linear in new samples. */
    void update(const FlightRecord& record, std::size_t lines);

    /** Sets the points of `content`, from `emptyChart`, in this window, thinned. */
    void fill(TimeChartContent& content, const DecimationWindow& window) const;

    /**
     * Table of all samples as CSV: RFC 4180, UTF-8, '.' decimals, a header row with units, time
     * first; a missing value is an empty field. `content` names the columns.
     */
    [[nodiscard]] std::string csv(const TimeChartContent& content) const;

    /** Table of all samples for display. */
    [[nodiscard]] CellSheet values(const TimeChartContent& content, const QLocale& locale) const;

private:
    [[nodiscard]] std::vector<double> rowTimes_s(const TimeChartContent& content) const;

    ChartKind m_kind;
    std::uint64_t m_generation = 0;
    std::uint64_t m_rewrites = 0;
    std::vector<double> m_times_s;
    std::vector<TimeSeries> m_lines;
};

} // namespace berg
