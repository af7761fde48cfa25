#pragma once

#include "core/io/import/forecast/grid_layers.h"
#include "core/io/import/scenario/import_scenario.h"

#include <array>
#include <cstddef>
#include <optional>
#include <stop_token>
#include <vector>

namespace berg {

/**
 * Gives a grid of places one latitude for each row and one longitude for each column, if those of
 * its nodes are equal.
 */
void makeRectilinear(SourceGrid& grid);

/** Rows and columns of the grid that a forecast gets: latitudes and longitudes rise. */
struct TargetGrid
{
    std::vector<double> latitude_deg;
    /** Continuous; may leave [-180, 180) at the antimeridian. */
    std::vector<double> longitude_deg;

    [[nodiscard]] std::size_t size() const { return latitude_deg.size() * longitude_deg.size(); }
};

/** How many places a target grid may have, and which area it covers. */
struct TargetWish
{
    std::optional<GeoBox> area; ///< nullopt for all of the source
    std::size_t mostPlaces = 1;
};

/** Reason why there is no target grid. */
enum class NoTarget
{
    NoPlaces, ///< the grid has no finite place
    TooWide,  ///< 180 degrees of longitude or more
    OutsideArea
};

/** A target grid, or the reason why there is none. */
struct TargetChoice
{
    TargetGrid grid;
    std::optional<NoTarget> fault;
    /** 1 if the grid is as fine as the source, 2 if half as fine in each direction, ... */
    std::size_t thinning = 1;
};

/**
 * Returns the target grid for a source: of a rectilinear one its own nodes in the area and the next
 * ones around, of another one a regular grid with the mean spacing of its nodes. With too many
 * places, every second, third, ... row and column is used.
 */
[[nodiscard]] TargetChoice chooseTarget(const SourceGrid& source, const TargetWish& wish);

/** Up to four nodes of a source around a place, and their weights, whose sum is 1. */
struct NodeShares
{
    std::array<std::size_t, 4> nodes{}; ///< row * columns + column, in the window
    std::array<double, 4> weights{};    ///< all 0 if the place is outside the source
};

/** How the values of a target grid are made of those of a source. */
struct GridSampling
{
    GridWindow window; ///< part of the source that is used; no rows if none is
    std::vector<NodeShares> shares;
    /** Direction of the source's columns (`againstX` heeded) from east, radians, as cos and sin. */
    std::vector<Point> alongX;
};

/** Finds the nodes around each place of the target, bilinear in the cells of the source. Throws
 * `Stopped`. */
[[nodiscard]] GridSampling sampling(const SourceGrid& source, const TargetGrid& target,
                                    const std::stop_token& stop);

/**
 * Returns the value at a place of the target: the weighted mean of its nodes that have one, or
 * nullopt if none has. `values` are those of the window.
 */
[[nodiscard]] std::optional<double> sampled(const NodeShares& shares, const double* values);

} // namespace berg
