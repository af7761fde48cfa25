#include "app/map/map_controller.h"

#include "app/dialogs/interaction.h"
#include "app/layout/docks.h"
#include "app/layout/panels.h"
#include "widgets/map/paint/overview_inset.h"
#include "widgets/map/view/map_view.h"
#include "widgets/panels/flight/alarm_strip.h"
#include "widgets/panels/icebergs/iceberg_table.h"
#include "widgets/panels/map/layers_panel.h"
#include "widgets/panels/plan/plan_panel.h"
#include "widgets/workspace/workspace.h"

#include <QSettings>

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace berg {

namespace {

constexpr const char* kPanelsKey = "view/mapPanels";
constexpr const char* kLayersKey = "view/layers";
constexpr double kTrackStep_s = 1800; // a smooth line through a turn of the tide
constexpr int kDriftPause_ms = 300;
constexpr const char* kTrackMarkKey = "view/trackMark";
constexpr const char* kFormerSweptKey = "view/swept"; // before it was one of the layers
constexpr const char* kOverviewKey = "view/overview";
constexpr const char* kHiddenColumnsKey = "icebergs/hiddenColumns";

DriftInstant driftInstantOf(const MissionSnapshot& shown)
{
    DriftInstant instant{.time_s = shown.time_s, .icebergs = shown.icebergs, .tracks = {}};
    for (std::size_t i = 0; i < shown.icebergs.size(); ++i) {
        const Track& track = shown.world.tracks[i];
        const bool isShown = shown.active[i] && !track.left;
        instant.tracks.push_back(isShown ? std::optional<Track>(track) : std::nullopt);
    }
    return instant;
}

} // namespace

MapController::MapController(WindowContext& context, const Docks& docks) : WindowPart(context)
{
    panels().map->panels().setInset(overviewIsShown() ? panels().overview : nullptr);
    panels().icebergs->setHiddenColumns(settings().value(kHiddenColumnsKey).toStringList());
    panels().map->panels().setStates(savedPanels());
    panels().layers->showLayers(savedLayers());
    panels().map->setLayers(panels().layers->layers());
    if (!settings().value(kFormerSweptKey, true).toBool())
        setLayerShown(MapLayer::Swept, false);
    settings().remove(kFormerSweptKey);
    connect(panels().layers, &LayersPanel::layersEdited, this, &MapController::showLayers);
    connect(&panels().map->panels(), &MapPanels::changed, this, &MapController::savePanels);
    connect(&m_drift, &DriftTrackRunner::updated, this, &MapController::showDriftTracks);
    connect(&workspace().document(), &ScenarioDocument::scenarioChanged, this,
            &MapController::predictDrift);
    m_driftPause.setSingleShot(true);
    m_driftPause.setInterval(kDriftPause_ms);
    connect(&m_driftPause, &QTimer::timeout, this, &MapController::predictDrift);
    connect(&workspace(), &Workspace::flightChanged, this, &MapController::predictDriftInFlight);
    connect(&workspace(), &Workspace::inFlightChanged, this, &MapController::predictDrift);
    predictDrift();
    connectMap(docks);
    connectTables();
}

void MapController::predictDrift()
{
    const FlightRecord& record = workspace().record();
    if (!layerIsShown(MapLayer::Tracks))
        m_drift.clear();
    else if (record.inFlight())
        m_drift.setInstant(record.scenario, driftInstantOf(record.shown()), kTrackStep_s);
    else
        m_drift.setScenario(workspace().document().scenario(), kTrackStep_s);
}

void MapController::predictDriftInFlight()
{
    if (workspace().record().inFlight() && !m_driftPause.isActive())
        m_driftPause.start();
}

void MapController::showDriftTracks()
{
    MapLayers layers = panels().layers->layers();
    layers.tracks = m_drift.tracks();
    panels().layers->showLayers(layers);
    panels().map->setLayers(layers);
}

/** In the order of `MapPanel`: hidden, folded, moved by x, moved by y. */
void MapController::savePanels()
{
    QStringList states;
    for (const MapPanelState& state : panels().map->panels().states())
        states << u"%1 %2 %3 %4"_s.arg(int(state.isHidden))
                      .arg(int(state.isFolded))
                      .arg(state.moved_px.x())
                      .arg(state.moved_px.y());
    settings().setValue(kPanelsKey, states);
}

MapPanelStates MapController::savedPanels() const
{
    MapPanelStates states;
    const QStringList saved = settings().value(kPanelsKey).toStringList();
    for (std::size_t i = 0; i < std::min(states.size(), static_cast<std::size_t>(saved.size()));
         ++i) {
        const QStringList parts = saved[static_cast<qsizetype>(i)].split(u' ');
        const QPointF moved_px(parts.value(2).toDouble(), parts.value(3).toDouble());
        if (parts.size() == 4 && std::isfinite(moved_px.x()) && std::isfinite(moved_px.y()))
            states[i] = {.isHidden = parts[0] == u"1"_s,
                         .isFolded = parts[1] == u"1"_s,
                         .moved_px = moved_px};
    }
    return states;
}

/**
 * Returns the horizon, 0 for an automatic one, then the opacities; a value that is missing or not a
 * number has its default.
 */
MapLayers MapController::savedLayers() const
{
    const QStringList saved = settings().value(kLayersKey).toStringList();
    MapLayers layers;
    for (qsizetype i = 0; i < saved.size(); ++i) {
        bool isNumber = false;
        const double value = saved[i].toDouble(&isNumber);
        if (!isNumber || !std::isfinite(value))
            continue;
        if (i == 0)
            layers.horizon_s = value > 0 ? std::optional(value) : std::nullopt;
        else if (i <= static_cast<qsizetype>(kMapLayers))
            layers.set(static_cast<MapLayer>(i - 1), value);
    }
    const double mark_s = settings().value(kTrackMarkKey).toDouble();
    if (std::isfinite(mark_s) && mark_s > 0)
        layers.trackMark_s = std::max(mark_s, 3600.0);
    return layers;
}

/** On the map, and in the settings. */
void MapController::showLayers(const MapLayers& layers)
{
    panels().map->setLayers(layers);
    QStringList saved{QString::number(layers.horizon_s.value_or(0))};
    for (const double opacity : layers.opacities)
        saved << QString::number(opacity);
    settings().setValue(kLayersKey, saved);
    settings().setValue(kTrackMarkKey, layers.trackMark_s);
    predictDrift();
    emit layersChanged();
}

bool MapController::layerIsShown(MapLayer layer) const
{
    return panels().map->layers().shows(layer);
}

void MapController::setLayerShown(MapLayer layer, bool shown)
{
    MapLayers layers = panels().layers->layers();
    const double usual = MapLayers().opacity(layer);
    layers.set(layer, !shown ? 0 : usual > 0 ? usual : 1);
    panels().layers->showLayers(layers);
    showLayers(layers);
}

void MapController::setBackdrop(const BackdropPointer& backdrop)
{
    MapLayers layers = panels().layers->layers();
    layers.backdrop = backdrop;
    panels().layers->showLayers(layers);
    panels().map->setLayers(layers);
}

bool MapController::panelIsShown(MapPanel panel) const
{
    return !panels().map->panels().states()[static_cast<std::size_t>(panel)].isHidden;
}

/** One that is shown again is where and as large as it is by itself. */
void MapController::setPanelShown(MapPanel panel, bool shown)
{
    MapPanelStates states = panels().map->panels().states();
    states[static_cast<std::size_t>(panel)] = {.isHidden = !shown, .moved_px = {}};
    panels().map->panels().setStates(states);
    savePanels();
}

void MapController::connectMap(const Docks& docks)
{
    MapView* map = panels().map;
    connect(&map->camera(), &MapCamera::moved, this, &MapController::showOverview);
    connect(panels().overview, &OverviewInset::placePicked, &map->camera(), &MapCamera::centreOn);
    connect(map, &MapView::windEdited, &workspace(), &Workspace::setWind);
    connect(map, &MapView::assetMoved, &workspace(), &Workspace::moveAsset);
    connect(map, &MapView::icebergPlaced, &workspace(), &Workspace::addIceberg);
    connect(map, &MapView::removalRequested, this, [this](const std::vector<std::string>& ids) {
        if (workspace().refuseIntervention())
            return;
        const std::vector<std::string> flown = workspace().icebergsInFlight(ids);
        QStringList names;
        for (const std::string& id : flown)
            names << QString::fromStdString(id);
        if (flown.empty() || !interaction().askRemove(panels().map, names))
            return;
        if (const int count = workspace().remove(flown); count > 0)
            showMessage(
                tr("%n icebergs removed from this run. Undo brings them back.", nullptr, count),
                kLongMessage_ms);
    });
    connect(panels().alarms, &AlarmStrip::noticeChosen, this,
            [this](const std::vector<std::string>& about) {
                workspace().selection().set(about);
                panels().map->camera().showObjects(about);
            });
    connect(map, &MapView::editRequested, &docks, &Docks::openInspector);
}

void MapController::connectTables()
{
    MapView* map = panels().map;
    const auto select = [this](const std::string& id) { workspace().selection().set({id}); };
    PlanPanel* plan = panels().plan;
    connect(plan, &PlanPanel::hovered, map, &MapView::setHighlight);
    connect(&map->tools(), &MapToolbox::hoveredChanged, plan, &PlanPanel::setHighlight);
    connect(plan, &PlanPanel::activated, this, select);
    connect(plan, &PlanPanel::assignRequested, this,
            [this](const std::string& iceberg, const std::string& uav) {
                workspace().assign({iceberg}, uav);
            });
    const IcebergTable* icebergs = panels().icebergs;
    connect(icebergs, &IcebergTable::hovered, map, &MapView::setHighlight);
    connect(&map->tools(), &MapToolbox::hoveredChanged, icebergs, &IcebergTable::setHighlight);
    connect(icebergs, &IcebergTable::chosen, this, [map, select](const std::string& id) {
        select(id);
        map->camera().showIceberg(id);
    });
    connect(icebergs, &IcebergTable::mapPasteRequested, map, [map] { map->edits().paste(); });
    connect(icebergs, &IcebergTable::hiddenColumnsChanged, this,
            [this](const QStringList& keys) { settings().setValue(kHiddenColumnsKey, keys); });
}

bool MapController::overviewIsShown() const
{
    return settings().value(kOverviewKey, false).toBool();
}

void MapController::setOverviewShown(bool shown)
{
    settings().setValue(kOverviewKey, shown);
    panels().map->panels().setInset(shown ? panels().overview : nullptr);
    showOverview();
}

void MapController::showOverview()
{
    if (!panels().map->panels().hasInset())
        return;
    panels().overview->setPlace(workspace().document().scenario().origin);
    panels().overview->setExtent(panels().map->camera().outline());
}

} // namespace berg
