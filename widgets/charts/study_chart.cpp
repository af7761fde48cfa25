#include "widgets/charts/study_chart.h"

#include "widgets/charts/figure_text.h"
#include "widgets/theme/quantity_text.h"
#include "widgets/words/policy_words.h"

#include <cmath>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr double kColumnGap_px = 36; // distance of the policies from the largest tau
constexpr double kSlot_px = 14;      // width per policy
constexpr double kPoint_px = 3.2;
constexpr double kLowest_px = 5.5;
constexpr double kMark_px = 5;
constexpr double kReference_px = 7.5;
constexpr double kBand = 0.16;          // colour strength of the band
constexpr double kFaint = 0.55;         // colour strength of policy lines
constexpr double kRoomForPoints_px = 7; // smallest distance of two marks
constexpr double kBeside_px = 250;      // width taken by numbers and names

std::vector<PlotPoint> curveOf(const ZetaContent& content, double Summary::*value)
{
    std::vector<PlotPoint> points;
    for (const ZetaPoint& point : content.curve)
        points.push_back({.x = *point.of.tau, .y = point.zeta_m2s.*value});
    return points;
}

void include(PlotAxis& axis, double value)
{
    axis.least = std::min(axis.least, value);
    axis.largest = std::max(axis.largest, value);
}

void includeAll(PlotAxis& axis, const ZetaContent& content)
{
    for (const std::vector<ZetaPoint>* points : {&content.curve, &content.policies})
        for (const ZetaPoint& point : *points)
            for (const double value : {point.zeta_m2s.mean, point.zeta_m2s.median,
                                       point.zeta_m2s.quartile1, point.zeta_m2s.quartile3})
                include(axis, value);
    if (content.bestTau_m2s)
        include(axis, *content.bestTau_m2s);
}

/** Marks the reference by a ring, and its place on the axis by a line. */
void addReference(Figure& figure, const PlotPoint& at)
{
    PlotPoint foot = at;
    foot.y = -kPlotEdge;
    PlotPoint top = at;
    top.dy_px = kReference_px;
    figure.lines.push_back({.points = {top, foot}, .ink = {.of = InkOf::Uav}, .dash_px = {1, 2}});
    figure.marks.push_back({.at = at,
                            .radius_px = kReference_px,
                            .ink = {.of = InkOf::Uav},
                            .shape = MarkShape::Ring});
}

} // namespace

void StudyFigure::setResult(const StudyPointer& result)
{
    m_result = result;
    forgetItems(result ? result->summary.settings.size() : 0);
    refresh();
}

QString StudyFigure::nameOfSetting(std::size_t setting) const
{
    return settingText(summary().settings[setting].setting, locale());
}

Figure StudyFigure::titled(const QString& name, const QString& emptyText) const
{
    Figure figure{.name = utf8(name)};
    if (!hasCases()) {
        figure.emptyText = utf8(emptyText);
        return figure;
    }
    const int cases = static_cast<int>(summary().cases.size());
    const QString study = QString::fromStdString(m_result->study.spec.name);
    const QString count = tr("%n cases", nullptr, cases);
    figure.title =
        utf8(study.isEmpty() ? count
                             : tr("%1: %2", "name of a study, how many cases").arg(study, count));
    figure.description = figure.title;
    return figure;
}

StudyChart::StudyChart(const Theme& theme, QWidget* parent) : StudyFigure(theme, parent)
{
    refresh();
}

Figure StudyChart::figure() const
{
    Figure figure =
        titled(tr("Accumulated uncertainty ζ against the trade-off τ"),
               tr("Choose what to fly and press Start, or load a figure from the paper."));
    if (!hasCases())
        return figure;
    const ZetaContent content = zetaContent(summary(), locale());
    addTitles(figure, content);
    const double lowest_m2s = summary().settings[content.lowest].zeta_m2s.mean;
    figure.y = {
        .least = lowest_m2s, .largest = lowest_m2s, .spacing_px = 36, .text = numberText(locale())};
    includeAll(figure.y, content);
    const ShownUnit unit = zetaUnit(figure.y.largest);
    figure.y.inUnit = unit.inSi;
    figure.leftTitles = {utf8((hasSpread() ? tr("Mean ζ, %1") : tr("Zeta ζ, %1")).arg(unit.name))};
    addCurve(figure, content);
    addPolicies(figure, content);
    return figure;
}

void StudyChart::addTitles(Figure& figure, const ZetaContent& content) const
{
    const bool isTau = !content.lowestTau || content.lowestTau == content.lowest;
    const QString lowest =
        isTau ? tr("Lowest: %1.").arg(nameOfSetting(content.lowest))
              : tr("Lowest: %1; of the values of τ: %2.")
                    .arg(nameOfSetting(content.lowest), nameOfSetting(*content.lowestTau));
    const QString legend = hasSpread() ? tr("Band: quartiles. Dashed: median. Ring: reference.")
                                       : tr("Ring: reference.");
    figure.rightTitles = {utf8(lowest + u"  "_s + legend), utf8(lowest)};
}

void StudyChart::addItem(Figure& figure, std::size_t setting, const PlotPoint& at) const
{
    if (setting == summary().reference)
        addReference(figure, at);
    figure.items.push_back({.id = setting, .at = at, .readout = readout(setting)});
}

void StudyChart::addCurve(Figure& figure, const ZetaContent& content) const
{
    PlotAxis& x = figure.x;
    x = {.ends = AxisEnds::Exact, .spacing_px = 56};
    if (content.curve.empty())
        return;
    x.text = numberText(locale());
    x.title = utf8(tr("Trade-off τ"));
    x.least = *content.curve.front().of.tau;
    x.largest = *content.curve.back().of.tau;
    x.inset_px = kMark_px;
    const Ink ink{.of = InkOf::Plan};
    if (hasSpread()) {
        std::vector<PlotPoint> band = curveOf(content, &Summary::quartile3);
        const std::vector<PlotPoint> below = curveOf(content, &Summary::quartile1);
        band.insert(band.end(), below.rbegin(), below.rend());
        figure.areas.push_back(
            {.outline = std::move(band), .ink = {.of = InkOf::Plan, .strength = kBand}});
        figure.lines.push_back({.points = curveOf(content, &Summary::median),
                                .ink = ink,
                                .width_px = 1.2,
                                .dash_px = {6, 5}});
    }
    figure.lines.push_back(
        {.points = curveOf(content, &Summary::mean), .ink = ink, .width_px = 2.2});
    const auto columns = static_cast<double>(content.policies.size());
    const bool hasRoom = width() - kBeside_px - kColumnGap_px - kSlot_px * columns >
                         kRoomForPoints_px * static_cast<double>(content.curve.size());
    for (const ZetaPoint& point : content.curve) {
        const PlotPoint at{*point.of.tau, point.zeta_m2s.mean};
        const bool isLowest = point.setting == content.lowestTau;
        addItem(figure, point.setting, at);
        if (isLowest || hasRoom || content.curve.size() < 8)
            figure.marks.push_back(
                {.at = at, .radius_px = isLowest ? kLowest_px : kPoint_px, .ink = ink});
    }
}

/** Adds horizontal lines of the policies, marks right of the curve, and names in the margin. */
void StudyChart::addPolicies(Figure& figure, const ZetaContent& content) const
{
    const auto count = static_cast<double>(content.policies.size());
    if (!content.policies.empty() && !content.curve.empty())
        figure.x.reserve_px = kColumnGap_px + kSlot_px * count;
    const auto across = [&](double zeta_m2s, const Ink& ink, const QString& name) {
        PlotLine line{.points = {{-kPlotEdge, zeta_m2s}, {kPlotEdge, zeta_m2s}},
                      .ink = {ink.of, ink.value, kFaint},
                      .width_px = 1.2};
        if (ink.of == InkOf::Plan)
            line = {.points = line.points, .ink = ink, .width_px = 1.4, .dash_px = {1.4, 4.2}};
        figure.lines.insert(figure.lines.begin(), std::move(line)); // drawn below the curve
        figure.labels.push_back({.text = utf8(name), .end = {kPlotEdge, zeta_m2s}, .ink = ink});
    };
    double slot_px = -kSlot_px * (count - 0.5);
    for (const ZetaPoint& policy : content.policies) {
        const Ink ink{.of = InkOf::Policy, .value = static_cast<double>(policy.of.policy)};
        across(policy.zeta_m2s.mean, ink, policy.name);
        const PlotPoint at{kPlotEdge, policy.zeta_m2s.mean, slot_px};
        if (hasSpread())
            figure.lines.push_back({.points = {{kPlotEdge, policy.zeta_m2s.quartile1, slot_px},
                                               {kPlotEdge, policy.zeta_m2s.quartile3, slot_px}},
                                    .ink = ink,
                                    .width_px = 1.6});
        addItem(figure, policy.setting, at);
        figure.marks.push_back(policyMark(policy.of.policy, at, kMark_px));
        slot_px += kSlot_px;
    }
    if (content.bestTau_m2s)
        across(*content.bestTau_m2s, {.of = InkOf::Plan}, tr("Best τ of each case"));
}

std::vector<std::string> StudyChart::readout(std::size_t setting) const
{
    const SettingSummary& of = summary().settings.at(setting);
    const auto number = [this](double value) { return significantText(value, 4, locale()); };
    QStringList lines{nameOfSetting(setting)};
    if (!hasSpread()) {
        lines << tr("ζ %1 m² s").arg(number(of.zeta_m2s.mean));
    } else {
        lines << tr("mean %1, median %2").arg(number(of.zeta_m2s.mean), number(of.zeta_m2s.median))
              << tr("quartiles %1 to %2")
                     .arg(number(of.zeta_m2s.quartile1), number(of.zeta_m2s.quartile3));
    }
    if (setting != summary().reference)
        lines << tr("%1 vs %2")
                     .arg(changeText(summary().differences[setting].relative.mean, locale()),
                          nameOfReference());
    if (of.stuckShare > 0) {
        const auto cases = static_cast<double>(summary().cases.size());
        lines << (hasSpread() ? tr("stuck in %1 of %2 cases")
                                    .arg(std::lround(of.stuckShare * cases))
                                    .arg(summary().cases.size())
                              : tr("stuck: visits at most two icebergs in the second half"));
    }
    return utf8(lines);
}

} // namespace berg
