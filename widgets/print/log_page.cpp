#include "widgets/print/log_page.h"

#include "core/io/export/flight_log.h"
#include "widgets/charts/figure_painter.h"
#include "widgets/charts/figure_text.h"
#include "widgets/print/brief_table.h"
#include "widgets/print/flight_brief.h"
#include "widgets/print/page_text.h"
#include "widgets/print/printable_text.h"
#include "widgets/print/printed_document.h"
#include "widgets/print/printed_map.h"
#include "widgets/words/policy_words.h"

#include <algorithm>
#include <memory>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr double kChart_px = 300;    // height
constexpr double kLeastMap_px = 240; // height

/** Quantities as in the window; the figure becomes the picture "chart". */
LogFormat paperFormat(const ExportContent& content, const QLocale& locale, double width_px,
                      Figure& figure)
{
    const MissionClock clock{.start = content.start};
    return {.start = html(clock.dateText(0)),
            .time = [clock](double time_s) { return html(clock.text(time_s)); },
            .date = [clock](double time_s) { return html(clock.dateText(time_s)); },
            .duration = [](double time_s) { return html(clockText(time_s)); },
            .distance = [locale](double m) { return html(distanceText(m, locale)); },
            .zeta = [locale](double m2s) { return html(zetaText(m2s, locale)); },
            .sigma = [locale](double m2) { return html(significantText(m2, 3, locale)); },
            .radius = [locale](double m2) { return html(radius95Text(m2, locale)); },
            .planner = [locale](const PlannerSettings& of) { return html(policyText(of, locale)); },
            .number = numberText(locale),
            .speed = [locale](double mps,
                              int decimals) { return html(fixedSpeedText(mps, decimals, locale)); },
            .figure =
                [&figure, width_px](const Figure& drawn) {
                    figure = drawn;
                    return pictureHtml("chart", {width_px, kChart_px});
                }};
}

} // namespace

PicturePage logPage(const ExportContent& content, const QLocale& locale)
{
    auto document = std::make_shared<PrintedDocument>();
    document->paper_px = briefPage_px(locale);
    const double width_px = document->room_px().width();
    Figure figure;
    const LogPage log = logPage(content, paperFormat(content, locale, width_px, figure));
    const QString title = printable(log.title);
    const std::string head = "<h1>" + html(title) + "</h1>\n<p>" + html(pathsText(content)) +
                             "</p>\n<hr/>\n" + log.summary;
    document->html = withPrintableNames(head + log.figure);
    document->pictures[u"chart"_s] =
        [drawing = layOut(figure, {width_px, kChart_px}, figureFonts(Theme::light()))](
            QPainter& painter) { paintDrawing(painter, drawing, Theme::light()); };
    constexpr double kGap_px = 6;
    const QSizeF map_px(width_px,
                        std::max(kLeastMap_px, PrintedText(*document).spare_px() - kGap_px));
    document->pictures[u"map"_s] = printedMap(content, map_px, locale);
    document->html = withFewMarks(
        withPrintableNames(head + pictureHtml("map", map_px) + log.figure + log.details));
    const int pages = PrintedText(*document).pageCount();
    const auto paint = [document, pages](int page) {
        return [document, page, pages](QPainter& painter) {
            PrintedText(*document).paintPage(painter, page);
            const QSizeF room_px = document->room_px();
            painter.setFont(printFont(kPrint_px));
            painter.setPen(Qt::black);
            painter.drawText(QRectF(QPointF(kPaperMargin_px, kPaperMargin_px + room_px.height()),
                                    QSizeF(room_px.width(), kPaperMargin_px / 2)),
                             Qt::AlignRight | Qt::AlignBottom,
                             u"%1 / %2"_s.arg(page + 1).arg(pages));
        };
    };
    PicturePage page{.size_px = document->paper_px,
                     .title = title,
                     .description = QString::fromStdString(figure.description),
                     .paint = paint(0)};
    for (int more = 1; more < pages; ++more)
        page.more.emplace_back(paint(more));
    return page;
}

} // namespace berg
