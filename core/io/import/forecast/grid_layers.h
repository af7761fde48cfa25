#pragma once

#include "core/earth/forecast.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace berg {

/** Places of the nodes of a model's grid, in rows of the file's order. */
struct SourceGrid
{
    std::size_t rows = 0;
    std::size_t columns = 0;
    /** One for each row, or one for each node, row after row; NaN for an unknown one. */
    std::vector<double> latitude_deg;
    /** One for each column, or one for each node; any turn of the circle. */
    std::vector<double> longitude_deg;
    /** True if columns are numbered against the direction of the grid's x axis. */
    bool againstX = false;

    [[nodiscard]] bool isRectilinear() const
    {
        return latitude_deg.size() == rows && longitude_deg.size() == columns;
    }
    /** Returns the place of a node. */
    [[nodiscard]] LatLon at(std::size_t row, std::size_t column) const
    {
        if (isRectilinear())
            return {latitude_deg[row], longitude_deg[column]};
        return {latitude_deg[row * columns + column], longitude_deg[row * columns + column]};
    }
};

/** One number of a forecast on a grid, in the units of `ForecastEntry`. */
enum class GridNumber : std::uint8_t
{
    WindEast,
    WindNorth,
    WindAlongX,
    WindAlongY,
    Gust,
    AirTemperature,
    DewPoint,
    Fog,
    Visibility,
    Ceiling,
    CurrentEast,
    CurrentNorth,
    CurrentAlongX,
    CurrentAlongY,
    Depth,
    AngleOfX ///< direction of the grid's x axis, radians counter-clockwise from east
};
inline constexpr std::size_t kGridNumbers = 16;

/** The values of one number in a file. */
struct GridLayer
{
    GridNumber number = GridNumber::WindEast;
    std::size_t grid = 0;            ///< index in `GridSource::grids`
    std::string name;                ///< of the variable or message, for errors
    std::vector<ForecastTime> times; ///< rise; empty for values that are for all times
};

/** Part of a grid. */
struct GridWindow
{
    std::size_t firstRow = 0;
    std::size_t rows = 0;
    std::size_t firstColumn = 0;
    std::size_t columns = 0;
};

/** A file of forecasts on grids, opened for reading. */
class GridSource
{
public:
    GridSource() = default;
    GridSource(const GridSource&) = delete;
    GridSource& operator=(const GridSource&) = delete;
    virtual ~GridSource() = default;

    [[nodiscard]] virtual const std::vector<SourceGrid>& grids() const = 0;
    /** Returns the layers; each number appears at most once. */
    [[nodiscard]] virtual const std::vector<GridLayer>& layers() const = 0;
    /**
     * Returns the values of a layer at `count` of its times from `first` on (1 from 0 if it has no
     * times), time after time and row after row of the window; NaN for a missing one.
     */
    [[nodiscard]] virtual std::vector<double> read(const GridLayer& layer, std::size_t first,
                                                   std::size_t count, const GridWindow& window) = 0;
    [[nodiscard]] virtual std::string source() const = 0;
    [[nodiscard]] virtual std::optional<ForecastTime> issued() const = 0;
};

} // namespace berg
