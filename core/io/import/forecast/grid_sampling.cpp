#include "core/io/import/forecast/grid_sampling.h"

#include "core/base/angles.h"
#include "core/base/stopped.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace berg {

namespace {

/** Nodes at the corners of a cell; the second row may be the first where there is only one. */
struct Cell
{
    std::array<std::size_t, 2> rows{};
    std::array<std::size_t, 2> columns{};
    std::array<Point, 4> corners; ///< degrees east of the middle and north, row after row
};

/** Position within a cell: 0 to 1 along its columns and rows. */
struct InCell
{
    double column = 0;
    double row = 0;
};

double eastFrom_deg(double middle_deg, double longitude_deg)
{
    const double offset = longitude_deg - middle_deg;
    return offset - 360 * std::floor((offset + 180) / 360);
}

constexpr double kSlack = 1e-6; ///< of a cell; rounding must not put a node beside itself

/** Returns 0 and 1 for what is nearly that, or nullopt outside. */
std::optional<double> inUnit(double value)
{
    if (!(value > -kSlack && value < 1 + kSlack))
        return std::nullopt;
    if (value < kSlack)
        return 0.0;
    return value > 1 - kSlack ? 1.0 : value;
}

double cross2(const Point& a, const Point& b)
{
    return a.x() * b.y() - a.y() * b.x();
}

/** Returns where the place is between two corners, or nullopt if it is not on the line. */
std::optional<double> onLine(const Point& from, const Point& to, const Point& place)
{
    const Point line = to - from;
    const double length2 = line.squaredNorm();
    if (length2 <= 0)
        return (place - from).norm() < 1e-9 ? std::optional(0.0) : std::nullopt;
    if (std::abs(cross2(line, place - from)) > 1e-6 * length2)
        return std::nullopt;
    return inUnit(line.dot(place - from) / length2);
}

/** Inverts the bilinear map of a quadrilateral by Newton's method. */
std::optional<InCell> inQuadrilateral(const Cell& cell, const Point& place)
{
    const Point a = cell.corners[0];
    const Point along = cell.corners[1] - a;
    const Point across = cell.corners[2] - a;
    const Point twist = cell.corners[3] - cell.corners[1] - across;
    double u = 0.5;
    double v = 0.5;
    for (int i = 0; i < 12; ++i) {
        const Point rest = place - (a + u * along + v * across + u * v * twist);
        const Point byU = along + v * twist;
        const Point byV = across + u * twist;
        const double determinant = cross2(byU, byV);
        if (determinant == 0 || !std::isfinite(determinant))
            return std::nullopt;
        const double du = cross2(rest, byV) / determinant;
        const double dv = cross2(byU, rest) / determinant;
        u += du;
        v += dv;
        if (std::abs(du) < 1e-12 && std::abs(dv) < 1e-12)
            break;
    }
    const std::optional<double> column = inUnit(u);
    const std::optional<double> row = inUnit(v);
    if (!column || !row)
        return std::nullopt;
    return InCell{.column = *column, .row = *row};
}

std::optional<InCell> positionIn(const Cell& cell, const Point& place)
{
    const bool oneRow = cell.rows[0] == cell.rows[1];
    const bool oneColumn = cell.columns[0] == cell.columns[1];
    if (!oneRow && !oneColumn)
        return inQuadrilateral(cell, place);
    const std::optional<double> share =
        onLine(cell.corners[0], oneRow ? cell.corners[1] : cell.corners[2], place);
    if (!share)
        return std::nullopt;
    return oneRow ? InCell{.column = *share} : InCell{.row = *share};
}

/** Direction of the columns at a place of the cell, as east and north. */
Point alongColumns(const Cell& cell, const InCell& at, double latitude_deg)
{
    Point along = (1 - at.row) * (cell.corners[1] - cell.corners[0]) +
                  at.row * (cell.corners[3] - cell.corners[2]);
    along.x() *= std::cos(radFromDeg(latitude_deg));
    return along.norm() > 0 ? Point(along.normalized()) : Point(1, 0);
}

/** Fills in the shares of the places, cell by cell. */
class Sampler
{
public:
    Sampler(const SourceGrid& source, const TargetGrid& target)
        : m_source(source)
        , m_target(target)
        , m_middle_deg((target.longitude_deg.front() + target.longitude_deg.back()) / 2)
    {
        for (const double longitude : target.longitude_deg)
            m_east_deg.push_back(longitude - m_middle_deg);
        m_sampling.shares.resize(target.size());
        m_sampling.alongX.resize(target.size(), Point(1, 0));
    }

    void addCell(std::size_t row, std::size_t column)
    {
        Cell cell{.rows = {row, std::min(row + 1, m_source.rows - 1)},
                  .columns = {column, std::min(column + 1, m_source.columns - 1)},
                  .corners = {}};
        for (std::size_t i = 0; i < 4; ++i) {
            const LatLon place = m_source.at(cell.rows[i / 2], cell.columns[i % 2]);
            cell.corners[i] =
                Point(eastFrom_deg(m_middle_deg, place.longitude_deg), place.latitude_deg);
            if (!cell.corners[i].allFinite())
                return;
        }
        Point low = cell.corners[0];
        Point high = cell.corners[0];
        for (const Point& corner : cell.corners) {
            low = low.cwiseMin(corner);
            high = high.cwiseMax(corner);
        }
        constexpr double kWidestCell_deg = 90; // a wider one crosses the far side of the Earth
        if (high.x() - low.x() < kWidestCell_deg)
            addPlaces(cell, low, high);
    }

    GridSampling done()
    {
        GridWindow& window = m_sampling.window;
        if (m_lastRow < m_firstRow)
            return std::move(m_sampling);
        window = {.firstRow = m_firstRow,
                  .rows = m_lastRow - m_firstRow + 1,
                  .firstColumn = m_firstColumn,
                  .columns = m_lastColumn - m_firstColumn + 1};
        for (NodeShares& shares : m_sampling.shares)
            for (std::size_t i = 0; i < 4; ++i)
                if (shares.weights[i] > 0)
                    shares.nodes[i] =
                        (shares.nodes[i] / m_source.columns - window.firstRow) * window.columns +
                        (shares.nodes[i] % m_source.columns - window.firstColumn);
        return std::move(m_sampling);
    }

private:
    void addPlaces(const Cell& cell, const Point& low, const Point& high)
    {
        constexpr double kEdge_deg = 1e-6;
        const auto range = [](const std::vector<double>& axis, double from, double to) {
            return std::pair(std::ranges::lower_bound(axis, from - kEdge_deg) - axis.begin(),
                             std::ranges::upper_bound(axis, to + kEdge_deg) - axis.begin());
        };
        const auto [south, north] = range(m_target.latitude_deg, low.y(), high.y());
        const auto [west, east] = range(m_east_deg, low.x(), high.x());
        for (auto r = south; r < north; ++r)
            for (auto c = west; c < east; ++c)
                addPlace(cell, static_cast<std::size_t>(r), static_cast<std::size_t>(c));
    }

    void addPlace(const Cell& cell, std::size_t row, std::size_t column)
    {
        NodeShares& shares = m_sampling.shares[row * m_east_deg.size() + column];
        if (std::ranges::any_of(shares.weights, [](double weight) { return weight > 0; }))
            return;
        const double latitude_deg = m_target.latitude_deg[row];
        const std::optional<InCell> at = positionIn(cell, {m_east_deg[column], latitude_deg});
        if (!at)
            return;
        shares.weights = {(1 - at->row) * (1 - at->column), (1 - at->row) * at->column,
                          at->row * (1 - at->column), at->row * at->column};
        for (std::size_t i = 0; i < 4; ++i) {
            shares.nodes[i] = cell.rows[i / 2] * m_source.columns + cell.columns[i % 2];
            if (shares.weights[i] > 0)
                widen(cell.rows[i / 2], cell.columns[i % 2]);
        }
        const Point along = alongColumns(cell, *at, latitude_deg);
        m_sampling.alongX[row * m_east_deg.size() + column] =
            m_source.againstX ? Point(-along) : along;
    }

    void widen(std::size_t row, std::size_t column)
    {
        m_firstRow = std::min(m_firstRow, row);
        m_lastRow = m_hasRow ? std::max(m_lastRow, row) : row;
        m_firstColumn = std::min(m_firstColumn, column);
        m_lastColumn = m_hasRow ? std::max(m_lastColumn, column) : column;
        m_hasRow = true;
    }

    const SourceGrid& m_source;
    const TargetGrid& m_target;
    double m_middle_deg;
    std::vector<double> m_east_deg;
    GridSampling m_sampling;
    std::size_t m_firstRow = std::numeric_limits<std::size_t>::max();
    std::size_t m_lastRow = 0;
    std::size_t m_firstColumn = std::numeric_limits<std::size_t>::max();
    std::size_t m_lastColumn = 0;
    bool m_hasRow = false;
};

} // namespace

GridSampling sampling(const SourceGrid& source, const TargetGrid& target,
                      const std::stop_token& stop)
{
    Sampler sampler(source, target);
    const auto cells = [](std::size_t nodes) { return nodes > 1 ? nodes - 1 : nodes; };
    for (std::size_t row = 0; row < cells(source.rows); ++row) {
        throwIfStopped(stop);
        for (std::size_t column = 0; column < cells(source.columns); ++column)
            sampler.addCell(row, column);
    }
    return sampler.done();
}

std::optional<double> sampled(const NodeShares& shares, const double* values)
{
    double sum = 0;
    double weight = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        if (shares.weights[i] <= 0)
            continue;
        const double value = values[shares.nodes[i]];
        if (std::isnan(value))
            continue;
        sum += shares.weights[i] * value;
        weight += shares.weights[i];
    }
    if (weight <= 0)
        return std::nullopt;
    return sum / weight;
}

} // namespace berg
