#include "widgets/charts/time_chart.h"

#include "widgets/charts/chart_labels.h"
#include "widgets/charts/decimate.h"
#include "widgets/charts/nice_ticks.h"
#include "widgets/theme/quantity_text.h"

#include <QAreaSeries>
#include <QChart>
#include <QCoreApplication>
#include <QFontMetricsF>
#include <QGraphicsLayout>
#include <QLineSeries>
#include <QLinearGradient>
#include <QPainter>
#include <QValueAxis>

#include <algorithm>
#include <cmath>
#include <numeric>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr double kTickSpacing_px = 52; // least distance of grid lines
constexpr double kTimeSpacing_px = 84;
constexpr double kLabelHeight_px = 15;
constexpr double kLeader_px = 16;        // between the end of a line and its label in the margin
constexpr double kFarthestLabel_px = 32; // from the end of its line
constexpr double kSimplify_px = 0.1;
constexpr int kGradientStops = 24;

/** Context of the texts: that of the class would have its namespace, which lupdate leaves out. */
struct TimeChartText
{
    Q_DECLARE_TR_FUNCTIONS(TimeChartText)
};

double penWidth(LineRole role)
{
    switch (role) {
    case LineRole::Accumulated:
        return 2.4;
    case LineRole::Momentary:
        return 1.8;
    case LineRole::Sigma:
        return 1.5;
    }
    return 1;
}

QValueAxis* makeAxis(QChart& chart, Qt::Alignment alignment)
{
    auto* axis = new QValueAxis(&chart);
    axis->setLabelsVisible(false); // ours are localised, grouped and times are mm:ss
    axis->setLineVisible(false);
    axis->setTickType(QValueAxis::TicksDynamic);
    axis->setTickAnchor(0);
    chart.addAxis(axis, alignment);
    return axis;
}

} // namespace

TimeChart::TimeChart(const Theme& theme, QWidget* parent) : QChartView(parent), m_theme(theme)
{
    chart()->setAnimationOptions(QChart::NoAnimation);
    chart()->setBackgroundVisible(false);
    chart()->setMargins(QMargins());
    chart()->legend()->hide();
    m_time = makeAxis(*chart(), Qt::AlignBottom);
    m_left = makeAxis(*chart(), Qt::AlignLeft);
    m_right = makeAxis(*chart(), Qt::AlignRight);
    m_right->setGridLineVisible(false); // its ticks lie on the grid of the left axis
    setRenderHint(QPainter::Antialiasing);
    setFrameShape(QFrame::NoFrame);
    setMinimumSize(120, 80);
    setTheme(theme);
}

void TimeChart::setTheme(const Theme& theme)
{
    m_theme = theme;
    for (QValueAxis* axis : {m_time, m_left, m_right})
        axis->setGridLinePen(QPen(m_theme.chartGrid, 1));
    layOut();
    viewport()->update();
}

void TimeChart::setContent(const TimeChartContent& content)
{
    const bool sameLines =
        std::equal(content.lines.begin(), content.lines.end(), m_content.lines.begin(),
                   m_content.lines.end(), [](const TimeLine& a, const TimeLine& b) {
                       return a.role == b.role && a.onRightAxis == b.onRightAxis;
                   });
    m_content = content;
    setAccessibleName(content.title);
    setAccessibleDescription(hasPoints() ? content.leftTitle : content.emptyText);
    if (!sameLines)
        rebuild(); // else the series there are get new points
    layOut();
    viewport()->update();
}

void TimeChart::rebuild()
{
    chart()->removeAllSeries(); // deletes them
    m_series.clear();
    m_areas.clear();
    // Areas first: lines must not disappear below them.
    for (const TimeLine& line : m_content.lines) {
        QAreaSeries* area = nullptr;
        if (line.role == LineRole::Momentary) {
            area = new QAreaSeries;
            area->setUpperSeries(new QLineSeries(area));
            addSeries(area, line);
        }
        m_areas.push_back(area);
    }
    for (const TimeLine& line : m_content.lines) {
        auto* series = new QLineSeries;
        addSeries(series, line);
        m_series.push_back(series);
    }
}

void TimeChart::addSeries(QAbstractSeries* series, const TimeLine& line)
{
    chart()->addSeries(series);
    series->attachAxis(m_time);
    series->attachAxis(line.onRightAxis ? m_right : m_left);
}

bool TimeChart::hasPoints() const
{
    return std::any_of(m_content.lines.begin(), m_content.lines.end(),
                       [](const TimeLine& line) { return !line.points.empty(); });
}

bool TimeChart::labelsInMargin() const
{
    return std::any_of(m_content.lines.begin(), m_content.lines.end(),
                       [](const TimeLine& line) { return line.role == LineRole::Sigma; });
}

double TimeChart::largest(bool onRightAxis) const
{
    double largest = 0;
    for (const TimeLine& line : m_content.lines)
        if (line.onRightAxis == onRightAxis)
            for (const QPointF& p : line.points)
                if (std::isfinite(p.y()))
                    largest = std::max(largest, p.y());
    return largest;
}

std::vector<ChartTick> TimeChart::valueTicks(const NiceTicks& ticks) const
{
    std::vector<ChartTick> out;
    for (int k = 0; k <= ticks.count; ++k)
        out.push_back({.at_px = m_frame.plot.bottom() - m_frame.plot.height() * k / ticks.count,
                       .text = fixedText(k * ticks.step, ticks.decimals(), locale())});
    return out;
}

void TimeChart::setPlot(const NiceTicks& left, const NiceTicks& right)
{
    const QSizeF size = viewport()->size();
    const QFontMetricsF small(m_theme.small());
    const auto widest = [&small](const std::vector<ChartTick>& ticks) {
        double width_px = 0;
        for (const ChartTick& tick : ticks)
            width_px = std::max(width_px, small.horizontalAdvance(tick.text));
        return width_px;
    };
    double rightWidth_px = m_content.rightTitle.isEmpty() ? 0 : widest(valueTicks(right));
    if (labelsInMargin())
        for (const TimeLine& line : m_content.lines)
            rightWidth_px =
                std::max(rightWidth_px, kLeader_px + small.horizontalAdvance(line.label));
    const double left_px = kChartSide_px + widest(valueTicks(left)) + kChartTickGap_px;
    const double right_px = size.width() - kChartSide_px - rightWidth_px - kChartTickGap_px;
    m_frame.plot = QRectF(left_px, kChartTop_px, std::max(10.0, right_px - left_px),
                          std::max(10.0, size.height() - kChartTop_px - kChartBottom_px));
    chart()->setPlotArea(m_frame.plot);
}

void TimeChart::layOut()
{
    const double height_px = viewport()->height() - kChartTop_px - kChartBottom_px;
    const int most = std::max(1, static_cast<int>(height_px / kTickSpacing_px));
    const NiceTicks left = niceTicks(largest(false), most);
    const NiceTicks right = niceTicksExactly(largest(true), left.count);
    m_left->setTickInterval(left.step);
    m_left->setRange(0, left.end());
    m_right->setTickInterval(right.step);
    m_right->setRange(0, right.end());
    setPlot(left, right);
    const double duration_s = std::max(1e-3, m_content.duration_s);
    m_time->setTickInterval(timeStep_s(
        duration_s, std::max(1, static_cast<int>(m_frame.plot.width() / kTimeSpacing_px))));
    m_time->setRange(0, duration_s);
    chart()->layout()->invalidate(); // or the grid stays where the old plot was
    chart()->layout()->activate();
    replacePoints();
    styleLines();
    fillFrame(left, right);
    if (labelsInMargin())
        placeMarginLabels();
    else
        placeInnerLabels();
}

double TimeChart::timeToView(double time_s) const
{
    return m_frame.plot.left() + m_frame.plot.width() * time_s / m_time->max();
}

void TimeChart::fillFrame(const NiceTicks& left, const NiceTicks& right)
{
    const auto colourOf = [&](bool onRightAxis) {
        for (const TimeLine& line : m_content.lines)
            if (line.onRightAxis == onRightAxis && line.role != LineRole::Sigma)
                return lineColour(line);
        return m_theme.mutedText;
    };
    m_frame.size = viewport()->size();
    m_frame.title = m_content.title;
    m_frame.leftTitle = m_content.leftTitle;
    m_frame.rightTitle = m_content.rightTitle;
    m_frame.timeTitle = m_time->max() >= 3600 ? TimeChartText::tr("Time, h:mm:ss")
                                              : TimeChartText::tr("Time, mm:ss");
    m_frame.leftColour = colourOf(false);
    m_frame.rightColour = colourOf(true);
    m_frame.left = valueTicks(left);
    m_frame.right = m_content.rightTitle.isEmpty() ? std::vector<ChartTick>() : valueTicks(right);
    m_frame.times.clear();
    const double step_s = m_time->tickInterval();
    for (int k = 0; k * step_s <= m_time->max() * (1 + 1e-9); ++k)
        m_frame.times.push_back({.at_px = timeToView(k * step_s), .text = clockText(k * step_s)});
    m_frame.marks_px.clear();
    for (const double time_s : m_content.marks_s)
        m_frame.marks_px.push_back(timeToView(time_s));
    m_frame.marksTitle = m_content.marksTitle;
    m_frame.labels.clear();
    m_frame.emptyText = hasPoints() ? QString() : m_content.emptyText;
}

void TimeChart::replacePoints()
{
    const DecimationWindow window{.from = 0,
                                  .to = m_time->max(),
                                  .columns = std::max(1, static_cast<int>(m_frame.plot.width()))};
    for (std::size_t i = 0; i < m_series.size(); ++i) {
        // Qt draws each segment by itself: fewer of them are faster and join without seams.
        const TimeLine& line = m_content.lines[i];
        const double end = line.onRightAxis ? m_right->max() : m_left->max();
        const QList<QPointF> points =
            simplified(decimate(line.points, window), kSimplify_px * end / m_frame.plot.height());
        m_series[i]->replace(points);
        if (m_areas[i] != nullptr)
            m_areas[i]->upperSeries()->replace(points);
    }
}

QColor TimeChart::lineColour(const TimeLine& line) const
{
    switch (line.role) {
    case LineRole::Accumulated:
        return m_theme.accumulated;
    case LineRole::Momentary:
        return m_theme.momentary;
    case LineRole::Sigma:
        return m_theme.sigma.colour(line.points.empty() ? 0 : line.points.back().y(),
                                    m_content.sigmaFull_m2);
    }
    return {};
}

void TimeChart::styleLines()
{
    // Series draw in the coordinates of the plot: the colour of sigma follows the height.
    QLinearGradient bySigma(0, m_frame.plot.height(), 0, 0);
    for (int k = 0; k <= kGradientStops; ++k) {
        const double t = static_cast<double>(k) / kGradientStops;
        bySigma.setColorAt(t, m_theme.sigma.colour(t * m_left->max(), m_content.sigmaFull_m2));
    }
    for (std::size_t i = 0; i < m_series.size(); ++i) {
        const TimeLine& line = m_content.lines[i];
        const QBrush brush =
            line.role == LineRole::Sigma ? QBrush(bySigma) : QBrush(lineColour(line));
        m_series[i]->setPen(
            QPen(brush, penWidth(line.role), Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        if (m_areas[i] != nullptr) {
            m_areas[i]->setPen(Qt::NoPen);
            QColor fill = lineColour(line);
            fill.setAlphaF(0.12F);
            m_areas[i]->setBrush(fill);
        }
    }
}

QPointF TimeChart::toView(const TimeLine& line, const QPointF& p) const
{
    const double end = line.onRightAxis ? m_right->max() : m_left->max();
    return {timeToView(p.x()), m_frame.plot.bottom() - m_frame.plot.height() * p.y() / end};
}

void TimeChart::placeMarginLabels()
{
    // Where lines crowd, the most uncertain ones are named.
    std::vector<const TimeLine*> named;
    for (const TimeLine& line : m_content.lines)
        if (!line.points.empty())
            named.push_back(&line);
    std::stable_sort(named.begin(), named.end(), [](const TimeLine* a, const TimeLine* b) {
        return a->points.back().y() > b->points.back().y();
    });
    const LabelColumn column{.top = m_frame.plot.top() - kLabelHeight_px / 2,
                             .bottom = m_frame.plot.bottom() + kLabelHeight_px / 2,
                             .spacing = kLabelHeight_px};
    std::vector<double> wanted;
    for (const TimeLine* line : named)
        wanted.push_back(toView(*line, line->points.back()).y());
    const std::vector<std::optional<double>> middles =
        nameableLabels(wanted, column, kFarthestLabel_px);
    const QFontMetricsF small(m_theme.small());
    for (std::size_t k = 0; k < named.size(); ++k) {
        if (!middles[k])
            continue;
        const QPointF end = toView(*named[k], named[k]->points.back());
        const QRectF rect(end.x() + kLeader_px, *middles[k] - kLabelHeight_px / 2,
                          small.horizontalAdvance(named[k]->label) + 2, kLabelHeight_px);
        m_frame.labels.push_back({.text = named[k]->label,
                                  .rect = rect,
                                  .end = end,
                                  .colour = lineColour(*named[k]),
                                  .inMargin = true});
    }
}

void TimeChart::placeInnerLabels()
{
    std::vector<QPolygonF> polygons;
    for (std::size_t i = 0; i < m_series.size(); ++i) {
        QPolygonF polygon;
        for (const QPointF& p : m_series[i]->points())
            polygon << toView(m_content.lines[i], p);
        polygons.push_back(polygon);
    }
    QFont font = m_theme.strong();
    const QFontMetricsF metrics(font);
    std::vector<QRectF> taken;
    for (std::size_t i = 0; i < polygons.size(); ++i) {
        const TimeLine& line = m_content.lines[i];
        const QSizeF size(metrics.horizontalAdvance(line.label) + 2, metrics.height());
        const auto rect = labelBesideLine(polygons[i], polygons, taken, size,
                                          m_frame.plot.adjusted(4, 0, -4, -kChartMark_px - 2));
        if (!rect)
            continue;
        taken.push_back(*rect);
        m_frame.labels.push_back({.text = line.label,
                                  .rect = *rect,
                                  .end = polygons[i].back(),
                                  .colour = lineColour(line)});
    }
}

std::vector<QRectF> TimeChart::labelRects() const
{
    std::vector<QRectF> rects;
    for (const ChartLabel& label : m_frame.labels)
        rects.push_back(label.rect);
    return rects;
}

std::vector<QList<QPointF>> TimeChart::drawnPoints() const
{
    std::vector<QList<QPointF>> points;
    for (const QLineSeries* series : m_series)
        points.push_back(series->points());
    return points;
}

void TimeChart::resizeEvent(QResizeEvent* event)
{
    QChartView::resizeEvent(event);
    layOut();
}

void TimeChart::drawBackground(QPainter* painter, const QRectF& rect)
{
    painter->fillRect(rect, m_theme.chart);
}

void TimeChart::drawForeground(QPainter* painter, const QRectF& /*rect*/)
{
    paintChartFrame(*painter, m_frame, m_theme);
}

} // namespace berg
