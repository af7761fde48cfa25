#pragma once

#include "core/study/study.h"
#include "widgets/theme/theme.h"

#include <QWidget>

#include <optional>
#include <vector>

class QBoxLayout;
class QCheckBox;
class QComboBox;
class QLayout;
class QRadioButton;

namespace berg {

class NumberField;

/** Form of a study: scenarios, runs, values of tau and policies. */
class StudySetup : public QWidget
{
    Q_OBJECT

public:
    explicit StudySetup(QWidget* parent = nullptr);

    void setTheme(const Theme& theme);
    /** Sets the window's scenario. */
    void setScenario(const Scenario& scenario);
    [[nodiscard]] const Scenario& scenario() const { return m_scenario; }

    /** Returns the study of the fields. */
    [[nodiscard]] StudySpec spec() const;
    /** Fills in the fields; the study's own scenarios are replaced by the window's. */
    void showSpec(const StudySpec& spec);
    /** Returns why `spec` cannot be flown, in the user's words; empty if it can. */
    [[nodiscard]] QString fault() const;
    /** Accepts typed text. */
    void finishTyping();

signals:
    /** Emitted when `spec` may have changed. */
    void edited();

private:
    struct NumberSpec
    {
        const char* name;
        QString label;
        double low;
        double high;
        double value;
        int decimals;
        QString toolTip;
    };
    NumberField* addNumber(QBoxLayout& row, const NumberSpec& spec);
    void addScenarios();
    [[nodiscard]] QLayout* addRegime();
    void addTau();
    void addPolicies();
    void updateEnabled();
    [[nodiscard]] std::vector<double> taus() const;

    Scenario m_scenario;
    QRadioButton* m_this = nullptr;
    QRadioButton* m_random = nullptr;
    NumberField* m_count = nullptr;
    NumberField* m_seed = nullptr;
    NumberField* m_icebergs = nullptr;
    QComboBox* m_regime = nullptr;
    NumberField* m_runs = nullptr;
    NumberField* m_from = nullptr;
    NumberField* m_to = nullptr;
    NumberField* m_step = nullptr;
    /** Values of tau that the fields cannot express, until they are edited. */
    std::vector<double> m_listed;
    std::vector<std::pair<PolicyKind, QCheckBox*>> m_policies;
};

/** Returns `low`, `low` + `step` to `high`, as the decimals shown; both ends if they are met. */
[[nodiscard]] std::vector<double> tausBetween(double low, double high, double step);

} // namespace berg
