#pragma once

#include "widgets/model/study_runner.h"
#include "widgets/theme/theme.h"

#include <QWidget>

class QBoxLayout;
class QPushButton;

namespace berg {

class StudyResults;
class StudyRunBar;
class StudySetup;

/**
 * zeta against tau and policy over many flights: what to fly, the figures of the paper at one
 * click, start, cancel and carry on, results that grow meanwhile, and the way from a point to its
 * flights. Shows and steers a runner that it borrows.
 */
class StudyPanel : public QWidget
{
    Q_OBJECT

public:
    explicit StudyPanel(StudyRunner& runner, QWidget* parent = nullptr);

    void setTheme(const Theme& theme);
    /** What the window works on. */
    void setScenario(const Scenario& scenario);
    /** What became of a file, where one looks for it. */
    void showNote(const QString& text);
    [[nodiscard]] const StudyResults& results() const { return *m_results; }
    /** Flies it in place of the study there is; with `compares`, Figure 5 follows. */
    void start(const StudySpec& spec, bool compares);
    /** The fields, and what is awaited, as in another one. */
    void showAs(const StudyPanel& other);

    [[nodiscard]] QSize sizeHint() const override;

signals:
    /** This is wanted in place of the study there is, which may be unsaved: `start` follows. */
    void startRequested(const berg::StudySpec& spec, bool compares);
    /** The solution times of Figure 3 are wanted. */
    void solveTimesRequested();
    /** Figure 5: both flights of this scenario, one beside the other. */
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
    bool m_comparesThen = false; ///< Figure 5 waits for Figure 4, which is being flown
};

} // namespace berg
