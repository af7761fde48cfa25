#include "widgets/panels/plan/policy_combo.h"

#include "core/sim/policy_forecast.h"
#include "core/study/statistics.h"
#include "widgets/map/paint/map_symbols.h"
#include "widgets/panels/fields/panel_labels.h"
#include "widgets/theme/quantity_text.h"
#include "widgets/words/policy_words.h"

#include <QAbstractItemView>
#include <QPainter>
#include <QStyleOptionComboBox>

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr int kMargin_px = 8;
constexpr int kLineGap_px = 1;
constexpr int kColumnGap_px = 24;
constexpr int kPillMargin_px = 6;

QString zetaText(double zeta_m2s, const QLocale& locale)
{
    return PolicyCombo::tr("%1 m² s").arg(significantText(zeta_m2s, 4, locale));
}

QFont boldOf(QFont font)
{
    font.setBold(true);
    return font;
}

} // namespace

void PolicyDelegate::paint(QPainter* painter, const QStyleOptionViewItem& given,
                           const QModelIndex& index) const
{
    const bool selected = given.state.testFlag(QStyle::State_Selected);
    const QFont small = m_theme.small();
    const QFont name = boldOf(m_theme.body());
    const QRect row = given.rect.adjusted(kMargin_px, kMargin_px / 2, -kMargin_px, -kMargin_px / 2);
    const int first_px = QFontMetrics(name).height();
    const QRect upper(row.topLeft(), QSize(row.width(), first_px));
    const QRect lower(upper.bottomLeft() + QPoint(0, 1 + kLineGap_px),
                      QSize(row.width(), QFontMetrics(small).height()));
    const QColor ink = selected ? m_theme.planText : m_theme.text;
    const QColor muted = selected ? ink : m_theme.mutedText;

    painter->save();
    painter->fillRect(given.rect, selected ? m_theme.plan : m_theme.chart);
    const auto text = [&](const QRect& where, Qt::Alignment side, const QFont& font,
                          const QColor& colour, int role) {
        painter->setFont(font);
        painter->setPen(colour);
        painter->drawText(where, static_cast<int>(side | Qt::AlignVCenter),
                          index.data(role).toString());
    };
    text(upper, Qt::AlignLeft, name, ink, Qt::DisplayRole);
    text(lower, Qt::AlignLeft, small, muted, SentenceRole);
    const bool present = index.data(PresentRole).toBool();
    text(upper, Qt::AlignRight, m_theme.body(), present ? ink : muted, FigureRole);
    text(lower, Qt::AlignRight, small, muted, RemarkRole);
    if (const QString pill = index.data(LowestRole).toString(); !pill.isEmpty()) {
        painter->setRenderHint(QPainter::Antialiasing);
        const QString title = index.data(Qt::DisplayRole).toString();
        painter->setPen(muted);
        paintPill(*painter, pill, upper,
                  upper.left() + QFontMetrics(name).horizontalAdvance(title) + kMargin_px);
    }
    painter->restore();
}

/** In words in a rounded box of the pen's colour. */
void PolicyDelegate::paintPill(QPainter& painter, const QString& text, const QRect& row,
                               int from_px) const
{
    const QFontMetrics metrics(m_theme.small());
    const QRectF box(from_px + 0.5, row.top() + 0.5,
                     metrics.horizontalAdvance(text) + 2 * kPillMargin_px, row.height() - 1);
    painter.setFont(m_theme.small());
    painter.setBrush(Qt::NoBrush);
    painter.drawRoundedRect(box, box.height() / 2, box.height() / 2);
    painter.drawText(box, Qt::AlignCenter, text);
}

QSize PolicyDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const
{
    const int height_px = QFontMetrics(boldOf(m_theme.body())).height() + kLineGap_px +
                          QFontMetrics(m_theme.small()).height() + kMargin_px;
    return {QStyledItemDelegate::sizeHint(option, index).width(), height_px};
}

int PolicyDelegate::widthFor(const QAbstractItemModel& offers) const
{
    const QFontMetrics name(boldOf(m_theme.body()));
    const QFontMetrics small(m_theme.small());
    int left_px = 0;
    int right_px = 0;
    for (int row = 0; row < offers.rowCount(); ++row) {
        const QModelIndex index = offers.index(row, 0);
        const auto width = [&](const QFontMetrics& metrics, int role) {
            return metrics.horizontalAdvance(index.data(role).toString());
        };
        const int pill_px = width(small, LowestRole) + 2 * kPillMargin_px + kMargin_px;
        left_px =
            std::max({left_px, width(name, Qt::DisplayRole) + pill_px, width(small, SentenceRole)});
        right_px = std::max(
            {right_px, width(QFontMetrics(m_theme.body()), FigureRole), width(small, RemarkRole)});
    }
    return left_px + kColumnGap_px + right_px + 2 * kMargin_px;
}

PolicyCombo::PolicyCombo(QWidget* parent) : QComboBox(parent), m_delegate(new PolicyDelegate(this))
{
    setItemDelegate(m_delegate);
    for (const PolicyKind policy : offeredPolicies()) {
        addItem(policyName(policy), static_cast<int>(policy));
        setItemData(count() - 1, policySentence(policy), PolicyDelegate::SentenceRole);
    }
    connect(this, &QComboBox::currentIndexChanged, this, &PolicyCombo::updateOffers);
    updateOffers();
}

void PolicyCombo::setTheme(const Theme& theme)
{
    m_delegate->setTheme(theme);
    view()->viewport()->update();
}

PolicyKind PolicyCombo::shownPolicy() const
{
    return static_cast<PolicyKind>(currentData().toInt());
}

void PolicyCombo::showPolicy(PolicyKind policy)
{
    setCurrentIndex(findData(static_cast<int>(policy)));
}

void PolicyCombo::showForecasts(const PolicyForecastList& forecasts)
{
    if (forecasts == m_forecasts)
        return;
    m_forecasts = forecasts;
    m_isDrawn = std::ranges::all_of(m_forecasts, [](const auto& entry) {
        const PolicyForecast& forecast = entry.second;
        return forecast.state == ForecastState::Known
                   ? forecast.drawsNoMore || forecast.isFlown()
                   : forecast.state != ForecastState::Waiting &&
                         forecast.state != ForecastState::Computing;
    });
    updateOffers();
}

void PolicyCombo::setInFlight(bool inFlight)
{
    m_inFlight = inFlight;
    updateOffers();
}

const PolicyForecast* PolicyCombo::forecastOf(PolicyKind policy) const
{
    const auto found = m_forecasts.find(policy);
    return found == m_forecasts.end() ? nullptr : &found->second;
}

std::optional<double> PolicyCombo::zetaOf(PolicyKind policy) const
{
    const PolicyForecast* const forecast = forecastOf(policy);
    if (forecast == nullptr || forecast->state != ForecastState::Known)
        return std::nullopt;
    return hasMean(policy) ? summarise(forecast->drawn_m2s).mean : forecast->metrics.zeta_m2s;
}

/** Its zeta is the mean of flights in drawn worlds; in flight, when it is no longer weighed against
 * the others, as at the end of the flight. */
bool PolicyCombo::hasMean(PolicyKind policy) const
{
    const PolicyForecast* const forecast = forecastOf(policy);
    return (m_isDrawn || m_inFlight) && forecast != nullptr &&
           forecast->state == ForecastState::Known && forecast->isFlown();
}

/** Predicted, but too slow for the drawn worlds that others were flown in. */
std::vector<PolicyKind> PolicyCombo::leftOut() const
{
    std::vector<PolicyKind> policies;
    if (!m_isDrawn)
        return policies;
    for (const auto& [policy, forecast] : m_forecasts)
        if (forecast.state == ForecastState::Known && !forecast.isFlown())
            policies.push_back(policy);
    return policies;
}

/** Of zeta with the policy against that with the one chosen, both found in the same way. */
std::optional<double> PolicyCombo::changeTo(PolicyKind policy) const
{
    const std::optional<double> zeta_m2s = zetaOf(policy);
    const std::optional<double> chosen_m2s = zetaOf(shownPolicy());
    if (!zeta_m2s || !chosen_m2s)
        return std::nullopt;
    const bool isOfMeans = hasMean(policy) && hasMean(shownPolicy());
    const double to_m2s = isOfMeans ? *zeta_m2s : forecastOf(policy)->metrics.zeta_m2s;
    const double from_m2s = isOfMeans ? *chosen_m2s : forecastOf(shownPolicy())->metrics.zeta_m2s;
    return from_m2s > 0 ? std::optional(to_m2s / from_m2s - 1) : std::nullopt;
}

/** "65 120 to 80 330": of 20 flights all but the one or two at each end. Empty: not known. */
QString PolicyCombo::spreadOf(PolicyKind policy) const
{
    if (!hasMean(policy))
        return {};
    const ZetaRange range = forecastOf(policy)->range().value();
    return tr("%1 to %2")
        .arg(significantText(range.least_m2s, 4, locale()),
             significantText(range.most_m2s, 4, locale()));
}

/** Of those that are known; none while some are still to come or cannot be set beside the others.
 */
std::optional<PolicyKind> PolicyCombo::lowest() const
{
    std::optional<PolicyKind> best;
    const bool isAnyFlown = std::ranges::any_of(
        m_forecasts, [this](const auto& entry) { return hasMean(entry.first); });
    if (isAnyFlown && !leftOut().empty())
        return best;
    for (const auto& [policy, forecast] : m_forecasts) {
        if (forecast.state == ForecastState::Waiting || forecast.state == ForecastState::Computing)
            return std::nullopt;
        if (const auto zeta_m2s = zetaOf(policy); zeta_m2s && (!best || *zeta_m2s < *zetaOf(*best)))
            best = policy;
    }
    return best;
}

QString PolicyCombo::figureOf(PolicyKind policy) const
{
    const PolicyForecast* const forecast = forecastOf(policy);
    if (forecast == nullptr)
        return {};
    switch (forecast->state) {
    case ForecastState::Waiting:
        return u"…"_s;
    case ForecastState::Computing:
        return forecast->share > 0 ? tr("%1 %…").arg(fixedText(100 * forecast->share, 0, locale()))
                                   : u"…"_s;
    case ForecastState::Known:
        return u"ζ "_s + zetaText(*zetaOf(policy), locale());
    case ForecastState::TooLong:
    case ForecastState::Impossible:
        return noFigure();
    }
    return {};
}

QString PolicyCombo::remarkOf(PolicyKind policy) const
{
    const PolicyForecast* const forecast = forecastOf(policy);
    if (forecast != nullptr && forecast->state == ForecastState::TooLong)
        return tr("takes too long");
    QStringList parts;
    if (const QString spread = spreadOf(policy); !spread.isEmpty())
        parts << spread;
    else if (std::ranges::count(leftOut(), policy) > 0)
        parts << tr("too slow for %1 flights").arg(kDrawnFlights);
    if (policy == shownPolicy())
        parts << tr("chosen");
    else if (const std::optional<double> change = changeTo(policy))
        parts << changeText(*change, locale());
    return parts.join(u" · "_s);
}

QString PolicyCombo::toolTipOf(PolicyKind policy) const
{
    QString text = policySentence(policy);
    const PolicyForecast* const forecast = forecastOf(policy);
    if (forecast == nullptr)
        return text;
    if (forecast->state == ForecastState::TooLong)
        return text + u"\n\n"_s +
               tr("Not predicted: flying it in advance takes more than %1.")
                   .arg(durationText(PolicyForecasts::kLimit_ms / 1000.0, locale()));
    if (forecast->state == ForecastState::Impossible)
        return forecast->whyNot.isEmpty() ? text : text + u"\n\n"_s + forecast->whyNot;
    return text + u"\n\n"_s + explanation();
}

QString PolicyCombo::explanation()
{
    return tr("ζ is predicted before take-off by flying the mission in advance with the policy, "
              "planned\nagain at each sighting as in flight, with icebergs that drift exactly as "
              "entered. The real\nflight differs by the noise of the drift.") +
           u"\n\n"_s +
           tr("Then each policy is flown %1 times with drift and sightings drawn as the scenario "
              "describes\nthem, in the same %1 worlds: ζ is the mean of these flights, the range "
              "that of 90 % of them,\nand the policy with the lowest mean is recommended.")
               .arg(kDrawnFlights);
}

QString PolicyCombo::summary() const
{
    const PolicyKind policy = shownPolicy();
    const PolicyForecast* const forecast = forecastOf(policy);
    if (forecast == nullptr || forecast->state == ForecastState::Impossible)
        return {};
    if (forecast->state == ForecastState::TooLong)
        return tr("ζ not predicted: takes too long");
    const std::optional<double> zeta_m2s = zetaOf(policy);
    if (!zeta_m2s)
        return m_inFlight ? QString() : tr("Predicting ζ…");
    const QString spread = spreadOf(policy);
    const QString figure = spread.isEmpty()
                               ? zetaText(*zeta_m2s, locale())
                               : u"%1 (%2)"_s.arg(zetaText(*zeta_m2s, locale()), spread);
    if (m_inFlight)
        return tr("Predicted before take-off: ζ %1").arg(figure);
    QString told = (hasMean(policy) ? tr("Mean ζ %1") : tr("Predicted ζ %1")).arg(figure);
    const std::optional<PolicyKind> best = lowest();
    if (!best) {
        QStringList slow;
        for (const PolicyKind left : leftOut())
            slow << policyName(left);
        return slow.isEmpty() ? told
                              : tr("%1; too slow to compare: %2").arg(told, slow.join(u", "_s));
    }
    if (best == policy)
        return tr("%1, the lowest").arg(told);
    return tr("%1, lowest %2").arg(told, changeText(*zetaOf(*best) / *zeta_m2s - 1, locale()));
}

void PolicyCombo::updateOffers()
{
    const std::optional<PolicyKind> best = lowest();
    const QString pill = best && hasMean(*best) ? tr("Recommended") : tr("Lowest");
    for (int row = 0; row < count(); ++row) {
        const auto policy = static_cast<PolicyKind>(itemData(row).toInt());
        const QString figure = figureOf(policy);
        const QString remark = remarkOf(policy);
        setItemData(row, figure, PolicyDelegate::FigureRole);
        setItemData(row, remark, PolicyDelegate::RemarkRole);
        setItemData(row, best == policy ? pill : QString(), PolicyDelegate::LowestRole);
        setItemData(row, !m_inFlight && zetaOf(policy).has_value(), PolicyDelegate::PresentRole);
        setItemData(row, toolTipOf(policy), Qt::ToolTipRole);
        QStringList spoken{itemText(row)};
        for (const QString& part : {figure, remark})
            if (!part.isEmpty())
                spoken << part;
        setItemData(row, spoken.join(u", "_s), Qt::AccessibleTextRole);
    }
}

/** Styles cut what is too long without a sign of it. */
void PolicyCombo::initStyleOption(QStyleOptionComboBox* option) const
{
    constexpr int kMargins_px = 2; // of the text in the room for it
    QComboBox::initStyleOption(option);
    const QRect room =
        style()->subControlRect(QStyle::CC_ComboBox, option, QStyle::SC_ComboBoxEditField, this);
    option->currentText =
        fontMetrics().elidedText(option->currentText, Qt::ElideRight, room.width() - kMargins_px);
}

/** Wider than the panel when the texts are: Qt keeps the list on the screen. */
void PolicyCombo::showPopup()
{
    view()->setMinimumWidth(m_delegate->widthFor(*model()));
    QComboBox::showPopup();
}

} // namespace berg
