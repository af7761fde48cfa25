#pragma once

#include "widgets/map/paint/map_layout.h"

namespace berg {

struct MapPaint;

// Tracks, fields of view and plans of the UAVs, as parts of the content of a map.

/** Paints the water seen so far in one tint, however often it was seen. */
void paintSwept(const MapPaint& p);
/** Paints the tracks of the compared run. */
void paintComparison(const MapPaint& p);
/** Paints the flown tracks, older parts fainter. */
void paintTracks(const MapPaint& p);
/** Paints the fields of view of all UAVs. */
void paintFieldsOfView(const MapPaint& p);
/** Returns the pen for later rounds of a patrol: faint dots. */
[[nodiscard]] QPen laterVisitsPen(const QColor& colour);
/** Paints the later rounds of patrols: faint lines between the places of their visits. */
void paintLaterVisits(const MapPaint& p);
/** Paints the replaced plans: thin and dashed, without numbers. */
void paintFormerPlans(const MapPaint& p);
/** Paints the search patterns being flown. */
void paintSearches(const MapPaint& p);
/** Paints the plans with the next leg thicker; all legs are thin during a search. */
void paintPlans(const MapPaint& p);

/**
 * Returns the heading marks in wind: from the middle of each of the first three legs along its
 * heading, heading = course + asin(-w_n / U). Legs that are too short have none; the result is
 * empty without wind.
 */
[[nodiscard]] std::vector<QLineF> headingMarks(const MapPicture& picture, const MapLayout& layout,
                                               std::size_t uav);

} // namespace berg
