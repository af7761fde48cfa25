#pragma once

#include "core/tracking/observer.h"

#include <cstddef>
#include <vector>

namespace berg {

/** 4 million track spacings of way: days even where a spacing is a metre. */
inline constexpr int kMostSquareRounds = 1000;

/**
 * Corners of an expanding square search (IAMSAR Manual vol. II, section 5.5), the datum first:
 * legs of 1, 1, 2, 2, 3, 3, ... track spacings, each a quarter turn to the right of the one before,
 * the first along `heading_rad` (from the x = east axis, counter-clockwise). Offsets from the
 * datum, with which the pattern drifts. As many legs as cover the square of half width `reach_m`,
 * but those of `kMostSquareRounds` at most: what is farther out is not searched.
 */
[[nodiscard]] std::vector<Point> expandingSquare(double spacing_m, double reach_m,
                                                 double heading_rad);

/**
 * Corners of a sector search (same source): three equilateral triangles through the datum, nine
 * legs of `radius_m`, turns of 120 degrees to the right. Starts and ends at the datum.
 */
[[nodiscard]] std::vector<Point> sectorSearch(double radius_m, double heading_rad);

/**
 * Probability that what was there with `prior` is there still, after a look that would have shown
 * it with `detection`, and did not (Bayes).
 */
[[nodiscard]] double afterMiss(double prior, double detection);

/** Where a lost iceberg may be looked for. */
struct SearchPlace
{
    Point offset_m = Point::Zero(); ///< from its estimate
    double chance = 0;              ///< that a view over this place shows it
};

/**
 * A search for one lost iceberg: where it may be, and the pattern that is flown to find it. All
 * places are offsets from the iceberg's estimate, the datum, with which pattern and chances drift.
 * Where it may be are cells of the normal distribution about the datum whose spread grows with the
 * filter's; each look takes from those in view (Bayes).
 */
class LostSearch
{
public:
    LostSearch() = default;

    /**
     * Begins at the datum. `sd_m`: spread of the place along each axis at that time, made no less
     * than a quarter of the view: what was not seen is not where the filter believed it to be.
     */
    LostSearch(const ObserverSpec& observer, const SensorSpec& sensor, double sd_m,
               double heading_rad);

    /** Whether a corner is left to fly to. */
    [[nodiscard]] bool hasCorner() const { return m_next < m_corners_m.size(); }
    /** The corner flown to; needs one. */
    [[nodiscard]] const Point& corner_m() const { return m_corners_m[m_next]; }
    void nextCorner() { ++m_next; }

    /** Bayes: a look with this view, the iceberg's estimate being at `datum_m`, showed nothing. */
    void miss(const FieldOfView& view, const Point& datum_m, double detection);

    /** The filter's variance has grown by this: the cells move apart. */
    void grow(double added_m2);

    /** Mean of the variances of the place along both axes, about the datum. */
    [[nodiscard]] double variance_m2() const;

    /**
     * Largest chance per second of finding it, over the next one, two, ... four legs of the
     * pattern, flown from `uav_m` (offset from the datum) at `speed_mps`; 0 when none is left.
     * `reach_m`: so far to the side it is seen.
     */
    [[nodiscard]] double chancePerSecond(const Point& uav_m, double speed_mps, double reach_m,
                                         double detection) const;

    /**
     * The likeliest place for a square view of half width `half_m` (north-aligned), then the
     * likeliest one apart from it, and so on: `most` at most, their chances descending.
     */
    [[nodiscard]] std::vector<SearchPlace> likeliestPlaces(double half_m, std::size_t most) const;

    /** Of what is left of it, for whoever draws or keeps it. */
    [[nodiscard]] const std::vector<Point>& corners_m() const { return m_corners_m; }
    [[nodiscard]] std::size_t next() const { return m_next; }
    [[nodiscard]] double spread_m() const { return m_spread_m; }
    [[nodiscard]] const std::vector<double>& chances() const { return m_chances; }
    /** The same search again from what those four told. */
    [[nodiscard]] static LostSearch restored(std::vector<Point> corners_m, std::size_t next,
                                             double spread_m, std::vector<double> chances);

    bool operator==(const LostSearch&) const = default;

private:
    std::vector<Point> m_corners_m;
    std::size_t m_next = 1;
    double m_spread_m = 0;
    std::vector<double> m_chances; ///< by cell, their sum 1
};

} // namespace berg
