#pragma once

#include "core/base/label_column.h"

#include <QPolygonF>
#include <QRectF>

#include <optional>
#include <span>

namespace berg {

/**
 * A place inside `plot` for a label beside its own line, touching no line and no other label; the
 * later in time the better. None when there is no such place.
 */
[[nodiscard]] std::optional<QRectF> labelBesideLine(const QPolygonF& own,
                                                    std::span<const QPolygonF> lines,
                                                    std::span<const QRectF> taken,
                                                    const QSizeF& size, const QRectF& plot);

} // namespace berg
