#pragma once

#include "widgets/model/mission_runner.h"
#include "widgets/theme/theme.h"

#include <QWidget>

class QComboBox;
class QToolButton;

namespace berg {

class FigureLabel;
class RunProgress;

/** Take-off, pause, step, back to the start, rate, and how far the run has come. */
class PlaybackBar : public QWidget
{
    Q_OBJECT

public:
    explicit PlaybackBar(QWidget* parent = nullptr);

    void setTheme(const Theme& theme);
    void showState(RunPhase phase, double time_s, double duration_s);

    /** Simulated seconds a second; 0: as fast as possible. */
    [[nodiscard]] double rate() const;
    /** The rate on offer nearest to this one. Emits nothing. */
    void setRate(double rate);

signals:
    void playRequested();
    void pauseRequested();
    void stepRequested();
    void resetRequested();
    void rateEdited(double rate);

private:
    [[nodiscard]] QToolButton* addButton(const QString& name, const QString& text);
    void addRates();
    void updateButtons();

    Theme m_theme = Theme::light();
    RunPhase m_phase = RunPhase::Planning;
    QToolButton* m_play; ///< or pause
    QToolButton* m_step;
    QToolButton* m_reset;
    QComboBox* m_rate;
    RunProgress* m_progress;
    FigureLabel* m_time;
};

} // namespace berg
