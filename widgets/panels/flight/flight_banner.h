#pragma once

#include "widgets/panels/flight/flight_notices.h"
#include "widgets/theme/theme.h"

#include <QWidget>

#include <optional>
#include <vector>

class QBoxLayout;
class QLabel;
class QPushButton;

namespace berg {

/**
 * Says on top of the map why the scenario is locked, in flight or while one looks back, with the
 * one click that ends it, or why nothing can be planned; above that what the user is to know now.
 * Keeps itself in the middle of its parent's lower edge, between legend and scale. A button that
 * comes is never where another one was that has gone: what ends the flight is on the left, what a
 * double click may be meant for on the right.
 */
class FlightBanner : public QWidget
{
    Q_OBJECT

public:
    explicit FlightBanner(QWidget* parent);

    void setTheme(const Theme& theme);
    /**
     * `lookBack_s`: the instant looked back at; none: the newest is shown. `fault`: why nothing
     * can be planned; empty: nothing stands in the way.
     */
    void showState(bool inFlight, std::optional<double> lookBack_s, const QString& fault = {});
    /** Each in a line of its own. */
    void showNotices(const std::vector<FlightNotice>& notices);
    /** Says so, with a button that brings the flight back; empty: nothing was given up. */
    void showGivenUp(const QString& text);

signals:
    void bringBackRequested();
    void stopRequested();
    /** Give up what came after the instant shown and fly on from it. */
    void flyOnRequested();
    void newestRequested();
    void checksRequested();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    struct NoticeLine
    {
        QWidget* line;
        QLabel* icon;
        QLabel* text;
    };
    QPushButton* addButton(QWidget& row, const QString& name, const QString& text,
                           const QString& toolTip);
    void addGivenUpLine();
    void showOrHide();
    NoticeLine addNoticeLine();
    void fillNotices();
    void fitToTexts();
    void place();
    void elideFault();
    void setIcon(IconName name);

    Theme m_theme = Theme::light();
    IconName m_iconName = IconName::Locked;
    QString m_fault; ///< shown
    bool m_hasState = false;
    std::vector<FlightNotice> m_notices;
    std::vector<NoticeLine> m_noticeLines; ///< at least as many
    QBoxLayout* m_column = nullptr;
    QWidget* m_state = nullptr;   ///< the line of the lock or the fault
    QWidget* m_givenUp = nullptr; ///< the line of the flight that was given up
    QLabel* m_givenUpText = nullptr;
    bool m_hasGivenUp = false;
    QLabel* m_icon = nullptr;
    QLabel* m_text = nullptr;
    QPushButton* m_stop = nullptr;
    QPushButton* m_flyOn = nullptr;
    QPushButton* m_newest = nullptr;
    QPushButton* m_checks = nullptr;
};

} // namespace berg
