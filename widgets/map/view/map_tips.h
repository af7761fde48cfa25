#pragma once

#include <QPointF>
#include <QString>

namespace berg {

class MapScene;

/**
 * Returns the tooltip at a point of the map: of the wind, the date or an iceberg. Empty if there
 * is none.
 */
[[nodiscard]] QString mapToolTip(MapScene& scene, const QPointF& at);

} // namespace berg
