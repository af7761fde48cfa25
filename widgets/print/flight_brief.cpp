#include "widgets/print/flight_brief.h"

#include "widgets/print/brief_html.h"
#include "widgets/print/operation_page.h"
#include "widgets/print/page_text.h"
#include "widgets/print/printed_map.h"

#include <array>
#include <cmath>
#include <memory>
#include <optional>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

// Paper sizes at 96 per inch.
constexpr QSize kA4_px{794, 1123};
constexpr QSize kLetter_px{816, 1056};

constexpr int kSmallest_px = 9; // font size: 6.75 pt

/** The most generous first. */
constexpr std::array<BriefFit, 10> kFits{{{.size_px = 12},
                                          {.size_px = 11},
                                          {.size_px = 10},
                                          {.size_px = 10, .columns = 2},
                                          {.size_px = kSmallest_px, .columns = 2},
                                          {.size_px = kSmallest_px},
                                          {kSmallest_px, 2, 7, 3, 300},
                                          {kSmallest_px, 1, 7, 3, 300},
                                          {kSmallest_px, 2, 5, 1, 240},
                                          {kSmallest_px, 1, 5, 1, 240}}};

/** Finds how a brief fits on one page. */
class BriefFitter
{
public:
    BriefFitter(PrintedDocument& document, const BriefContent& content,
                const std::vector<QColor>& colours)
        : m_document(document), m_content(content), m_colours(colours)
    {
    }

    /** Writes the brief into the document and returns how it fits. */
    BriefFit fitted()
    {
        for (const BriefFit& fit : kFits)
            if (const auto spare = spare_px(fit))
                return grown(fit, *spare);
        BriefFit fit = kFits.back();
        for (const std::size_t columns : {std::size_t{2}, std::size_t{1}}) {
            fit.columns = columns;
            setMost(fit, fit.rows, mostLines(fit));
            if (const auto spare = spare_px(fit); spare && fit.rows > 1)
                return grown(fit, *spare);
        }
        for (const std::size_t columns : {std::size_t{2}, std::size_t{1}}) {
            fit.columns = columns;
            setMost(fit, fit.routes, m_content.routes.size());
            if (const auto spare = spare_px(fit))
                return grown(fit, *spare);
        }
        return grown(fit, 0);
    }

private:
    /** Lines of routes that a page has room for at most. */
    [[nodiscard]] std::size_t mostLines(const BriefFit& fit) const
    {
        return fit.columns * static_cast<std::size_t>(m_document.room_px().height() / fit.size_px);
    }

    [[nodiscard]] std::size_t linesWith(std::size_t rows) const
    {
        std::size_t lines = 0;
        for (const BriefRoute& route : m_content.routes)
            lines += std::min(rows, route.rows.size());
        return lines;
    }

    /** Sets `part` of `fit` to the largest value up to `most` that fits, at least 1. */
    void setMost(BriefFit& fit, std::size_t& part, std::size_t most)
    {
        std::size_t least = 1;
        while (least < most) {
            part = (least + most + 1) / 2;
            if (spare_px(fit))
                least = part;
            else
                most = part - 1;
        }
        part = least;
    }

    void write(const BriefFit& fit)
    {
        m_document.html = briefHtml(m_content, fit, m_colours, m_document.room_px().width());
    }

    /** Returns the height left on the page, nullopt if the brief does not fit. */
    std::optional<double> spare_px(const BriefFit& fit)
    {
        if (fit.routes >= m_content.routes.size() && linesWith(fit.rows) > mostLines(fit))
            return std::nullopt; // without the cost of a layout
        write(fit);
        constexpr double kBorders_px = 5; // of tables
        const PrintedText text(m_document);
        if (text.size().width() > m_document.room_px().width() + kBorders_px)
            return std::nullopt;
        const double spare = text.spare_px();
        return spare >= 0 ? std::optional(spare) : std::nullopt;
    }

    /** The map gets the height that is left. */
    BriefFit grown(BriefFit fit, double spare_px)
    {
        fit.map_px += std::floor(spare_px);
        write(fit);
        return fit;
    }

    PrintedDocument& m_document;
    const BriefContent& m_content;
    const std::vector<QColor>& m_colours;
};

} // namespace

QSize briefPage_px(const QLocale& locale)
{
    return locale.measurementSystem() == QLocale::ImperialUSSystem ? kLetter_px : kA4_px;
}

PrintedDocument briefDocument(const ExportContent& content, const QLocale& locale)
{
    PrintedDocument document{.paper_px = briefPage_px(locale)};
    std::vector<QColor> colours;
    for (std::size_t uav = 0; uav < content.uavs.size(); ++uav)
        colours.push_back(printedColour(content, uav));
    const BriefContent words = briefContent(content, locale);
    const BriefFit fit = BriefFitter(document, words, colours).fitted();
    document.pictures[u"map"_s] =
        printedMap(content, {document.room_px().width(), fit.map_px}, locale);
    return document;
}

PicturePage flightBrief(const ExportContent& content, const QLocale& locale)
{
    const auto painted = [](PrintedDocument document) {
        return [document = std::make_shared<const PrintedDocument>(std::move(document))](
                   QPainter& painter) { PrintedText(*document).paintPage(painter, 0); };
    };
    PicturePage page{.size_px = briefPage_px(locale),
                     .title = FlightBrief::tr("Flight brief: %1").arg(pageTitle(content)),
                     .description = pathsText(content),
                     .paint = painted(briefDocument(content, locale))};
    if (content.operation)
        page.more.emplace_back(painted(operationDocument(content, locale)));
    return page;
}

} // namespace berg
