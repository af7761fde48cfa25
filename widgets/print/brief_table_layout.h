#pragma once

#include "widgets/print/brief_layout.h"

namespace berg {

/** Font size and number of page columns of the brief's table. */
struct BriefTableStyle
{
    int size_px = 12;
    int columns = 1; ///< tables side by side on the page
};

/** Table of a brief, which is cut if it does not fit. */
class BriefTable
{
public:
    /** Measures the content, which must outlive the table. */
    explicit BriefTable(const BriefContent& content);

    /** Returns true if the whole table fits, with iceberg names long enough to be distinct. */
    [[nodiscard]] bool fitsInto(const QSizeF& room, const BriefTableStyle& style) const;

    /** Returns the height of the table, which is cut to `room_px` if necessary. */
    [[nodiscard]] double heightIn_px(double room_px, const BriefTableStyle& style) const;

    /** Adds the table to the layout, each UAV cut to the same number of rows if necessary. */
    void setInto(BriefLayout& layout, const QRectF& room, const BriefTableStyle& style) const;

private:
    enum class LineKind
    {
        Name, ///< name of the UAV
        Row,
        More, ///< number of rows left out
        MoreUavs
    };
    struct TableLine
    {
        LineKind kind = LineKind::Row;
        std::size_t route = 0;
        std::size_t row = 0; ///< row index; for `More` and `MoreUavs` the number left out
    };
    /** A column of cells on the page. */
    struct Cell
    {
        std::size_t column = 0;
        double left_px = 0;
        double width_px = 0;
    };

    [[nodiscard]] std::vector<TableLine> linesWith(std::size_t rowsEach) const;
    [[nodiscard]] std::vector<TableLine> linesFor(double room_px,
                                                  const BriefTableStyle& style) const;
    [[nodiscard]] static double heightOf_px(const std::vector<TableLine>& lines,
                                            const BriefTableStyle& style);
    [[nodiscard]] static std::vector<std::vector<TableLine>>
    inColumns(const std::vector<TableLine>& lines, int columns);
    [[nodiscard]] std::array<double, kBriefColumns> widthsIn(double width_px, int size_px) const;
    [[nodiscard]] std::vector<Cell> cellsFor(double width_px, int size_px) const;
    void setCaptions(BriefLayout& layout, const std::vector<Cell>& cells, const QRectF& strip,
                     int size_px) const;
    void setLine(BriefLayout& layout, const TableLine& line, const std::vector<Cell>& cells,
                 const QRectF& strip, int size_px) const;
    void setCells(BriefLayout& layout, const BriefCells& texts, const std::vector<Cell>& cells,
                  const QRectF& strip, const BriefType& type) const;

    const BriefContent& m_content;
    std::size_t m_mostRows = 0;                   ///< largest number of rows per UAV
    std::array<double, kBriefColumns> m_widths{}; ///< by column, for a font size of 1 px
};

} // namespace berg
