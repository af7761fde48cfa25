#pragma once

#include "core/io/figure/figure.h"
#include "core/study/study_summary.h"
#include "widgets/theme/theme.h"

#include <QLocale>
#include <QPixmap>
#include <QString>

#include <optional>
#include <vector>

namespace berg {

/** The mark of a policy on nothing, for lists; sharp on screens of high density. */
[[nodiscard]] QPixmap policyMark(PolicyKind policy, const Theme& theme, int size_px);

/** One setting as a picture shows it. */
struct ZetaPoint
{
    std::size_t setting = 0; ///< index, as `settingsOf`
    StudySetting of;
    QString name;
    Summary zeta_m2s;
};

/** zeta against tau and policy, as plain values. */
struct ZetaContent
{
    std::vector<ZetaPoint> curve;         ///< ascending tau
    std::vector<ZetaPoint> policies;      ///< ascending mean
    std::size_t lowest = 0;               ///< setting of the least mean
    std::optional<std::size_t> lowestTau; ///< of those with a tau
    std::optional<double> bestTau_m2s;    ///< mean with the best tau of each case, in hindsight
};
[[nodiscard]] ZetaContent zetaContent(const StudySummary& summary, const QLocale& locale);

/** A setting against the reference, shares of its zeta. */
struct DifferenceRow
{
    std::size_t setting = 0;
    StudySetting of;
    QString name;
    MeanInterval relative;
    bool isReference = false;
};

/**
 * Paired differences, policies by their mean, then values of tau: at most `most` rows, tau thinned
 * evenly, with the reference and the lowest.
 */
[[nodiscard]] std::vector<DifferenceRow> differenceRows(const StudySummary& summary,
                                                        std::size_t most, const QLocale& locale);

} // namespace berg
