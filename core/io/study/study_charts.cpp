#include "core/io/study/study_charts.h"

#include "core/base/label_column.h"
#include "core/io/results/result_csv.h"
#include "core/io/study/svg_plot.h"
#include "core/io/text/number_text.h"
#include "core/plan/policy/policy.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace berg {

namespace {

constexpr double kWidth_px = 760;
constexpr int kXTicks = 8;
constexpr int kYTicks = 6;

/** Settings with a tau, by tau. */
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

std::string policyStyle(const StudySetting& setting)
{
    return "p-" + nameOf(kPolicyNames, setting.policy);
}

/** The chart of zeta against tau. */
class ZetaChart
{
public:
    explicit ZetaChart(const StudySummary& summary)
        : m_summary(summary)
        , m_taus(byTau(summary))
        , m_single(summary.cases.size() == 1)
        , m_x(niceRange(*m_taus.front()->setting.tau, *m_taus.back()->setting.tau, kXTicks),
              kFrame.left, kFrame.right)
        , m_y(zetaRange(), kFrame.bottom, kFrame.top)
        , m_drawing({kWidth_px, 420}, "Zeta against tau; the numbers are in the table of settings")
    {
    }

    std::string svg()
    {
        drawYAxis(m_drawing, kFrame, m_y, "ζ, m² s");
        drawXAxis(m_drawing, kFrame, m_x, "trade-off τ", false);
        if (!m_single)
            drawSpread();
        for (const SettingSummary& s : m_summary.settings)
            if (!s.setting.tau)
                drawPolicy(s);
        drawCurves();
        drawLabels();
        return m_drawing.svg();
    }

private:
    using Value = double Summary::*;
    struct Label
    {
        double y_px;
        std::string text;
        std::string style;
    };

    static constexpr PlotFrame kFrame{.left = 70, .top = 40, .right = 610, .bottom = 370};

    [[nodiscard]] NiceRange zetaRange() const
    {
        double least = m_summary.settings.front().zeta_m2s.mean;
        double largest = least;
        const auto include = [&](double zeta_m2s) {
            least = std::min(least, zeta_m2s);
            largest = std::max(largest, zeta_m2s);
        };
        for (const SettingSummary& s : m_summary.settings) {
            include(s.zeta_m2s.mean);
            if (s.setting.tau) {
                include(s.zeta_m2s.decile1);
                include(s.zeta_m2s.decile9);
            }
        }
        return niceRange(least, largest, kYTicks);
    }

    [[nodiscard]] std::vector<SvgPoint> curve(Value value) const
    {
        std::vector<SvgPoint> points;
        for (const SettingSummary* s : m_taus)
            points.push_back({m_x.at(*s->setting.tau), m_y.at(s->zeta_m2s.*value)});
        return points;
    }

    void drawBand(Value low, Value high, std::string_view style)
    {
        std::vector<SvgPoint> outline = curve(low);
        const std::vector<SvgPoint> back = curve(high);
        outline.insert(outline.end(), back.rbegin(), back.rend());
        m_drawing.polygon(outline, style);
    }

    /** The label of a curve that ends at the largest tau. */
    void labelCurve(Value value, std::string text, std::string style)
    {
        m_labels.push_back(
            {m_y.at(m_taus.back()->zeta_m2s.*value), std::move(text), std::move(style)});
    }

    void drawSpread()
    {
        drawBand(&Summary::decile1, &Summary::decile9, "most");
        drawBand(&Summary::quartile1, &Summary::quartile3, "half");
        m_drawing.polyline(curve(&Summary::median), "median");
        labelCurve(&Summary::decile9, "90 % of cases below", "muted");
        labelCurve(&Summary::quartile3, "75 %", "muted");
        labelCurve(&Summary::median, "median", "muted");
        labelCurve(&Summary::quartile1, "25 %", "muted");
        labelCurve(&Summary::decile1, "10 %", "muted");
    }

    void drawPolicy(const SettingSummary& s)
    {
        const double y = m_y.at(s.zeta_m2s.mean);
        const std::string style = policyStyle(s.setting);
        m_drawing.line({kFrame.left, y}, {kFrame.right, y}, "policy " + style);
        m_labels.push_back({y, settingName(s.setting), style});
    }

    void drawCurves()
    {
        m_drawing.polyline(curve(&Summary::mean), "mean");
        labelCurve(&Summary::mean, m_single ? "visitation" : "mean, visitation", "p-visitation");
        constexpr std::size_t kMostDots = 60;
        if (m_taus.size() > kMostDots)
            return;
        const int decimals = decimalsFor(m_taus.front()->zeta_m2s.mean, 5);
        for (const SettingSummary* s : m_taus)
            m_drawing.circle({m_x.at(*s->setting.tau), m_y.at(s->zeta_m2s.mean)}, 3, "dot",
                             settingName(s->setting) + ": " +
                                 printedNumber(s->zeta_m2s.mean, decimals) + " m² s");
    }

    /** Beside the plot, moved apart, with a line to what they belong to. */
    void drawLabels()
    {
        std::vector<double> wanted;
        for (const Label& label : m_labels)
            wanted.push_back(label.y_px);
        const std::vector<double> places = spreadLabels(
            wanted, {.top = kFrame.top - 12, .bottom = kFrame.bottom + 12, .spacing = 15});
        for (std::size_t i = 0; i < m_labels.size(); ++i) {
            const Label& label = m_labels[i];
            m_drawing.line({kFrame.right + 2, label.y_px}, {kFrame.right + 16, places[i]},
                           "leader " + label.style);
            m_drawing.text({kFrame.right + 20, places[i]}, label.text,
                           label.style == "muted" ? "muted" : "");
        }
    }

    const StudySummary& m_summary;
    std::vector<const SettingSummary*> m_taus;
    bool m_single;
    PlotScale m_x;
    PlotScale m_y;
    SvgDrawing m_drawing;
    std::vector<Label> m_labels;
};

/** Range of the intervals that are drawn, 0 included, in percent. */
NiceRange differenceRange(const StudySummary& summary, const std::vector<std::size_t>& drawn)
{
    double least = 0;
    double largest = 0;
    for (const std::size_t i : drawn) {
        least = std::min(least, 100 * summary.differences[i].relative.low);
        largest = std::max(largest, 100 * summary.differences[i].relative.high);
    }
    return niceRange(least, largest, kXTicks);
}

void drawDifference(SvgDrawing& drawing, const PlotScale& x, double y,
                    const PairedDifference& difference, bool isReference)
{
    const MeanInterval& change = difference.relative;
    const std::string name = settingName(difference.setting);
    drawing.text({150, y}, isReference ? name + " (reference)" : name, isReference ? "strong" : "",
                 TextAnchor::End);
    const double mean_px = x.at(100 * change.mean);
    if (isReference) {
        drawing.circle({mean_px, y}, 4, "hollow", {});
        return;
    }
    const double low_px = x.at(100 * change.low);
    const double high_px = x.at(100 * change.high);
    drawing.line({low_px, y}, {high_px, y}, "whisker");
    for (const double end_px : {low_px, high_px})
        drawing.line({end_px, y - 4}, {end_px, y + 4}, "whisker");
    drawing.circle({mean_px, y}, 4, "dot " + policyStyle(difference.setting), {});
    drawing.text({kWidth_px - 4, y},
                 signedNumber(100 * change.mean, 1) + " %  [" + signedNumber(100 * change.low, 1) +
                     ", " + signedNumber(100 * change.high, 1) + "]",
                 "number", TextAnchor::End);
}

/** Whole numbers from 0. */
NiceRange countRange(int most)
{
    constexpr int kSteps = 5;
    if (most <= kSteps)
        return {.first = 0, .step = 1, .count = most};
    NiceTicks ticks = niceTicks(most, kSteps);
    if (ticks.decimals() > 0) // 2.5
        ticks = niceTicks(most, kSteps - 2);
    return {.first = 0, .step = ticks.step, .count = ticks.count};
}

} // namespace

std::string settingName(const StudySetting& setting)
{
    if (!setting.tau)
        return nameOf(kPolicyNames, setting.policy);
    constexpr double kPerUnit = 1e6; // 3 x 0.1 is meant to be 0.3
    return "τ = " + numberText(std::round(*setting.tau * kPerUnit) / kPerUnit);
}

std::string zetaChart(const StudySummary& summary)
{
    if (summary.cases.empty() || byTau(summary).size() < 2)
        return {};
    return ZetaChart(summary).svg();
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

std::string differenceChart(const StudySummary& summary)
{
    if (summary.cases.size() < 2 || summary.settings.size() < 2)
        return {};
    constexpr double kRow_px = 18;
    const std::vector<std::size_t> drawn = drawnDifferences(summary);
    const double height_px = kRow_px * static_cast<double>(drawn.size());
    const PlotFrame frame{.left = 165, .top = 10, .right = 590, .bottom = 10 + height_px};
    const PlotScale x(differenceRange(summary, drawn), frame.left, frame.right);
    SvgDrawing drawing({kWidth_px, frame.bottom + 50},
                       "Differences to the reference; the numbers are in the table of differences");
    drawXAxis(drawing, frame, x,
              "mean difference of ζ to " +
                  settingName(summary.settings[summary.reference].setting) + ", %",
              true);
    drawing.line({x.at(0), frame.top}, {x.at(0), frame.bottom}, "axis");
    double y = frame.top + kRow_px / 2;
    for (const std::size_t i : drawn) {
        drawDifference(drawing, x, y, summary.differences[i], i == summary.reference);
        y += kRow_px;
    }
    return drawing.svg();
}

std::string bestTauChart(const StudySummary& summary)
{
    if (!summary.bestTau || summary.cases.size() < 2)
        return {};
    std::map<double, int> counts;
    for (const SettingSummary* s : byTau(summary))
        counts[*s->setting.tau] = 0;
    int most = 0;
    for (const double tau : summary.bestTau->byCase)
        most = std::max(most, ++counts[tau]);

    const PlotFrame frame{.left = 70, .top = 40, .right = 740, .bottom = 210};
    constexpr double kInset_px = 24; // room for half a bar
    const PlotScale x(niceRange(counts.begin()->first, counts.rbegin()->first, kXTicks),
                      frame.left + kInset_px, frame.right - kInset_px);
    const PlotScale y(countRange(most), frame.bottom, frame.top);
    double gap_px = 40;
    for (auto at = counts.begin(); std::next(at) != counts.end(); ++at)
        gap_px = std::min(gap_px, x.at(std::next(at)->first) - x.at(at->first));
    const double width_px = std::max(1.5, 0.8 * gap_px);

    SvgDrawing drawing({kWidth_px, frame.bottom + 50}, "Cases in which each tau is the best");
    drawYAxis(drawing, frame, y, "cases");
    for (const auto& [tau, count] : counts)
        if (count > 0)
            drawing.rect({x.at(tau) - width_px / 2, y.at(count)},
                         {width_px, frame.bottom - y.at(count)}, "bar",
                         settingName({.tau = tau}) + ": " + std::to_string(count));
    drawXAxis(drawing, frame, x, "τ of the lowest ζ of a case", false);
    return drawing.svg();
}

} // namespace berg
