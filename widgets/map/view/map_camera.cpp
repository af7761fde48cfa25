#include "widgets/map/view/map_camera.h"

#include "widgets/document/scenario_edits.h"
#include "widgets/map/picture/scenario_picture.h"

#include <algorithm>

namespace berg {
namespace {

constexpr double kUavClearance_px = 20; // distance of a followed UAV from panels

// The smallest scale shows the whole range of coordinates; at the largest a pixel is a tenth of a
// metre.
constexpr double kSmallestScale_pxpm = 2e-4;
constexpr double kLargestScale_pxpm = 10;

/** Half the share of the view within which a followed UAV moves. */
constexpr double kFollowShare = 0.2;

constexpr int kOutlinePieces = 8; // per side

} // namespace

MapCamera::MapCamera(MapScene& scene, const Selection& selection)
    : m_scene(scene), m_selection(selection)
{
}

void MapCamera::fit()
{
    m_scene.fit();
    m_scene.settle();
    m_isFitted = true;
    emit moved();
}

void MapCamera::centreOn(const LatLon& place)
{
    const Point place_m = LocalFrame(m_scene.picture().origin).toPlane(place);
    panBy(m_scene.rect().center() - m_scene.view().toPixel(place_m));
}

void MapCamera::zoomBy(double factor, const QPointF& at)
{
    const double scale_pxpm = m_scene.view().scale_pxpm();
    const double wanted_pxpm =
        std::clamp(scale_pxpm * factor, kSmallestScale_pxpm, kLargestScale_pxpm);
    if (wanted_pxpm == scale_pxpm)
        return;
    // The zoom centre is a followed UAV, otherwise the place under the cursor.
    const MapUav* uav = m_followsUav ? followedUav() : nullptr;
    const QPointF fixed = uav != nullptr ? m_scene.view().toPixel(uav->position_m) : at;
    setView(m_scene.view().zoomed(wanted_pxpm / scale_pxpm, fixed));
}

void MapCamera::showIceberg(const std::string& id)
{
    const std::vector<MapIceberg>& icebergs = m_scene.picture().icebergs;
    const auto it = std::ranges::find(icebergs, id, keyOf);
    if (it != icebergs.end())
        panBy(m_scene.rect().center() - m_scene.view().toPixel(it->position_m));
}

void MapCamera::showObjects(const std::vector<std::string>& ids)
{
    constexpr double kShare = 0.6; // share of the map, which leaves the surroundings visible
    const MapPicture& picture = m_scene.picture();
    std::vector<Point> places_m;
    const auto add = [&](const std::string& id, const Point& place_m) {
        if (std::ranges::find(ids, id) != ids.end())
            places_m.push_back(place_m);
    };
    for (const MapIceberg& iceberg : picture.icebergs)
        add(keyOf(iceberg), iceberg.position_m);
    for (const MapUav& uav : picture.uavs)
        if (uav.key)
            add(*uav.key, uav.position_m);
    if (picture.asset)
        add(kAssetKey, picture.asset->position_m);
    if (places_m.empty())
        return;
    setFollowUav(false);
    QRectF middle(QPointF(), m_scene.rect().size() * kShare);
    middle.moveCenter(m_scene.rect().center());
    setView(MapViewTransform::fitted(boundsOf(places_m), middle));
}

void MapCamera::panBy(const QPointF& offset_px)
{
    setFollowUav(false);
    setView(m_scene.view().moved(offset_px));
}

void MapCamera::setFollowUav(bool follow)
{
    if (m_followsUav == follow)
        return;
    m_followsUav = follow;
    if (const MapUav* uav = followedUav(); follow && uav != nullptr)
        setView(m_scene.view().moved(m_scene.rect().center() -
                                     m_scene.view().toPixel(uav->position_m)));
    emit followUavChanged(follow);
}

void MapCamera::showAs(const MapCamera& other)
{
    if (!other.m_isFitted)
        setView(other.m_scene.view());
    setFollowUav(other.m_followsUav);
}

/** Selected UAV, otherwise the first; null if there is none. */
const MapUav* MapCamera::followedUav() const
{
    const std::vector<MapUav>& uavs = m_scene.picture().uavs;
    const auto selected = std::find_if(uavs.begin(), uavs.end(), [&](const MapUav& uav) {
        return uav.key && m_selection.contains(*uav.key);
    });
    if (selected != uavs.end())
        return &*selected;
    return uavs.empty() ? nullptr : &uavs.front();
}

void MapCamera::resize(const QRectF& rect)
{
    const QPointF before = m_scene.rect().center();
    m_scene.setRect(rect);
    if (m_isFitted)
        fit();
    else
        setView(m_scene.view().moved(m_scene.rect().center() - before));
}

void MapCamera::setView(const MapViewTransform& view)
{
    // The middle of the map stays within the limits of a scenario.
    const QPointF middle = m_scene.rect().center();
    const Point middle_m = view.toWorld(middle);
    const QPointF offset_px = middle - view.toPixel(clampedPosition(middle_m));
    m_scene.setView(view.moved(offset_px));
    m_isFitted = false;
    emit moved();
}

void MapCamera::keepUavInSight()
{
    const MapUav* uav = followedUav();
    if (!m_followsUav || uav == nullptr)
        return;
    const QRectF rect = m_scene.rect();
    const QPointF half(kFollowShare * rect.width(), kFollowShare * rect.height());
    const QPointF at = m_scene.view().toPixel(uav->position_m);
    const QPointF middle = rect.center();
    QPointF inside(std::clamp(at.x(), middle.x() - half.x(), middle.x() + half.x()),
                   std::clamp(at.y(), middle.y() - half.y(), middle.y() + half.y()));
    for (const QRectF& overlay : m_scene.layout().overlays())
        if (overlay
                .marginsAdded(
                    {kUavClearance_px, kUavClearance_px, kUavClearance_px, kUavClearance_px})
                .contains(inside))
            inside = middle;
    if (inside != at)
        setView(m_scene.view().moved(inside - at));
}

std::vector<LatLon> MapCamera::outline() const
{
    const LocalFrame frame(m_scene.picture().origin);
    const QRectF shown = m_scene.rect();
    const QPolygonF corners({shown.topLeft(), shown.topRight(), shown.bottomRight(),
                             shown.bottomLeft(), shown.topLeft()});
    std::vector<LatLon> places;
    for (qsizetype i = 0; i + 1 < corners.size(); ++i) {
        const QLineF side(corners[i], corners[i + 1]);
        for (int k = 0; k < kOutlinePieces; ++k)
            places.push_back(frame.toGeographic(
                m_scene.view().toWorld(side.pointAt(static_cast<double>(k) / kOutlinePieces))));
    }
    return places;
}

} // namespace berg
