#include "widgets/charts/comparison_chart.h"

#include "core/base/nice_ticks.h"
#include "widgets/charts/chart_labels.h"
#include "widgets/charts/decimate.h"
#include "widgets/theme/quantity_text.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QPaintEvent>
#include <QPainter>

#include <algorithm>
#include <array>
#include <cmath>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr double kTickSpacing_px = 40;
constexpr double kTimeSpacing_px = 84;
constexpr double kLine_px = 2.2;
constexpr double kLabelHeight_px = 15;
constexpr double kStrongHeight_px = 17;
constexpr double kLeader_px = 16;
constexpr double kLabelShare = 0.34; // of the width, at most, for the labels
constexpr double kSimplify_px = 0.1;
constexpr double kPlain = 0.16;   // part of the reference's colour in its shade
constexpr double kHatch = 0.5;    // of the other's, in the lines of its shade
constexpr double kTint = 0.12;    // between those lines
constexpr double kAtMargin = 0.9; // part of the time axis from which a line ends at the margin

struct ComparisonChartText
{
    Q_DECLARE_TR_FUNCTIONS(ComparisonChartText)
};

/** Ordinate of a line at `x` inside it. */
double ordinateAt(const QPolygonF& line, double x)
{
    const auto after = std::lower_bound(line.begin(), line.end(), x,
                                        [](const QPointF& p, double at) { return p.x() < at; });
    if (after == line.end())
        return line.back().y();
    if (after == line.begin() || after->x() == x)
        return after->y();
    const QPointF& from = *(after - 1);
    return std::lerp(from.y(), after->y(), (x - from.x()) / (after->x() - from.x()));
}

/** Where the lines cross or bend, ascending, up to `end`. */
std::vector<double> breaksOf(const QPolygonF& a, const QPolygonF& b, double end)
{
    std::vector<double> at{end};
    for (const QPolygonF* line : {&a, &b})
        for (const QPointF& p : *line)
            if (p.x() < end)
                at.push_back(p.x());
    std::sort(at.begin(), at.end());
    at.erase(std::unique(at.begin(), at.end()), at.end());
    std::vector<double> breaks;
    for (std::size_t k = 0; k < at.size(); ++k) {
        breaks.push_back(at[k]);
        if (k + 1 == at.size())
            break;
        const double left = ordinateAt(a, at[k]) - ordinateAt(b, at[k]);
        const double right = ordinateAt(a, at[k + 1]) - ordinateAt(b, at[k + 1]);
        if (left * right < 0)
            breaks.push_back(std::lerp(at[k], at[k + 1], left / (left - right)));
    }
    return breaks;
}

/** By how many per cent of the reference's zeta the other one has more; 0: it would read 0.0. */
double percentMore(const RunComparison& comparison)
{
    const double a = figuresAt(*comparison.reference, comparison.until_s).zeta_m2s;
    const double b = figuresAt(*comparison.other, comparison.until_s).zeta_m2s;
    const double percent = a > 0 ? 100 * (b / a - 1) : 0;
    return std::abs(percent) < 0.05 ? 0 : percent;
}

QString amountText(double percent, const QLocale& locale)
{
    return fixedText(std::abs(percent), std::abs(percent) < 99.95 ? 1 : 0, locale);
}

QString shortVerdict(const RunComparison& comparison, const QLocale& locale)
{
    const double percent = percentMore(comparison);
    if (percent == 0)
        return ComparisonChartText::tr("The same ζ");
    return ComparisonChartText::tr("%1 ahead by %2 %")
        .arg(runName(percent > 0 ? *comparison.reference : *comparison.other, locale),
             amountText(percent, locale));
}

} // namespace

QString verdictText(const RunComparison& comparison, const QLocale& locale)
{
    const QString a = runName(*comparison.reference, locale);
    const QString b = runName(*comparison.other, locale);
    const double percent = percentMore(comparison);
    const QString amount = amountText(percent, locale);
    if (percent == 0)
        return ComparisonChartText::tr("%1 and %2: the same ζ").arg(a, b);
    return percent > 0
               ? ComparisonChartText::tr("%1 is ahead: %2 has %3 % more ζ").arg(a, b, amount)
               : ComparisonChartText::tr("%1 is ahead: it has %3 % less ζ than %2")
                     .arg(b, a, amount);
}

ComparisonChart::ComparisonChart(const Theme& theme, QWidget* parent)
    : QWidget(parent), m_theme(theme)
{
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setAccessibleName(tr("Accumulated uncertainty of two runs"));
    layOut();
}

void ComparisonChart::setComparison(const std::optional<RunComparison>& comparison)
{
    m_comparison = comparison;
    layOut();
    update();
}

void ComparisonChart::setTheme(const Theme& theme)
{
    m_theme = theme;
    layOut();
    update();
}

void ComparisonChart::setTitleShown(bool shown)
{
    m_titleShown = shown;
    layOut();
    update();
}

void ComparisonChart::setCursor_s(std::optional<double> time_s)
{
    m_cursor_s = time_s;
    layOut();
    update();
}

QSize ComparisonChart::sizeHint() const
{
    return {480, 220};
}

QSize ComparisonChart::minimumSizeHint() const
{
    return {200, 130};
}

void ComparisonChart::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    layOut();
}

QPointF ComparisonChart::toView(double time_s, double zeta_m2s) const
{
    const QRectF& plot = m_frame.plot;
    return {plot.left() + plot.width() * time_s / m_duration_s,
            plot.bottom() - plot.height() * zeta_m2s / m_zetaEnd_m2s};
}

QPolygonF ComparisonChart::polygon(const ComparedRun& run) const
{
    std::vector<QPointF> points;
    points.reserve(run.samples.size());
    for (const Sample& sample : run.samples)
        points.push_back(toView(sample.time_s, sample.zeta_m2s));
    return simplified(decimate(points, {.from = m_frame.plot.left(),
                                        .to = m_frame.plot.right(),
                                        .columns = static_cast<int>(m_frame.plot.width())}),
                      kSimplify_px);
}

void ComparisonChart::layOut()
{
    m_frame.size = size();
    m_frame.title = m_titleShown ? tr("Accumulated uncertainty of two runs") : QString();
    m_frame.leftTitle = tr("Zeta ζ, m² s");
    m_frame.leftColour = m_theme.mutedText;
    m_frame.rightColour = m_theme.text;
    m_frame.emptyText =
        m_comparison ? QString() : tr("Two runs of the same scenario are compared here.");
    setVerdict();
    setAxes();
    placeLabels();
}

/** In a sentence, or in a few words where that is too long. */
void ComparisonChart::setVerdict()
{
    m_frame.rightTitle.clear();
    setAccessibleDescription(m_frame.emptyText);
    setToolTip({});
    if (!m_comparison)
        return;
    const QString whole = verdictText(*m_comparison, locale());
    const QFontMetricsF small(m_theme.small());
    const double room_px =
        width() - 2 * kChartSide_px - small.horizontalAdvance(m_frame.leftTitle) - 16;
    m_frame.rightTitle = small.elidedText(
        small.horizontalAdvance(whole) <= room_px ? whole : shortVerdict(*m_comparison, locale()),
        Qt::ElideRight, room_px);
    setAccessibleDescription(whole);
    setToolTip(tr("%1.\nLess ζ is better. Plain shade: A, %2, has less. Hatched: B, %3, has less.")
                   .arg(whole, runName(*m_comparison->reference, locale()),
                        runName(*m_comparison->other, locale())));
}

void ComparisonChart::setAxes()
{
    m_duration_s = 1;
    double largest = 0;
    if (m_comparison)
        for (const ComparedRun* run : {m_comparison->reference.get(), m_comparison->other.get()}) {
            m_duration_s = std::max(m_duration_s, run->flown_s);
            largest = std::max(largest, run->metrics.zeta_m2s);
        }
    const double top_px = chartTop(m_frame);
    const double height_px = std::max(20.0, height() - top_px - kChartBottom_px);
    const NiceTicks ticks =
        niceTicks(largest, std::max(1, static_cast<int>(height_px / kTickSpacing_px)));
    m_zetaEnd_m2s = ticks.end();

    const QFontMetricsF small(m_theme.small());
    const double left_px =
        kChartSide_px + kChartTickGap_px +
        small.horizontalAdvance(fixedText(ticks.end(), ticks.decimals(), locale()));
    double labels_px = 0;
    if (m_comparison)
        for (const RunPointer& run : {m_comparison->reference, m_comparison->other})
            if (endsAtMargin(*run))
                labels_px = std::max(labels_px, small.horizontalAdvance(runName(*run, locale())));
    labels_px = m_comparison ? kLeader_px + std::min(labels_px + 3, kLabelShare * width()) : 0;
    m_frame.plot =
        QRectF(left_px, top_px, std::max(20.0, width() - kChartSide_px / 2 - labels_px - left_px),
               height_px);

    m_frame.left.clear();
    m_frame.times.clear();
    m_frame.cursor_px.reset();
    m_frame.timeTitle = m_duration_s >= 3600 ? tr("Time, h:mm:ss") : tr("Time, mm:ss");
    if (!m_comparison)
        return;
    for (int k = 0; k <= ticks.count; ++k)
        m_frame.left.push_back({.at_px = toView(0, k * ticks.step).y(),
                                .text = fixedText(k * ticks.step, ticks.decimals(), locale())});
    const double step_s = timeStep_s(
        m_duration_s, std::max(1, static_cast<int>(m_frame.plot.width() / kTimeSpacing_px)));
    for (int k = 0; k * step_s <= m_duration_s * (1 + 1e-9); ++k)
        m_frame.times.push_back(
            {.at_px = toView(k * step_s, 0).x(), .text = clockText(k * step_s)});
    if (m_cursor_s && *m_cursor_s <= m_duration_s)
        m_frame.cursor_px = toView(*m_cursor_s, 0).x();
}

bool ComparisonChart::endsAtMargin(const ComparedRun& run) const
{
    return run.flown_s >= kAtMargin * m_duration_s;
}

/** Lines that reach the right end are named in the margin, one that ends earlier beside its end. */
void ComparisonChart::placeLabels()
{
    m_frame.labels.clear();
    if (!m_comparison)
        return;
    const std::array<const ComparedRun*, 2> runs{m_comparison->reference.get(),
                                                 m_comparison->other.get()};
    std::vector<double> wanted;
    for (std::size_t k = 0; k < runs.size(); ++k) {
        ChartLabel label = labelInPlot(*runs[k], *runs[1 - k]);
        label.colour = k == 0 ? m_theme.accumulated : m_theme.comparison;
        label.inMargin = endsAtMargin(*runs[k]);
        if (label.inMargin)
            wanted.push_back(label.end.y());
        m_frame.labels.push_back(std::move(label));
    }
    const std::vector<double> middles =
        spreadLabels(wanted, {.top = m_frame.plot.top() - kLabelHeight_px / 2,
                              .bottom = m_frame.plot.bottom() + kLabelHeight_px / 2,
                              .spacing = kLabelHeight_px});
    const QFontMetricsF small(m_theme.small());
    const double left_px = m_frame.plot.right() + kLeader_px;
    const double width_px = width() - kChartSide_px / 2 - left_px;
    std::size_t placed = 0;
    for (ChartLabel& label : m_frame.labels) {
        if (!label.inMargin)
            continue;
        label.rect =
            QRectF(left_px, middles[placed++] - kLabelHeight_px / 2, width_px, kLabelHeight_px);
        label.text = small.elidedText(label.text, Qt::ElideRight, width_px);
    }
}

/**
 * Where zeta, which never falls, leaves room: above and left of the end of the upper line, below
 * and right of that of the lower one.
 */
ChartLabel ComparisonChart::labelInPlot(const ComparedRun& run, const ComparedRun& beside) const
{
    ChartLabel label{.text = runName(run, locale()),
                     .end = toView(run.flown_s, run.metrics.zeta_m2s)};
    const QRectF& plot = m_frame.plot;
    const double width_px = std::min(
        plot.width() - 2, QFontMetricsF(m_theme.strong()).horizontalAdvance(label.text) + 4);
    const double until_s = std::min(run.flown_s, beside.flown_s);
    const bool isUpper = figuresAt(run, until_s).zeta_m2s >= figuresAt(beside, until_s).zeta_m2s;
    QRectF rect(0, 0, width_px, kStrongHeight_px);
    if (isUpper)
        rect.moveBottomRight(label.end - QPointF(4, 4));
    else
        rect.moveTopLeft(label.end + QPointF(4, 4));
    rect.moveLeft(std::clamp(rect.left(), plot.left() + 2, plot.right() - width_px));
    rect.moveTop(std::clamp(rect.top(), plot.top(), plot.bottom() - kStrongHeight_px));
    label.rect = rect;
    return label;
}

void ComparisonChart::paintDifference(QPainter& painter) const
{
    const QPolygonF a = polygon(*m_comparison->reference);
    const QPolygonF b = polygon(*m_comparison->other);
    if (a.isEmpty() || b.isEmpty())
        return;
    const std::vector<double> breaks = breaksOf(a, b, toView(m_comparison->until_s, 0).x());
    const auto shade = [&](std::size_t first, std::size_t last, bool referenceAhead) {
        QPolygonF area;
        for (std::size_t k = first; k <= last; ++k)
            area << QPointF(breaks[k], ordinateAt(a, breaks[k]));
        for (std::size_t k = last + 1; k-- > first;)
            area << QPointF(breaks[k], ordinateAt(b, breaks[k]));
        painter.setPen(Qt::NoPen);
        painter.setBrush(referenceAhead ? mixed(m_theme.chart, m_theme.accumulated, kPlain)
                                        : mixed(m_theme.chart, m_theme.comparison, kTint));
        painter.drawPolygon(area);
        if (referenceAhead)
            return;
        painter.setBrush(
            QBrush(mixed(m_theme.chart, m_theme.comparison, kHatch), Qt::BDiagPattern));
        painter.drawPolygon(area);
    };
    // Stretches in which one and the same run has less: lower on the screen is larger.
    std::size_t first = 0;
    for (std::size_t k = 0; k + 1 < breaks.size(); ++k) {
        const auto ahead = [&](std::size_t i) {
            const double middle = (breaks[i] + breaks[i + 1]) / 2;
            return ordinateAt(a, middle) >= ordinateAt(b, middle);
        };
        if (k + 2 < breaks.size() && ahead(k) == ahead(k + 1))
            continue;
        shade(first, k + 1, ahead(k));
        first = k + 1;
    }
}

void ComparisonChart::paintEvent(QPaintEvent* event)
{
    QPainter painter(this);
    painter.fillRect(event->rect(), m_theme.chart);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(m_theme.chartGrid, 1));
    for (const ChartTick& tick : m_frame.left)
        painter.drawLine(QPointF(m_frame.plot.left(), tick.at_px),
                         QPointF(m_frame.plot.right(), tick.at_px));
    for (const ChartTick& tick : m_frame.times)
        painter.drawLine(QPointF(tick.at_px, m_frame.plot.top()),
                         QPointF(tick.at_px, m_frame.plot.bottom()));
    if (m_comparison) {
        paintDifference(painter);
        painter.setBrush(Qt::NoBrush);
        const auto line = [&](const ComparedRun& run, const QColor& colour) {
            painter.setPen(QPen(colour, kLine_px, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
            painter.drawPolyline(polygon(run));
        };
        line(*m_comparison->other, m_theme.comparison);
        line(*m_comparison->reference, m_theme.accumulated);
    }
    paintChartFrame(painter, m_frame, m_theme);
}

} // namespace berg
