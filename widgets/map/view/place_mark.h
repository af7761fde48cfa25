#pragma once

#include "widgets/map/view/map_view.h"

#include <QTimer>

namespace berg {

/** Marks a place of a map for some seconds, also while the map moves. GUI thread. */
class PlaceMark : public QWidget
{
    Q_OBJECT

public:
    explicit PlaceMark(MapView& map);

    void setTheme(const Theme& theme);
    /** Shows the mark at metres east and north of the map's origin; `name` may be empty. */
    void showAt(const Point& position_m, const QString& name);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void follow();

    MapView& m_map;
    Theme m_theme = Theme::light();
    Point m_position_m = Point::Zero();
    QString m_name;
    QTimer m_timer;
};

} // namespace berg
