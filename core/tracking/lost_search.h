#pragma once

#include "core/tracking/observer.h"

#include <cstddef>
#include <vector>

namespace berg {

/**
 * Largest number of rounds of an expanding square: 4 million track spacings, which is days of
 * flight even at a spacing of one metre.
 */
inline constexpr int kMostSquareRounds = 1000;

/**
 * Returns the corners of an expanding square search (IAMSAR Manual vol. II, section 5.5), the datum
 * first: legs of 1, 1, 2, 2, 3, 3, ... track spacings, each a quarter turn to the right of the one
 * before, the first along `heading_rad` (from the x = east axis, counter-clockwise). Corners are
 * offsets from the datum, m, with which the pattern drifts. The legs cover the square of half width
 * `reach_m`, but end after `kMostSquareRounds` rounds: the area beyond is not searched. With reach
 * 0 the datum is the only corner. Throws `std::logic_error` unless `spacing_m` > 0 and `reach_m` >=
 * 0.
 */
[[nodiscard]] std::vector<Point> expandingSquare(double spacing_m, double reach_m,
                                                 double heading_rad);

/**
 * Returns the corners of a sector search (same source): three equilateral triangles through the
 * datum, nine legs of `radius_m`, turns of 120 degrees to the right. Starts and ends at the datum.
 * Corners are offsets from the datum, m; the first leg is along `heading_rad` (from the x = east
 * axis, counter-clockwise). Throws `std::logic_error` unless `radius_m` > 0.
 */
[[nodiscard]] std::vector<Point> sectorSearch(double radius_m, double heading_rad);

/**
 * Returns the probability (Bayes) that an object is still at a place after a camera sample that
 * would have shown it with probability `detection` but did not; `prior` is the probability before
 * it.
 */
[[nodiscard]] double afterMiss(double prior, double detection);

/** A place at which to search for a lost iceberg. */
struct SearchPlace
{
    Point offset_m = Point::Zero(); ///< offset from the iceberg's estimate
    double chance = 0;              ///< probability that a view over this place shows the iceberg
};

/**
 * A search for one lost iceberg: the distribution of its position, and the pattern flown to find
 * it. All places are offsets from the iceberg's estimate, the datum, with which pattern and
 * probabilities drift. The distribution is a grid of cells of the normal distribution about the
 * datum whose spread grows with the filter's; each camera sample lowers the probability of the
 * cells in view (Bayes).
 */
class LostSearch
{
public:
    /**
     * Probability at first that the iceberg is in no cell, because its velocity has changed or it
     * is gone. It grows with each cell seen empty (Bayes), so that a search in vain is worth less
     * and less.
     */
    static constexpr double kElsewhere = 0.02;

    LostSearch() = default;

    /**
     * Begins a search at the datum with the pattern of `observer`. `sd_m` is the standard deviation
     * of the position along each axis at that time; at least a quarter of the view is used, because
     * an iceberg that was not seen is not where the filter placed it. The pattern starts along
     * `heading_rad`. `SearchPattern::None` gives no corners.
     */
    LostSearch(const ObserverSpec& observer, const SensorSpec& sensor, double sd_m,
               double heading_rad);

    /** Returns whether a corner of the pattern is left to fly to. */
    [[nodiscard]] bool hasCorner() const { return m_next < m_corners_m.size(); }
    /** Returns the corner to fly to; requires one to be left. */
    [[nodiscard]] const Point& corner_m() const { return m_corners_m[m_next]; }
    /** Advances to the next corner; requires one to be left. */
    void nextCorner() { ++m_next; }

    /**
     * Updates the probabilities after a camera sample with this view showed nothing (Bayes); the
     * iceberg's estimate was at `datum_m`. They stay as they are if that leaves no cell possible.
     */
    void miss(const FieldOfView& view, const Point& datum_m, double detection);

    /** Moves the cells apart, because the filter's variance has grown by `added_m2`. */
    void grow(double added_m2);

    /** Returns the mean of the position variances along both axes, about the datum. */
    [[nodiscard]] double variance_m2() const;

    /**
     * Returns the largest probability per second of finding the iceberg over the next one, two, ...
     * four legs of the pattern, flown from `uav_m` (offset from the datum) at `speed_mps`; 0 if no
     * leg is left. `reach_m` is the distance to the side at which the iceberg is seen.
     */
    [[nodiscard]] double chancePerSecond(const Point& uav_m, double speed_mps, double reach_m,
                                         double detection) const;

    /**
     * Moves to the corner from which `chancePerSecond`, with the same parameters, is largest, the
     * first of equals: what was searched in vain is left out when a search is resumed. Of a pattern
     * with more than 100 corners only every n-th is compared.
     */
    void startAtBestCorner(const Point& uav_m, double speed_mps, double reach_m, double detection);

    /**
     * Returns up to `most` places with descending probability: the likeliest place for a square
     * view of half width `half_m` (north-aligned), then the likeliest one outside it, and so on.
     * Places below 2 % are left out.
     */
    [[nodiscard]] std::vector<SearchPlace> likeliestPlaces(double half_m, std::size_t most) const;

    /** The state of the search, for drawing and saving. */
    [[nodiscard]] const std::vector<Point>& corners_m() const { return m_corners_m; }
    [[nodiscard]] std::size_t next() const { return m_next; }
    [[nodiscard]] double spread_m() const { return m_spread_m; }
    [[nodiscard]] const std::vector<double>& chances() const { return m_chances; }
    [[nodiscard]] double presence() const { return m_presence; }
    /** Returns the number of cells, and of `chances`. */
    [[nodiscard]] static std::size_t cellCount();
    /**
     * Returns the search that has this state, as read by the five functions above. Throws
     * `std::logic_error` unless there are `cellCount()` chances.
     */
    [[nodiscard]] static LostSearch restored(std::vector<Point> corners_m, std::size_t next,
                                             double spread_m, std::vector<double> chances,
                                             double presence);

    bool operator==(const LostSearch&) const = default;

private:
    std::vector<Point> m_corners_m;
    std::size_t m_next = 1;
    double m_spread_m = 0;
    std::vector<double> m_chances; ///< probabilities by cell if it is in one; their sum is 1
    double m_presence = 1 - kElsewhere;
};

} // namespace berg
