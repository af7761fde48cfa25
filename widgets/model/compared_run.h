#pragma once

#include "core/sim/unseen.h"
#include "widgets/model/flight_record.h"

#include <QLocale>
#include <QString>

namespace berg {

/** What is kept of a run that was flown, to be set beside others. */
struct ComparedRun
{
    Scenario scenario;                      ///< as flown, with the planner chosen at take-off
    PlannerSettings planner;                ///< at the end
    bool wasChanged = false;                ///< tau or policy, in flight
    std::vector<Intervention> worldChanges; ///< in flight: wind, asset, icebergs added and removed
    QString name;                           ///< given by the user; empty: none
    QString file;                           ///< it was opened from; empty: flown here
    Metrics metrics;                        ///< at the end
    double flown_s = 0;                     ///< up to here
    std::vector<Sample> samples;            ///< the last one at `flown_s`
    std::vector<double> visits_s;           ///< when a target was reached
    std::vector<std::vector<double>> uavVisits_s; ///< the same by UAV
    std::vector<double> plans_s;   ///< when a plan was made, of several UAVs one for all
    std::vector<Iceberg> icebergs; ///< those added in flight at the end
    std::vector<std::vector<UnseenInterval>> unseen; ///< by iceberg
};

/** Of what has been flown so far. Cost: linear in the record. */
[[nodiscard]] ComparedRun comparedRun(const FlightRecord& record);

/** As the user has named it, else what tells runs of a scenario apart: "τ 1.00", "Round tour", "τ
 * 1.00, changed in flight, to 05:00". */
[[nodiscard]] QString runName(const ComparedRun& run, const QLocale& locale);

/** Equal scenarios apart from name, notes and planner: runs of one can be set beside the other. */
[[nodiscard]] bool isSameWorld(const ScenarioWorld& a, const ScenarioWorld& b);
/** Runs in the same world, which was changed in flight in the same way at the same times. */
[[nodiscard]] bool isComparable(const ComparedRun& a, const ComparedRun& b);
/** Equal settings, tau aside where the policy does not use it. */
[[nodiscard]] bool isSamePlanner(const PlannerSettings& a, const PlannerSettings& b);
/** Comparable, flown in the same way as far, with the same result. */
[[nodiscard]] bool isSameRun(const ComparedRun& a, const ComparedRun& b);

/** What one UAV has done. */
struct UavTotals
{
    int visits = 0;
    double flown_m = 0; ///< through the air
};

/** The numbers of a run at one instant. */
struct RunFigures
{
    double zeta_m2s = 0;
    double meanSigmaSum_m2 = 0; ///< zeta over time
    int visits = 0;
    int plans = 0;
    double flown_m = 0;
    std::vector<UavTotals> uavs;    ///< by UAV
    std::vector<UnseenTime> unseen; ///< by iceberg
    int longestUnseen = -1;         ///< index of the one that was out of view longest; -1: none
};

/** `until_s` at most `flown_s`; between samples sums are interpolated. */
[[nodiscard]] RunFigures figuresAt(const ComparedRun& run, double until_s);

} // namespace berg
