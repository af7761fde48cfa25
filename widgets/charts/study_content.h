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

/** Mark of a policy on a transparent pixmap, for lists; sharp on high-density screens. */
[[nodiscard]] QPixmap policyMark(PolicyKind policy, const Theme& theme, int size_px);

/** Result of one setting for a figure. */
struct ZetaPoint
{
    std::size_t setting = 0; ///< index as in `settingsOf`
    StudySetting of;
    QString name;
    Summary zeta_m2s;
};

/** zeta by tau and by policy, as plain values. */
struct ZetaContent
{
    std::vector<ZetaPoint> curve;         ///< ascending tau
    std::vector<ZetaPoint> policies;      ///< ascending mean
    std::size_t lowest = 0;               ///< setting with the smallest mean
    std::optional<std::size_t> lowestTau; ///< setting with the smallest mean among those with a tau
    std::optional<double> bestTau_m2s; ///< mean with the best tau of each case, chosen in hindsight
};
/** Content of the chart of zeta; empty if the study has no cases. */
[[nodiscard]] ZetaContent zetaContent(const StudySummary& summary, const QLocale& locale);

/** Difference of a setting from the reference, relative to the reference's zeta. */
struct DifferenceRow
{
    std::size_t setting = 0;
    StudySetting of;
    QString name;
    MeanInterval relative;
    bool isReference = false;
};

/**
 * Paired differences: policies by mean, then values of tau. At most `most` rows: tau is thinned
 * evenly, but the reference and the lowest are kept.
 */
[[nodiscard]] std::vector<DifferenceRow> differenceRows(const StudySummary& summary,
                                                        std::size_t most, const QLocale& locale);

} // namespace berg
