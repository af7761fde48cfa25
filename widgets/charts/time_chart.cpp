#include "widgets/charts/time_chart.h"

#include "widgets/charts/figure_painter.h"
#include "widgets/charts/line_style.h"
#include "widgets/theme/accessible_roles.h"

#include <QAreaSeries>
#include <QChart>
#include <QGraphicsLayout>
#include <QLineSeries>
#include <QLinearGradient>
#include <QPainter>
#include <QValueAxis>

#include <algorithm>

namespace berg {
namespace {

constexpr qsizetype kRoundSegments = 700; // with more, lines have flat ends for speed
constexpr int kGradientStops = 24;
constexpr std::size_t kSeriesAtOnce = 100; // Qt takes 0.1 to 0.2 ms per series

QValueAxis* makeAxis(QChart& chart, Qt::Alignment alignment)
{
    auto* axis = new QValueAxis(&chart);
    axis->setLabelsVisible(false); // the chart draws localised labels itself
    axis->setLineVisible(false);
    axis->setTickType(QValueAxis::TicksDynamic);
    axis->setTickAnchor(0);
    chart.addAxis(axis, alignment);
    return axis;
}

} // namespace

TimeChart::TimeChart(const Theme& theme, QWidget* parent) : QChartView(parent), m_theme(theme)
{
    setAccessibleRole(*this, QAccessible::Chart);
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
    viewport()->setMouseTracking(true);
    m_nextSeries.setSingleShot(true);
    connect(&m_nextSeries, &QTimer::timeout, this, [this] {
        addMissingSeries();
        layOut();
    });
    setTheme(theme);
}

void TimeChart::setTheme(const Theme& theme)
{
    m_theme = theme;
    for (QValueAxis* axis : {m_time, m_left, m_right})
        axis->setGridLinePen(QPen(m_theme.chartGrid, 1));
    layOut();
}

void TimeChart::setTitleShown(bool shown)
{
    m_titleShown = shown;
    layOut();
}

void TimeChart::setValuesBeside(bool beside)
{
    if (m_valuesBeside == beside)
        return;
    m_valuesBeside = beside;
    layOut();
}

void TimeChart::setGradients(bool wanted)
{
    m_gradients = wanted;
    layOut();
}

void TimeChart::setContent(const TimeChartContent& content)
{
    m_content = content;
    setAccessibleName(content.title);
    const QString text = content.summary.isEmpty() ? content.leftTitle : content.summary;
    setAccessibleDescription(hasPoints(m_content) ? text : content.emptyText);
    if (m_zoom && m_zoom->from_s >= content.duration_s && !m_following)
        m_zoom.reset(); // another mission has not reached the zoomed range
    // Existing series are reused for the new points.
    if (!hasSeriesOfKinds()) {
        chart()->removeAllSeries(); // deletes them
        m_series.clear();
    }
    addMissingSeries();
    layOut();
}

/** Compares the kinds of common series; surplus series are kept without points for later. */
bool TimeChart::hasSeriesOfKinds() const
{
    const std::size_t both = std::min(m_content.lines.size(), m_series.size());
    return std::equal(m_series.begin(), m_series.begin() + static_cast<std::ptrdiff_t>(both),
                      m_content.lines.begin(), [](const LineSeries& made, const TimeLine& line) {
                          return line.role == made.role && line.onRightAxis == made.onRightAxis;
                      });
}

std::size_t TimeChart::drawnSeries() const
{
    return std::min(m_figure.drawn.size(), m_series.size());
}

void TimeChart::finishSeries()
{
    while (m_series.size() < m_content.lines.size())
        addMissingSeries();
    layOut();
}

/** Adds a part of hundreds of series in each turn of the event loop. */
void TimeChart::addMissingSeries()
{
    const std::vector<TimeLine>& lines = m_content.lines;
    const std::size_t first = m_series.size();
    const std::size_t end = std::min(lines.size(), first + kSeriesAtOnce);
    // Areas are added first, so that they do not cover lines.
    for (std::size_t i = first; i < end; ++i) {
        LineSeries made{.role = lines[i].role, .onRightAxis = lines[i].onRightAxis};
        if (made.role == LineRole::Momentary) {
            made.area = new QAreaSeries;
            made.area->setUpperSeries(new QLineSeries(made.area));
            addSeries(made.area, lines[i]);
        }
        m_series.push_back(made);
    }
    for (std::size_t i = first; i < end; ++i) {
        m_series[i].line = new QLineSeries;
        addSeries(m_series[i].line, lines[i]);
    }
    if (end < lines.size())
        m_nextSeries.start();
}

void TimeChart::addSeries(QAbstractSeries* series, const TimeLine& line)
{
    chart()->addSeries(series);
    series->attachAxis(m_time);
    series->attachAxis(line.onRightAxis ? m_right : m_left);
}

QColor TimeChart::colourOf(const TimeLine& line) const
{
    return inkColour(lineInk(line, m_content.sigmaFull_m2), m_theme);
}

int TimeChart::columns() const
{
    return chartColumns(viewport()->width());
}

void TimeChart::layOut()
{
    m_isLaidOut = true;
    m_figure = timeFigure(m_content, {.theme = m_theme,
                                      .locale = locale(),
                                      .size_px = viewport()->size(),
                                      .window = window(),
                                      .hasTitle = m_titleShown,
                                      .hasNames = !m_valuesBeside,
                                      .hasLines = false});
    chart()->setPlotArea(plot());
    for (const LineSeries& series : m_series) {
        // With points, each change of an axis would lay out points that are about to be replaced.
        series.line->clear();
        if (series.area != nullptr)
            series.area->upperSeries()->clear();
    }
    setAxes();
    chart()->layout()->invalidate(); // otherwise the grid stays at the old plot
    chart()->layout()->activate();
    styleLines();
    showPoints();
    placeLabels(m_figure.figure, figureFonts(m_theme), m_figure.drawing, flagsAtCursor());
    m_pixmap = {};
    viewport()->update();
    emit readoutChanged();
}

void TimeChart::setAxes()
{
    const auto set = [](QValueAxis& axis, const PlotScale& scale) {
        axis.setTickInterval(scale.step);
        // Qt's axes have no free space at their ends.
        const double high = scale.high_px == scale.to_px
                                ? scale.to
                                : scale.from + (scale.to - scale.from) *
                                                   (scale.high_px - scale.from_px) /
                                                   (scale.to_px - scale.from_px);
        axis.setRange(scale.from, high);
    };
    set(*m_left, m_figure.drawing.y);
    set(*m_right, m_figure.drawing.right);
    set(*m_time, m_figure.drawing.x);
    for (QValueAxis* axis : {m_left, m_time})
        axis->setGridLineVisible(m_figure.figure.emptyText.empty());
}

void TimeChart::showPoints()
{
    // Qt draws each segment separately: fewer segments are faster and join without seams.
    for (std::size_t i = 0; i < drawnSeries(); ++i) {
        m_series[i].line->replace(m_figure.drawn[i]);
        if (m_series[i].area != nullptr)
            m_series[i].area->upperSeries()->replace(m_figure.drawn[i]);
    }
}

void TimeChart::styleLines()
{
    // Series use the coordinates of the plot, so the colour of sigma follows the height.
    QLinearGradient gradient(0, m_figure.drawing.plot.height(), 0, 0);
    QLinearGradient faint = gradient;
    for (int k = 0; k <= kGradientStops; ++k) {
        const double t = static_cast<double>(k) / kGradientStops;
        QColor colour = m_theme.sigma.colour(t * m_figure.drawing.y.to, m_content.sigmaFull_m2);
        gradient.setColorAt(t, colour);
        colour.setAlphaF(static_cast<float>(kFaintInk));
        faint.setColorAt(t, colour);
    }
    qsizetype segments = 0;
    for (std::size_t i = 0; i < drawnSeries(); ++i) // an area is as expensive as its line
        segments += m_figure.drawn[i].size() * (m_series[i].area != nullptr ? 2 : 1);
    m_plain = isCrowded(segments);
    // Round ends join the segments at several times the cost; many short segments do without.
    const Qt::PenCapStyle cap = segments > kRoundSegments ? Qt::FlatCap : Qt::RoundCap;
    for (std::size_t i = 0; i < drawnSeries(); ++i) {
        // Lines that dense are translucent, so that single ones remain visible.
        const LineEmphasis emphasis = m_content.lines[i].emphasis;
        const bool isFaint =
            emphasis == LineEmphasis::Faint || (m_plain && emphasis == LineEmphasis::None);
        styleLine(i, isFaint ? faint : gradient, cap);
    }
}

void TimeChart::styleLine(std::size_t index, const QBrush& bySigma, Qt::PenCapStyle cap)
{
    const TimeLine& line = m_content.lines[index];
    QColor colour = colourOf(line);
    if (line.emphasis == LineEmphasis::Faint)
        colour.setAlphaF(static_cast<float>(kFaintInk));
    const QBrush brush = line.role == LineRole::Sigma && m_gradients ? bySigma : QBrush(colour);
    const Qt::PenStyle style = isDashed(line.role) ? Qt::DashLine : Qt::SolidLine;
    const LineSeries& series = m_series[index];
    series.line->setPen(QPen(brush, lineWidth_px(line, m_plain), style, cap, Qt::RoundJoin));
    if (series.area == nullptr)
        return;
    series.area->setPen(Qt::NoPen);
    QColor fill = colourOf(line);
    fill.setAlphaF(static_cast<float>(kAreaInk));
    series.area->setBrush(fill);
}

void TimeChart::resizeEvent(QResizeEvent* event)
{
    QChartView::resizeEvent(event);
    changeWindow();
}

void TimeChart::paintEvent(QPaintEvent* /*event*/)
{
    const QRect rect = viewport()->rect();
    if (m_pixmap.isNull() || m_pixmap.devicePixelRatio() != devicePixelRatioF()) {
        m_pixmap = QPixmap(rect.size() * devicePixelRatioF());
        m_pixmap.setDevicePixelRatio(devicePixelRatioF());
        QPainter painter(&m_pixmap);
        painter.setRenderHint(QPainter::Antialiasing, !m_plain);
        render(&painter, rect, rect);
    }
    QPainter painter(viewport());
    painter.drawPixmap(0, 0, m_pixmap);
    paintReadout(painter);
    if (hasFocus()) {
        painter.setPen(QPen(m_theme.plan, 1));
        painter.drawRect(QRectF(rect).adjusted(0.5, 0.5, -0.5, -0.5));
    }
}

void TimeChart::drawBackground(QPainter* painter, const QRectF& rect)
{
    painter->fillRect(rect, m_theme.chart);
}

void TimeChart::drawForeground(QPainter* painter, const QRectF& /*rect*/)
{
    paintFrame(*painter, m_figure.drawing, m_theme);
}

} // namespace berg
