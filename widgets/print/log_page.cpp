#include "widgets/print/log_page.h"

#include "core/base/version.h"
#include "core/io/export/flight_log.h"
#include "core/io/text/utc_time.h"
#include "widgets/charts/figure_painter.h"
#include "widgets/charts/mission_charts.h"
#include "widgets/map/paint/map_painter.h"
#include "widgets/map/picture/scenario_picture.h"
#include "widgets/print/brief_surroundings.h"
#include "widgets/print/brief_table.h"
#include "widgets/print/document_chart.h"
#include "widgets/print/export_picture.h"
#include "widgets/print/flight_brief.h"
#include "widgets/print/page_text.h"
#include "widgets/print/printable_text.h"
#include "widgets/theme/painter_state.h"
#include "widgets/theme/quantity_text.h"
#include "widgets/words/event_text.h"
#include "widgets/words/policy_words.h"

#include <QCoreApplication>

#include <array>
#include <cmath>
#include <memory>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

/** Words that the log as a web page has as well are translated once, in this context. */
struct LogText
{
    Q_DECLARE_TR_FUNCTIONS(Report)
};

constexpr BriefType kHeading{.size_px = 12, .isBold = true};
constexpr BriefType kWords{.size_px = 10};

constexpr double kGap_px = 9;
constexpr double kChart_px = 330; // height of the chart
constexpr double kMapScale = 0.78;
constexpr std::size_t kMostPages = 3;

QString timeOr(const ExportContent& content, const std::optional<double>& time_s,
               const QString& missing)
{
    return time_s ? briefClock(content, *time_s) : missing;
}

std::vector<BriefFact> factsOf(const ExportContent& content, const FlightLog& log,
                               const QLocale& locale)
{
    const Scenario& scenario = content.mission->scenario();
    const QString day = content.start
                            ? QString::fromStdString(utcText(*content.start, 0)).left(10) + u' '
                            : QString();
    const bool isUtc = MissionClock{.start = content.start}.isUtc();
    return {
        {isUtc ? LogText::tr("Start, UTC") : LogText::tr("Start"), day + briefClock(content, 0)},
        {isUtc ? LogText::tr("Until, UTC") : LogText::tr("Until"),
         briefClock(content, log.flown_s)},
        {LogText::tr("Zeta flown"), zetaText(log.metrics.zeta_m2s, locale)},
        {LogText::tr("Predicted before take-off"),
         log.predicted ? zetaText(log.predicted->mean_m2s, locale) : u"–"_s},
        {LogText::tr("Visits"), locale.toString(log.metrics.visits)},
        {LogText::tr("Plans made"), locale.toString(log.metrics.replans)},
        {LogText::tr("Planned by"), policyText(scenario.planner, locale)},
        {LogText::tr("Seed"), QString::number(scenario.seed)},
        {LogText::tr("Program"), QString::fromStdString(programName())}};
}

std::vector<QStringList> uavRows(const ExportContent& content, const FlightLog& log,
                                 const QLocale& locale)
{
    std::vector<QStringList> rows{
        {LogText::tr("UAV"), LogText::tr("Visits planned"), LogText::tr("flown"),
         LogText::tr("Distance planned"), LogText::tr("flown"), LogText::tr("Time planned"),
         LogText::tr("aloft"), LogText::tr("Took off"), LogText::tr("Landed")}};
    if (content.operation)
        rows.front() << LogText::tr("Outside the flight geography");
    for (const LogUav& uav : log.uavs) {
        rows.push_back({printable(titleOf(content.mission->scenario().uavs[uav.row])),
                        locale.toString(static_cast<qulonglong>(uav.plannedVisits)),
                        locale.toString(uav.visits), distanceText(uav.plannedLength_m, locale),
                        distanceText(uav.flown_m, locale), clockText(uav.plannedTime_s),
                        clockText(uav.aloft_s), timeOr(content, uav.tookOff_s, u"–"_s),
                        timeOr(content, uav.landed_s, u"–"_s)});
        if (content.operation)
            rows.back() << clockText(uav.outside_s);
    }
    return rows;
}

std::vector<QStringList> sightingRows(const ExportContent& content, const FlightLog& log,
                                      const QLocale& locale)
{
    std::vector<QStringList> rows{{LogText::tr("Iceberg"), LogText::tr("First seen"),
                                   LogText::tr("Last seen"), LogText::tr("Visits"),
                                   LogText::tr("Longest unseen"), LogText::tr("σ at the end, m²"),
                                   LogText::tr("95 % within")}};
    for (const LogIceberg& iceberg : log.icebergs)
        rows.push_back({printable(titleOf(content.mission->icebergs()[iceberg.iceberg])),
                        timeOr(content, iceberg.first_s, LogText::tr("never")),
                        timeOr(content, iceberg.last_s, LogText::tr("never")),
                        locale.toString(iceberg.visits), clockText(iceberg.longestUnseen_s),
                        significantText(iceberg.sigma_m2, 3, locale),
                        radius95Text(iceberg.sigma_m2, locale)});
    return rows;
}

QStringList deviationLines(const ExportContent& content, const FlightLog& log,
                           const QLocale& locale)
{
    const Mission& mission = *content.mission;
    QStringList lines;
    if (log.wasChanged)
        lines << LogText::tr("Something was changed in flight: the prediction was for another "
                             "flight.");
    for (const MissionEvent& event : log.deviations)
        lines << u"%1  %2"_s.arg(
            briefClock(content, event.time_s),
            printable(eventSentence(event, mission.icebergs(), mission.scenario().uavs, locale)));
    if (lines.isEmpty())
        lines << LogText::tr("None on record.");
    return lines;
}

/** All pages with lines and texts; the first one has room for map and chart. */
struct LogSheets
{
    std::vector<BriefLayout> pages;
    QRectF map;
    QRectF chart;
};

/** Lays out blocks from top to bottom, and starts a new page when one is full. */
class LogLayout
{
public:
    explicit LogLayout(const QSizeF& page) : m_composer(page) {}

    LogSheets laidOut(const ExportContent& content, const FlightLog& log, const QLocale& locale)
    {
        m_composer.line(LogText::tr("Flight log: %1").arg(pageTitle(content)), kBriefTitle);
        m_composer.line(pathsText(content), kBriefHead);
        m_composer.rule(true);
        m_composer.setFacts(factsOf(content, log, locale), 3);
        m_composer.rule(false);
        m_composer.setUavTable(uavRows(content, log, locale));
        m_composer.takeStrip(kGap_px);
        const QRectF& free = m_composer.free;
        m_sheets.chart = QRectF(free.left(), free.bottom() - kChart_px, free.width(), kChart_px);
        m_sheets.map = free.adjusted(0, 0, 0, -kChart_px - kGap_px);
        turn();
        setTable(LogText::tr("Sightings"), sightingRows(content, log, locale));
        setLines(LogText::tr("Deviations"), deviationLines(content, log, locale));
        setHashes(content, log);
        m_sheets.pages.push_back(std::move(m_composer.layout));
        return std::move(m_sheets);
    }

private:
    void turn()
    {
        const QSizeF page = m_composer.layout.page;
        m_sheets.pages.push_back(std::move(m_composer.layout));
        m_composer = PageComposer(page);
    }

    [[nodiscard]] bool isLastPage() const { return m_sheets.pages.size() + 1 == kMostPages; }

    /** Number of lines that fit on this page above a reserved height of `keep_px`. */
    [[nodiscard]] qsizetype room(double line_px, double keep_px) const
    {
        return static_cast<qsizetype>(
            std::floor(std::max(0.0, m_composer.free.height() - keep_px) / line_px));
    }

    /** Sets a table with a wide first column; rows that do not fit go to the next page. */
    void setTable(const QString& heading, const std::vector<QStringList>& rows)
    {
        m_composer.line(heading, kHeading);
        const double line_px = linePitch_px(kWords.size_px);
        setRow(rows.front(), kBriefCaption);
        const double keep_px = 14 * line_px; // reserved for the blocks that follow
        for (std::size_t i = 1; i < rows.size(); ++i) {
            if (room(line_px, isLastPage() ? keep_px : 0) < 2) {
                if (isLastPage()) {
                    setMore(rows.size() - i);
                    break;
                }
                turn();
                setRow(rows.front(), kBriefCaption);
            }
            setRow(rows[i], kWords);
        }
        m_composer.takeStrip(kGap_px);
    }

    void setRow(const QStringList& cells, const BriefType& type)
    {
        constexpr double kFirst = 0.28; // share of the width
        const QRectF strip = m_composer.takeStrip(linePitch_px(type.size_px));
        const double first_px = kFirst * strip.width();
        const double other_px = (strip.width() - first_px) /
                                static_cast<double>(std::max<qsizetype>(1, cells.size() - 1));
        BriefType right = type;
        right.isRight = true;
        for (qsizetype i = 0; i < cells.size(); ++i)
            setText(m_composer.layout,
                    i == 0 ? QRectF(strip.left(), strip.top(), first_px, strip.height())
                           : QRectF(strip.left() + first_px + static_cast<double>(i - 1) * other_px,
                                    strip.top(), other_px, strip.height()),
                    cells[i], i == 0 ? type : right);
    }

    void setLines(const QString& heading, const QStringList& lines)
    {
        const double line_px = linePitch_px(kWords.size_px);
        const double hashes_px = 8 * line_px;
        if (room(line_px, hashes_px) < 4 && !isLastPage())
            turn();
        m_composer.line(heading, kHeading);
        for (qsizetype i = 0; i < lines.size(); ++i) {
            if (room(line_px, hashes_px) < 2) {
                if (isLastPage()) {
                    setMore(lines.size() - i);
                    break;
                }
                turn();
            }
            m_composer.line(lines[i], kWords);
        }
        m_composer.takeStrip(kGap_px);
    }

    template <class Count>
    void setMore(Count count)
    {
        m_composer.line(LogText::tr("and %1 more; all of them: export log-html").arg(count),
                        kWords);
    }

    /** Sets the plan hashes of as many UAVs as fit. */
    void setHashes(const ExportContent& content, const FlightLog& log)
    {
        m_composer.line(LogText::tr("SHA-256 of the first plan as a file of the format wpl:"),
                        kBriefCaption);
        const double line_px = linePitch_px(kWords.size_px);
        for (std::size_t i = 0; i < log.uavs.size(); ++i) {
            if (i + 1 < log.uavs.size() && room(line_px, 0) < 2) {
                setMore(log.uavs.size() - i);
                break;
            }
            const LogUav& uav = log.uavs[i];
            m_composer.line(
                u"%1  %2"_s.arg(QString::fromStdString(uav.planHash),
                                printable(titleOf(content.mission->scenario().uavs[uav.row]))),
                kWords);
        }
    }

    PageComposer m_composer; ///< the present page
    LogSheets m_sheets;
};

/** Data that the pages are painted from. */
struct LogBook
{
    Theme theme = Theme::light();
    QLocale locale;
    MapPicture picture;
    MapLayout map; ///< in map pixels, which are smaller than those of the page
    std::vector<TimeFigure> charts;
    LogSheets sheets;
};

void paintFirst(QPainter& painter, const LogBook& book)
{
    const PainterState saved(painter);
    paintLayout(painter, book.sheets.pages.front());
    painter.save();
    painter.setClipRect(book.sheets.map);
    painter.translate(book.sheets.map.topLeft());
    painter.scale(kMapScale, kMapScale);
    paintMap(painter, book.picture, {.theme = book.theme, .locale = book.locale}, book.map);
    painter.restore();
    painter.setPen(QPen(Qt::black, 0.8));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(book.sheets.map);
    painter.translate(book.sheets.chart.topLeft());
    for (const TimeFigure& chart : book.charts)
        paintDrawing(painter, chart.drawing, book.theme);
}

} // namespace

PicturePage logPage(const ExportContent& content, const QLocale& locale)
{
    const FlightLog log = flightLog(content);
    const QSize size_px = briefPage_px(locale);
    auto book = std::make_shared<LogBook>();
    book->locale = locale;
    book->sheets = LogLayout(QSizeF(size_px)).laidOut(content, log, locale);
    book->picture = exportPicture(content);
    book->picture.air = exportAir(content);
    book->map = arrangeMap(book->picture, {.theme = book->theme, .locale = locale},
                           QRectF(QPointF(0, 0), book->sheets.map.size() / kMapScale));
    const FlightRecord record = recordOf(*content.mission);
    std::array contents{missionChart(ChartKind::Zeta, record, locale)};
    contents[0].emptyText = LogText::tr("Nothing was flown");
    book->charts = documentCharts(contents, book->theme, book->sheets.chart.size(), locale);
    std::vector<std::function<void(QPainter&)>> more;
    for (std::size_t page = 1; page < book->sheets.pages.size(); ++page)
        more.emplace_back(
            [book, page](QPainter& painter) { paintLayout(painter, book->sheets.pages[page]); });
    return {.size_px = size_px,
            .title = LogText::tr("Flight log: %1").arg(pageTitle(content)),
            .description = contents[0].summary,
            .paint = [book](QPainter& painter) { paintFirst(painter, *book); },
            .more = std::move(more)};
}

} // namespace berg
