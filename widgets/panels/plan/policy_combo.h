#pragma once

#include "widgets/model/policy_forecasts.h"
#include "widgets/theme/theme.h"

#include <QComboBox>
#include <QStyledItemDelegate>

namespace berg {

/** Draws an offer of `PolicyCombo` in its list: name, sentence and what it is predicted to give. */
class PolicyDelegate : public QStyledItemDelegate
{
    Q_OBJECT

public:
    enum Role
    {
        SentenceRole = Qt::UserRole + 1,
        FigureRole,      ///< right of the name
        RemarkRole,      ///< below the figure
        RecommendedRole, ///< "Recommended" of the one that is
        PresentRole,     ///< bool: the figure is of the flight to come
    };

    using QStyledItemDelegate::QStyledItemDelegate;

    void setTheme(const Theme& theme) { m_theme = theme; }
    void paint(QPainter* painter, const QStyleOptionViewItem& given,
               const QModelIndex& index) const override;
    [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem& option,
                                 const QModelIndex& index) const override;
    /** Of the list, so that no text of these offers is cut. */
    [[nodiscard]] int widthFor(const QAbstractItemModel& offers) const;

private:
    void paintPill(QPainter& painter, const QString& text, const QRect& row, int from_px) const;

    Theme m_theme = Theme::light();
};

/**
 * The choice of the policy: each is offered with what it does and the zeta that it is predicted to
 * come to, set against the one that is chosen. A line of that is `summary`. Shows what it is given.
 */
class PolicyCombo : public QComboBox
{
    Q_OBJECT

public:
    explicit PolicyCombo(QWidget* parent = nullptr);

    void setTheme(const Theme& theme);
    void showPolicy(PolicyKind policy);
    void showForecasts(const PolicyForecastList& forecasts);
    /** In flight the forecasts are of the time before take-off. */
    void setInFlight(bool inFlight);

    /** Of the policy shown, e.g. "Predicted ζ 72 410 m² s (65 120 to 80 330); recommended: Least
     * waiting time". */
    [[nodiscard]] QString summary() const;
    /** What the forecasts are. */
    [[nodiscard]] static QString explanation();

    void showPopup() override;

protected:
    void initStyleOption(QStyleOptionComboBox* option) const override;

private:
    [[nodiscard]] PolicyKind shownPolicy() const;
    [[nodiscard]] const PolicyForecast* forecastOf(PolicyKind policy) const;
    [[nodiscard]] std::optional<ZetaPrediction> predictionOf(PolicyKind policy) const;
    [[nodiscard]] bool isComplete() const;
    [[nodiscard]] std::vector<PolicyKind> tooSlow() const;
    [[nodiscard]] std::optional<double> changeTo(PolicyKind policy) const;
    [[nodiscard]] QString spreadOf(PolicyKind policy) const;
    [[nodiscard]] std::optional<PolicyKind> recommended() const;
    [[nodiscard]] QString figureOf(PolicyKind policy) const;
    [[nodiscard]] QString remarkOf(PolicyKind policy) const;
    [[nodiscard]] QString toolTipOf(PolicyKind policy) const;
    [[nodiscard]] QString waitingText(const PolicyForecast& forecast) const;
    void updateOffers();

    PolicyDelegate* m_delegate;
    PolicyForecastList m_forecasts;
    bool m_inFlight = false;
};

} // namespace berg
