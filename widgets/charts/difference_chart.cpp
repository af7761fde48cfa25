#include "widgets/charts/difference_chart.h"

#include "widgets/charts/figure_text.h"
#include "widgets/words/policy_words.h"

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr double kRow_px = 20;
constexpr double kMark_px = 4.6;
constexpr double kCap_px = 4; // half length of the end caps of an interval

} // namespace

DifferenceChart::DifferenceChart(const Theme& theme, QWidget* parent) : StudyFigure(theme, parent)
{
    refresh();
}

Figure DifferenceChart::figure() const
{
    Figure figure = titled(tr("Differences vs the reference"),
                           tr("This chart compares each setting with a reference, case by case."));
    if (!hasCases())
        return figure;
    figure.leftTitles = {utf8(tr("Less ζ is better: to the left")), {}};
    if (hasSpread())
        figure.rightTitles = {utf8(tr("Mean of the cases with its 95 % confidence interval"))};
    figure.x = {
        .ends = AxisEnds::Around0,
        .largest = 0,
        .spacing_px = 70,
        .text =
            [locale = locale()](double percent, int decimals) {
                const QString sign = percent < 0 ? u"−"_s : percent > 0 ? u"+"_s : QString();
                return utf8(sign + fixedText(std::abs(percent), decimals, locale));
            },
        .title = utf8(tr("Difference of ζ vs %1, %").arg(nameOfReference()))};
    figure.y = {.ends = AxisEnds::Rows, .hasGrid = false};
    figure.lines.push_back(
        {.points = {{0, -kPlotEdge}, {0, kPlotEdge}}, .ink = {.of = InkOf::Uav}, .width_px = 1.4});
    const double room_px = std::max(kRow_px, height() - kFigureTop_px - kFigureBottom_px);
    for (const DifferenceRow& row :
         differenceRows(summary(), static_cast<std::size_t>(room_px / kRow_px), locale()))
        addRow(figure, row);
    if (figure.x.least == figure.x.largest)
        figure.x.largest = 1; // no differences
    return figure;
}

void DifferenceChart::addRow(Figure& figure, const DifferenceRow& row) const
{
    const auto y = static_cast<double>(figure.y.rows.size());
    const double low = 100 * row.relative.low;
    const double high = 100 * row.relative.high;
    figure.y.rows.push_back(utf8(row.name));
    if (!std::isfinite(low) || !std::isfinite(high)) { // the reference may have zero zeta
        figure.y.rowEnds.push_back(utf8(u"–"_s));
        return;
    }
    figure.y.rowEnds.push_back(utf8(changeText(row.relative.mean, locale())));
    const PlotPoint at{100 * row.relative.mean, y};
    figure.items.push_back({.id = row.setting, .at = at, .readout = readout(row.setting)});
    if (row.isReference) {
        figure.marks.push_back(
            {.at = at, .radius_px = kMark_px, .ink = {.of = InkOf::Uav}, .isHollow = true});
        return;
    }
    figure.x.least = std::min(figure.x.least, low);
    figure.x.largest = std::max(figure.x.largest, high);
    const PlotMark mark = policyMark(row.of.policy, at, kMark_px);
    const auto line = [&](const PlotPoint& from, const PlotPoint& to) {
        figure.lines.push_back({.points = {from, to}, .ink = mark.ink, .width_px = 1.8});
    };
    line({low, y}, {high, y});
    for (const double end : {low, high})
        line({end, y, 0, -kCap_px}, {end, y, 0, kCap_px});
    figure.marks.push_back(mark);
}

std::vector<std::string> DifferenceChart::readout(std::size_t setting) const
{
    const PairedDifference& of = summary().differences.at(setting);
    QStringList lines{nameOfSetting(setting)};
    if (setting == summary().reference)
        return utf8(lines << tr("the reference"));
    const auto share = [this](double value) { return changeText(value, locale()); };
    const auto cases = static_cast<double>(summary().cases.size());
    lines << tr("%1 vs %2").arg(share(of.relative.mean), nameOfReference());
    if (hasSpread())
        lines << tr("95 %: %1 to %2").arg(share(of.relative.low), share(of.relative.high))
              << tr("less in %1 of %2 cases")
                     .arg(std::lround(of.lowerShare * cases))
                     .arg(summary().cases.size())
              << tr("worst %1").arg(share(of.worst));
    return utf8(lines);
}

} // namespace berg
