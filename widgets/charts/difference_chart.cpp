#include "widgets/charts/difference_chart.h"

#include "widgets/theme/quantity_text.h"

#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr double kRow_px = 20;
constexpr double kTickSpacing_px = 70;
constexpr double kNameShare = 0.3; ///< of the width, at most
constexpr double kMark_px = 4.6;
constexpr double kCap_px = 4; ///< half of the ends of an interval
constexpr double kGap_px = 10;

/** Of a relative difference that may be infinite: the reference can be 0. */
bool isDrawn(const DifferenceRow& row)
{
    return std::isfinite(row.relative.low) && std::isfinite(row.relative.high);
}

} // namespace

DifferenceChart::DifferenceChart(const Theme& theme, QWidget* parent) : StudyPicture(theme, parent)
{
    setAccessibleName(tr("Differences to the reference"));
    refresh();
}

void DifferenceChart::layOut()
{
    m_rows.clear();
    if (!hasCases()) {
        m_frame.emptyText = tr("Here each setting is compared with a reference, case by case.");
        m_frame.plot = QRectF(rect());
        return;
    }
    fillTitles();
    const double top_px = chartTop(m_frame);
    const double height_px = std::max(kRow_px, height() - top_px - kChartBottom_px);
    m_rows = differenceRows(summary(), static_cast<std::size_t>(height_px / kRow_px), locale());

    const QFontMetricsF small(m_theme.small());
    double names_px = 0;
    for (const DifferenceRow& row : m_rows)
        names_px = std::max(names_px, small.horizontalAdvance(row.name));
    names_px = std::min(names_px, kNameShare * width());
    const double figures_px = small.horizontalAdvance(changeText(-0.999, locale()));
    const double left_px = kChartSide_px + names_px + kGap_px;
    m_frame.plot =
        QRectF(left_px, top_px,
               std::max(40.0, width() - kChartSide_px - figures_px - kGap_px - left_px), height_px);
    setAxis();
    setTicks();
    for (std::size_t k = 0; k < m_rows.size(); ++k)
        if (isDrawn(m_rows[k]))
            m_spots.push_back(
                {.setting = m_rows[k].setting, .at = {x_px(m_rows[k].relative.mean), y_px(k)}});
}

void DifferenceChart::fillTitles()
{
    const QString reference =
        settingText(summary().settings[summary().reference].setting, locale());
    const bool hasSpread = summary().cases.size() > 1;
    m_frame.leftTitle = tr("Less ζ is better: to the left");
    m_frame.rightTitle =
        hasSpread ? tr("Mean of the cases with its 95 % confidence interval") : QString();
    const QFontMetricsF small(m_theme.small());
    if (small.horizontalAdvance(m_frame.leftTitle + m_frame.rightTitle) + 60 > width())
        m_frame.leftTitle.clear();
    m_frame.timeTitle = tr("Difference of ζ to %1, %").arg(reference);
}

void DifferenceChart::setAxis()
{
    double low = 0;
    double high = 0;
    for (const DifferenceRow& row : m_rows)
        if (isDrawn(row)) {
            low = std::min(low, 100 * row.relative.low);
            high = std::max(high, 100 * row.relative.high);
        }
    if (low == high)
        high = 1; // nothing differs
    m_ticks = niceTicksAround(
        low, high, std::max(2, static_cast<int>(m_frame.plot.width() / kTickSpacing_px)));
}

void DifferenceChart::setTicks()
{
    for (int k = -m_ticks.below; k <= m_ticks.count; ++k) {
        const double percent = k * m_ticks.step;
        const QString sign = k < 0 ? u"−"_s : k > 0 ? u"+"_s : QString();
        m_frame.times.push_back(
            {.at_px = x_px(percent / 100),
             .text = sign + fixedText(std::abs(percent), m_ticks.decimals(), locale())});
    }
    const QFontMetricsF small(m_theme.small());
    for (std::size_t k = 0; k < m_rows.size(); ++k) {
        const double room_px = m_frame.plot.left() - kChartSide_px - kChartTickGap_px;
        m_frame.left.push_back(
            {.at_px = y_px(k), .text = small.elidedText(m_rows[k].name, Qt::ElideRight, room_px)});
        m_frame.right.push_back(
            {.at_px = y_px(k),
             .text = isDrawn(m_rows[k]) ? changeText(m_rows[k].relative.mean, locale()) : u"–"_s});
    }
}

double DifferenceChart::x_px(double share) const
{
    return m_frame.plot.left() + m_frame.plot.width() * (100 * share - m_ticks.start()) /
                                     (m_ticks.end() - m_ticks.start());
}

double DifferenceChart::y_px(std::size_t row) const
{
    return m_frame.plot.top() + m_frame.plot.height() * (static_cast<double>(row) + 0.5) /
                                    static_cast<double>(m_rows.size());
}

void DifferenceChart::paintContent(QPainter& painter) const
{
    const QRectF& plot = m_frame.plot;
    painter.setPen(QPen(m_theme.chartGrid, 1));
    for (const ChartTick& tick : m_frame.times)
        painter.drawLine(QPointF(tick.at_px, plot.top()), QPointF(tick.at_px, plot.bottom()));
    painter.setPen(QPen(m_theme.uav, 1.4));
    painter.drawLine(QPointF(x_px(0), plot.top()), QPointF(x_px(0), plot.bottom()));
    for (std::size_t k = 0; k < m_rows.size(); ++k)
        if (isDrawn(m_rows[k]))
            paintRow(painter, k);
}

void DifferenceChart::paintRow(QPainter& painter, std::size_t k) const
{
    const DifferenceRow& row = m_rows[k];
    const QPointF at(x_px(row.relative.mean), y_px(k));
    if (row.isReference) {
        painter.setPen(QPen(m_theme.uav, 1.8));
        painter.setBrush(m_theme.chart);
        painter.drawEllipse(at, kMark_px, kMark_px);
        return;
    }
    const double low_px = x_px(row.relative.low);
    const double high_px = x_px(row.relative.high);
    painter.setPen(QPen(policyColour(row.of.policy, m_theme), 1.8, Qt::SolidLine, Qt::FlatCap));
    painter.drawLine(QPointF(low_px, at.y()), QPointF(high_px, at.y()));
    if (high_px - low_px > 2 * kMark_px)
        for (const double end_px : {low_px, high_px})
            painter.drawLine(QPointF(end_px, at.y() - kCap_px), QPointF(end_px, at.y() + kCap_px));
    paintPolicyMark(painter, at, kMark_px, row.of.policy, m_theme);
}

QStringList DifferenceChart::readout(std::size_t setting) const
{
    const PairedDifference& of = summary().differences.at(setting);
    QStringList lines{settingText(of.setting, locale())};
    if (setting == summary().reference) {
        lines << tr("the reference");
        return lines;
    }
    const auto share = [this](double value) { return changeText(value, locale()); };
    const auto cases = static_cast<double>(summary().cases.size());
    lines << tr("%1 to %2")
                 .arg(share(of.relative.mean),
                      settingText(summary().settings[summary().reference].setting, locale()));
    if (summary().cases.size() > 1)
        lines << tr("95 %: %1 to %2").arg(share(of.relative.low), share(of.relative.high))
              << tr("less in %1 of %2 cases")
                     .arg(std::lround(of.lowerShare * cases))
                     .arg(summary().cases.size())
              << tr("worst %1").arg(share(of.worst));
    return lines;
}

} // namespace berg
