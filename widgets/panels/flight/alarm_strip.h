#pragma once

#include "widgets/panels/flight/flight_notices.h"
#include "widgets/theme/mission_clock.h"
#include "widgets/theme/theme.h"

#include <QTimer>
#include <QWidget>

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

class QBoxLayout;
class QLabel;
class QPushButton;
class QToolButton;

namespace berg {

/**
 * Notices above the map, worst first, each with the colour of its rank; a click shows its subject
 * on the map. Below them is the state of the flight, or why nothing can be planned. An acknowledged
 * alarm returns if it ends and happens again. One line is always shown, so that neither take-off
 * nor the first alarm moves the map.
 */
class AlarmStrip : public QWidget
{
    Q_OBJECT

public:
    explicit AlarmStrip(QWidget* parent = nullptr);

    void setTheme(const Theme& theme);
    /** Sets the clock that formats instants of the run. */
    void setClock(const MissionClock& clock);
    /** Returns the height of the line that is always shown. */
    [[nodiscard]] int lineHeight() const;
    /**
     * `lookBack_s` is the instant looked back at, or nullopt for the newest. `fault` is why nothing
     * can be planned; empty if planning is possible.
     */
    void showState(bool inFlight, std::optional<double> lookBack_s, const QString& fault = {});
    void showNotices(const std::vector<FlightNotice>& notices);
    /** Copies reported and acknowledged notices from another strip. */
    void takeOver(const AlarmStrip& other);
    /**
     * Shows that a flight was discarded, with a button that restores it; an empty text hides the
     * line.
     */
    void showDiscardedFlight(const QString& text);

signals:
    /** Emitted with the ids of a notice's subjects. */
    void noticeChosen(const std::vector<std::string>& about);
    /** Emitted for a new alarm or warning at the newest instant. */
    void raised(const QString& text);
    /** Emitted with whether a present alarm is not acknowledged. */
    void alarmPending(bool isPending);
    void restoreRequested();
    /** Requests to discard the flight after the instant shown and to continue from there. */
    void continueRequested();
    void newestRequested();
    void checksRequested();

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    /** A line for a notice. All lines exist from the beginning. */
    struct NoticeLine
    {
        QWidget* line;
        QWidget* edge; ///< bar in the full colour of the rank
        QToolButton* text;
        QLabel* more; ///< number of hidden notices, below the last line
        QPushButton* acknowledge;
    };
    void addNoticeLine();
    void addStateLine();
    void addDiscardedLine();
    void dropEndedAcknowledgements();
    void reportNewNotices();
    void fillNotices();
    void fill(const NoticeLine& line, const FlightNotice& notice);
    void fillState();
    void acknowledge(std::size_t line);
    void showOrHide();

    Theme m_theme = Theme::light();
    std::vector<FlightNotice> m_notices;  ///< all notices
    std::vector<FlightNotice> m_reported; ///< notices of the newest instant shown
    std::vector<FlightNotice> m_open;     ///< unacknowledged ones of these, worst first
    /** Ids of the subjects of acknowledged notices. */
    std::map<NoticeKind, std::set<std::string>> m_acknowledged;
    /**
     * Runs after an acknowledgement, because a double click must not acknowledge the next alarm.
     */
    QTimer m_pause;
    bool m_isInFlight = false;
    MissionClock m_clock;
    std::optional<double> m_lookBack_s;
    QString m_fault;
    QBoxLayout* m_column = nullptr;
    std::vector<NoticeLine> m_lines;
    QWidget* m_state = nullptr;
    QLabel* m_icon = nullptr;
    QLabel* m_text = nullptr;
    QPushButton* m_continue = nullptr;
    QPushButton* m_newest = nullptr;
    QPushButton* m_checks = nullptr;
    QWidget* m_discarded = nullptr;
    QLabel* m_discardedText = nullptr;
};

} // namespace berg
