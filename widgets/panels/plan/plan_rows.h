#pragma once

#include "widgets/flight/flight_record.h"

#include <QString>

#include <optional>
#include <string>
#include <vector>

namespace berg {

/** Course and speed on a straight leg. */
struct LegCourse
{
    double true_deg = 0; ///< true course over ground at the leg's start
    /** Declination at the leg's start, positive east; nullopt if only true courses are shown. */
    std::optional<double> declination_deg = {};
    double groundSpeed_mps = 0;
    bool operator==(const LegCourse&) const = default;
};

/** An iceberg of the plan, in visiting order. */
struct PlanRow
{
    std::string id;
    QString name;     ///< name, or the id if there is none
    double leg_m = 0; ///< length over ground from the iceberg before, or from the UAV
    std::optional<LegCourse> course = {}; ///< course of that leg; nullopt if it is not straight
    double arrival_s = 0;                 ///< time from now
    double sigma_m2 = 0;                  ///< present value
    double arrivalSigma_m2 = 0;           ///< value on arrival, unless the iceberg is seen before
    /** Chance of being in view on arrival; nullopt if it depends on the aim. */
    std::optional<double> chance = {};
    std::vector<PlannedSearch> searches = {}; ///< places where a lost iceberg is searched for
    std::optional<int> number = {};           ///< place in the order, from 1; nullopt for a search
    bool isSeen = true;      ///< if false, plan or run ends before, and leg and arrival are unknown
    bool isAssigned = false; ///< whether it is assigned to this one of several UAVs
    /** Time from now to the next visit of a patrol after `arrival_s`; nullopt if there is none. */
    std::optional<double> again_s = {};
    bool isLater = false; ///< whether a patrol visits it beyond the path that is planned
    bool operator==(const PlanRow&) const = default;
};

/** A leg that does not end at an iceberg of the rows. */
struct ReturnLeg
{
    double leg_m = 0;
    double arrival_s = 0; ///< time from now
};

/** The plan of one UAV. */
struct PlanSection
{
    std::string uav;                    ///< id of the UAV
    QString name;                       ///< empty for a single UAV
    int place = 0;                      ///< index in the scenario, for its colour
    bool isOver = false;                ///< the run has ended: nothing is left to fly
    bool isPlanned = true;              ///< false while it returns, holds or is on the ground
    FlightMode mode = FlightMode::Idle; ///< mode while it is not planned
    std::vector<PlanRow> rows;
    /** Leg after the rows that are seen: to home, or to the start of a closed route. */
    std::optional<ReturnLeg> returns;
    std::optional<ReturnLeg> unfinished; ///< cut leg at the end of the run, in place of `returns`

    /** Returns the length of all known legs with the return, until the end of the run, m. */
    [[nodiscard]] double length_m() const;
    /** Returns the time of the last known arrival from now, s; 0 without any. */
    [[nodiscard]] double lastArrival_s() const;
};

/**
 * Returns the forecast of the present plan (`forecastPlan`), a section for each UAV; for plans with
 * aim points the predicted sightings and the paths to them.
 */
[[nodiscard]] std::vector<PlanSection> planSections(const MissionSnapshot& now,
                                                    const Scenario& scenario);
/**
 * Returns warnings about flights that begin or end in the dark, before take-off; empty without a
 * start in UTC.
 */
[[nodiscard]] std::vector<Issue> darkFlights(const MissionSnapshot& now, const Scenario& scenario,
                                             const std::vector<PlanSection>& sections);
/** Returns the length of all sections, m. */
[[nodiscard]] double planLength_m(const std::vector<PlanSection>& sections);
/** Returns the last arrival of all sections from now, s; 0 without rows. */
[[nodiscard]] double planEnd_s(const std::vector<PlanSection>& sections);
/** Returns the last time in the rows, from now: arrivals and later visits; 0 without rows. */
[[nodiscard]] double lastTime_s(const std::vector<PlanSection>& sections);
/** Returns true if a UAV has something to visit or to search for. */
[[nodiscard]] bool hasRows(const std::vector<PlanSection>& sections);
/** Returns whether a section ends at home. */
[[nodiscard]] bool comesHome(const std::vector<PlanSection>& sections);

/** Summary of the whole plan. */
struct PlanOutlook
{
    double zeta_m2s = 0; ///< zeta at the end of the mission: present value plus predicted increase
    /** If false, zeta is shown only with the policy: it is of the flight, not of the plan. */
    bool isInFlight = false;
    bool isOver = false;              ///< whether zeta is that of the complete flight
    std::optional<double> until_s;    ///< time of zeta, if before the end
    bool isAimed = false;             ///< whether zeta is predicted for legs with aim points
    std::optional<PlanChange> change; ///< change by the plan shown, all UAVs together
    double changed_s = 0;             ///< time of the change, s
    QString before;                  ///< remaining icebergs of the former order of each changed UAV
    std::optional<double> bound_m2s; ///< lower bound on zeta of any flight, at the same time
    double boundShare = 1;           ///< share of the work for the bound that is done
    /** Source of the complete bound, see `BoundPoint`; nullopt while it is computed. */
    std::optional<bool> isBoundFromRates = {};
    /** Longest time that a patrol leaves an iceberg unseen; nullopt if the plan is no patrol. */
    std::optional<double> longestGap_s = {};
    QString longestGapName = {}; ///< name of that iceberg
};

/**
 * Returns the summary at the instant shown; nullopt without a plan, or while a plan with aim points
 * is being made.
 */
[[nodiscard]] std::optional<PlanOutlook> planOutlook(const FlightRecord& record);

} // namespace berg
