#pragma once

// Private to core/io: edge weights of TSPLIB files (G. Reinelt, TSPLIB 95).

#include "core/geometry/geometry.h"
#include "core/plan/solve/names.h"

#include <array>
#include <cstdint>

namespace berg {

/** Type of edge weights, by the keyword of the format. */
enum class TsplibWeight : std::uint8_t
{
    Explicit,
    Euclidean,
    Ceiling,
    Pseudo,
    Geographic
};
inline constexpr std::array<Named<TsplibWeight>, 5> kTsplibWeightNames{{
    {TsplibWeight::Explicit, "EXPLICIT"},
    {TsplibWeight::Euclidean, "EUC_2D"},
    {TsplibWeight::Ceiling, "CEIL_2D"},
    {TsplibWeight::Pseudo, "ATT"},
    {TsplibWeight::Geographic, "GEO"},
}};

/**
 * Given part of the matrix. The columns of one triangle are the rows of the other, as distances are
 * then the same in both directions.
 */
enum class TsplibMatrix : std::uint8_t
{
    Full,
    Upper,
    UpperWithDiagonal,
    Lower,
    LowerWithDiagonal
};
inline constexpr std::array<Named<TsplibMatrix>, 9> kTsplibMatrixNames{{
    {TsplibMatrix::Full, "FULL_MATRIX"},
    {TsplibMatrix::Upper, "UPPER_ROW"},
    {TsplibMatrix::Lower, "LOWER_ROW"},
    {TsplibMatrix::UpperWithDiagonal, "UPPER_DIAG_ROW"},
    {TsplibMatrix::LowerWithDiagonal, "LOWER_DIAG_ROW"},
    {TsplibMatrix::Lower, "UPPER_COL"},
    {TsplibMatrix::Upper, "LOWER_COL"},
    {TsplibMatrix::LowerWithDiagonal, "UPPER_DIAG_COL"},
    {TsplibMatrix::UpperWithDiagonal, "LOWER_DIAG_COL"},
}};

/** Iterates over the given cells of a matrix of `nodes` rows, row by row. */
class TsplibCells
{
public:
    TsplibCells(TsplibMatrix part, Eigen::Index nodes) : m_part(part), m_nodes(nodes)
    {
        m_column = first();
        skipFinishedRows();
    }

    [[nodiscard]] bool atEnd() const { return m_row == m_nodes; }
    [[nodiscard]] Eigen::Index row() const { return m_row; }
    [[nodiscard]] Eigen::Index column() const { return m_column; }
    void advance()
    {
        ++m_column;
        skipFinishedRows();
    }
    /** Returns the total number of given cells. */
    [[nodiscard]] std::size_t count() const
    {
        const auto n = static_cast<std::size_t>(m_nodes);
        if (m_part == TsplibMatrix::Full)
            return n * n;
        const bool hasDiagonal =
            m_part == TsplibMatrix::UpperWithDiagonal || m_part == TsplibMatrix::LowerWithDiagonal;
        return n * (n - 1) / 2 + (hasDiagonal ? n : 0);
    }

private:
    [[nodiscard]] Eigen::Index first() const
    {
        if (m_part == TsplibMatrix::Upper)
            return m_row + 1;
        return m_part == TsplibMatrix::UpperWithDiagonal ? m_row : 0;
    }
    /** Returns the column after the last given one of the row. */
    [[nodiscard]] Eigen::Index behindLast() const
    {
        if (m_part == TsplibMatrix::Lower)
            return m_row;
        return m_part == TsplibMatrix::LowerWithDiagonal ? m_row + 1 : m_nodes;
    }
    void skipFinishedRows()
    {
        while (m_row < m_nodes && m_column >= behindLast()) {
            ++m_row;
            m_column = first();
        }
    }

    TsplibMatrix m_part;
    Eigen::Index m_nodes;
    Eigen::Index m_row = 0;
    Eigen::Index m_column = 0;
};

/**
 * Returns the weight between two places, a whole number in the unit of the file. For `Geographic`
 * the places are latitude and longitude as DDD.MM (degrees and minutes) and the weight is in
 * kilometres. Throws `std::logic_error` for `Explicit`.
 */
[[nodiscard]] double tsplibWeight(const Point& a, const Point& b, TsplibWeight type);

} // namespace berg
