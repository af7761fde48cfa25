#include "widgets/map/view/map_panels.h"

#include <QWidget>

#include <utility>

namespace berg {

MapPanels::MapPanels(MapScene& scene, MapCamera& camera, QWidget& map)
    : m_scene(scene), m_camera(camera), m_map(map)
{
}

void MapPanels::setStates(const MapPanelStates& states)
{
    m_scene.setPanels(states);
    if (m_camera.isFitted())
        m_camera.fit();
    placeInset();
    m_map.update();
}

void MapPanels::setCover(int cover_px)
{
    m_scene.setCover(cover_px);
    placeInset();
    m_map.update();
}

void MapPanels::setInset(QWidget* inset)
{
    if (m_inset != nullptr && m_inset != inset)
        m_inset->hide();
    m_inset = inset;
    m_scene.setInset(inset != nullptr ? QSizeF(inset->sizeHint()) : QSizeF());
    placeInset();
    m_map.update();
}

void MapPanels::placeInset()
{
    if (m_inset == nullptr)
        return;
    const QRectF place = m_scene.layout().inset;
    m_inset->setVisible(!place.isNull());
    if (!place.isNull())
        m_inset->setGeometry(place.toRect());
}

void MapPanels::fold(MapPanel panel)
{
    const bool isIcon = isFolded(panel);
    MapPanelStates states = m_scene.panels();
    MapPanelState& state = states[static_cast<std::size_t>(panel)];
    state.isFolded = !isIcon;
    state.isOpened = isIcon;
    setStates(states);
    emit changed();
}

bool MapPanels::press(const QPointF& at)
{
    const std::optional<MapPanelPart> part = m_scene.panelPartAt(at);
    if (!part)
        return false;
    if (!part->isGrip) {
        fold(part->panel);
        return true;
    }
    m_moved = part->panel;
    m_from = at - m_scene.panelOffset_px(part->panel);
    return true;
}

void MapPanels::move(const QPointF& at)
{
    m_scene.movePanel(*m_moved, at - m_from);
    placeInset();
    m_map.update();
}

void MapPanels::release()
{
    if (std::exchange(m_moved, std::nullopt))
        emit changed();
}

} // namespace berg
