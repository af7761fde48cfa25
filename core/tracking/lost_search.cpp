#include "core/tracking/lost_search.h"

#include "core/base/angles.h"
#include "core/base/error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

namespace berg {

namespace {

/** Track spacing of the expanding square, as a fraction of the width of the view. */
constexpr double kSpacing = 0.9;
/** A pattern covers this many standard deviations to either side of the datum. */
constexpr double kCovered_sd = 3;
/** Number of legs over which a search is judged: one round of the square. */
constexpr std::size_t kLegsAhead = 4;

/** Number of corners at which the start of a search is compared. */
constexpr std::size_t kMostCompared = 100;

// The cells are a square grid in standard deviations.
constexpr int kCellsAcross = 21;
constexpr double kCellsReach_sd = 3.2;

struct Cells
{
    std::vector<Point> offset_sd;
    std::vector<double> chance; ///< probabilities; their sum is 1
};

const Cells& cells()
{
    static const Cells kCells = [] {
        Cells all;
        for (int row = 0; row < kCellsAcross; ++row)
            for (int column = 0; column < kCellsAcross; ++column) {
                const Point offset_sd =
                    kCellsReach_sd *
                    (2 * Point(column, row) / (kCellsAcross - 1) - Point(Point::Ones()));
                all.offset_sd.push_back(offset_sd);
                all.chance.push_back(std::exp(-offset_sd.squaredNorm() / 2));
            }
        const double sum = std::accumulate(all.chance.begin(), all.chance.end(), 0.0);
        for (double& chance : all.chance)
            chance /= sum;
        return all;
    }();
    return kCells;
}

Point towards(double heading_rad)
{
    return {std::cos(heading_rad), std::sin(heading_rad)};
}

} // namespace

std::vector<Point> expandingSquare(double spacing_m, double reach_m, double heading_rad)
{
    require(spacing_m > 0 && reach_m >= 0, "expandingSquare: needs a spacing and a reach");
    // The corner after leg 2 k - 1 or 2 k is within k spacings of the datum along either axis.
    const int rounds =
        static_cast<int>(std::min<double>(std::ceil(reach_m / spacing_m), kMostSquareRounds));
    std::vector<Point> corners_m{Point::Zero()};
    for (int leg = 0; leg < 4 * rounds + 1 && rounds > 0; ++leg) {
        const int longer = leg / 2 + 1; // every second leg is longer
        const double length_m = spacing_m * longer;
        corners_m.emplace_back(corners_m.back() + length_m * towards(heading_rad - leg * kPi / 2));
    }
    return corners_m;
}

std::vector<Point> sectorSearch(double radius_m, double heading_rad)
{
    require(radius_m > 0, "sectorSearch: needs a radius");
    std::vector<Point> corners_m{Point::Zero()};
    double leg_rad = heading_rad;
    for (int triangle = 0; triangle < 3; ++triangle) {
        // The legs lead out, across and back through the datum; the next triangle starts straight
        // on.
        const Point out_m = radius_m * towards(leg_rad);
        const Point across_m = out_m + radius_m * towards(leg_rad - 2 * kPi / 3);
        corners_m.insert(corners_m.end(), {out_m, across_m, Point(Point::Zero())});
        leg_rad -= 4 * kPi / 3;
    }
    return corners_m;
}

double afterMiss(double prior, double detection)
{
    const double missed = prior * (1 - detection);
    const double either = missed + (1 - prior);
    return either > 0 ? missed / either : 0;
}

LostSearch::LostSearch(const ObserverSpec& observer, const SensorSpec& sensor, double sd_m,
                       double heading_rad)
    : m_chances(cells().chance)
{
    const double width_m = sensor.shape == FovShape::Disk ? sensor.fov_m.x() : sensor.fov_m.y();
    m_spread_m = std::max(sd_m, width_m / 4);
    const double reach_m = kCovered_sd * m_spread_m;
    switch (observer.search) {
    case SearchPattern::None:
        break;
    case SearchPattern::Square:
        m_corners_m = expandingSquare(kSpacing * width_m, reach_m, heading_rad);
        break;
    case SearchPattern::Sector:
        m_corners_m = sectorSearch(std::max(reach_m, width_m), heading_rad);
        break;
    }
}

void LostSearch::miss(const FieldOfView& view, const Point& datum_m, double detection)
{
    double left = 0;
    std::vector<double> chances = m_chances;
    for (std::size_t k = 0; k < chances.size(); ++k) {
        if (view.contains(datum_m + m_spread_m * cells().offset_sd[k]))
            chances[k] *= 1 - detection;
        left += chances[k];
    }
    // all cells were in view without a sighting: nothing is learnt about the position
    if (!(left > 0))
        return;
    for (double& chance : chances)
        chance /= left;
    m_chances = std::move(chances);
    m_presence *= left / (m_presence * left + 1 - m_presence);
}

void LostSearch::grow(double added_m2)
{
    m_spread_m = std::sqrt(m_spread_m * m_spread_m + added_m2);
}

double LostSearch::variance_m2() const
{
    double sum = 0;
    for (std::size_t k = 0; k < m_chances.size(); ++k)
        sum += m_chances[k] * cells().offset_sd[k].squaredNorm();
    return m_spread_m * m_spread_m * sum / 2;
}

double LostSearch::chancePerSecond(const Point& uav_m, double speed_mps, double reach_m,
                                   double detection) const
{
    std::vector<bool> swept(m_chances.size(), false);
    double best = 0;
    double flown_m = 0;
    double found = 0;
    Point from_m = uav_m;
    const std::size_t end = std::min(m_corners_m.size(), m_next + kLegsAhead);
    for (std::size_t leg = m_next; leg < end; ++leg) {
        const Point& to_m = m_corners_m[leg];
        flown_m += (to_m - from_m).norm();
        for (std::size_t k = 0; k < m_chances.size(); ++k) {
            const Point cell_m = m_spread_m * cells().offset_sd[k];
            if (swept[k] || distanceToSegment(from_m, to_m, cell_m) > reach_m)
                continue;
            swept[k] = true;
            found += detection * m_chances[k];
        }
        if (flown_m > 0)
            best = std::max(best, found * speed_mps / flown_m);
        from_m = to_m;
    }
    return best * m_presence;
}

std::vector<SearchPlace> LostSearch::likeliestPlaces(double half_m, std::size_t most) const
{
    constexpr double kLeastChance = 0.02;
    const double spacing_m = m_spread_m * 2 * kCellsReach_sd / (kCellsAcross - 1);
    const int within = std::min(kCellsAcross, static_cast<int>(half_m / spacing_m));
    std::vector<double> left = m_chances;
    std::vector<SearchPlace> places;
    const auto cell = [](int row, int column) {
        return static_cast<std::size_t>(row) * kCellsAcross + static_cast<std::size_t>(column);
    };
    const auto range = [within](int at) {
        return std::pair(std::max(0, at - within), std::min(kCellsAcross - 1, at + within));
    };
    while (places.size() < most) {
        // Sums over the columns of the view of each cell, then over its rows.
        std::vector<double> ofRow(left.size(), 0);
        for (int row = 0; row < kCellsAcross; ++row)
            for (int column = 0; column < kCellsAcross; ++column)
                for (auto [k, last] = range(column); k <= last; ++k)
                    ofRow[cell(row, column)] += left[cell(row, k)];
        double best = 0;
        int bestRow = 0;
        int bestColumn = 0;
        for (int row = 0; row < kCellsAcross; ++row)
            for (int column = 0; column < kCellsAcross; ++column) {
                double sum = 0;
                for (auto [k, last] = range(row); k <= last; ++k)
                    sum += ofRow[cell(k, column)];
                if (sum > best * (1 + 1e-9)) {
                    best = sum;
                    bestRow = row;
                    bestColumn = column;
                }
            }
        if (best < kLeastChance)
            break;
        places.push_back({.offset_m = m_spread_m * cells().offset_sd[cell(bestRow, bestColumn)],
                          .chance = best});
        for (auto [row, lastRow] = range(bestRow); row <= lastRow; ++row)
            for (auto [column, last] = range(bestColumn); column <= last; ++column)
                left[cell(row, column)] = 0;
    }
    return places;
}

void LostSearch::startAtBestCorner(const Point& uav_m, double speed_mps, double reach_m,
                                   double detection)
{
    const std::size_t stride = 1 + m_corners_m.size() / kMostCompared;
    double best = -1;
    std::size_t bestCorner = 0;
    for (m_next = 0; m_next < m_corners_m.size(); m_next += stride) {
        const double chance = chancePerSecond(uav_m, speed_mps, reach_m, detection);
        if (chance > best) {
            best = chance;
            bestCorner = m_next;
        }
    }
    m_next = bestCorner;
}

std::size_t LostSearch::cellCount()
{
    return cells().chance.size();
}

LostSearch LostSearch::restored(std::vector<Point> corners_m, std::size_t next, double spread_m,
                                std::vector<double> chances, double presence)
{
    require(chances.size() == cellCount(), "LostSearch: needs a probability of each cell");
    LostSearch search;
    search.m_corners_m = std::move(corners_m);
    search.m_next = next;
    search.m_spread_m = spread_m;
    search.m_chances = std::move(chances);
    search.m_presence = presence;
    return search;
}

} // namespace berg
