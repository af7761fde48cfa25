#pragma once

#include "widgets/model/flight_record.h"

#include <QString>

#include <string>
#include <vector>

namespace berg {

/** How a straight leg is flown. */
struct LegCourse
{
    double true_deg = 0; ///< over ground, at the leg's start
    /** At the leg's start, positive east; nullopt if courses are shown by true north alone. */
    std::optional<double> declination_deg = {};
    double groundSpeed_mps = 0;
    bool operator==(const LegCourse&) const = default;
};

/** One iceberg of the plan, in visiting order. */
struct PlanRow
{
    std::string id;
    QString name;                         ///< never empty: the id where there is no name
    double leg_m = 0;                     ///< over ground, from the one before or the UAV
    std::optional<LegCourse> course = {}; ///< of that leg; nullopt if it is not straight
    double arrival_s = 0;                 ///< from now
    double sigma_m2 = 0;                  ///< now
    double arrivalSigma_m2 = 0;           ///< when the UAV is there, unless it is seen on the way
    std::optional<double> chance = {};    ///< of being in view on arrival; none: depends on the aim
    std::vector<PlannedSearch> searches = {}; ///< places where the lost iceberg is looked for
    int number = 0;          ///< in the order, from 1; 0: as the rows are; -1: searched for
    bool isSeen = true;      ///< false: plan or run end before, legs and arrivals are not known
    bool isAssigned = false; ///< of several UAVs this one alone is to visit it
    bool operator==(const PlanRow&) const = default;
};

/** A leg that ends at none of the rows. */
struct ReturnLeg
{
    double leg_m = 0;
    double arrival_s = 0; ///< from now
};

/** What one UAV is to visit. */
struct PlanSection
{
    std::string uav;                    ///< id
    QString name;                       ///< empty: it is the only one
    int place = 0;                      ///< in the scenario: it gives the colour
    bool isOver = false;                ///< the run has ended: nothing is left to fly
    bool isPlanned = true;              ///< not on its way home, on the ground or holding
    FlightMode mode = FlightMode::Idle; ///< then which of them
    std::vector<PlanRow> rows;
    /** After the rows that are seen: back home, or to the start of a closed route. */
    std::optional<ReturnLeg> returns;
    std::optional<ReturnLeg> unfinished; ///< in their place: what the run leaves of a leg

    /** Of all legs that are known, the return among them, until the end of the run. */
    [[nodiscard]] double length_m() const;
    /** At the end of what is known, from now; 0 without any. */
    [[nodiscard]] double lastArrival_s() const;
};

/**
 * The present plan as it is forecast from this instant (`forecastPlan`), a section for each UAV; of
 * plans with aim points the sightings that they predict, and the ways to them.
 */
[[nodiscard]] std::vector<PlanSection> planSections(const MissionSnapshot& now,
                                                    const Scenario& scenario);
/** Warnings about flights of the plan, before take-off, that begin or end in the dark; empty
 * without a start in UTC. */
[[nodiscard]] std::vector<Issue> darkFlights(const MissionSnapshot& now, const Scenario& scenario,
                                             const std::vector<PlanSection>& sections);
/** Of all sections. */
[[nodiscard]] double planLength_m(const std::vector<PlanSection>& sections);
/** The last arrival of all, from now; 0 without rows. */
[[nodiscard]] double planEnd_s(const std::vector<PlanSection>& sections);
/** Whether one of them ends at home. */
[[nodiscard]] bool comesHome(const std::vector<PlanSection>& sections);

/** What is told of the plan as a whole. */
struct PlanOutlook
{
    double zeta_m2s =
        0; ///< at the end of the mission: what it is and what is predicted to be added
    bool isInFlight =
        false;           ///< else zeta is told with the policy alone: of the flight, not the plan
    bool isOver = false; ///< zeta is that of the whole flight
    std::optional<double> until_s;    ///< the zeta is that of this time, before the end
    bool isAimed = false;             ///< predicted for legs with aim points
    std::optional<PlanChange> change; ///< what the plan shown changed, of all UAVs
    double changed_s = 0;             ///< when
    QString before;                   ///< icebergs left in the order before, of each UAV changed
    std::optional<double> bound_m2s;  ///< zeta of no flight is below, at the same time
    double boundShare = 1;            ///< of the work for the bound that is done
};

/** Of the instant shown; none without a plan, or with one that has aim points and is being made. */
[[nodiscard]] std::optional<PlanOutlook> planOutlook(const FlightRecord& record);

} // namespace berg
