#pragma once

#include "widgets/study/benchmark_runner.h"
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
 * Solution times of this machine beside those of the paper: settings, start and stop, and a chart
 * that grows as rows arrive. Shows and controls a runner that it borrows.
 */
class SolveTimePanel : public QWidget
{
    Q_OBJECT

public:
    explicit SolveTimePanel(BenchmarkRunner& runner, QWidget* parent = nullptr);

    void setTheme(const Theme& theme);

    /** Fills in the fields; ignored during a measurement. */
    void showSpec(const BenchmarkSpec& spec);
    /** Returns the benchmark that Start would measure. */
    [[nodiscard]] BenchmarkSpec spec() const;
    /** Starts the measurement and discards the previous one. */
    void start();

signals:
    void startRequested();
    /** Requests to save the runner's table. */
    void saveRequested();

private:
    void addInputs();
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
    double m_done = 0; ///< share of the instances that are done
    bool m_cancelled = false;
    QTimer m_second; ///< updates the remaining time while a single solve takes long
};

} // namespace berg
