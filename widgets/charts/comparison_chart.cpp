#include "widgets/charts/comparison_chart.h"

#include "widgets/charts/decimate.h"
#include "widgets/charts/figure_text.h"
#include "widgets/theme/quantity_text.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr double kPlain = 0.16;    // colour share of the reference in plain shading
constexpr double kAtMargin = 0.9;  // lines that end beyond this share are named in the margin
constexpr int kItems = 20;         // number of readable items
constexpr int kColumns = 1500;     // columns of pixels that a line is decimated to
constexpr double kSimplify = 2e-4; // tolerance relative to the final zeta

struct ComparisonChartText
{
    Q_DECLARE_TR_FUNCTIONS(ComparisonChartText)
};

/** Ordinate of a line at an abscissa `x` that it reaches. */
double ordinateAt(const QList<QPointF>& line, double x)
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

/** Abscissas where the lines bend or cross, ascending, up to `end`. */
std::vector<double> breaksOf(const QList<QPointF>& a, const QList<QPointF>& b, double end)
{
    std::vector<double> at{end};
    for (const QList<QPointF>* line : {&a, &b})
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

/** Zeta of a run over time, decimated to what is visible. */
QList<QPointF> lineOf(const ComparedRun& run)
{
    std::vector<QPointF> points;
    points.reserve(run.samples.size());
    for (const Sample& sample : run.samples)
        points.emplace_back(sample.time_s, sample.zeta_m2s);
    return simplified(
        decimate(points, {.from = 0, .to = std::max(1.0, run.flown_s), .columns = kColumns}),
        kSimplify * run.metrics.zeta_m2s);
}

/** Adds readable items: zeta of both runs at equally spaced times up to their common end. */
void addItems(Figure& figure, const RunComparison& comparison, const QList<QPointF>& reference,
              const QList<QPointF>& other, const QLocale& locale)
{
    constexpr int kDigits = 4;
    if (reference.isEmpty() || other.isEmpty())
        return;
    const auto text = [&](const ComparedRun& run, double zeta_m2s) {
        return u"%1: %2 m² s"_s.arg(runName(run, locale),
                                    significantText(zeta_m2s, kDigits, locale));
    };
    for (int i = 0; i <= kItems; ++i) {
        const double time_s = comparison.until_s * i / kItems;
        const double zeta_m2s = ordinateAt(reference, time_s);
        figure.items.push_back(
            {.id = static_cast<std::size_t>(i),
             .at = {time_s, zeta_m2s},
             .readout = utf8(QStringList{clockOf(comparison.reference->scenario).text(time_s),
                                         text(*comparison.reference, zeta_m2s),
                                         text(*comparison.other, ordinateAt(other, time_s))})});
    }
}

/** Shades the difference up to `until_s`, one area per interval with the same run ahead. */
void addDifference(Figure& figure, const QList<QPointF>& a, const QList<QPointF>& b, double until_s)
{
    if (a.isEmpty() || b.isEmpty())
        return;
    const std::vector<double> breaks = breaksOf(a, b, until_s);
    const auto shade = [&](std::size_t first, std::size_t last, bool referenceAhead) {
        PlotArea area{
            .outline = {}, .ink = {.of = InkOf::Comparison}, .isHatched = !referenceAhead};
        if (referenceAhead)
            area.ink = {.of = InkOf::Accumulated, .strength = kPlain};
        for (std::size_t k = first; k <= last; ++k)
            area.outline.push_back({breaks[k], ordinateAt(a, breaks[k])});
        for (std::size_t k = last + 1; k-- > first;)
            area.outline.push_back({breaks[k], ordinateAt(b, breaks[k])});
        figure.areas.push_back(std::move(area));
    };
    std::size_t first = 0;
    for (std::size_t k = 0; k + 1 < breaks.size(); ++k) {
        const auto ahead = [&](std::size_t i) {
            const double middle = (breaks[i] + breaks[i + 1]) / 2;
            return ordinateAt(a, middle) <= ordinateAt(b, middle);
        };
        if (k + 2 < breaks.size() && ahead(k) == ahead(k + 1))
            continue;
        shade(first, k + 1, ahead(k));
        first = k + 1;
    }
}

/** Percentage by which the other run has more zeta; zero if it would be displayed as 0.0. */
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

ComparisonChart::ComparisonChart(const Theme& theme, QWidget* parent) : FigureView(theme, parent)
{
    setTitleShown(true);
}

void ComparisonChart::setComparison(const std::optional<RunComparison>& comparison)
{
    m_comparison = comparison;
    if (!comparison)
        forgetItems(0);
    setToolTip(!comparison ? QString()
                           : tr("%1.\nLess ζ is better. Plain shade: A, %2, has less. Hatched: B, "
                                "%3, has less.")
                                 .arg(verdictText(*comparison, locale()),
                                      runName(*comparison->reference, locale()),
                                      runName(*comparison->other, locale())));
    refresh();
}

void ComparisonChart::setCursor_s(std::optional<double> time_s)
{
    m_cursor_s = time_s;
    refresh();
}

Figure ComparisonChart::figure() const
{
    Figure figure{.name = utf8(tr("Comparison of accumulated uncertainty"))};
    figure.title = figure.name;
    if (!m_comparison) {
        figure.emptyText = utf8(tr("This chart compares runs of one scenario."));
        return figure;
    }
    const ComparedRun& reference = *m_comparison->reference;
    const ComparedRun& other = *m_comparison->other;
    figure.description = utf8(verdictText(*m_comparison, locale()));
    figure.rightTitles = {figure.description, utf8(shortVerdict(*m_comparison, locale()))};
    figure.rightInk = {};
    const double duration_s = std::max({1.0, reference.flown_s, other.flown_s});
    figure.x = timeAxis(clockOf(reference.scenario), 0, duration_s, tr("Time, UTC"),
                        duration_s >= 3600 ? tr("Time, h:mm:ss") : tr("Time, mm:ss"));
    const double largest_m2s = std::max(reference.metrics.zeta_m2s, other.metrics.zeta_m2s);
    const ShownUnit unit = zetaUnit(largest_m2s);
    figure.leftTitles = {utf8(tr("Zeta ζ, %1").arg(unit.name))};
    figure.y = {.ends = AxisEnds::Around0,
                .largest = largest_m2s,
                .text = numberText(locale()),
                .inUnit = unit.inSi};
    const QList<QPointF> a = lineOf(reference);
    const QList<QPointF> b = lineOf(other);
    addDifference(figure, a, b, m_comparison->until_s);
    addRun(figure, other, b, InkOf::Comparison);
    addRun(figure, reference, a, InkOf::Accumulated);
    addItems(figure, *m_comparison, a, b, locale());
    std::reverse(figure.labels.begin(), figure.labels.end());
    if (m_cursor_s && *m_cursor_s <= duration_s)
        figure.lines.push_back({.points = {{*m_cursor_s, -kPlotEdge}, {*m_cursor_s, kPlotEdge}},
                                .ink = {.of = InkOf::Uav},
                                .width_px = 1.2});
    return figure;
}

/** Adds a run: its name is in the margin if it reaches the right end, otherwise beside its end. */
void ComparisonChart::addRun(Figure& figure, const ComparedRun& run, const QList<QPointF>& line,
                             InkOf ink) const
{
    PlotLine drawn{.points = {}, .ink = {.of = ink}, .width_px = 2.2};
    for (const QPointF& point : line)
        drawn.points.push_back({point.x(), point.y()});
    figure.lines.push_back(std::move(drawn));
    const bool atMargin = run.flown_s >= kAtMargin * figure.x.largest;
    figure.labels.push_back({.text = utf8(runName(run, locale())),
                             .end = {run.flown_s, run.metrics.zeta_m2s},
                             .ink = {.of = ink},
                             .place = atMargin ? LabelPlace::Margin : LabelPlace::Free,
                             .needsMargin = atMargin});
}

} // namespace berg
