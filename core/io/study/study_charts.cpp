#include "core/io/study/study_charts.h"

#include "core/base/number_text.h"
#include "core/io/figure/figure_svg.h"
#include "core/io/figure/policy_style.h"
#include "core/io/results/result_csv.h"
#include "core/plan/policy/policy.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace berg {

namespace {

constexpr double kWidth_px = 760;

/** Returns the settings with a tau, sorted by tau. */
std::vector<const SettingSummary*> byTau(const StudySummary& summary)
{
    std::vector<const SettingSummary*> settings;
    for (const SettingSummary& s : summary.settings)
        if (s.setting.tau)
            settings.push_back(&s);
    std::stable_sort(settings.begin(), settings.end(),
                     [](const auto* a, const auto* b) { return a->setting.tau < b->setting.tau; });
    return settings;
}

Ink inkOf(const StudySetting& setting)
{
    if (setting.tau)
        return {.of = InkOf::Plan};
    return {.of = InkOf::Policy, .value = static_cast<double>(setting.policy)};
}

/**
 * Dashes of a policy's line, which distinguish policies without tau in addition to their colours.
 */
std::vector<double> dashOf(PolicyKind policy)
{
    const std::array<double, 4>& dash_px = styleOf(policy).dash_px;
    return {dash_px.begin(), std::ranges::find(dash_px, 0.0)};
}

PlotAxis axisFor(AxisEnds ends, double spacing_px, std::string title = {})
{
    return {
        .ends = ends, .spacing_px = spacing_px, .text = printedNumber, .title = std::move(title)};
}

void include(PlotAxis& axis, double value)
{
    axis.least = std::min(axis.least, value);
    axis.largest = std::max(axis.largest, value);
}

/** Builds the chart of zeta against tau. */
struct ZetaFigure
{
    using Value = double Summary::*;

    const ReportWords& words;
    Figure figure;
    std::vector<const SettingSummary*> taus;

    [[nodiscard]] std::vector<PlotPoint> curve(Value value) const
    {
        std::vector<PlotPoint> points;
        for (const SettingSummary* s : taus)
            points.push_back({.x = *s->setting.tau, .y = s->zeta_m2s.*value});
        return points;
    }
    void addBand(Value low, Value high, double opacity, std::string key)
    {
        std::vector<PlotPoint> outline = curve(low);
        const std::vector<PlotPoint> back = curve(high);
        outline.insert(outline.end(), back.rbegin(), back.rend());
        figure.areas.push_back({.outline = std::move(outline),
                                .ink = {.of = InkOf::Plan},
                                .opacity = opacity,
                                .key = std::move(key)});
    }
    void addLabel(double zeta_m2s, std::string text, const Ink& ink)
    {
        figure.labels.push_back(
            {.text = std::move(text), .end = {kPlotEdge, zeta_m2s}, .ink = ink});
    }
    /** Labels a curve at its end, the largest tau. */
    void labelCurve(Value value, std::string text, InkOf ink = InkOf::Muted)
    {
        addLabel(taus.back()->zeta_m2s.*value, std::move(text), {.of = ink});
    }
    void addSpread()
    {
        addBand(&Summary::decile1, &Summary::decile9, 0.13, "most");
        addBand(&Summary::quartile1, &Summary::quartile3, 0.2, "half");
        figure.lines.push_back({.points = curve(&Summary::median),
                                .width_px = 1.5,
                                .dash_px = {2, 3},
                                .key = "median"});
        labelCurve(&Summary::decile9,
                   words.text(QT_TRANSLATE_NOOP("Report", "90 % of cases below")));
        labelCurve(&Summary::quartile3, "75 %");
        labelCurve(&Summary::median, words.text(QT_TRANSLATE_NOOP("Report", "median")));
        labelCurve(&Summary::quartile1, "25 %");
        labelCurve(&Summary::decile1, "10 %");
    }
    void addPolicy(const SettingSummary& s)
    {
        const double zeta_m2s = s.zeta_m2s.mean;
        include(figure.y, zeta_m2s);
        figure.lines.push_back({.points = {{-kPlotEdge, zeta_m2s}, {kPlotEdge, zeta_m2s}},
                                .ink = inkOf(s.setting),
                                .width_px = 2,
                                .dash_px = dashOf(s.setting.policy)});
        addLabel(zeta_m2s, settingName(s.setting), inkOf(s.setting));
    }
    void addMean(bool isSingle)
    {
        figure.lines.push_back({.points = curve(&Summary::mean),
                                .ink = {.of = InkOf::Plan},
                                .width_px = 2.5,
                                .key = "mean"});
        labelCurve(&Summary::mean,
                   isSingle ? "visitation"
                            : words.text(QT_TRANSLATE_NOOP("Report", "mean, visitation")),
                   InkOf::Plan);
        constexpr std::size_t kMostDots = 60;
        const int decimals = decimalsFor(taus.front()->zeta_m2s.mean, 5);
        for (const SettingSummary* s : taus) {
            for (const Value value : {&Summary::decile1, &Summary::mean, &Summary::decile9})
                include(figure.y, s->zeta_m2s.*value);
            if (taus.size() <= kMostDots)
                figure.marks.push_back({.at = {*s->setting.tau, s->zeta_m2s.mean},
                                        .ink = {.of = InkOf::Plan},
                                        .tip = settingName(s->setting) + ": " +
                                               printedNumber(s->zeta_m2s.mean, decimals) +
                                               " m² s"});
        }
    }
};

/** Adds the mean difference of the cases with its interval, in row `row`. */
void addDifference(Figure& figure, double row, const PairedDifference& difference)
{
    const MeanInterval& change = difference.relative;
    const auto line = [&](const PlotPoint& from, const PlotPoint& to) {
        figure.lines.push_back({.points = {from, to}, .width_px = 1.2});
    };
    line({100 * change.low, row}, {100 * change.high, row});
    for (const double end : {100 * change.low, 100 * change.high}) {
        include(figure.x, end);
        line({end, row, 0, -4}, {end, row, 0, 4});
    }
    figure.marks.push_back(
        {.at = {100 * change.mean, row}, .radius_px = 4, .ink = inkOf(difference.setting)});
    figure.y.rowEnds.back() = signedNumber(100 * change.mean, 1) + " %  [" +
                              signedNumber(100 * change.low, 1) + ", " +
                              signedNumber(100 * change.high, 1) + "]";
}

} // namespace

std::string settingName(const StudySetting& setting)
{
    if (!setting.tau)
        return nameOf(kPolicyNames, setting.policy);
    constexpr double kPerUnit = 1e6; // 3 x 0.1 is meant to be 0.3
    return "τ = " + numberText(std::round(*setting.tau * kPerUnit) / kPerUnit);
}

std::string zetaChart(const StudySummary& summary, const ReportWords& words)
{
    ZetaFigure zeta{.words = words, .figure = {}, .taus = byTau(summary)};
    if (summary.cases.empty() || zeta.taus.size() < 2)
        return {};
    const bool isSingle = summary.cases.size() == 1;
    Figure& figure = zeta.figure;
    figure.name = words.text(
        QT_TRANSLATE_NOOP("Report", "Zeta against tau; the numbers are in the table of settings"));
    figure.leftTitles = {"ζ, m² s"};
    figure.x = axisFor(AxisEnds::Round, 66, words.text(QT_TRANSLATE_NOOP("Report", "trade-off τ")));
    figure.x.least = *zeta.taus.front()->setting.tau;
    figure.x.largest = *zeta.taus.back()->setting.tau;
    figure.y = axisFor(AxisEnds::Round, 54);
    figure.y.least = figure.y.largest = zeta.taus.front()->zeta_m2s.mean;
    if (!isSingle)
        zeta.addSpread();
    for (const SettingSummary& s : summary.settings)
        if (!s.setting.tau)
            zeta.addPolicy(s);
    zeta.addMean(isSingle);
    return figureSvg(figure, kWidth_px, 420);
}

std::vector<std::size_t> drawnDifferences(const StudySummary& summary)
{
    constexpr std::size_t kMostTaus = 42;
    const std::size_t stride = (byTau(summary).size() + kMostTaus - 1) / kMostTaus;
    std::vector<std::size_t> drawn;
    std::size_t taus = 0;
    for (std::size_t i = 0; i < summary.settings.size(); ++i) {
        const bool isTau = summary.settings[i].setting.tau.has_value();
        if (!isTau || i == summary.reference || taus % stride == 0)
            drawn.push_back(i);
        taus += isTau ? 1 : 0;
    }
    return drawn;
}

std::string differenceChart(const StudySummary& summary, const ReportWords& words)
{
    if (summary.cases.size() < 2 || summary.settings.size() < 2)
        return {};
    constexpr double kRow_px = 18;
    constexpr double kAround_px = 60; // above and below the rows
    const std::vector<std::size_t> drawn = drawnDifferences(summary);
    Figure figure;
    figure.name = words.text(QT_TRANSLATE_NOOP(
        "Report", "Differences vs the reference; the numbers are in the table of differences"));
    figure.x = axisFor(AxisEnds::Round, 52,
                       words.text(QT_TRANSLATE_NOOP("Report", "mean difference of ζ vs %1, %"),
                                  {settingName(summary.settings[summary.reference].setting)}));
    figure.x.largest = 0;
    figure.y = {.ends = AxisEnds::Rows, .hasGrid = false};
    figure.lines.push_back(
        {.points = {{0, -kPlotEdge}, {0, kPlotEdge}}, .ink = {.of = InkOf::Axis}});
    for (const std::size_t i : drawn) {
        const auto row = static_cast<double>(figure.y.rows.size());
        figure.y.rows.push_back(settingName(summary.settings[i].setting));
        figure.y.rowEnds.emplace_back();
        if (i != summary.reference) {
            addDifference(figure, row, summary.differences[i]);
            continue;
        }
        figure.y.rows.back() =
            words.text(QT_TRANSLATE_NOOP("Report", "%1 (reference)"), {figure.y.rows.back()});
        figure.marks.push_back({.at = {0, row}, .radius_px = 4, .isHollow = true});
    }
    return figureSvg(figure, kWidth_px, kRow_px * static_cast<double>(drawn.size()) + kAround_px);
}

std::string bestTauChart(const StudySummary& summary, const ReportWords& words)
{
    if (!summary.bestTau || summary.cases.size() < 2)
        return {};
    std::map<double, int> counts;
    for (const SettingSummary* s : byTau(summary))
        counts[*s->setting.tau] = 0;
    for (const double tau : summary.bestTau->byCase)
        ++counts[tau];
    Figure figure;
    figure.name = words.text(QT_TRANSLATE_NOOP("Report", "Cases in which each tau is the best"));
    figure.leftTitles = {words.text(QT_TRANSLATE_NOOP("Report", "cases"))};
    figure.x = axisFor(AxisEnds::Round, 80,
                       words.text(QT_TRANSLATE_NOOP("Report", "τ of the lowest ζ of a case")));
    figure.x.least = counts.begin()->first;
    figure.x.largest = counts.rbegin()->first;
    figure.x.inset_px = 24; // room for half a bar
    figure.y = axisFor(AxisEnds::Around0, 34);
    figure.y.isWhole = true;
    constexpr double kPlot_px = 640;
    double half_px = 16;
    for (auto at = counts.begin(); std::next(at) != counts.end(); ++at)
        half_px = std::min(half_px, 0.4 * kPlot_px * (std::next(at)->first - at->first) /
                                        (figure.x.largest - figure.x.least));
    half_px = std::max(0.75, half_px);
    for (const auto& [tau, count] : counts) {
        include(figure.y, count);
        const double top = count;
        if (count > 0)
            figure.areas.push_back(
                {.outline = {{tau, 0, -half_px},
                             {tau, top, -half_px},
                             {tau, top, half_px},
                             {tau, 0, half_px}},
                 .ink = {.of = InkOf::Plan},
                 .tip = settingName({.tau = tau}) + ": " + std::to_string(count)});
    }
    return figureSvg(figure, kWidth_px, 260);
}

} // namespace berg
