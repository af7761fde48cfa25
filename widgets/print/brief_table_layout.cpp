#include "widgets/print/brief_table_layout.h"

#include "widgets/print/brief_surroundings.h"

#include <QFontMetricsF>

#include <algorithm>
#include <iterator>
#include <numeric>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr double kGutter_px = 16;   // between tables side by side
constexpr double kLeastGap_px = 6;  // between cells
constexpr double kSpareText_px = 1; // tolerance of measured text widths
constexpr double kLeastName = 5.5;  // smallest width of iceberg names, relative to the font size
constexpr double kWidestName = 18;  // largest width of iceberg names, relative to the font size
constexpr int kMeasured_px = 100;   // measuring size; widths are proportional to it

/** Columns dropped on a narrow page, the least important first. */
constexpr std::array kDispensable = {BriefColumn::SecondUncertainty, BriefColumn::LegTime,
                                     BriefColumn::FirstUncertainty, BriefColumn::GroundSpeed};

/** Height of the captions: two lines, closer than those of the table. */
double captionsHeight_px(int size_px)
{
    return std::round(2.5 * size_px);
}

double columnWidth_px(double width_px, int columns)
{
    return (width_px - kGutter_px * (columns - 1)) / columns;
}

bool isLeftAligned(std::size_t column)
{
    return column == placeOf(BriefColumn::Name);
}

} // namespace

BriefTable::BriefTable(const BriefContent& content) : m_content(content)
{
    const auto measure = [this](const BriefCells& cells, bool isBold) {
        const QFontMetricsF metrics(briefFont({.size_px = kMeasured_px, .isBold = isBold}));
        for (std::size_t i = 0; i < kBriefColumns; ++i)
            m_widths[i] = std::max(m_widths[i], metrics.horizontalAdvance(cells[i]) / kMeasured_px);
    };
    measure(content.captions.names, true);
    measure(content.captions.units, false);
    for (const BriefRoute& route : content.routes) {
        m_mostRows = std::max(m_mostRows, route.rows.size());
        for (const BriefCells& row : route.rows)
            measure(row, false);
    }
    double& name = m_widths[placeOf(BriefColumn::Name)];
    name = std::min(name, kWidestName);
}

std::vector<BriefTable::TableLine> BriefTable::linesWith(std::size_t rowsEach) const
{
    std::vector<TableLine> lines;
    for (std::size_t route = 0; route < m_content.routes.size(); ++route) {
        const std::size_t rows = m_content.routes[route].rows.size();
        if (!m_content.routes[route].name.isEmpty())
            lines.push_back({.kind = LineKind::Name, .route = route});
        for (std::size_t row = 0; row < std::min(rows, rowsEach); ++row)
            lines.push_back({.kind = LineKind::Row, .route = route, .row = row});
        if (rows > rowsEach)
            lines.push_back({.kind = LineKind::More, .route = route, .row = rows - rowsEach});
    }
    return lines;
}

std::vector<std::vector<BriefTable::TableLine>>
BriefTable::inColumns(const std::vector<TableLine>& lines, int columns)
{
    const auto count = static_cast<std::size_t>(columns);
    const std::size_t each = (lines.size() + count - 1) / count;
    std::vector<std::vector<TableLine>> parts;
    std::size_t next = 0;
    while (next < lines.size()) {
        std::size_t end = std::min(lines.size(), next + each);
        // A name stays with the first of its rows.
        if (end < lines.size() && end > next + 1 && lines[end - 1].kind == LineKind::Name)
            --end;
        if (parts.size() + 1 == count)
            end = lines.size();
        parts.emplace_back(lines.begin() + static_cast<std::ptrdiff_t>(next),
                           lines.begin() + static_cast<std::ptrdiff_t>(end));
        next = end;
    }
    return parts;
}

double BriefTable::heightOf_px(const std::vector<TableLine>& lines, const BriefTableStyle& style)
{
    std::size_t longest = 0;
    for (const auto& part : inColumns(lines, style.columns))
        longest = std::max(longest, part.size());
    return captionsHeight_px(style.size_px) +
           static_cast<double>(longest) * linePitch_px(style.size_px);
}

/** Lines that fit: an equal number of rows for each UAV, as many as possible. If even one row each
 * is too much, the first row of the first UAVs. */
std::vector<BriefTable::TableLine> BriefTable::linesFor(double room_px,
                                                        const BriefTableStyle& style) const
{
    constexpr double kRounding_px = 1e-6;
    const auto fits = [&](const std::vector<TableLine>& lines) {
        return heightOf_px(lines, style) <= room_px + kRounding_px;
    };
    for (std::size_t rowsEach = m_mostRows; rowsEach > 0; --rowsEach)
        if (std::vector<TableLine> lines = linesWith(rowsEach); fits(lines))
            return lines;
    const std::vector<TableLine> firstRows = linesWith(1);
    std::vector<TableLine> lines;
    for (std::size_t uavs = m_content.routes.size(); uavs-- > 0;) {
        lines.clear();
        std::ranges::copy_if(firstRows, std::back_inserter(lines),
                             [uavs](const TableLine& line) { return line.route < uavs; });
        lines.push_back({.kind = LineKind::MoreUavs, .row = m_content.routes.size() - uavs});
        if (fits(lines))
            break;
    }
    return lines;
}

double BriefTable::heightIn_px(double room_px, const BriefTableStyle& style) const
{
    return heightOf_px(linesFor(room_px, style), style);
}

bool BriefTable::fitsInto(const QSizeF& room, const BriefTableStyle& style) const
{
    const std::size_t name = placeOf(BriefColumn::Name);
    const double width_px = columnWidth_px(room.width(), style.columns);
    return heightOf_px(linesWith(m_mostRows), style) <= room.height() &&
           widthsIn(width_px, style.size_px)[name] >=
               std::min(m_widths[name], kLeastName) * style.size_px;
}

/** Widths of the columns; zero if a column is dropped. */
std::array<double, kBriefColumns> BriefTable::widthsIn(double width_px, int size_px) const
{
    std::array<double, kBriefColumns> widths_px{};
    for (std::size_t i = 0; i < kBriefColumns; ++i)
        widths_px[i] = m_widths[i] > 0 ? m_widths[i] * size_px + kSpareText_px : 0;
    const std::size_t name = placeOf(BriefColumn::Name);
    const double leastName_px = std::min(widths_px[name], kLeastName * size_px + kSpareText_px);
    const auto others_px = [&] {
        const auto shown = std::ranges::count_if(widths_px, [](double w) { return w > 0; });
        return std::accumulate(widths_px.begin(), widths_px.end(), 0.0) - widths_px[name] +
               kLeastGap_px * static_cast<double>(shown - 1);
    };
    for (const BriefColumn column : kDispensable)
        if (others_px() + leastName_px > width_px)
            widths_px[placeOf(column)] = 0;
    widths_px[name] = std::clamp(width_px - others_px(), 0.0, widths_px[name]);
    return widths_px;
}

/** Positions of the cells, spread over the whole width, with the number close to the name. */
std::vector<BriefTable::Cell> BriefTable::cellsFor(double width_px, int size_px) const
{
    const std::array<double, kBriefColumns> widths_px = widthsIn(width_px, size_px);
    const double number_px = widths_px[placeOf(BriefColumn::Number)];
    const auto shown = std::ranges::count_if(widths_px, [](double w) { return w > 0; });
    const double spare_px = width_px - std::accumulate(widths_px.begin(), widths_px.end(), 0.0) -
                            (number_px > 0 ? kLeastGap_px : 0);
    const double gaps = static_cast<double>(shown) - (number_px > 0 ? 2 : 1);
    std::vector<Cell> cells;
    double left_px = 0;
    for (std::size_t i = 0; i < kBriefColumns; ++i)
        if (widths_px[i] > 0) {
            cells.push_back({.column = i, .left_px = left_px, .width_px = widths_px[i]});
            left_px +=
                widths_px[i] + (i == placeOf(BriefColumn::Number) ? kLeastGap_px : spare_px / gaps);
        }
    return cells;
}

void BriefTable::setCaptions(BriefLayout& layout, const std::vector<Cell>& cells,
                             const QRectF& strip, int size_px) const
{
    const QRectF names = strip.adjusted(0, 0, 0, -strip.height() / 2);
    setCells(layout, m_content.captions.names, cells, names, {.size_px = size_px, .isBold = true});
    setCells(layout, m_content.captions.units, cells, names.translated(0, names.height()),
             {.size_px = size_px, .isMuted = true});
    layout.rules.push_back({QLineF(strip.bottomLeft(), strip.bottomRight()), true});
}

void BriefTable::setCells(BriefLayout& layout, const BriefCells& texts,
                          const std::vector<Cell>& cells, const QRectF& strip,
                          const BriefType& type) const
{
    for (const Cell& cell : cells) {
        BriefType own = type;
        own.isRight = !isLeftAligned(cell.column);
        setText(layout,
                QRectF(strip.left() + cell.left_px, strip.top(), cell.width_px, strip.height()),
                texts[cell.column], own);
    }
}

void BriefTable::setLine(BriefLayout& layout, const TableLine& line, const std::vector<Cell>& cells,
                         const QRectF& strip, int size_px) const
{
    const double sign_px = 0.62 * size_px;
    switch (line.kind) {
    case LineKind::Name:
        layout.signs.push_back(
            {QRectF(strip.left(), strip.center().y() - sign_px / 2, sign_px, sign_px),
             m_content.routes[line.route].uav});
        setText(layout, strip.adjusted(sign_px + 5, 0, 0, 0), m_content.routes[line.route].name,
                {.size_px = size_px, .isBold = true});
        return;
    case LineKind::Row:
        setCells(layout, m_content.routes[line.route].rows[line.row], cells, strip,
                 {.size_px = size_px});
        return;
    case LineKind::More:
        setText(layout, strip,
                FlightBrief::tr("and %1 more; export CSV for the whole list").arg(line.row),
                {.size_px = size_px, .isBold = true});
        return;
    case LineKind::MoreUavs:
        setText(layout, strip,
                FlightBrief::tr("and %1 more UAVs; export CSV for the whole list").arg(line.row),
                {.size_px = size_px, .isBold = true});
        return;
    }
}

void BriefTable::setInto(BriefLayout& layout, const QRectF& room,
                         const BriefTableStyle& style) const
{
    const double captions_px = captionsHeight_px(style.size_px);
    const double pitch_px = linePitch_px(style.size_px);
    const double width_px = columnWidth_px(room.width(), style.columns);
    const std::vector<Cell> cells = cellsFor(width_px, style.size_px);
    double left_px = room.left();
    for (const std::vector<TableLine>& part :
         inColumns(linesFor(room.height(), style), style.columns)) {
        QRectF strip(left_px, room.top(), width_px, captions_px);
        setCaptions(layout, cells, strip, style.size_px);
        strip = QRectF(left_px, strip.bottom() - pitch_px, width_px, pitch_px);
        for (const TableLine& line : part) {
            strip.translate(0, pitch_px);
            setLine(layout, line, cells, strip, style.size_px);
            layout.rules.push_back({QLineF(strip.bottomLeft(), strip.bottomRight())});
        }
        left_px += width_px + kGutter_px;
    }
}

} // namespace berg
