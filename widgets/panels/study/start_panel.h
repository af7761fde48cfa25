#pragma once

#include "widgets/study/start_runner.h"
#include "widgets/theme/theme.h"

#include <QWidget>

class QLabel;
class QProgressBar;
class QPushButton;

namespace berg {

class NumberField;
class ScenarioDocument;
class StartChart;

/**
 * Compares start times of the scenario: settings, progress and cancel, a chart of zeta and weather,
 * and a button that moves the start. Shows and controls a runner that it borrows.
 */
class StartPanel : public QWidget
{
    Q_OBJECT

public:
    StartPanel(StartRunner& runner, ScenarioDocument& document, QWidget* parent = nullptr);

    void setTheme(const Theme& theme);

private:
    void addRow();
    void compareOrCancel();
    void showProgress(qulonglong done, qulonglong count);
    void showEnd(const QString& failure);
    void showChosen();
    void showState();
    void useChosen();
    [[nodiscard]] StartScanSpec spec() const;
    /** Returns whether the scenario is still the one that was compared. */
    [[nodiscard]] bool isCurrent() const;

    StartRunner& m_runner;
    ScenarioDocument& m_document;
    NumberField* m_span = nullptr;
    NumberField* m_every = nullptr;
    StartChart* m_chart = nullptr;
    QPushButton* m_compare = nullptr;
    QPushButton* m_use = nullptr;
    QProgressBar* m_bar = nullptr;
    QLabel* m_state = nullptr;
    bool m_wasCancelled = false;
    QString m_failure;
};

} // namespace berg
