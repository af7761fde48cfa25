#pragma once

#include "widgets/forecast/policy_forecasts.h"
#include "widgets/theme/theme.h"

#include <QComboBox>
#include <QStyledItemDelegate>

namespace berg {

/** Draws an entry of `PolicyCombo`: name, sentence and prediction. */
class PolicyDelegate : public QStyledItemDelegate
{
    Q_OBJECT

public:
    enum Role
    {
        SentenceRole = Qt::UserRole + 1,
        FigureRole,      ///< right of the name
        RemarkRole,      ///< below the figure
        RecommendedRole, ///< "Recommended" for the recommended policy
        PresentRole,     ///< bool: the figure is of the present policy
    };

    using QStyledItemDelegate::QStyledItemDelegate;

    void setTheme(const Theme& theme) { m_theme = theme; }
    void paint(QPainter* painter, const QStyleOptionViewItem& given,
               const QModelIndex& index) const override;
    [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem& option,
                                 const QModelIndex& index) const override;
    /** Returns a width of the list in which no text of these entries is cut. */
    [[nodiscard]] int widthFor(const QAbstractItemModel& offers) const;

private:
    void paintPill(QPainter& painter, const QString& text, const QRect& row, int from_px) const;

    Theme m_theme = Theme::light();
};

/**
 * Choice of the policy. Each entry has a description and its predicted zeta compared with that of
 * the chosen policy; `summary` is one line of it. Shows what it is given.
 */
class PolicyCombo : public QComboBox
{
    Q_OBJECT

public:
    explicit PolicyCombo(QWidget* parent = nullptr);

    void setTheme(const Theme& theme);
    void showPolicy(PolicyKind policy);
    void showForecasts(const PolicyForecastList& forecasts);
    /** Marks the forecasts as made before take-off. */
    void setInFlight(bool inFlight);

    /**
     * Returns the forecast of the policy shown, e.g. "Predicted ζ 72 410 m² s (65 120 to 80 330);
     * recommended: Least waiting time".
     */
    [[nodiscard]] QString summary() const;
    /** Returns an explanation of the forecasts. */
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
