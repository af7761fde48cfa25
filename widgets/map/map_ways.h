#pragma once

#include "widgets/map/map_layout.h"

namespace berg {

struct MapPaint;

// Where the UAV was, is and goes, as parts of the content of a map.

/** The water seen so far, in one tint however often it was seen. */
void paintSwept(const MapPaint& p);
/** Another run's track. */
void paintComparison(const MapPaint& p);
/** The flown track, older parts fainter. */
void paintTrack(const MapPaint& p);
void paintFieldOfView(const MapPaint& p);
/** What the plan took the place of: thin and dashed, without numbers. */
void paintFormerPlan(const MapPaint& p);
/** The pattern that is flown to find a lost iceberg. */
void paintSearch(const MapPaint& p);
/** The plan, its next leg thicker; all thin while something else is flown. */
void paintPlan(const MapPaint& p);

/**
 * In wind: short lines from the middle of the first legs along the heading that they are flown
 * with, heading = course + asin(-w_n / U). Legs without room for one have none.
 */
[[nodiscard]] std::vector<QLineF> headingMarks(const MapPicture& picture, const MapLayout& layout);

} // namespace berg
