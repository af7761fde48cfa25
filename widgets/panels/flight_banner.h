#pragma once

#include "widgets/theme/icons.h"
#include "widgets/theme/theme.h"

#include <QWidget>

#include <optional>

class QLabel;
class QPushButton;

namespace berg {

/**
 * Says on top of the map why the scenario is locked, in flight or while one looks back, with the
 * one click that ends it, or why nothing can be planned. Keeps itself in the middle of its parent's
 * lower edge, between legend and scale.
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

signals:
    void stopRequested();
    /** Give up what came after the instant shown and fly on from it. */
    void flyOnRequested();
    void newestRequested();
    void checksRequested();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    QPushButton* addButton(const QString& name, const QString& text, const QString& toolTip);
    void place();
    void elideFault();
    void setIcon(IconName icon);

    Theme m_theme = Theme::light();
    IconName m_iconName = IconName::Locked;
    QString m_fault; ///< shown
    QLabel* m_icon;
    QLabel* m_text;
    QPushButton* m_stop;
    QPushButton* m_flyOn;
    QPushButton* m_newest;
    QPushButton* m_checks;
};

} // namespace berg
