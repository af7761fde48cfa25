#pragma once

#include "core/io/figure/figure.h"
#include "core/io/words/report_words.h"
#include "core/study/study_summary.h"

#include <functional>
#include <string>
#include <vector>

namespace berg {

// Figures of a study. The window paints them and reports write them as SVG. They show the complete
// cases only; without any they have a name and nothing else.

/** Returns the name of a setting: "τ = 0.5" (six decimals at most), or the name of the policy. */
[[nodiscard]] std::string settingName(const StudySetting& setting);

/** Unit of the numbers of an axis. */
struct FigureUnit
{
    std::string name;
    double inSi = 1;
};

/** Names and numbers of a study's figures; by default those of a report. */
struct StudyFigureFormat
{
    using Text = std::function<std::string(double)>;

    ReportWords words = {};
    std::function<std::string(const StudySetting&)> setting = settingName;
    std::function<std::string(double value, int decimals)> number = defaultNumber;
    Text zeta = defaultZeta;     ///< of m² s: four significant digits without unit
    Text change = defaultChange; ///< of a share: "+16.2 %"
    std::function<FigureUnit(double largest_m2s)> unit = defaultUnit; ///< unit of the axis of zeta

    static std::string defaultNumber(double value, int decimals);
    static std::string defaultZeta(double zeta_m2s);
    static std::string defaultChange(double share);
    static FigureUnit defaultUnit(double largest_m2s);
};

/**
 * Returns the figure of zeta against tau, as Figure 4 of the paper: mean with a band between the
 * quartiles, median dashed; points only for a single case. The other policies are horizontal lines
 * with marks right of the largest tau. Items are the settings. In a figure of `width_px` that is
 * too narrow for the marks of all tau, only the lowest is marked. Less is better.
 */
[[nodiscard]] Figure zetaFigure(const StudySummary& summary, const StudyFigureFormat& format,
                                double width_px);

/**
 * Returns the settings of at most `most` rows of `differenceFigure`: policies by mean, then values
 * of tau. The values of tau are thinned evenly, but the reference and the lowest remain.
 */
[[nodiscard]] std::vector<std::size_t> differenceRows(const StudySummary& summary,
                                                      std::size_t most);
/**
 * Returns the figure of the differences of these settings from the reference, case by case: a row
 * for each with the mean and its 95 % confidence interval. Items are the settings.
 */
[[nodiscard]] Figure differenceFigure(const StudySummary& summary,
                                      const std::vector<std::size_t>& rows,
                                      const StudyFigureFormat& format);

/**
 * Returns the figure of the number of cases for which each tau is the best; without a best tau it
 * has a name and nothing else.
 */
[[nodiscard]] Figure bestTauFigure(const StudySummary& summary, const StudyFigureFormat& format);

} // namespace berg
