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

/** What a study is to fly: scenarios, runs, values of tau and policies, as a form. */
class StudySetup : public QWidget
{
    Q_OBJECT

public:
    explicit StudySetup(QWidget* parent = nullptr);

    void setTheme(const Theme& theme);
    /** What the window works on. */
    void setScenario(const Scenario& scenario);
    [[nodiscard]] const Scenario& scenario() const { return m_scenario; }

    /** As the fields are. */
    [[nodiscard]] StudySpec spec() const;
    /** Fills the fields in; its own scenarios are the one of the window. */
    void showSpec(const StudySpec& spec);
    /** Why `spec` cannot be flown, in the user's words; empty: it can. */
    [[nodiscard]] QString fault() const;
    /** Takes what is being typed. */
    void finishTyping();

signals:
    /** `spec` may be another one. */
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
    std::vector<double>
        m_listed; ///< values of tau that the fields cannot say, until they are edited
    std::vector<std::pair<PolicyKind, QCheckBox*>> m_policies;
};

/** `low`, `low` + `step` .. `high`, as the decimals one reads; both ends when they are met. */
[[nodiscard]] std::vector<double> tausBetween(double low, double high, double step);

} // namespace berg
