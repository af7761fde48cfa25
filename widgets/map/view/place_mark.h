#pragma once

#include "widgets/map/view/map_view.h"

#include <QTimer>

namespace berg {

/** Points at a place of a map for some seconds, wherever the map is moved. GUI thread. */
class PlaceMark : public QWidget
{
    Q_OBJECT

public:
    explicit PlaceMark(MapView& map);

    void setTheme(const Theme& theme);
    /** East and north of the map's origin; `name` may be empty. */
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
