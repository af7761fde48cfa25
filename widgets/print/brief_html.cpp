#include "widgets/print/brief_html.h"

#include "core/io/text/html_text.h"
#include "widgets/print/printed_document.h"

#include <algorithm>
#include <numeric>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr double kCell_px = 6;     // padding and border of a cell
constexpr double kGutter_px = 8;   // between tables side by side
constexpr double kWidestName = 18; // of an iceberg, relative to the font size
constexpr double kLeastName = 5.5;

/** Columns dropped on a narrow page, the least important first. */
constexpr std::array kDispensable = {BriefColumn::SecondUncertainty, BriefColumn::LegTime,
                                     BriefColumn::FirstUncertainty, BriefColumn::GroundSpeed};

std::string inElement(const std::string& element, const std::string& content)
{
    return '<' + element + '>' + content + "</" + element.substr(0, element.find(' ')) + ">\n";
}

std::string htmlFacts(const std::vector<BriefFact>& facts, std::size_t columns)
{
    std::vector<HtmlFact> all;
    for (const BriefFact& fact : facts)
        all.push_back({html(fact.caption), html(fact.value)});
    return factsHtml(all, columns);
}

/** Widths of the columns for the routes' texts; zero if a column is empty or dropped. */
std::array<double, kBriefColumns> columnWidths(const BriefContent& content, const BriefFit& fit,
                                               double width_px)
{
    std::array<double, kBriefColumns> widths_px{};
    const auto measure = [&](const BriefCells& cells) {
        for (std::size_t i = 0; i < kBriefColumns; ++i)
            if (!cells[i].isEmpty())
                widths_px[i] =
                    std::max(widths_px[i], kCell_px + printWidth_px(cells[i], fit.size_px));
    };
    measure(content.captions.names);
    measure(content.captions.units);
    for (const BriefRoute& route : content.routes)
        for (std::size_t row = 0; row < std::min(route.rows.size(), fit.rows); ++row)
            measure(route.rows[row]);
    double& name_px = widths_px[placeOf(BriefColumn::Name)];
    const double least_px = std::min(name_px, kLeastName * fit.size_px + kCell_px);
    const auto others_px = [&] {
        return std::accumulate(widths_px.begin(), widths_px.end(), 0.0) - name_px;
    };
    for (const BriefColumn column : kDispensable)
        if (others_px() + least_px > width_px)
            widths_px[placeOf(column)] = 0;
    name_px = std::clamp(width_px - others_px(), least_px,
                         std::max(least_px, std::min(name_px, kWidestName * fit.size_px)));
    return widths_px;
}

/** Writes the routes as tables side by side. */
class RouteTables
{
public:
    RouteTables(const BriefContent& content, const BriefFit& fit,
                const std::vector<QColor>& colours, double width_px)
        : m_content(content)
        , m_fit(fit)
        , m_colours(colours)
        , m_widths_px(columnWidths(content, fit,
                                   width_px / static_cast<double>(fit.columns) -
                                       (fit.columns > 1 ? kGutter_px : 0)))
    {
    }

    [[nodiscard]] std::string html() const
    {
        const std::vector<std::string> lines = allLines();
        const std::size_t each = (lines.size() + m_fit.columns - 1) / m_fit.columns;
        std::string tables;
        for (std::size_t from = 0; from < lines.size(); from += each) {
            const auto begin = lines.begin() + static_cast<std::ptrdiff_t>(from);
            const auto end =
                lines.begin() + static_cast<std::ptrdiff_t>(std::min(lines.size(), from + each));
            const std::string table = "<table class=\"nowrap\" width=\"100%\" style=\"font-size: " +
                                      std::to_string(m_fit.size_px) + "px\">\n<thead>" +
                                      captions() + "</thead>\n<tbody>\n" +
                                      std::accumulate(begin, end, std::string()) +
                                      "</tbody>\n</table>";
            tables += m_fit.columns == 1
                          ? table
                          : "<td style=\"padding: 0 8px 0 0; border: 0px\" width=\"" +
                                std::to_string(100 / m_fit.columns) + "%\">" + table + "</td>";
        }
        return m_fit.columns == 1 ? tables
                                  : "<table width=\"100%\"><tr>" + tables + "</tr></table>\n";
    }

private:
    [[nodiscard]] std::vector<std::string> allLines() const
    {
        const std::vector<BriefRoute>& routes = m_content.routes;
        const std::size_t shown = std::min(routes.size(), m_fit.routes);
        std::vector<std::string> lines;
        for (std::size_t i = 0; i < shown; ++i) {
            const BriefRoute& route = routes[i];
            if (!route.name.isEmpty())
                lines.push_back(line("<span style=\"background-color: " +
                                     m_colours.at(route.uav).name().toStdString() +
                                     "\">&#160;&#160;&#160;</span> <b>" +
                                     htmlWithin(route.name, 30.0 * m_fit.size_px, m_fit.size_px) +
                                     "</b>"));
            for (std::size_t row = 0; row < std::min(route.rows.size(), m_fit.rows); ++row)
                lines.push_back(inElement("tr", cells(route.rows[row], "td")));
            if (route.rows.size() > m_fit.rows)
                lines.push_back(more(FlightBrief::tr("and %1 more; export CSV for the whole list")
                                         .arg(route.rows.size() - m_fit.rows)));
        }
        if (shown < routes.size())
            lines.push_back(more(FlightBrief::tr("and %1 more UAVs; export CSV for the whole list")
                                     .arg(routes.size() - shown)));
        return lines;
    }

    /** A line over all columns. */
    [[nodiscard]] std::string line(const std::string& text) const
    {
        const auto shown = std::ranges::count_if(m_widths_px, [](double px) { return px > 0; });
        return "<tr><td class=\"text\" colspan=\"" + std::to_string(shown) + "\">" + text +
               "</td></tr>\n";
    }

    [[nodiscard]] std::string more(const QString& text) const
    {
        return line(inElement("b", berg::html(text)));
    }

    [[nodiscard]] std::string captions() const
    {
        return inElement("tr", cells(m_content.captions.names, "th", &m_content.captions.units));
    }

    [[nodiscard]] std::string cells(const BriefCells& texts, const std::string& element,
                                    const BriefCells* below = nullptr) const
    {
        std::string row;
        for (std::size_t i = 0; i < kBriefColumns; ++i) {
            if (m_widths_px[i] == 0)
                continue;
            const bool isName = i == placeOf(BriefColumn::Name);
            std::string text = isName
                                   ? htmlWithin(texts[i], m_widths_px[i] - kCell_px, m_fit.size_px)
                                   : berg::html(texts[i]);
            if (below != nullptr)
                text.insert(0, "<b>").append("</b><br/>").append(berg::html((*below)[i]));
            const bool isNumber = i == placeOf(BriefColumn::Number);
            row += inElement(element + (isName ? " class=\"text\"" : "") +
                                 (isNumber ? " width=\"1%\"" : ""),
                             text);
        }
        return row;
    }

    const BriefContent& m_content;
    const BriefFit& m_fit;
    const std::vector<QColor>& m_colours;
    std::array<double, kBriefColumns> m_widths_px;
};

/** Returns the warnings on so many lines; if there are more, the last line gives their number. */
std::string warningsHtml(const QStringList& warnings, int mostLines, double width_px)
{
    if (warnings.isEmpty())
        return inElement("h2", html(FlightBrief::tr("No warnings")));
    std::string items;
    int lines = 0;
    for (qsizetype i = 0; i < warnings.size(); ++i) {
        const qsizetype left = warnings.size() - i;
        const int needed = printWidth_px(warnings[i]) > width_px ? 2 : 1;
        if (lines + needed > mostLines - (left > 1 ? 1 : 0)) {
            items += inElement("li", html(FlightBrief::tr("and %1 more").arg(left)));
            break;
        }
        lines += needed;
        constexpr double kTwoLines = 1.9; // words move to the second one
        items += inElement("li", htmlWithin(warnings[i], kTwoLines * width_px));
    }
    return inElement("h2", html(FlightBrief::tr("Warnings (%1)").arg(warnings.size()))) +
           inElement("ul", items);
}

} // namespace

std::string uavTableHtml(const std::vector<QStringList>& rows, double width_px)
{
    constexpr std::size_t kMostRows = 8; // without captions
    constexpr double kNameShare = 0.25;  // of the width, at most
    const auto cellsOf = [&](const QStringList& row) {
        std::vector<std::string> cells;
        for (const QString& cell : row)
            cells.push_back(cells.empty() ? htmlWithin(cell, kNameShare * width_px) : html(cell));
        return cells;
    };
    const std::size_t uavs = rows.size() - 1;
    const std::size_t shown = uavs > kMostRows ? kMostRows - 1 : uavs;
    HtmlTable table({}, cellsOf(rows.front()));
    for (std::size_t row = 1; row <= shown; ++row)
        table.addRow(cellsOf(rows[row]));
    return table.html() +
           (shown < uavs ? inElement("p", html(FlightBrief::tr("and %1 more").arg(uavs - shown)))
                         : std::string());
}

std::string briefHtml(const BriefContent& content, const BriefFit& fit,
                      const std::vector<QColor>& colours, double width_px)
{
    constexpr std::size_t kFactColumns = 4;
    constexpr double kTitle = 2; // size of a heading
    std::vector<BriefFact> facts = content.flight;
    facts.insert(facts.end(), content.planning.begin(), content.planning.end());
    std::string page = inElement("h1", htmlWithin(content.title, 0.85 * width_px / kTitle)) +
                       "<table class=\"plain\" width=\"100%\"><tr><td>" +
                       html(FlightBrief::tr("Flight brief: %1").arg(content.about)) + " · " +
                       html(content.origin) + "</td><td class=\"end\"><b>" + html(content.start) +
                       "</b></td></tr></table>\n<hr/>\n" + htmlFacts(facts, kFactColumns) +
                       uavTableHtml(content.uavs, width_px);
    if (!content.sorties.empty())
        page += uavTableHtml(content.sorties, width_px);
    if (!content.weather.rows.empty())
        page += uavTableHtml(content.weather.rows, width_px) +
                inElement("p class=\"foot\"", htmlWithin(content.weather.source, width_px));
    page += pictureHtml("map", {width_px, fit.map_px}) +
            RouteTables(content, fit, colours, width_px).html() +
            warningsHtml(content.warnings, fit.warningLines, width_px);
    if (!content.notes.isEmpty())
        page += inElement("h2", html(FlightBrief::tr("Notes"))) +
                inElement("p", htmlWithin(content.notes, 0.9 * fit.noteLines * width_px));
    return page + inElement("p class=\"foot\"", html(content.foot));
}

} // namespace berg
