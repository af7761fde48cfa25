#pragma once

#include "app/layout/window_part.h"
#include "widgets/forecast/drift_track_runner.h"
#include "widgets/map/paint/map_layers.h"
#include "widgets/map/paint/map_overlays.h"

#include <QTimer>

namespace berg {

class Docks;

/** Connects the map, the tables beside it, the overview and the workspace. */
class MapController : public WindowPart
{
    Q_OBJECT

public:
    MapController(WindowContext& context, const Docks& docks);

    [[nodiscard]] bool overviewIsShown() const;
    void setOverviewShown(bool shown);
    [[nodiscard]] bool panelIsShown(MapPanel panel) const;
    void setPanelShown(MapPanel panel, bool shown);
    [[nodiscard]] bool layerIsShown(MapLayer layer) const;
    /** Shows it with the opacity that it has by default, or hides it. */
    void setLayerShown(MapLayer layer, bool shown);
    /** The widget below the map; may be null. */
    void setBackdrop(const BackdropPointer& backdrop);

signals:
    /** Layers of the map are shown, hidden or made faint. */
    void layersChanged();

private:
    void connectMap(const Docks& docks);
    void connectTables();
    void showOverview();
    void savePanels();
    [[nodiscard]] MapLayers savedLayers() const;
    void showLayers(const MapLayers& layers);
    /** Predicts the drift of the icebergs, in flight from the instant shown, if its layer is shown.
     */
    void predictDrift();
    /** Predicts it a moment later, because a flight changes many times a second. */
    void predictDriftInFlight();
    void showDriftTracks();
    [[nodiscard]] MapPanelStates savedPanels() const;

    DriftTrackRunner m_drift;
    QTimer m_driftPause;
};

} // namespace berg
