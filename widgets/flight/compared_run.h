#pragma once

#include "core/mission/revisit_intervals.h"
#include "widgets/flight/flight_record.h"

#include <QLocale>
#include <QString>

#include <optional>

namespace berg {

/** Stored result of a flown run, for comparison with others. */
struct ComparedRun
{
    Scenario scenario;       ///< scenario with the planner settings at take-off
    PlannerSettings planner; ///< settings at the end of the run
    bool wasChanged = false; ///< whether the planner, an assignment or an order changed in flight
    /** Changes in flight of wind, asset and icebergs (added or removed). */
    std::vector<Intervention> worldChanges;
    QString name;                 ///< name given by the user; may be empty
    QString file;                 ///< run file it was opened from; empty if flown here
    Metrics metrics;              ///< values at the end
    double flown_s = 0;           ///< flown time, s
    std::vector<Sample> samples;  ///< samples up to `flown_s`
    std::vector<double> visits_s; ///< times at which a target was reached, s
    std::vector<std::vector<double>> uavVisits_s; ///< visit times of each UAV, s
    std::vector<double> plans_s; ///< times of the plans, s; one solve for several UAVs counts once
    std::vector<Iceberg> icebergs; ///< all icebergs; those added in flight come last
    std::vector<std::vector<UnseenInterval>> unseen; ///< intervals out of view, by iceberg
};

/** Summarises what has been flown so far. Cost: linear in the record. */
[[nodiscard]] ComparedRun comparedRun(const FlightRecord& record);

/**
 * Returns the user's name of a run, else a text that distinguishes runs of one scenario: "τ 1.00",
 * "Round tour", "τ 1.00, changed in flight, to 05:00".
 */
[[nodiscard]] QString runName(const ComparedRun& run, const QLocale& locale);

/**
 * Returns whether two scenarios are equal except for name, notes and planner, so that runs of them
 * can be compared.
 */
[[nodiscard]] bool isSameWorld(const ScenarioWorld& a, const ScenarioWorld& b);
/**
 * Returns whether two runs share the world and had the same changes in flight at the same times.
 */
[[nodiscard]] bool isComparable(const ComparedRun& a, const ComparedRun& b);
/** Returns whether settings are equal; tau is ignored if the policy does not use it. */
[[nodiscard]] bool isSamePlanner(const PlannerSettings& a, const PlannerSettings& b);
/**
 * Returns whether two runs are comparable, have equal settings and flown time, and gave the same
 * result.
 */
[[nodiscard]] bool isSameRun(const ComparedRun& a, const ComparedRun& b);

/** Totals of one UAV. */
struct UavTotals
{
    int visits = 0;
    double flown_m = 0; ///< distance flown through the air, m
};

/** Figures of a run up to one instant. */
struct RunFigures
{
    double zeta_m2s = 0;
    double meanSigmaSum_m2 = 0; ///< mean over time, i.e. zeta divided by the flown time
    int visits = 0;
    int plans = 0;
    double flown_m = 0;
    std::vector<UavTotals> uavs;    ///< totals of each UAV
    std::vector<UnseenTime> unseen; ///< time out of view of each iceberg
    /** Index of the iceberg that was out of view longest; nullopt if all were always in view. */
    std::optional<std::size_t> longestUnseen;
};

/**
 * Returns the figures at `until_s`, which is at most `flown_s`. Sums are interpolated between
 * samples.
 */
[[nodiscard]] RunFigures figuresAt(const ComparedRun& run, double until_s);

} // namespace berg
