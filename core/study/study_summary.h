#pragma once

#include "core/study/statistics.h"
#include "core/study/study.h"

namespace berg {

/** One setting over all complete cases. */
struct SettingSummary
{
    StudySetting setting;
    Summary zeta_m2s;
    double meanVisits = 0;
    double stuckShare = 0; ///< of the cases
};

/** A setting against the reference, case by case. */
struct PairedDifference
{
    StudySetting setting;
    MeanInterval zeta_m2s; ///< of zeta - zeta of the reference
    MeanInterval relative; ///< of zeta / zeta of the reference - 1
    double lowerShare = 0; ///< cases with zeta below that of the reference
    double worst = 0;      ///< largest zeta / zeta of the reference - 1
};

/** The tau of lowest zeta of each case, chosen in hindsight (the smaller one of a tie). */
struct BestTau
{
    std::vector<double> byCase; ///< tau, in the order of `StudySummary::cases`
    Summary tau;
    Summary zeta_m2s;
    MeanInterval relative; ///< against the reference
};

/** Which setting to fly; every tau and every policy counts alike. */
struct Recommendation
{
    std::size_t lowest = 0;          ///< index of the lowest mean zeta, the first of a tie
    std::optional<std::size_t> best; ///< surely lowest (`isSurelyLowest`); nullopt: no clear winner
    std::optional<std::size_t> next; ///< with `best`: the setting that comes closest to it
    MeanInterval relative;           ///< zeta of `best` / zeta of `next` - 1, case by case
    std::vector<std::size_t> contenders; ///< no setting is surely lower than these; ascending
};

/** Statistics of the cases that every setting has flown; with none of them all numbers are 0. */
struct StudySummary
{
    std::vector<std::size_t> cases;            ///< complete ones, ascending
    std::vector<SettingSummary> settings;      ///< as `settingsOf`
    std::size_t reference = 0;                 ///< index of a setting
    std::vector<PairedDifference> differences; ///< of all settings, the reference included
    std::optional<BestTau> bestTau; ///< with two values of tau or more and a complete case
    std::optional<Recommendation> recommendation; ///< with a complete case
};

/** tau = 1 when it is there, else the first setting. */
[[nodiscard]] std::size_t usualReference(const StudySpec& spec);
/** `reference`: index of a setting. */
[[nodiscard]] StudySummary summarise(const Study& study, std::size_t reference);

} // namespace berg
