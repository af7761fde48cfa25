#include "widgets/panels/plan/policy_combo.h"

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
    if (const QString pill = index.data(RecommendedRole).toString(); !pill.isEmpty()) {
        painter->setRenderHint(QPainter::Antialiasing);
        const QString title = index.data(Qt::DisplayRole).toString();
        painter->setPen(muted);
        paintPill(*painter, pill, upper,
                  upper.left() + QFontMetrics(name).horizontalAdvance(title) + kMargin_px);
    }
    painter->restore();
}

/** Paints a text in a rounded box of the pen's colour. */
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
        const int pill_px = width(small, RecommendedRole) + 2 * kPillMargin_px + kMargin_px;
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
    for (const PolicyKind policy : kOfferedPolicies) {
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

std::optional<ZetaPrediction> PolicyCombo::predictionOf(PolicyKind policy) const
{
    const PolicyForecast* const forecast = forecastOf(policy);
    return forecast == nullptr ? std::nullopt : forecast->prediction();
}

bool PolicyCombo::isComplete() const
{
    return std::ranges::none_of(m_forecasts, [](const auto& entry) {
        return entry.second.state == ForecastState::Waiting ||
               entry.second.state == ForecastState::Computing;
    });
}

/** Returns the policies that cannot be compared, once the others are known. */
std::vector<PolicyKind> PolicyCombo::tooSlow() const
{
    std::vector<PolicyKind> policies;
    for (const auto& [policy, forecast] : m_forecasts)
        if (isComplete() && forecast.state == ForecastState::TooLong)
            policies.push_back(policy);
    return policies;
}

/**
 * Returns the relative change of its mean zeta from the chosen policy; nullopt if it is unknown.
 */
std::optional<double> PolicyCombo::changeTo(PolicyKind policy) const
{
    const std::optional<ZetaPrediction> to = predictionOf(policy);
    const std::optional<ZetaPrediction> from = predictionOf(shownPolicy());
    if (!to || !from || from->mean_m2s <= 0)
        return std::nullopt;
    return to->mean_m2s / from->mean_m2s - 1;
}

/**
 * Returns "65 120 to 80 330", the range of 20 flights without the extreme one or two at each end;
 * empty if it is unknown.
 */
QString PolicyCombo::spreadOf(PolicyKind policy) const
{
    const std::optional<ZetaPrediction> prediction = predictionOf(policy);
    if (!prediction || prediction->most_m2s <= 0)
        return {};
    const ShownUnit unit = zetaUnit(prediction->mean_m2s); // the unit of the mean before it
    return tr("%1 to %2")
        .arg(significantText(unit.fromSi(prediction->least_m2s), 4, locale()),
             significantText(unit.fromSi(prediction->most_m2s), 4, locale()));
}

/**
 * Returns the policy with the surely lowest zeta in the same worlds; if several share it, the
 * chosen one. Returns nullopt while forecasts are missing, if one is too slow, or without a clear
 * winner.
 */
std::optional<PolicyKind> PolicyCombo::recommended() const
{
    if (!isComplete() || !tooSlow().empty())
        return std::nullopt;
    std::vector<std::vector<double>> all;
    for (const auto& [policy, forecast] : m_forecasts)
        if (forecast.state == ForecastState::Known)
            all.push_back(forecast.drawn_m2s);
    std::optional<PolicyKind> best;
    for (const auto& [policy, forecast] : m_forecasts)
        if (forecast.state == ForecastState::Known && isSurelyLowest(forecast.drawn_m2s, all) &&
            (!best || policy == shownPolicy()))
            best = policy;
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
        return predictionOf(policy)->mean_m2s > 0
                   ? u"ζ "_s + zetaText(predictionOf(policy)->mean_m2s, locale())
                   : missingValueText();
    case ForecastState::TooLong:
    case ForecastState::Impossible:
        return missingValueText();
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
               tr("Not predicted: flying it %1 times in advance takes more than %2.")
                   .arg(kDrawnFlights)
                   .arg(durationText(PolicyForecasts::kLimit_ms / 1000.0, locale()));
    if (forecast->state == ForecastState::Impossible)
        return forecast->unsupportedReason.isEmpty()
                   ? text
                   : text + u"\n\n"_s + forecast->unsupportedReason;
    return text + u"\n\n"_s + explanation();
}

QString PolicyCombo::explanation()
{
    return tr("ζ is predicted before take-off by flying the mission %1 times with each policy, "
              "with "
              "drift\nand sightings drawn as the scenario describes them, in the same %1 worlds: ζ "
              "is "
              "the mean of\nthese flights, the range that of 90 % of them. A policy is recommended "
              "if its ζ is surely lower\nthan that of every other one (95 % interval of the "
              "differences in the same worlds).")
        .arg(kDrawnFlights);
}

/** Returns the text in place of a missing figure. */
QString PolicyCombo::waitingText(const PolicyForecast& forecast) const
{
    if (forecast.state == ForecastState::TooLong)
        return tr("ζ not predicted: takes too long");
    if (m_inFlight || forecast.state == ForecastState::Impossible)
        return {};
    return forecast.share > 0
               ? tr("Predicting ζ: %1 %").arg(fixedText(100 * forecast.share, 0, locale()))
               : tr("Predicting ζ…");
}

QString PolicyCombo::summary() const
{
    const PolicyKind policy = shownPolicy();
    const PolicyForecast* const forecast = forecastOf(policy);
    if (forecast == nullptr)
        return {};
    const std::optional<ZetaPrediction> prediction = forecast->prediction();
    if (!prediction)
        return waitingText(*forecast);
    if (prediction->mean_m2s <= 0)
        return tr("No ζ to predict: there is no iceberg out of view.");
    const QString figure =
        u"%1 (%2)"_s.arg(zetaText(prediction->mean_m2s, locale()), spreadOf(policy));
    if (m_inFlight)
        return tr("Predicted before take-off: ζ %1").arg(figure);
    QString text = tr("Predicted ζ %1").arg(figure);
    if (!isComplete())
        return text;
    if (const std::vector<PolicyKind> slow = tooSlow(); !slow.empty()) {
        QStringList names;
        for (const PolicyKind left : slow)
            names << policyName(left);
        return tr("%1; too slow to compare: %2").arg(text, names.join(u", "_s));
    }
    const std::optional<PolicyKind> best = recommended();
    if (!best)
        return tr("%1; no policy is a clear winner").arg(text);
    if (best == policy)
        return tr("%1; recommended").arg(text);
    return tr("%1; recommended: %2").arg(text, policyName(*best));
}

void PolicyCombo::updateOffers()
{
    const std::optional<PolicyKind> best = recommended();
    for (int row = 0; row < count(); ++row) {
        const auto policy = static_cast<PolicyKind>(itemData(row).toInt());
        const QString figure = figureOf(policy);
        const QString remark = remarkOf(policy);
        setItemData(row, figure, PolicyDelegate::FigureRole);
        setItemData(row, remark, PolicyDelegate::RemarkRole);
        setItemData(row, best == policy ? tr("Recommended") : QString(),
                    PolicyDelegate::RecommendedRole);
        setItemData(row, !m_inFlight && predictionOf(policy).has_value(),
                    PolicyDelegate::PresentRole);
        setItemData(row, toolTipOf(policy), Qt::ToolTipRole);
        QStringList spoken{itemText(row)};
        for (const QString& part : {figure, remark})
            if (!part.isEmpty())
                spoken << part;
        setItemData(row, spoken.join(u", "_s), Qt::AccessibleTextRole);
    }
}

/** Elides long texts, which styles would cut. */
void PolicyCombo::initStyleOption(QStyleOptionComboBox* option) const
{
    constexpr int kMargins_px = 2; // margins of the text in its room
    QComboBox::initStyleOption(option);
    const QRect room =
        style()->subControlRect(QStyle::CC_ComboBox, option, QStyle::SC_ComboBoxEditField, this);
    option->currentText =
        fontMetrics().elidedText(option->currentText, Qt::ElideRight, room.width() - kMargins_px);
}

/** Makes the list wider than the panel for long texts; Qt keeps it on the screen. */
void PolicyCombo::showPopup()
{
    view()->setMinimumWidth(m_delegate->widthFor(*model()));
    QComboBox::showPopup();
}

} // namespace berg
