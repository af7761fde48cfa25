#include "core/io/study/study_figures.h"

#include "core/base/number_text.h"
#include "core/io/figure/policy_style.h"
#include "core/plan/policy/policy.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace berg {

namespace {

constexpr double kMark_px = 5;
constexpr double kReference_px = 7.5;
constexpr double kFaint = 0.55; // colour strength of policy lines
constexpr double kSlot_px = 14; // width per policy

double changeOf(const StudySummary& summary, std::size_t setting)
{
    return summary.differences[setting].relative.mean;
}

/** Returns the settings with a tau, ascending, or those without one. */
std::vector<std::size_t> settingsWithTau(const StudySummary& summary, bool hasTau)
{
    std::vector<std::size_t> settings;
    for (std::size_t s = 0; s < summary.settings.size(); ++s)
        if (summary.settings[s].setting.tau.has_value() == hasTau)
            settings.push_back(s);
    if (hasTau)
        std::ranges::stable_sort(settings, {},
                                 [&](std::size_t s) { return *summary.settings[s].setting.tau; });
    return settings;
}

/** Builds the figures of a study with cases. */
class StudyFigureBuilder
{
public:
    StudyFigureBuilder(const StudySummary& summary, const StudyFigureFormat& format,
                       std::string_view name)
        : m_summary(summary), m_format(format), m_figure{.name = text(name)}
    {
    }

    [[nodiscard]] Figure zeta(double width_px);
    [[nodiscard]] Figure differences(const std::vector<std::size_t>& rows);
    [[nodiscard]] Figure bestTau();

private:
    [[nodiscard]] std::string text(std::string_view english,
                                   const std::vector<std::string>& arguments = {}) const
    {
        return m_format.words.text(english, arguments);
    }
    [[nodiscard]] bool hasSpread() const { return m_summary.cases.size() > 1; }
    [[nodiscard]] const Summary& zetaOf(std::size_t setting) const
    {
        return m_summary.settings[setting].zeta_m2s;
    }
    [[nodiscard]] std::string nameOfSetting(std::size_t setting) const
    {
        return m_format.setting(m_summary.settings[setting].setting);
    }
    [[nodiscard]] std::string nameOfReference() const { return nameOfSetting(m_summary.reference); }
    [[nodiscard]] std::string caseCount() const { return std::to_string(m_summary.cases.size()); }
    [[nodiscard]] std::string casesOf(double share) const
    {
        return std::to_string(std::lround(share * static_cast<double>(m_summary.cases.size())));
    }
    [[nodiscard]] std::vector<PlotPoint> curveOf(double Summary::*value) const
    {
        std::vector<PlotPoint> points;
        for (const std::size_t s : m_curve)
            points.push_back({.x = *m_summary.settings[s].setting.tau, .y = zetaOf(s).*value});
        return points;
    }
    [[nodiscard]] std::size_t lowestTau() const
    {
        return *std::ranges::min_element(m_curve, {},
                                         [this](std::size_t s) { return zetaOf(s).mean; });
    }
    void addZetaTitles();
    void addZetaAxis();
    void addCurve(double width_px);
    void addPolicies();
    void addLineAcross(double zeta_m2s, PlotLine line, std::string name);
    void addItem(std::size_t setting, const PlotPoint& at, std::vector<std::string> readout);
    void addMark(PlotMark mark);
    void addRow(std::size_t setting);
    [[nodiscard]] std::string comparedText(std::size_t setting) const;
    [[nodiscard]] std::vector<std::string> zetaReadout(std::size_t setting) const;
    [[nodiscard]] std::vector<std::string> differenceReadout(std::size_t setting) const;

    const StudySummary& m_summary;
    const StudyFigureFormat& m_format;
    std::vector<std::size_t> m_curve;    ///< settings by ascending tau
    std::vector<std::size_t> m_policies; ///< settings without tau by ascending mean
    Figure m_figure;
};

Figure StudyFigureBuilder::zeta(double width_px)
{
    if (m_summary.cases.empty())
        return std::move(m_figure);
    m_curve = settingsWithTau(m_summary, true);
    m_policies = settingsWithTau(m_summary, false);
    std::ranges::stable_sort(m_policies, {}, [this](std::size_t s) { return zetaOf(s).mean; });
    addZetaTitles();
    addZetaAxis();
    addCurve(width_px);
    addPolicies();
    return std::move(m_figure);
}

void StudyFigureBuilder::addZetaTitles()
{
    const std::size_t lowest = m_summary.recommendation->lowest;
    const std::string title =
        m_curve.empty() || lowestTau() == lowest
            ? text(QT_TRANSLATE_NOOP("Report", "Lowest: %1."), {nameOfSetting(lowest)})
            : text(QT_TRANSLATE_NOOP("Report", "Lowest: %1; of the values of τ: %2."),
                   {nameOfSetting(lowest), nameOfSetting(lowestTau())});
    const std::string legend =
        hasSpread()
            ? text(QT_TRANSLATE_NOOP("Report", "Band: quartiles. Dashed: median. Ring: reference."))
            : text(QT_TRANSLATE_NOOP("Report", "Ring: reference."));
    m_figure.rightTitles = {title + "  " + legend, title};
}

void StudyFigureBuilder::addZetaAxis()
{
    PlotAxis& y = m_figure.y;
    y = {.least = zetaOf(0).mean,
         .largest = zetaOf(0).mean,
         .spacing_px = 36,
         .text = m_format.number};
    for (const SettingSummary& setting : m_summary.settings)
        for (const double value : {setting.zeta_m2s.mean, setting.zeta_m2s.median,
                                   setting.zeta_m2s.quartile1, setting.zeta_m2s.quartile3})
            y.include(value);
    if (m_summary.bestTau)
        y.include(m_summary.bestTau->zeta_m2s.mean);
    const FigureUnit unit = m_format.unit(y.largest);
    y.inUnit = unit.inSi;
    m_figure.leftTitles = {hasSpread()
                               ? text(QT_TRANSLATE_NOOP("Report", "Mean ζ, %1"), {unit.name})
                               : text(QT_TRANSLATE_NOOP("Report", "Zeta ζ, %1"), {unit.name})};
}

/** Adds a setting; the reference gets a ring, and a line to its place on the axis. */
void StudyFigureBuilder::addItem(std::size_t setting, const PlotPoint& at,
                                 std::vector<std::string> readout)
{
    m_figure.items.push_back({.id = setting, .at = at, .readout = std::move(readout)});
    if (setting != m_summary.reference)
        return;
    PlotPoint top = at;
    top.dy_px = kReference_px;
    m_figure.lines.push_back(
        {.points = {top, {at.x, -kPlotEdge, at.dx_px}}, .ink = {}, .dash_px = {1, 2}});
    m_figure.marks.push_back({.at = at, .radius_px = kReference_px, .shape = MarkShape::Ring});
}

/** Adds the mark of the last item, whose readout is its tooltip. */
void StudyFigureBuilder::addMark(PlotMark mark)
{
    mark.at = m_figure.items.back().at;
    for (const std::string& line : m_figure.items.back().readout)
        mark.tip += (mark.tip.empty() ? "" : ", ") + line;
    m_figure.marks.push_back(std::move(mark));
}

void StudyFigureBuilder::addCurve(double width_px)
{
    constexpr double kBand = 0.16; // opacity
    constexpr double kPoint_px = 3.2;
    constexpr double kLowest_px = 5.5;
    constexpr double kColumnGap_px = 36;    // distance of the policies from the largest tau
    constexpr double kRoomForPoints_px = 7; // smallest distance of two marks
    constexpr double kBeside_px = 250;      // width taken by numbers and names
    constexpr std::size_t kAlwaysMarked = 7;
    PlotAxis& x = m_figure.x;
    x = {.ends = AxisEnds::Exact, .spacing_px = 56};
    if (m_curve.empty())
        return;
    const std::vector<PlotPoint> means = curveOf(&Summary::mean);
    x.text = m_format.number;
    x.title = text(QT_TRANSLATE_NOOP("Report", "Trade-off τ"));
    x.least = means.front().x;
    x.largest = means.back().x;
    x.inset_px = kMark_px;
    const double beside_px = kColumnGap_px + kSlot_px * static_cast<double>(m_policies.size());
    if (!m_policies.empty())
        x.reserve_px = beside_px;
    const Ink ink{.of = InkOf::Plan};
    if (hasSpread()) {
        std::vector<PlotPoint> band = curveOf(&Summary::quartile3);
        const std::vector<PlotPoint> below = curveOf(&Summary::quartile1);
        band.insert(band.end(), below.rbegin(), below.rend());
        m_figure.areas.push_back(
            {.outline = std::move(band), .ink = ink, .opacity = kBand, .key = "half"});
        m_figure.lines.push_back({.points = curveOf(&Summary::median),
                                  .ink = ink,
                                  .width_px = 1.2,
                                  .dash_px = {6, 5},
                                  .key = "median"});
    }
    m_figure.lines.push_back({.points = means, .ink = ink, .width_px = 2.2, .key = "mean"});
    const bool areMarked =
        means.size() <= kAlwaysMarked ||
        width_px - kBeside_px - beside_px > kRoomForPoints_px * static_cast<double>(means.size());
    for (std::size_t k = 0; k < means.size(); ++k) {
        const bool isLowest = m_curve[k] == lowestTau();
        addItem(m_curve[k], means[k], zetaReadout(m_curve[k]));
        if (isLowest || areMarked)
            addMark({.radius_px = isLowest ? kLowest_px : kPoint_px, .ink = ink});
    }
}

/** Adds horizontal lines of the policies, marks right of the curve, and names in the margin. */
void StudyFigureBuilder::addPolicies()
{
    double slot_px = -kSlot_px * (static_cast<double>(m_policies.size()) - 0.5);
    for (const std::size_t s : m_policies) {
        const PolicyKind policy = m_summary.settings[s].setting.policy;
        const PlotMark mark = policyMark(policy, kMark_px);
        const Ink faint{mark.ink.of, mark.ink.value, kFaint};
        addLineAcross(zetaOf(s).mean, {.ink = faint, .width_px = 1.2}, nameOfSetting(s));
        if (hasSpread())
            m_figure.lines.push_back({.points = {{kPlotEdge, zetaOf(s).quartile1, slot_px},
                                                 {kPlotEdge, zetaOf(s).quartile3, slot_px}},
                                      .ink = mark.ink,
                                      .width_px = 1.6});
        addItem(s, {kPlotEdge, zetaOf(s).mean, slot_px}, zetaReadout(s));
        addMark(mark);
        slot_px += kSlot_px;
    }
    if (m_summary.bestTau && hasSpread()) // for a single case it is the lowest point of the curve
        addLineAcross(m_summary.bestTau->zeta_m2s.mean,
                      {.ink = {.of = InkOf::Plan}, .width_px = 1.4, .dash_px = {1.4, 4.2}},
                      text(QT_TRANSLATE_NOOP("Report", "Best τ of each case")));
}

/** Adds a horizontal line below the curve, named in the margin. */
void StudyFigureBuilder::addLineAcross(double zeta_m2s, PlotLine line, std::string name)
{
    const Ink ink{line.ink.of, line.ink.value};
    line.points = {{-kPlotEdge, zeta_m2s}, {kPlotEdge, zeta_m2s}};
    m_figure.lines.insert(m_figure.lines.begin(), std::move(line));
    m_figure.labels.push_back({.text = std::move(name), .end = {kPlotEdge, zeta_m2s}, .ink = ink});
}

std::string StudyFigureBuilder::comparedText(std::size_t setting) const
{
    return text(QT_TRANSLATE_NOOP("Report", "%1 vs %2"),
                {m_format.change(changeOf(m_summary, setting)), nameOfReference()});
}

std::vector<std::string> StudyFigureBuilder::zetaReadout(std::size_t setting) const
{
    const Summary& zeta = zetaOf(setting);
    std::vector<std::string> lines{nameOfSetting(setting)};
    if (!hasSpread()) {
        lines.push_back(text(QT_TRANSLATE_NOOP("Report", "ζ %1 m² s"), {m_format.zeta(zeta.mean)}));
    } else {
        lines.push_back(text(QT_TRANSLATE_NOOP("Report", "mean %1, median %2"),
                             {m_format.zeta(zeta.mean), m_format.zeta(zeta.median)}));
        lines.push_back(text(QT_TRANSLATE_NOOP("Report", "quartiles %1 to %2"),
                             {m_format.zeta(zeta.quartile1), m_format.zeta(zeta.quartile3)}));
    }
    if (setting != m_summary.reference)
        lines.push_back(comparedText(setting));
    const double stuck = m_summary.settings[setting].stuckShare;
    if (stuck > 0)
        lines.push_back(
            hasSpread() ? text(QT_TRANSLATE_NOOP("Report", "stuck in %1 of %2 cases"),
                               {casesOf(stuck), caseCount()})
                        : text(QT_TRANSLATE_NOOP(
                              "Report", "stuck: visits at most two icebergs in the second half")));
    return lines;
}

Figure StudyFigureBuilder::differences(const std::vector<std::size_t>& rows)
{
    if (m_summary.cases.empty())
        return std::move(m_figure);
    m_figure.leftTitles = {text(QT_TRANSLATE_NOOP("Report", "Less ζ is better: to the left")), {}};
    if (hasSpread())
        m_figure.rightTitles = {text(
            QT_TRANSLATE_NOOP("Report", "Mean of the cases with its 95 % confidence interval"))};
    m_figure.x = {.ends = AxisEnds::Around0,
                  .largest = 0,
                  .spacing_px = 70,
                  .text =
                      [number = m_format.number](double percent, int decimals) {
                          const char* sign = percent < 0 ? "−" : percent > 0 ? "+" : "";
                          return sign + number(std::abs(percent), decimals);
                      },
                  .title = text(QT_TRANSLATE_NOOP("Report", "Difference of ζ vs %1, %"),
                                {nameOfReference()})};
    m_figure.y = {.ends = AxisEnds::Rows, .hasGrid = false};
    m_figure.lines.push_back(
        {.points = {{0, -kPlotEdge}, {0, kPlotEdge}}, .ink = {}, .width_px = 1.4});
    for (const std::size_t s : rows)
        addRow(s);
    if (m_figure.x.least == m_figure.x.largest)
        m_figure.x.largest = 1; // no differences
    return std::move(m_figure);
}

void StudyFigureBuilder::addRow(std::size_t setting)
{
    constexpr double kRowMark_px = 4.6;
    constexpr double kCap_px = 4; // half length of the end caps of an interval
    const MeanInterval& change = m_summary.differences[setting].relative;
    const auto y = static_cast<double>(m_figure.y.rows.size());
    const double low = 100 * change.low;
    const double high = 100 * change.high;
    m_figure.y.rows.push_back(nameOfSetting(setting));
    if (!std::isfinite(low) || !std::isfinite(high)) { // the reference may have zero zeta
        m_figure.y.rowEnds.emplace_back("–");
        return;
    }
    m_figure.y.rowEnds.push_back(m_format.change(change.mean));
    m_figure.items.push_back(
        {.id = setting, .at = {100 * change.mean, y}, .readout = differenceReadout(setting)});
    if (setting == m_summary.reference)
        return addMark({.radius_px = kRowMark_px, .isHollow = true});
    m_figure.x.include(low);
    m_figure.x.include(high);
    const PlotMark mark = policyMark(m_summary.settings[setting].setting.policy, kRowMark_px);
    const auto line = [&](const PlotPoint& from, const PlotPoint& to) {
        m_figure.lines.push_back({.points = {from, to}, .ink = mark.ink, .width_px = 1.8});
    };
    line({low, y}, {high, y});
    for (const double end : {low, high})
        line({end, y, 0, -kCap_px}, {end, y, 0, kCap_px});
    addMark(mark);
}

std::vector<std::string> StudyFigureBuilder::differenceReadout(std::size_t setting) const
{
    if (setting == m_summary.reference)
        return {nameOfSetting(setting), text(QT_TRANSLATE_NOOP("Report", "the reference"))};
    const PairedDifference& of = m_summary.differences[setting];
    std::vector<std::string> lines{nameOfSetting(setting), comparedText(setting)};
    if (!hasSpread())
        return lines;
    lines.push_back(text(QT_TRANSLATE_NOOP("Report", "95 %: %1 to %2"),
                         {m_format.change(of.relative.low), m_format.change(of.relative.high)}));
    lines.push_back(text(QT_TRANSLATE_NOOP("Report", "less in %1 of %2 cases"),
                         {casesOf(of.lowerShare), caseCount()}));
    lines.push_back(text(QT_TRANSLATE_NOOP("Report", "worst %1"), {m_format.change(of.worst)}));
    return lines;
}

Figure StudyFigureBuilder::bestTau()
{
    if (!m_summary.bestTau)
        return std::move(m_figure);
    constexpr double kPlot_px = 640; // width
    std::map<double, int> counts;
    for (const std::size_t s : settingsWithTau(m_summary, true))
        counts[*m_summary.settings[s].setting.tau] = 0;
    for (const double tau : m_summary.bestTau->byCase)
        ++counts[tau];
    m_figure.leftTitles = {text(QT_TRANSLATE_NOOP("Report", "cases"))};
    m_figure.x = {.least = counts.begin()->first,
                  .largest = counts.rbegin()->first,
                  .spacing_px = 80,
                  .text = m_format.number,
                  .title = text(QT_TRANSLATE_NOOP("Report", "τ of the lowest ζ of a case")),
                  .inset_px = 24}; // room for half a bar
    m_figure.y = {
        .ends = AxisEnds::Around0, .spacing_px = 34, .text = m_format.number, .isWhole = true};
    double half_px = 16;
    for (auto at = counts.begin(); std::next(at) != counts.end(); ++at)
        half_px = std::min(half_px, 0.4 * kPlot_px * (std::next(at)->first - at->first) /
                                        (m_figure.x.largest - m_figure.x.least));
    half_px = std::max(0.75, half_px);
    for (const auto& [tau, count] : counts) {
        m_figure.y.include(count);
        const double top = count;
        if (count > 0)
            m_figure.areas.push_back(
                {.outline = {{tau, 0, -half_px},
                             {tau, top, -half_px},
                             {tau, top, half_px},
                             {tau, 0, half_px}},
                 .ink = {.of = InkOf::Plan},
                 .tip = m_format.setting({.tau = tau}) + ": " + std::to_string(count)});
    }
    return std::move(m_figure);
}

/** Thins `all` evenly to at most `most` settings; those accepted by `isNeeded` always remain. */
template <class IsNeeded>
std::vector<std::size_t> thinned(const std::vector<std::size_t>& all, std::size_t most,
                                 const IsNeeded& isNeeded)
{
    const auto always = static_cast<std::size_t>(std::ranges::count_if(all, isNeeded));
    std::size_t step = 1;
    while ((all.size() + step - 1) / step + always > std::max(most, always + 1) &&
           step < all.size())
        ++step;
    std::vector<std::size_t> out;
    for (std::size_t k = 0; k < all.size(); ++k)
        if (k % step == 0 || isNeeded(all[k]))
            out.push_back(all[k]);
    return out;
}

} // namespace

std::string StudyFigureFormat::defaultNumber(double value, int decimals)
{
    return printedNumber(value, decimals);
}

std::string StudyFigureFormat::defaultZeta(double zeta_m2s)
{
    return printedNumber(zeta_m2s, decimalsFor(zeta_m2s, 4));
}

std::string StudyFigureFormat::defaultChange(double share)
{
    return signedNumber(100 * share, 1) + " %";
}

FigureUnit StudyFigureFormat::defaultUnit(double /*largest_m2s*/)
{
    return {.name = "m² s"};
}

std::string settingName(const StudySetting& setting)
{
    if (!setting.tau)
        return nameOf(kPolicyNames, setting.policy);
    constexpr double kPerUnit = 1e6; // 3 x 0.1 is meant to be 0.3
    return "τ = " + numberText(std::round(*setting.tau * kPerUnit) / kPerUnit);
}

Figure zetaFigure(const StudySummary& summary, const StudyFigureFormat& format, double width_px)
{
    return StudyFigureBuilder(
               summary, format,
               QT_TRANSLATE_NOOP("Report", "Accumulated uncertainty ζ against the trade-off τ"))
        .zeta(width_px);
}

std::vector<std::size_t> differenceRows(const StudySummary& summary, std::size_t most)
{
    if (summary.cases.empty())
        return {};
    const auto change = [&](std::size_t s) { return summary.differences[s].relative.mean; };
    std::vector<std::size_t> rows = settingsWithTau(summary, false);
    std::ranges::stable_sort(rows, {}, change);
    const std::vector<std::size_t> taus = settingsWithTau(summary, true);
    if (taus.empty())
        return rows;
    const std::size_t lowest = *std::ranges::min_element(taus, {}, change);
    const std::vector<std::size_t> shown =
        thinned(taus, most > rows.size() ? most - rows.size() : 0,
                [&](std::size_t s) { return s == summary.reference || s == lowest; });
    rows.insert(rows.end(), shown.begin(), shown.end());
    return rows;
}

Figure differenceFigure(const StudySummary& summary, const std::vector<std::size_t>& rows,
                        const StudyFigureFormat& format)
{
    return StudyFigureBuilder(summary, format,
                              QT_TRANSLATE_NOOP("Report", "Differences vs the reference"))
        .differences(rows);
}

Figure bestTauFigure(const StudySummary& summary, const StudyFigureFormat& format)
{
    return StudyFigureBuilder(summary, format,
                              QT_TRANSLATE_NOOP("Report", "Cases in which each tau is the best"))
        .bestTau();
}

} // namespace berg
