#include "widgets/print/printed_map.h"

#include "widgets/map/paint/map_painter.h"
#include "widgets/map/picture/route_colours.h"
#include "widgets/print/export_picture.h"
#include "widgets/theme/painter_state.h"

#include <memory>

namespace berg {
namespace {

// Scales of the map, because its fonts and symbols are made for the screen.
constexpr double kMapScale = 0.78;
constexpr double kDenseMapScale = 0.67; // ids get the smallest permitted size
constexpr std::size_t kDense = 24;      // number of icebergs from which the map is dense

constexpr qsizetype kLongestLabel = 28;

/** Data that the map is painted from. */
struct PrintedMap
{
    Theme theme = Theme::light();
    QLocale locale;
    MapPicture picture;
    double scale = kMapScale;
    MapLayout layout; ///< in map pixels, which are smaller than those of the page

    [[nodiscard]] MapStyle style() const { return {.theme = theme, .locale = locale}; }
};

QString labelOf(const QString& name)
{
    return name.size() <= kLongestLabel ? name : name.left(kLongestLabel - 1) + u'…';
}

} // namespace

std::function<void(QPainter&)> printedMap(const ExportContent& content, const QSizeF& size_px,
                                          const QLocale& locale)
{
    auto map = std::make_shared<PrintedMap>();
    map->locale = locale;
    MapPicture& picture = map->picture;
    picture = exportPicture(content);
    for (MapIceberg& iceberg : picture.icebergs)
        iceberg.id = labelOf(iceberg.id);
    for (MapUav& uav : picture.uavs)
        uav.label = labelOf(uav.label);
    if (picture.asset)
        picture.asset->name = labelOf(picture.asset->name);
    picture.air = exportAir(content);
    map->scale = picture.icebergs.size() > kDense ? kDenseMapScale : kMapScale;
    const QRectF frame(QPointF(0, 0), size_px);
    map->layout = arrangeMap(picture, map->style(), QRectF(frame.topLeft(), size_px / map->scale));
    return [map = std::shared_ptr<const PrintedMap>(std::move(map)), frame](QPainter& painter) {
        const PainterState saved(painter);
        painter.setClipRect(frame);
        painter.save();
        painter.scale(map->scale, map->scale);
        paintMap(painter, map->picture, map->style(), map->layout);
        painter.restore();
        painter.setPen(QPen(Qt::black, 0.8));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(frame.adjusted(0.4, 0.4, -0.4, -0.4));
    };
}

QColor printedColour(const ExportContent& content, std::size_t uav)
{
    return routeColours(exportPicture(content), Theme::light(), uav).plan;
}

} // namespace berg
