#pragma once

#include "widgets/model/policy_forecasts.h"
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
 * The trade-off tau, the choices of planning and what came of them. Holds nothing of its own:
 * shows what it is given and tells what the user wants. tau 0 is "most uncertain first", large is
 * "shortest path", Eq. (14); the slider covers 0 to 5, the field all of 0 to 100.
 */
class TradeoffPanel : public QWidget
{
    Q_OBJECT

public:
    explicit TradeoffPanel(QWidget* parent = nullptr);
    ~TradeoffPanel() override;

    void setTheme(const Theme& theme);

    /** Emits nothing. While the user is changing tau, the panel shows the user's. */
    void showSettings(const PlannerSettings& settings);
    /** In flight only tau and policy can be changed. */
    void setInFlight(bool inFlight);
    /** At an instant before the latest nothing can be changed. */
    void setLookingBack(bool looksBack);
    void showPlan(const PlanReadout& readout);
    /** Objective and distance weight of the plan. */
    void setDetailsShown(bool isShown);
    /** What each policy is predicted to come to, beside its name and below the one chosen. */
    void showForecasts(const PolicyForecastList& forecasts);
    /** The plans along the trade-off, below the slider. */
    void showCurve(const TauCurve& curve);
    /** To the neighbouring plan: +1 towards shorter ways, -1 towards most uncertain first. */
    void stepPlan(int direction);
    /** No higher than what is in it: what is below has use for the room. */
    void setHeightLimited(bool isLimited);
    /** Takes what is typed as if Return had been pressed. */
    void finishTyping();
    /** The change of tau that is under way ends: what is in force may be shown. */
    void finishTau();
    /** As if the user had set tau to this. */
    void chooseTau(double tau);

protected:
    bool event(QEvent* event) override;

signals:
    void tauEdited(double tau);
    /** The last `tauEdited` of a row: slider let go, typing or stepping ended. */
    void tauEditFinished();
    void policyEdited(berg::PolicyKind policy);
    void backendEdited(berg::Backend backend);
    void routeEdited(berg::Route route);
    /** What stands in the way of planning is to be shown. */
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
    PlannerSettings m_settings; ///< shown
    PlanReadout m_readout;
    bool m_inFlight = false;
    bool m_looksBack = false;
    bool m_isHeightLimited = false;
    bool m_tauEditing = false;
    QTimer m_tauRest; ///< ends a row of keys or wheel turns, which have no end of their own
};

} // namespace berg
