#pragma once

#include "widgets/document/selection.h"
#include "widgets/map/view/map_scene.h"

#include <QObject>

namespace berg {

/**
 * Which part of the Earth the map shows: everything, what the user moved to, or a followed UAV.
 * GUI thread.
 */
class MapCamera : public QObject
{
    Q_OBJECT

public:
    /** Borrows both. */
    MapCamera(MapScene& scene, const Selection& selection);

    /** Shows all objects as large as possible. */
    void fit();
    /** Returns true until the map is moved after `fit`. */
    [[nodiscard]] bool isFitted() const { return m_isFitted; }
    /** Centres the map on a place, or on the nearest one within the limits of a scenario, and stops
     * following a UAV. */
    void centreOn(const LatLon& place);
    /** Zooms about a pixel, or about a followed UAV, within the limits of scale. */
    void zoomBy(double factor, const QPointF& at);
    /** Centres the map on an iceberg and stops following a UAV; does nothing if the iceberg is not
     * in the picture. */
    void showIceberg(const std::string& id);
    /** Zooms to these icebergs, UAVs and the asset and stops following a UAV; does nothing if none
     * is in the picture. */
    void showObjects(const std::vector<std::string>& ids);
    /** Moves the map by `offset_px` and stops following a UAV. */
    void panBy(const QPointF& offset_px);
    /** Keeps the selected UAV, otherwise the first one, in the middle part of the view until the
     * map is moved by hand. */
    void setFollowUav(bool follow);
    [[nodiscard]] bool followsUav() const { return m_followsUav; }
    /** Follows it, if one is followed: it or the selection has changed. */
    void keepUavInSight();
    /** Takes over from another map centre and scale, unless that one is fitted, and following. */
    void showAs(const MapCamera& other);
    /** Gives the map another size: fitted again, else with the same middle. */
    void resize(const QRectF& rect);
    /** Returns the outline of the area shown, with points between the corners; it is not closed. */
    [[nodiscard]] std::vector<LatLon> outline() const;

signals:
    /** Another part of the Earth is shown. */
    void moved();
    void followUavChanged(bool follows);

private:
    [[nodiscard]] const MapUav* followedUav() const;
    void setView(const MapViewTransform& view);

    MapScene& m_scene;
    const Selection& m_selection;
    bool m_isFitted = true; ///< unmoved since `fit`: a resize fits again
    bool m_followsUav = false;
};

} // namespace berg
