#pragma once

#include "widgets/flight/mission_runner.h"
#include "widgets/theme/mission_clock.h"
#include "widgets/theme/theme.h"

#include <QWidget>

class QComboBox;
class QLineEdit;
class QToolButton;

namespace berg {

class FigureLabel;
class RunTimeLine;

/** Controls of the flight: take-off, pause, step, stop, rate, and the time line of the run. */
class PlaybackBar : public QWidget
{
    Q_OBJECT

public:
    explicit PlaybackBar(QWidget* parent = nullptr);

    void setTheme(const Theme& theme);
    /** Sets the clock that formats and reads instants of the run. */
    void setClock(const MissionClock& clock);
    /** Shows the instant `time_s` of a flight flown up to `newest_s`, by default the same. */
    void showState(RunPhase phase, double time_s, double duration_s,
                   std::optional<double> newest_s = {});
    [[nodiscard]] RunTimeLine& timeLine() const { return *m_timeLine; }

    [[nodiscard]] FlightRate rate() const;
    /** Selects the offered rate nearest to this one. Emits nothing. */
    void setRate(FlightRate rate);
    /** Moves by `steps` in the list of rates. Emits `rateEdited`. */
    void stepRate(int steps);
    /** Puts the cursor into the time field. */
    void editTime();

signals:
    void playRequested();
    void pauseRequested();
    void stepRequested();
    void resetRequested();
    void rateEdited(FlightRate rate);
    /** Emitted when the user chooses an instant of the flight. */
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
    QToolButton* m_play = nullptr; ///< take-off or pause
    QToolButton* m_step = nullptr;
    QToolButton* m_reset = nullptr;
    QToolButton* m_lock = nullptr; ///< shown while the scenario is locked
    QComboBox* m_rate = nullptr;
    RunTimeLine* m_timeLine = nullptr;
    QLineEdit* m_time = nullptr;     ///< time shown; can be typed
    FigureLabel* m_length = nullptr; ///< length of the run
    MissionClock m_clock;
    double m_time_s = 0; ///< time shown, s
    double m_duration_s = 0;
};

} // namespace berg
