#include "widgets/map/paint/place_names.h"

#include "core/base/angles.h"
#include "widgets/map/paint/map_paint.h"
#include "widgets/map/paint/map_symbols.h"
#include "widgets/map/picture/map_plane.h"

#include <QFontMetricsF>

#include <algorithm>
#include <array>
#include <cmath>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

/** Largest metres per pixel at which names are shown, by rank. */
constexpr std::array<double, 5> kFarthest_mppx{25'000, 6000, 2500, 900, 300};
/** Smallest metres per pixel at which names of waters and lands are shown, by rank. */
constexpr std::array<double, 5> kNearest_mppx{150, 50, 15, 5, 0};
constexpr double kGap_px = 5;        // between a place's mark and its name
constexpr double kMargin_px = 3;     // free margin around a name
constexpr double kUavRoom_px = 20;   // half the size of its symbol
constexpr double kAssetRoom_px = 34; // no place is shown nearer to it

/** Waters and lands are named at their middle without a mark, other places at a point. */
bool isPoint(PlaceKind kind)
{
    return kind != PlaceKind::Water && kind != PlaceKind::Land;
}

QFont placeFont(const GazetteerPlace& place, const Theme& theme)
{
    constexpr int kWellKnown = 2;
    QFont font = place.rank <= kWellKnown ? labelFont(theme) : theme.small();
    font.setItalic(place.kind == PlaceKind::Water);
    return font;
}

/** Finds free places for names, and whether a place is in sight. */
class NameRoom
{
public:
    NameRoom(const MapLayout& layout, const MapPicture& picture)
        : m_layout(layout), m_plane(picture.origin), m_taken(layout.overlays())
    {
        for (const PlacedLabel& label : layout.labels)
            m_taken.push_back(label.rect);
        m_taken.insert(m_taken.end(), layout.uavLabels.begin(), layout.uavLabels.end());
        for (const MapUav& uav : picture.uavs)
            reserve(uav.position_m, kUavRoom_px);
        if (picture.asset) {
            m_asset_px = layout.view.toPixel(picture.asset->position_m);
            reserve(picture.asset->position_m, kAssetRoom_px);
        }
        const QRectF& rect = layout.rect;
        const Point middle_m = layout.view.toWorld(rect.center());
        m_middle = m_plane.toGeographic(middle_m);
        const double side_px = std::hypot(rect.width(), rect.height());
        m_sight_rad = side_px / 2 / layout.view.scale_pxpm() / kEarthRadius_m;
    }

    /** Returns nullopt if the place is out of sight or too near the asset. */
    [[nodiscard]] std::optional<QPointF> pixelOf(const LatLon& place) const
    {
        constexpr double kRounding = 1.02; // the Earth is not a sphere
        if (arcTo_rad(place) > kRounding * m_sight_rad)
            return std::nullopt;
        const Point position_m = m_plane.toPlane(place);
        const QPointF at = m_layout.view.toPixel(position_m);
        if (position_m.norm() > mapReach_m(m_plane) || !m_layout.rect.contains(at))
            return std::nullopt;
        const bool isAsset = m_asset_px && std::hypot(m_asset_px->x() - at.x(),
                                                      m_asset_px->y() - at.y()) < kAssetRoom_px;
        return isAsset ? std::nullopt : std::optional(at);
    }

    [[nodiscard]] bool isFree(const QRectF& name) const
    {
        const QRectF wide = name.adjusted(-kMargin_px, -kMargin_px, kMargin_px, kMargin_px);
        return m_layout.rect.contains(wide) &&
               std::ranges::none_of(m_taken,
                                    [&](const QRectF& one) { return one.intersects(wide); }) &&
               std::ranges::none_of(m_layout.icebergs, [&](const LabelDisk& iceberg) {
                   return overlaps(name, iceberg);
               });
    }

    void reserve(const QRectF& name) { m_taken.push_back(name); }

private:
    void reserve(const Point& position_m, double half_px)
    {
        const QPointF half(half_px, half_px);
        const QPointF at = m_layout.view.toPixel(position_m);
        m_taken.emplace_back(at - half, at + half);
    }
    /** Arc from the middle of the map, on a sphere. */
    [[nodiscard]] double arcTo_rad(const LatLon& place) const
    {
        const double from = radFromDeg(m_middle.latitude_deg);
        const double to = radFromDeg(place.latitude_deg);
        const double across = radFromDeg(place.longitude_deg - m_middle.longitude_deg);
        return std::acos(std::clamp(std::sin(from) * std::sin(to) +
                                        std::cos(from) * std::cos(to) * std::cos(across),
                                    -1.0, 1.0));
    }

    const MapLayout& m_layout;
    LocalFrame m_plane;
    std::vector<QRectF> m_taken;
    std::optional<QPointF> m_asset_px;
    LatLon m_middle;
    double m_sight_rad = 0;
};

/** First free place beside the mark, or around the middle; null if there is none. */
QRectF freePlace(const NameRoom& room, const QPointF& at, const QSizeF& size_px, bool isBeside)
{
    const double aside_px = kGap_px + size_px.width() / 2;
    const double up_px = size_px.height();
    const std::array<QPointF, 5> offsets =
        isBeside
            ? std::array<QPointF, 5>{QPointF(aside_px, 0), QPointF(-aside_px, 0), QPointF(0, up_px),
                                     QPointF(0, -up_px), QPointF(aside_px, up_px / 2)}
            : std::array<QPointF, 5>{QPointF(0, 0), QPointF(0, up_px), QPointF(0, -up_px),
                                     QPointF(0, 2 * up_px), QPointF(0, -2 * up_px)};
    QRectF rect(QPointF(0, 0), size_px);
    for (const QPointF& offset : offsets) {
        rect.moveCenter(at + offset);
        if (room.isFree(rect))
            return rect;
    }
    return {};
}

void paintMark(QPainter& painter, const QPointF& at, PlaceKind kind, const Theme& theme)
{
    constexpr double kTown_px = 2.4;
    constexpr double kCape_px = 1.5;
    painter.setPen(QPen(theme.sea, 1));
    painter.setBrush(theme.mutedText);
    const double radius_px = kind == PlaceKind::Cape ? kCape_px : kTown_px;
    const QRectF mark(at - QPointF(radius_px, radius_px), at + QPointF(radius_px, radius_px));
    if (kind == PlaceKind::Field)
        painter.drawRect(mark);
    else
        painter.drawEllipse(mark);
}

} // namespace

std::vector<MapPlaceName> placeNamesOn(const MapLayout& layout, const MapPicture& picture,
                                       const Theme& theme)
{
    std::vector<MapPlaceName> names;
    NameRoom room(layout, picture);
    for (const GazetteerPlace& place : gazetteer()) {
        const std::size_t rank = static_cast<std::size_t>(place.rank) - 1;
        if (kFarthest_mppx.at(rank) * layout.view.scale_pxpm() < 1)
            break; // the rest are less well known
        const bool isTooNear =
            !isPoint(place.kind) && kNearest_mppx.at(rank) * layout.view.scale_pxpm() > 1;
        const std::optional<QPointF> at = room.pixelOf(place.at);
        if (!at || isTooNear)
            continue;
        const QFontMetricsF metrics(placeFont(place, theme));
        const QSizeF size_px(std::ceil(metrics.horizontalAdvance(placeName(place))) + 2,
                             std::ceil(metrics.height()));
        const QRectF rect = freePlace(room, *at, size_px, isPoint(place.kind));
        if (rect.isNull())
            continue;
        room.reserve(rect);
        names.push_back({.place = &place, .at_px = *at, .rect = rect});
    }
    return names;
}

void paintPlaceNames(const MapPaint& p)
{
    constexpr double kHalo_px = 3;
    for (const MapPlaceName& name : p.layout.places) {
        const GazetteerPlace& place = *name.place;
        if (isPoint(place.kind))
            paintMark(p.painter, name.at_px, place.kind, p.theme);
        const QString text = placeName(place);
        const bool isOnLand = place.kind == PlaceKind::Land || place.kind == PlaceKind::Town;
        const QSizeF size_px = name.rect.size();
        paintCached(
            p, u"place %1 "_s.arg(static_cast<int>(place.kind)) + text,
            QRectF(QPointF(-kHalo_px, -kHalo_px), size_px + QSizeF(2 * kHalo_px, 2 * kHalo_px)),
            name.rect.topLeft(), [&](QPainter& painter) {
                painter.setFont(placeFont(place, p.theme));
                drawHaloText(painter, QRectF(QPointF(0, 0), size_px), Qt::AlignCenter, text,
                             place.kind == PlaceKind::Water ? p.theme.graticuleText
                                                            : p.theme.mutedText,
                             isOnLand ? p.theme.land : p.theme.sea);
            });
    }
}

} // namespace berg
