#pragma once

#include "widgets/theme/theme.h"

#include <QWidget>

#include <optional>

class QLabel;
class QPushButton;

namespace berg {

/**
 * Says on top of the map why the scenario is locked, in flight or while one looks back, with the
 * one click that ends it. Keeps itself in the middle of its parent's lower edge,
 * between legend and scale.
 */
class FlightBanner : public QWidget
{
    Q_OBJECT

public:
    explicit FlightBanner(QWidget* parent);

    void setTheme(const Theme& theme);
    /** `lookBack_s`: the instant looked back at; none: the newest is shown. */
    void showState(bool inFlight, std::optional<double> lookBack_s);

signals:
    void stopRequested();
    /** Give up what came after the instant shown and fly on from it. */
    void flyOnRequested();
    void newestRequested();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    QPushButton* addButton(const QString& name, const QString& text, const QString& toolTip);
    void place();

    Theme m_theme = Theme::light();
    bool m_looksBack = false;
    QLabel* m_icon;
    QLabel* m_text;
    QPushButton* m_stop;
    QPushButton* m_flyOn;
    QPushButton* m_newest;
};

} // namespace berg
