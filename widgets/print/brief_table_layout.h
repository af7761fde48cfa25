#pragma once

#include "widgets/print/brief_layout.h"

namespace berg {

/** Type and columns of the table of the brief. */
struct BriefTableStyle
{
    int size_px = 12;
    int columns = 1; ///< of the page, side by side
};

/** The table of a brief, cut where there is no room for the whole of it. */
class BriefTable
{
public:
    explicit BriefTable(const BriefContent& content);

    /** The whole table does, with names of icebergs long enough to tell them apart. */
    [[nodiscard]] bool fitsInto(const QSizeF& room, const BriefTableStyle& style) const;

    /** Of the table in a room of this height, cut if need be. */
    [[nodiscard]] double heightIn_px(double room_px, const BriefTableStyle& style) const;

    /** Sets it into `room`, each UAV cut to the same number of rows if need be. */
    void setInto(BriefLayout& layout, const QRectF& room, const BriefTableStyle& style) const;

private:
    enum class LineKind
    {
        Name, ///< of the UAV
        Row,
        More, ///< so many rows are left out
        MoreUavs
    };
    struct Line
    {
        LineKind kind = LineKind::Row;
        std::size_t route = 0;
        std::size_t row = 0; ///< of `More` and `MoreUavs`, how many
    };
    /** A column of cells on the page. */
    struct Cell
    {
        std::size_t column = 0;
        double left_px = 0;
        double width_px = 0;
    };

    [[nodiscard]] std::vector<Line> linesWith(std::size_t rowsEach) const;
    [[nodiscard]] std::vector<Line> linesFor(double room_px, const BriefTableStyle& style) const;
    [[nodiscard]] static double heightOf_px(const std::vector<Line>& lines,
                                            const BriefTableStyle& style);
    [[nodiscard]] static std::vector<std::vector<Line>> inColumns(const std::vector<Line>& lines,
                                                                  int columns);
    [[nodiscard]] std::array<double, kBriefColumns> widthsIn(double width_px, int size_px) const;
    [[nodiscard]] std::vector<Cell> cellsFor(double width_px, int size_px) const;
    void setCaptions(BriefLayout& layout, const std::vector<Cell>& cells, const QRectF& strip,
                     int size_px) const;
    void setLine(BriefLayout& layout, const Line& line, const std::vector<Cell>& cells,
                 const QRectF& strip, int size_px) const;
    void setCells(BriefLayout& layout, const BriefCells& texts, const std::vector<Cell>& cells,
                  const QRectF& strip, const BriefType& type) const;

    const BriefContent& m_content;
    std::size_t m_mostRows = 0;                   ///< of one UAV
    std::array<double, kBriefColumns> m_widths{}; ///< for type of 1 px
};

} // namespace berg
