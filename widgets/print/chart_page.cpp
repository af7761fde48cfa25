#include "widgets/print/chart_page.h"

#include "core/base/error.h"
#include "widgets/charts/figure_painter.h"
#include "widgets/charts/mission_charts.h"
#include "widgets/print/document_chart.h"
#include "widgets/print/page_text.h"
#include "widgets/print/printable_text.h"
#include "widgets/theme/painter_state.h"
#include "widgets/theme/quantity_text.h"

#include <QCoreApplication>
#include <QFontMetricsF>

#include <memory>
#include <vector>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr QSize kPage_px(1120, 980);
constexpr double kHead_px = 60;
constexpr int kTitle_px = 18; // font size

struct ChartPageText
{
    Q_DECLARE_TR_FUNCTIONS(ChartPageText)
};

/** Data that the page is painted from. */
struct ChartSheet
{
    QString title;
    QString subtitle;
    Theme theme = Theme::light();
    std::vector<TimeFigure> charts; ///< from top to bottom

    /** Returns the height of a chart when there are so many. */
    [[nodiscard]] static double chart_px(std::size_t count)
    {
        return (kPage_px.height() - kHead_px) / static_cast<double>(count);
    }
};

void paintHead(QPainter& painter, const ChartSheet& sheet)
{
    const double width_px = kPage_px.width() - 2 * kFigureSide_px;
    double top_px = 16;
    const auto line = [&](const QFont& font, const QColor& colour, const QString& text) {
        const QFontMetricsF metrics(font);
        painter.setFont(font);
        painter.setPen(colour);
        painter.drawText(QPointF(kFigureSide_px, top_px + metrics.ascent()),
                         metrics.elidedText(text, Qt::ElideRight, width_px));
        top_px += metrics.height() + 2;
    };
    QFont large = sheet.theme.strong();
    large.setPixelSize(kTitle_px);
    line(large, sheet.theme.text, sheet.title);
    line(sheet.theme.small(), sheet.theme.mutedText, sheet.subtitle);
}

void paintSheet(QPainter& painter, const ChartSheet& sheet)
{
    const PainterState saved(painter);
    paintHead(painter, sheet);
    painter.translate(0, kHead_px);
    for (const TimeFigure& chart : sheet.charts) {
        paintDrawing(painter, chart.drawing, sheet.theme);
        painter.translate(0, ChartSheet::chart_px(sheet.charts.size()));
    }
}

} // namespace

PicturePage chartPage(const ExportContent& content, const QLocale& locale)
{
    if (content.mission == nullptr)
        throw Error(ErrorCode::InvalidInput, "format", {IssueId::NothingFlown});
    auto sheet = std::make_shared<ChartSheet>();
    sheet->title = pageTitle(content);
    sheet->subtitle =
        pageSubtitle(content,
                     ChartPageText::tr("Flown until %1")
                         .arg(MissionClock{.start = content.start}.text(content.now_s)),
                     locale);
    const FlightRecord record = recordOf(*content.mission);
    std::vector contents{missionChart(ChartKind::Zeta, record, locale),
                         missionChart(ChartKind::Sigma, record, locale)};
    if (usableForecast(record.scenario) != nullptr) {
        contents.push_back(missionChart(ChartKind::Weather, record, locale));
        contents.back().cursor_s.reset(); // the cursor belongs to the screen only
    }
    for (TimeLine& line : contents[1].lines)
        line.label = printable(line.label); // labels are names, which may contain any character
    for (TimeChartContent& chart : contents)
        chart.emptyText = ChartPageText::tr("Nothing was flown");
    sheet->charts =
        documentCharts(contents, sheet->theme,
                       QSizeF(kPage_px.width(), ChartSheet::chart_px(contents.size())), locale);
    return {.size_px = kPage_px,
            .title = sheet->title,
            .description = contents[0].summary + u' ' + contents[1].summary,
            .paint = [sheet = std::shared_ptr<const ChartSheet>(std::move(sheet))](
                         QPainter& painter) { paintSheet(painter, *sheet); }};
}

} // namespace berg
