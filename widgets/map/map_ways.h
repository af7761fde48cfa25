#pragma once

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
/** The plan, its next leg thicker. */
void paintPlan(const MapPaint& p);

} // namespace berg
