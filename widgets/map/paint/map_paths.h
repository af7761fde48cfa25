#pragma once

#include "widgets/map/paint/map_layout.h"

namespace berg {

struct MapPaint;

// Where the UAVs were, are and go, as parts of the content of a map.

/** The water seen so far, in one tint however often it was seen. */
void paintSwept(const MapPaint& p);
/** The tracks of another run. */
void paintComparison(const MapPaint& p);
/** The flown tracks, older parts fainter. */
void paintTracks(const MapPaint& p);
void paintFieldsOfView(const MapPaint& p);
/** What the plans took the place of: thin and dashed, without numbers. */
void paintFormerPlans(const MapPaint& p);
/** The patterns that are flown to find a lost iceberg. */
void paintSearches(const MapPaint& p);
/** The plans, the next leg of each thicker; all thin while something else is flown. */
void paintPlans(const MapPaint& p);

/**
 * In wind: where small aircraft are drawn, from the middle of the first legs along the heading that
 * they are flown with, heading = course + asin(-w_n / U). Legs without room for one have none.
 */
[[nodiscard]] std::vector<QLineF> headingMarks(const MapPicture& picture, const MapLayout& layout,
                                               std::size_t uav);

} // namespace berg
