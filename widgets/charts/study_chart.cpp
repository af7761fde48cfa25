#include "widgets/charts/study_chart.h"

#include "widgets/charts/chart_labels.h"
#include "widgets/charts/decimate.h"
#include "widgets/theme/quantity_text.h"

#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr double kTickSpacing_px = 36;
constexpr double kTauSpacing_px = 56;
constexpr double kColumnGap_px = 36; ///< between the largest tau and the policies
constexpr double kSlot_px = 14;      ///< for each policy
constexpr double kLabelHeight_px = 15;
constexpr double kLeader_px = 16;
constexpr double kLabelShare = 0.3; ///< of the width, at most, for the labels
constexpr double kLine_px = 2.2;
constexpr double kPoint_px = 3.2;
constexpr double kLowest_px = 5.5;
constexpr double kMark_px = 5;
constexpr double kReference_px = 7.5;
constexpr double kRoomForPoints_px = 7; ///< between two of them
constexpr double kBand = 0.16;          ///< part of the curve's colour in the band
constexpr double kFaint = 0.55;         ///< of a policy's in its line
constexpr double kTitleGap_px = 24;

} // namespace

StudyChart::StudyChart(const Theme& theme, QWidget* parent) : StudyPicture(theme, parent)
{
    setAccessibleName(tr("Accumulated uncertainty ζ against the trade-off τ"));
    refresh();
}

void StudyChart::layOut()
{
    m_content = hasCases() ? zetaContent(summary(), locale()) : ZetaContent();
    if (!hasCases()) {
        m_frame.emptyText =
            tr("Choose what to fly and press Start, or take a figure of the paper.");
        m_frame.plot = QRectF(rect());
        return;
    }
    fillTitles();
    setPlot();
    setTicks();
    setSpots();
    placeLabels();
}

void StudyChart::fillTitles()
{
    m_frame.leftTitle = hasSpread() ? tr("Mean ζ, m² s") : tr("Zeta ζ, m² s");
    m_frame.timeTitle = tr("Trade-off τ");
    const QFontMetricsF small(m_theme.small());
    const double room_px =
        width() - 2 * kChartSide_px - kTitleGap_px - small.horizontalAdvance(m_frame.leftTitle);
    const auto name = [this](std::size_t setting) {
        return settingText(summary().settings[setting].setting, locale());
    };
    const bool isTau = !m_content.lowestTau || m_content.lowestTau == m_content.lowest;
    const QString lowest = isTau ? tr("Lowest: %1.").arg(name(m_content.lowest))
                                 : tr("Lowest: %1; of the values of τ: %2.")
                                       .arg(name(m_content.lowest), name(*m_content.lowestTau));
    const QString legend = hasSpread() ? tr("Band: quartiles. Dashed: median. Ring: reference.")
                                       : tr("Ring: reference.");
    const QString both = lowest + u"  "_s + legend;
    m_frame.rightTitle = small.horizontalAdvance(both) <= room_px ? both : lowest;
}

QString StudyChart::labelOf(const ZetaPoint& policy) const
{
    return policy.of.policy == PolicyKind::Path
               ? tr("%1 (TSP)", "travelling salesman problem").arg(policy.name)
               : policy.name;
}

void StudyChart::setPlot()
{
    double least = summary().settings[m_content.lowest].zeta_m2s.mean;
    double largest = least;
    for (const std::vector<ZetaPoint>* points : {&m_content.curve, &m_content.policies})
        for (const ZetaPoint& point : *points)
            for (const double value : {point.zeta_m2s.mean, point.zeta_m2s.median,
                                       point.zeta_m2s.quartile1, point.zeta_m2s.quartile3}) {
                least = std::min(least, value);
                largest = std::max(largest, value);
            }
    if (m_content.bestTau_m2s)
        least = std::min(least, *m_content.bestTau_m2s);

    const double top_px = chartTop(m_frame);
    const double height_px = std::max(20.0, height() - top_px - kChartBottom_px);
    m_axis = niceRange(least, largest, std::max(1, static_cast<int>(height_px / kTickSpacing_px)));

    const QFontMetricsF small(m_theme.small());
    double numbers_px = 0;
    for (int k = 0; k <= m_axis.count; ++k)
        numbers_px =
            std::max(numbers_px,
                     small.horizontalAdvance(fixedText(m_axis.at(k), m_axis.decimals(), locale())));
    const double left_px = kChartSide_px + kChartTickGap_px + numbers_px;
    double labels_px = 0;
    for (const ZetaPoint& policy : m_content.policies)
        labels_px = std::max(labels_px, small.horizontalAdvance(labelOf(policy)));
    if (m_content.bestTau_m2s)
        labels_px = std::max(labels_px, small.horizontalAdvance(tr("Best τ of each case")));
    const double margin_px =
        labels_px > 0 ? kLeader_px + 4 + std::min(labels_px, kLabelShare * width()) : kChartSide_px;
    m_frame.plot =
        QRectF(left_px, top_px, std::max(60.0, width() - 8 - margin_px - left_px), height_px);
    m_curveArea = m_frame.plot;
    if (!m_content.policies.empty() && !m_content.curve.empty())
        m_curveArea.setRight(
            std::max(left_px + 40, m_frame.plot.right() - kColumnGap_px -
                                       kSlot_px * static_cast<double>(m_content.policies.size())));
    if (m_content.curve.empty())
        m_curveArea.setWidth(0);
    else
        m_curveArea.adjust(kMark_px, 0, m_content.policies.empty() ? -kMark_px : 0, 0);
}

void StudyChart::setTicks()
{
    for (int k = 0; k <= m_axis.count; ++k)
        m_frame.left.push_back({.at_px = toView(0, m_axis.at(k)).y(),
                                .text = fixedText(m_axis.at(k), m_axis.decimals(), locale())});
    for (std::size_t k = 0; k < m_content.policies.size(); ++k)
        if (m_content.policies[k].of.policy == PolicyKind::Path)
            m_frame.times.push_back({.at_px = slot_px(k), .text = tr("TSP")});
    if (m_content.curve.empty()) {
        m_frame.timeTitle.clear();
        return;
    }
    m_lowTau = *m_content.curve.front().of.tau;
    m_highTau = *m_content.curve.back().of.tau;
    const NiceTicks steps = niceTicks(
        m_highTau - m_lowTau, std::max(1, static_cast<int>(m_curveArea.width() / kTauSpacing_px)));
    const double first = std::ceil(m_lowTau / steps.step - 1e-9);
    const double last = std::floor(m_highTau / steps.step + 1e-9);
    for (double k = first; k <= last; ++k)
        m_frame.times.push_back({.at_px = toView(k * steps.step, m_axis.first).x(),
                                 .text = fixedText(k * steps.step, steps.decimals(), locale())});
    if (m_highTau == m_lowTau)
        m_frame.times.push_back({.at_px = toView(m_lowTau, m_axis.first).x(),
                                 .text = fixedText(m_lowTau, 2, locale())});
}

QPointF StudyChart::toView(double tau, double zeta_m2s) const
{
    const double extent = m_highTau - m_lowTau;
    const double share = extent > 0 ? (tau - m_lowTau) / extent : 0.5;
    return {m_curveArea.left() + m_curveArea.width() * share,
            m_frame.plot.bottom() - m_frame.plot.height() * m_axis.share(zeta_m2s)};
}

double StudyChart::slot_px(std::size_t policy) const
{
    const double wanted_px =
        kSlot_px * (static_cast<double>(m_content.policies.size() - policy) - 0.5);
    return m_frame.plot.right() - wanted_px;
}

void StudyChart::setSpots()
{
    for (const ZetaPoint& point : m_content.curve)
        m_spots.push_back(
            {.setting = point.setting, .at = toView(*point.of.tau, point.zeta_m2s.mean)});
    for (std::size_t k = 0; k < m_content.policies.size(); ++k) {
        const ZetaPoint& policy = m_content.policies[k];
        m_spots.push_back(
            {.setting = policy.setting, .at = {slot_px(k), toView(0, policy.zeta_m2s.mean).y()}});
    }
}

/** In the margin at the right, each beside its line. */
void StudyChart::placeLabels()
{
    std::vector<ChartLabel> labels;
    const auto add = [&](const QString& text, double zeta_m2s, const QColor& colour) {
        labels.push_back({.text = text,
                          .end = {m_frame.plot.right(), toView(0, zeta_m2s).y()},
                          .colour = colour,
                          .inMargin = true});
    };
    for (const ZetaPoint& policy : m_content.policies)
        add(labelOf(policy), policy.zeta_m2s.mean, policyColour(policy.of.policy, m_theme));
    if (m_content.bestTau_m2s)
        add(tr("Best τ of each case"), *m_content.bestTau_m2s, m_theme.plan);
    const LabelColumn column{.top = m_frame.plot.top() - kLabelHeight_px / 2,
                             .bottom = m_frame.plot.bottom() + kLabelHeight_px / 2,
                             .spacing = kLabelHeight_px};
    labels.resize(std::min(
        labels.size(), static_cast<std::size_t>((column.bottom - column.top) / column.spacing)));
    std::vector<double> wanted;
    for (const ChartLabel& label : labels)
        wanted.push_back(label.end.y());
    const std::vector<double> middles = spreadLabels(wanted, column);
    const QFontMetricsF small(m_theme.small());
    const double left_px = m_frame.plot.right() + kLeader_px;
    for (std::size_t k = 0; k < labels.size(); ++k) {
        ChartLabel& label = labels[k];
        label.rect = QRectF(left_px, middles[k] - kLabelHeight_px / 2, width() - 4 - left_px,
                            kLabelHeight_px);
        label.text = small.elidedText(label.text, Qt::ElideRight, label.rect.width());
    }
    m_frame.labels = std::move(labels);
}

QPolygonF StudyChart::curve(double Summary::*value) const
{
    std::vector<QPointF> points;
    for (const ZetaPoint& point : m_content.curve)
        points.push_back(toView(*point.of.tau, point.zeta_m2s.*value));
    if (points.size() < 2)
        return QPolygonF(QList<QPointF>(points.begin(), points.end()));
    return decimate(points, {.from = m_curveArea.left(),
                             .to = m_curveArea.right(),
                             .columns = std::max(1, static_cast<int>(m_curveArea.width()))});
}

void StudyChart::paintContent(QPainter& painter) const
{
    paintChartGrid(painter, m_frame, m_theme);
    if (hasSpread() && m_content.curve.size() > 1) {
        QPolygonF band = curve(&Summary::quartile3);
        const QPolygonF below = curve(&Summary::quartile1);
        std::copy(below.rbegin(), below.rend(), std::back_inserter(band));
        painter.setPen(Qt::NoPen);
        painter.setBrush(mixed(m_theme.chart, m_theme.plan, kBand));
        painter.drawPolygon(band);
    }
    paintPolicies(painter);
    paintCurve(painter);
    paintReference(painter);
}

void StudyChart::paintPolicies(QPainter& painter) const
{
    const auto line = [&](double y, const QPen& pen) {
        painter.setPen(pen);
        painter.drawLine(QPointF(m_frame.plot.left(), y), QPointF(m_frame.plot.right(), y));
    };
    if (m_content.bestTau_m2s) {
        QPen dotted(m_theme.plan, 1.4, Qt::CustomDashLine, Qt::FlatCap);
        dotted.setDashPattern({1, 3});
        line(toView(0, *m_content.bestTau_m2s).y(), dotted);
    }
    for (std::size_t k = 0; k < m_content.policies.size(); ++k) {
        const ZetaPoint& policy = m_content.policies[k];
        const QColor colour = policyColour(policy.of.policy, m_theme);
        const double y = toView(0, policy.zeta_m2s.mean).y();
        line(y, QPen(mixed(m_theme.chart, colour, kFaint), 1.2));
        const double x = slot_px(k);
        if (hasSpread()) {
            painter.setPen(QPen(colour, 1.6, Qt::SolidLine, Qt::FlatCap));
            painter.drawLine(QPointF(x, toView(0, policy.zeta_m2s.quartile1).y()),
                             QPointF(x, toView(0, policy.zeta_m2s.quartile3).y()));
        }
    }
    for (std::size_t k = 0; k < m_content.policies.size(); ++k) {
        const ZetaPoint& policy = m_content.policies[k];
        paintPolicyMark(painter, {slot_px(k), toView(0, policy.zeta_m2s.mean).y()}, kMark_px,
                        policy.of.policy, m_theme);
    }
}

void StudyChart::paintCurve(QPainter& painter) const
{
    if (m_content.curve.empty())
        return;
    painter.setBrush(Qt::NoBrush);
    if (hasSpread()) {
        QPen dashed(m_theme.plan, 1.2, Qt::CustomDashLine, Qt::FlatCap, Qt::RoundJoin);
        dashed.setDashPattern({5, 4});
        painter.setPen(dashed);
        painter.drawPolyline(curve(&Summary::median));
    }
    painter.setPen(QPen(m_theme.plan, kLine_px, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPolyline(curve(&Summary::mean));
    const bool hasRoom =
        m_curveArea.width() > kRoomForPoints_px * static_cast<double>(m_content.curve.size());
    for (const ZetaPoint& point : m_content.curve)
        if (hasRoom || point.setting == m_content.lowestTau)
            paintPolicyMark(painter, toView(*point.of.tau, point.zeta_m2s.mean),
                            point.setting == m_content.lowestTau ? kLowest_px : kPoint_px,
                            PolicyKind::Visitation, m_theme);
}

/** A ring, and where it is on the axis. */
void StudyChart::paintReference(QPainter& painter) const
{
    const auto spot = std::find_if(m_spots.begin(), m_spots.end(), [&](const SettingSpot& one) {
        return one.setting == m_content.reference;
    });
    if (spot == m_spots.end())
        return;
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(m_theme.uav, 1.8));
    painter.drawEllipse(spot->at, kReference_px, kReference_px);
    painter.setPen(QPen(m_theme.uav, 1, Qt::DotLine));
    painter.drawLine(spot->at + QPointF(0, kReference_px),
                     QPointF(spot->at.x(), m_frame.plot.bottom()));
}

QStringList StudyChart::readout(std::size_t setting) const
{
    const SettingSummary& of = summary().settings.at(setting);
    const auto number = [this](double value) { return significantText(value, 4, locale()); };
    QStringList lines{settingText(of.setting, locale())};
    if (!hasSpread()) {
        lines << tr("ζ %1 m² s").arg(number(of.zeta_m2s.mean));
    } else {
        lines << tr("mean %1, median %2").arg(number(of.zeta_m2s.mean), number(of.zeta_m2s.median))
              << tr("quartiles %1 to %2")
                     .arg(number(of.zeta_m2s.quartile1), number(of.zeta_m2s.quartile3));
    }
    if (setting != m_content.reference)
        lines << tr("%1 to %2")
                     .arg(changeText(summary().differences[setting].relative.mean, locale()),
                          settingText(summary().settings[m_content.reference].setting, locale()));
    if (of.stuckShare > 0)
        lines << (hasSpread() ? tr("stuck in %1 of %2 cases")
                                    .arg(std::lround(of.stuckShare * m_content.cases))
                                    .arg(m_content.cases)
                              : tr("stuck: flies to two icebergs at most in the second half"));
    return lines;
}

} // namespace berg
