#pragma once

#include "widgets/forecast/policy_forecasts.h"
#include "widgets/theme/theme.h"
#include "widgets/words/plan_text.h"

#include <QTimer>
#include <QWidget>

class QComboBox;
class QSlider;

namespace berg {

class CaptionLabel;
class NumberField;
class PlanReadoutView;
class PolicyCombo;
class TauStrip;
struct TauCurve;

/**
 * Panel of the trade-off tau, the planning choices and their result. Stores nothing of its own:
 * shows what it is given and emits the user's edits. tau 0 is "most uncertain first", a large tau
 * is "shortest path", Eq. (14); the slider covers 0 to 5, the field 0 to 100.
 */
class TradeoffPanel : public QWidget
{
    Q_OBJECT

public:
    explicit TradeoffPanel(QWidget* parent = nullptr);
    ~TradeoffPanel() override;

    void setTheme(const Theme& theme);

    /** Shows settings and emits nothing. While the user is changing tau, the user's value stays. */
    void showSettings(const PlannerSettings& settings);
    /** In flight only tau and policy can be changed. */
    void setInFlight(bool inFlight);
    /** While looking back nothing can be changed. */
    void setLookingBack(bool looksBack);
    void showPlan(const PlanReadout& readout);
    /** Shows or hides objective and distance weight of the plan. */
    void setDetailsShown(bool isShown);
    /** Shows the forecast of each policy, beside its name and below the chosen one. */
    void showForecasts(const PolicyForecastList& forecasts);
    /** Shows the plans along the trade-off, below the slider. */
    void showCurve(const TauCurve& curve);
    /**
     * Moves to the neighbouring plan: +1 towards shorter paths, −1 towards most uncertain first.
     */
    void stepPlan(int direction);
    /** Limits the height to the contents, so that panels below get the rest. */
    void setHeightLimited(bool isLimited);
    /** Accepts typed text as if Return had been pressed. */
    void finishTyping();
    /** Ends the current change of tau, so that the value in force may be shown. */
    void finishTau();
    /** Sets tau as if by the user. */
    void chooseTau(double tau);

protected:
    bool event(QEvent* event) override;

signals:
    void tauEdited(double tau);
    /**
     * Emitted after the last `tauEdited` of a series: slider released, typing or stepping ended.
     */
    void tauEditFinished();
    void policyEdited(berg::PolicyKind policy);
    void backendEdited(berg::Backend backend);
    void routeEdited(berg::Route route);
    /** Requests to show the findings that prevent planning. */
    void checksRequested();
    void detailsToggled(bool isShown);

private:
    void addTau();
    void addChoices();
    void connectTau();
    void connectChoices();
    void editTau(double tau);
    void showTau();
    void showChoices();
    void updateEnabled();
    void updateForecast();
    [[nodiscard]] static QString lookingBackText();
    void updateHeight();

    NumberField* m_tau = nullptr;
    QSlider* m_slider = nullptr;
    TauStrip* m_strip = nullptr;
    PolicyCombo* m_policy = nullptr;
    CaptionLabel* m_forecast = nullptr;
    QComboBox* m_backend = nullptr;
    QComboBox* m_route = nullptr;
    PlanReadoutView* m_result = nullptr;
    PlannerSettings m_settings; ///< the settings shown
    PlanReadout m_readout;
    bool m_inFlight = false;
    bool m_looksBack = false;
    bool m_isHeightLimited = false;
    bool m_tauEditing = false;
    QTimer m_tauRest; ///< ends a series of keys or wheel turns, which have no end of their own
};

} // namespace berg
