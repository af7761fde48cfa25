#pragma once

#include "core/io/import/fields/import_table.h"
#include "core/scenario/scenario.h"

#include <cstddef>
#include <stop_token>
#include <string>
#include <string_view>

namespace berg {

/** Result of an import of an ice chart. */
struct IceChartResult
{
    Scenario scenario;       ///< with the chart, which replaces a former one
    std::size_t taken = 0;   ///< areas of the chart
    std::size_t far = 0;     ///< areas beyond `kNearIceChart_m`
    std::size_t leftOut = 0; ///< the smallest areas beyond `kMostIceAreas`
    double thinned_m = 0;    ///< greatest move of an outline, to have few enough corners
    Rejections rejected;     ///< areas whose outline cannot be read
};

/** Half the side of the square around the origin to which charts are cut. */
inline constexpr double kNearIceChart_m = 300'000;

/**
 * Returns true if the text is GeoJSON of an ice chart: it has total concentrations (CT) of SIGRID-3
 * with types of polygons, stages or forms.
 */
[[nodiscard]] bool isIceChart(std::string_view text);

/**
 * Returns the scenario with the ice chart of a GeoJSON text, cut to the surroundings of the origin.
 * Each polygon with ice or water is an area; land is left out. Its concentration is that of `CT`
 * (`tenthsOfSigrid`), or 0 for water without one; ice is fast if the form `FA` is 08. The date is
 * that of the first of RECDAT, ICEDATE, DATE, DATE_CARTE, OBSDATE, TIME that is one, or else of the
 * file name (20210118 or 20210118T1800). Throws `Error`: FileTooLarge (`ReadBudget`), SyntaxError
 * for broken JSON, WrongFormat if it is no ice chart, InvalidInput if no area is near or readable;
 * `Stopped` if a stop is requested.
 */
[[nodiscard]] IceChartResult importIceChart(const Scenario& base, std::string_view bytes,
                                            const std::string& subject,
                                            const std::stop_token& stop = {});

/** Returns the JSON document that the command line prints for an import of an ice chart. */
[[nodiscard]] std::string iceChartJson(const IceChartResult& result);

} // namespace berg
