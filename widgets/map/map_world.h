#pragma once

namespace berg {

struct MapPaint;

// What there is beside icebergs and UAV, as parts of the content of a map.

/** The area that is monitored, with a fence the one that the UAV stays inside. */
void paintArea(const MapPaint& p);
/** Where the UAV lands. */
void paintHome(const MapPaint& p);
/** What is to be protected, with its rings. */
void paintAsset(const MapPaint& p);
/** Outlines round icebergs that are planned as one point. */
void paintClusters(const MapPaint& p);
/** The circles that hold 95 %. */
void paintCircles(const MapPaint& p);
/** True positions that are apart from the estimates. */
void paintTruths(const MapPaint& p);
/** Signs at icebergs on their way into the inner ring of the asset. */
void paintAlarms(const MapPaint& p);

} // namespace berg
