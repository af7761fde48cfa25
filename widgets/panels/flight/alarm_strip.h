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
 * Above the map: what the user must know now, the worst first, each in a line of its rank's colour
 * that brings what it is about onto the map; below that what is shown of the flight, or why nothing
 * can be planned. An alarm that was acknowledged comes back when it was over and happens again.
 * There is always a line, so that neither take-off nor the first alarm moves the map.
 */
class AlarmStrip : public QWidget
{
    Q_OBJECT

public:
    explicit AlarmStrip(QWidget* parent = nullptr);

    void setTheme(const Theme& theme);
    /** Writes the instants of the run from now on. */
    void setClock(const MissionClock& clock);
    /** Of the first line, which is always there. */
    [[nodiscard]] int lineHeight() const;
    /**
     * `lookBack_s`: the instant looked back at; none: the newest is shown. `fault`: why nothing
     * can be planned; empty: nothing stands in the way.
     */
    void showState(bool inFlight, std::optional<double> lookBack_s, const QString& fault = {});
    void showNotices(const std::vector<FlightNotice>& notices);
    /** What was told and acknowledged there is here as well. */
    void takeOver(const AlarmStrip& other);
    /** Says so, with a button that brings the flight back; empty: nothing was given up. */
    void showGivenUp(const QString& text);

signals:
    /** Ids of what a notice is about. */
    void noticeChosen(const std::vector<std::string>& about);
    /** An alarm or warning of the present that was not there before. */
    void raised(const QString& text);
    /** Whether an alarm of the present is not acknowledged. */
    void alarmPending(bool isPending);
    void bringBackRequested();
    /** Give up what came after the instant shown and fly on from it. */
    void flyOnRequested();
    void newestRequested();
    void checksRequested();

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    /** One of the lines for notices; each is there from the beginning. */
    struct NoticeLine
    {
        QWidget* line;
        QWidget* edge; ///< in the full colour of the rank
        QToolButton* text;
        QLabel* more; ///< so many are not shown, below the last
        QPushButton* acknowledge;
    };
    void addNoticeLine();
    void addStateLine();
    void addGivenUpLine();
    void forgetWhatIsOver();
    void tellNews();
    void fillNotices();
    void fill(const NoticeLine& line, const FlightNotice& notice);
    void fillState();
    void acknowledge(std::size_t line);
    void showOrHide();

    Theme m_theme = Theme::light();
    std::vector<FlightNotice> m_notices; ///< all
    std::vector<FlightNotice> m_told;    ///< those of the newest instant shown
    std::vector<FlightNotice> m_open;    ///< of those what is not acknowledged, the worst first
    std::map<NoticeKind, std::set<std::string>> m_acknowledged; ///< ids of what those are about
    QTimer m_pause; ///< after an acknowledgement: a double click is not meant for the next alarm
    bool m_isInFlight = false;
    MissionClock m_clock;
    std::optional<double> m_lookBack_s;
    QString m_fault;
    QBoxLayout* m_column = nullptr;
    std::vector<NoticeLine> m_lines;
    QWidget* m_state = nullptr;
    QLabel* m_icon = nullptr;
    QLabel* m_text = nullptr;
    QPushButton* m_flyOn = nullptr;
    QPushButton* m_newest = nullptr;
    QPushButton* m_checks = nullptr;
    QWidget* m_givenUp = nullptr;
    QLabel* m_givenUpText = nullptr;
};

} // namespace berg
