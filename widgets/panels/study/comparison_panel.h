#pragma once

#include "widgets/study/run_list.h"
#include "widgets/theme/theme.h"

#include <QWidget>

#include <functional>

class QBoxLayout;
class QLabel;
class QProgressBar;
class QPushButton;
class QStackedWidget;
class QTabWidget;
class QToolButton;

namespace berg {

class ComparisonTable;
class NumberField;
class RunTable;

/**
 * List of runs, the two that are compared (A the reference, B the other) and their differences;
 * flies further runs. Made for a narrow dock at the side and a low one at the bottom. Shows and
 * controls a list that it borrows.
 */
class ComparisonPanel : public QWidget
{
    Q_OBJECT

public:
    explicit ComparisonPanel(RunList& list, QWidget* parent = nullptr);

    void setTheme(const Theme& theme);
    /** Sets the window's scenario, which is flown for comparison if no reference has its world. */
    void setScenario(const Scenario& scenario);

    [[nodiscard]] QSize sizeHint() const override;

signals:
    /** Requests the choice of a run file. */
    void openRunRequested();

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void addTables();
    void addActions();
    QWidget* progressOfFlight();
    void showRuns();
    void showFigures();
    void showProgress(double flown_s, double duration_s);
    void showEnd(const QString& failure);
    void updateEnabled();
    void arrange();
    void placeRuns(bool onTab);
    void arrangeActions();
    /** Flies the reference's world, or the window's, with the changed settings. */
    void flyBeside(const std::function<void(PlannerSettings&)>& change);
    [[nodiscard]] bool isOfThisWorld(const RunPointer& run) const;

    RunList& m_list;
    std::optional<Scenario> m_scenario;
    QBoxLayout* m_content = nullptr;
    RunTable* m_runs = nullptr;
    QTabWidget* m_tabs = nullptr;
    ComparisonTable* m_figures = nullptr;
    ComparisonTable* m_unseen = nullptr;
    QLabel* m_state = nullptr; ///< why the last flight failed
    QBoxLayout* m_actions = nullptr;
    QStackedWidget* m_flight = nullptr; ///< the button, or progress during a flight
    QPushButton* m_tour = nullptr;
    QLabel* m_progressText = nullptr;
    QProgressBar* m_bar = nullptr;
    QLabel* m_tauLabel = nullptr;
    NumberField* m_tau = nullptr;
    QPushButton* m_fly = nullptr;
    QToolButton* m_open = nullptr;
    QPushButton* m_remove = nullptr;
};

} // namespace berg
