#pragma once

#include "widgets/model/mission_runner.h"
#include "widgets/theme/mission_clock.h"
#include "widgets/theme/theme.h"

#include <QWidget>

class QComboBox;
class QLineEdit;
class QToolButton;

namespace berg {

class FigureLabel;
class RunTimeLine;

/** Take-off, pause, step, back to the start, rate, and the time line of the run. */
class PlaybackBar : public QWidget
{
    Q_OBJECT

public:
    explicit PlaybackBar(QWidget* parent = nullptr);

    void setTheme(const Theme& theme);
    /** Writes and reads the instants of the run from now on. */
    void setClock(const MissionClock& clock);
    /** `time_s` is shown; `newest_s` was flown, none: the same. */
    void showState(RunPhase phase, double time_s, double duration_s,
                   std::optional<double> newest_s = {});
    [[nodiscard]] RunTimeLine& timeLine() const { return *m_timeLine; }

    /** Simulated seconds a second; 0: as fast as possible. */
    [[nodiscard]] double rate() const;
    /** The rate on offer nearest to this one. Emits nothing. */
    void setRate(double rate);
    /** The next rate on offer, `steps` of them on. Emits `rateEdited`. */
    void stepRate(int steps);
    /** Puts the cursor into the time, to be typed. */
    void editTime();

signals:
    void playRequested();
    void pauseRequested();
    void stepRequested();
    void resetRequested();
    void rateEdited(double rate);
    /** The user wants to see this instant of what was flown. */
    void timeEdited(double time_s);

protected:
    void keyPressEvent(QKeyEvent* event) override;

private:
    [[nodiscard]] QToolButton* addButton(const QString& name, const QString& text);
    void addLock();
    void addRates();
    void updateButtons();
    void finishTime();
    void showTexts();

    Theme m_theme = Theme::light();
    RunPhase m_phase = RunPhase::Planning;
    QToolButton* m_play = nullptr; ///< or pause
    QToolButton* m_step = nullptr;
    QToolButton* m_reset = nullptr;
    QToolButton* m_lock = nullptr; ///< there while the scenario is locked
    QComboBox* m_rate = nullptr;
    RunTimeLine* m_timeLine = nullptr;
    QLineEdit* m_time = nullptr;     ///< shown, can be typed
    FigureLabel* m_length = nullptr; ///< of the run
    MissionClock m_clock;
    double m_time_s = 0; ///< shown
    double m_duration_s = 0;
};

} // namespace berg
