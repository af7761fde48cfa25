#pragma once

#include "widgets/study/study_runner.h"
#include "widgets/theme/theme.h"

#include <QWidget>

class QBoxLayout;
class QPushButton;

namespace berg {

class StudyResults;
class StudyRunBar;
class StudySetup;

/**
 * zeta against tau and policy over many flights: settings, the figures of the paper at one click,
 * start, stop and continue, results that grow meanwhile, and access to the flights of each point.
 * Shows and controls a runner that it borrows.
 */
class StudyPanel : public QWidget
{
    Q_OBJECT

public:
    explicit StudyPanel(StudyRunner& runner, QWidget* parent = nullptr);

    void setTheme(const Theme& theme);
    /** Sets the window's scenario. */
    void setScenario(const Scenario& scenario);
    /** Shows a note about a file. */
    void showNote(const QString& text);
    [[nodiscard]] const StudyResults& results() const { return *m_results; }
    /** Flies a study in place of the present one; with `compares`, Figure 5 follows. */
    void start(const StudySpec& spec, bool compares);
    /** Copies the fields and a pending Figure 5 from another panel. */
    void showAs(const StudyPanel& other);

    [[nodiscard]] QSize sizeHint() const override;

signals:
    /** Requests to replace the present study, which may be unsaved; `start` follows. */
    void startRequested(const berg::StudySpec& spec, bool compares);
    /** Requests the solution times of Figure 3. */
    void solveTimesRequested();
    /** Requests Figure 5: both flights of this scenario side by side. */
    void comparisonRequested(const berg::Scenario& scenario, const berg::PlannerSettings& best,
                             const berg::PlannerSettings& tsp);

private:
    [[nodiscard]] QWidget* makeSetup();
    void addFigures(QBoxLayout& column);
    void showSpec();
    void requestStart();
    void startFigure5();
    void compareIfWanted(const QString& failure);

    StudyRunner& m_runner;
    QPushButton* m_figure4 = nullptr;
    QPushButton* m_figure5 = nullptr;
    StudySetup* m_setup = nullptr;
    StudyRunBar* m_run = nullptr;
    StudyResults* m_results = nullptr;
    bool m_comparesThen = false; ///< whether Figure 5 follows the Figure 4 that is being flown
};

} // namespace berg
