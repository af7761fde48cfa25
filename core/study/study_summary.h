#pragma once

#include "core/study/statistics.h"
#include "core/study/study.h"

namespace berg {

/** Statistics of one setting over all complete cases. */
struct SettingSummary
{
    StudySetting setting;
    Summary zeta_m2s;
    double meanVisits = 0;
    double stuckShare = 0; ///< share of the cases
};

/** Differences of a setting to the reference, case by case. */
struct PairedDifference
{
    StudySetting setting;
    MeanInterval zeta_m2s; ///< zeta minus zeta of the reference
    MeanInterval relative; ///< zeta / zeta of the reference - 1
    double lowerShare = 0; ///< share of cases with zeta below that of the reference
    double worst = 0;      ///< largest zeta / zeta of the reference - 1
};

/** The tau of lowest zeta in each case, chosen in hindsight (the smaller one of a tie). */
struct BestTau
{
    std::vector<double> byCase; ///< tau, in the order of `StudySummary::cases`
    Summary tau;
    Summary zeta_m2s;
    MeanInterval relative; ///< difference to the reference
};

/** Recommended setting; every tau and every policy counts alike. */
struct Recommendation
{
    std::size_t lowest = 0; ///< index of the lowest mean zeta, the first of a tie
    /** Surely lowest setting (`isSurelyLowest`); nullopt without a clear winner. */
    std::optional<std::size_t> best;
    std::optional<std::size_t> next; ///< with `best`: the setting closest to it
    MeanInterval relative;           ///< zeta of `best` / zeta of `next` - 1, case by case
    /** Indices of the settings that no other setting is surely lower than, ascending. */
    std::vector<std::size_t> contenders;
};

/** Statistics of the cases that every setting has flown; all numbers are 0 if there is none. */
struct StudySummary
{
    std::vector<std::size_t> cases;            ///< complete cases, ascending
    std::vector<SettingSummary> settings;      ///< in the order of `settingsOf`
    std::size_t reference = 0;                 ///< index of a setting
    std::vector<PairedDifference> differences; ///< by setting, the reference included
    std::optional<BestTau> bestTau; ///< set with two or more values of tau and a complete case
    std::optional<Recommendation> recommendation; ///< set with a complete case
};

/** Returns the index of the setting tau = 1, or 0 if there is none. */
[[nodiscard]] std::size_t usualReference(const StudySpec& spec);
/**
 * Computes the statistics. `reference` is the index of a setting; throws `std::logic_error` if
 * there is no such setting.
 */
[[nodiscard]] StudySummary summarise(const Study& study, std::size_t reference);

} // namespace berg
