#pragma once

#include "widgets/panels/fields/place_field.h"
#include "widgets/theme/theme.h"

#include <QWidget>

class QLabel;
class QPushButton;

namespace berg {

/**
 * A bar over the map where a place to be shown is typed. A place beyond what the scenario reaches
 * is not gone to; the bar then offers to move the scenario there. Keeps to the middle of the upper
 * edge of its parent. GUI thread.
 */
class GotoBar : public QWidget
{
    Q_OBJECT

public:
    explicit GotoBar(QWidget* parent);

    void setTheme(const Theme& theme);

    /** Shows the bar with an empty line. `origin`: of the scenario, which may move if it is not in
     * flight. */
    void open(const LatLon& origin, bool mayMove);

signals:
    /** `name` is empty for a coordinate. */
    void placeChosen(const berg::LatLon& place, const QString& name);
    /** The scenario is wanted there. */
    void moveRequested(const berg::LatLon& place);
    void closed();

protected:
    void paintEvent(QPaintEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void go();
    void explain(const QString& reason, bool offersMove);
    void dismiss();
    void place();

    PlaceField* m_field = nullptr;
    QLabel* m_reason = nullptr;
    QPushButton* m_move = nullptr;
    Theme m_theme = Theme::light();
    LatLon m_origin;
    bool m_mayMove = true;
    LatLon m_far; ///< what is too far
};

} // namespace berg
