#pragma once

#include "widgets/model/benchmark_runner.h"
#include "widgets/theme/theme.h"

#include <QTimer>
#include <QWidget>

class QCheckBox;
class QLabel;
class QProgressBar;
class QPushButton;

namespace berg {

class NumberField;
class SolveTimeChart;

/**
 * Solution times of this machine beside those of the paper: what to measure, start and cancel, the
 * chart that grows as rows come in. Shows and steers a runner that it borrows.
 */
class SolveTimePanel : public QWidget
{
    Q_OBJECT

public:
    explicit SolveTimePanel(BenchmarkRunner& runner, QWidget* parent = nullptr);

    void setTheme(const Theme& theme);

    /** Fills in the fields; nothing while something is measured. */
    void showSpec(const BenchmarkSpec& spec);
    /** What Start would measure. */
    [[nodiscard]] BenchmarkSpec spec() const;
    /** Measures that; what was measured before is given up. */
    void start();

signals:
    void startRequested();
    /** The table that the runner has is to be saved. */
    void saveRequested();

private:
    void addSettings();
    void addRun();
    void startOrCancel();
    void showProgress(qulonglong done, qulonglong count);
    void showTimeLeft();
    void showRows();
    void showEnd(const QString& failure);
    void updateEnabled();

    BenchmarkRunner& m_runner;
    NumberField* m_largest = nullptr;
    NumberField* m_repeat = nullptr;
    NumberField* m_budget = nullptr;
    std::vector<std::pair<BenchmarkSolver, QCheckBox*>> m_solvers;
    SolveTimeChart* m_chart = nullptr;
    QPushButton* m_start = nullptr;
    QPushButton* m_save = nullptr;
    QProgressBar* m_bar = nullptr;
    QLabel* m_state = nullptr;
    double m_done = 0; ///< share of the instances
    bool m_cancelled = false;
    QTimer m_second; ///< keeps the time left going while a single solve takes long
};

} // namespace berg
