#include "widgets/map/view/map_tools.h"

#include "core/base/angles.h"
#include "widgets/document/scenario_edits.h"
#include "widgets/document/selection.h"
#include "widgets/map/view/area_tool.h"
#include "widgets/map/view/map_view.h"
#include "widgets/map/view/measure_tool.h"
#include "widgets/map/view/placing_tools.h"
#include "widgets/map/view/select_tool.h"

#include <QApplication>
#include <QKeyEvent>

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

struct MapTools
{
    Q_DECLARE_TR_FUNCTIONS(MapTools)
};

/** Moves the map itself. */
class PanTool final : public MapTool
{
public:
    using MapTool::MapTool;

    void press(const MapPointer& pointer) override { m_last = pointer.at_px; }
    void move(const MapPointer& pointer) override
    {
        if (!m_last)
            return;
        context().view.camera().panBy(pointer.at_px - *m_last);
        m_last = pointer.at_px;
    }
    void release(const MapPointer&) override { m_last.reset(); }
    [[nodiscard]] bool isBusy() const override { return m_last.has_value(); }
    void cancel() override { drop(); }
    [[nodiscard]] QCursor cursor(const std::string&) const override
    {
        return m_last ? Qt::ClosedHandCursor : Qt::OpenHandCursor;
    }
    [[nodiscard]] QString status() const override
    {
        return MapTools::tr("Drag to move the map, turn the wheel to zoom. Esc leaves the tool.");
    }

protected:
    void drop() override { m_last.reset(); }

private:
    std::optional<QPointF> m_last;
};

} // namespace

bool isEditing(MapToolKind kind)
{
    switch (kind) {
    case MapToolKind::Iceberg:
    case MapToolKind::Uav:
    case MapToolKind::Asset:
    case MapToolKind::Area:
    case MapToolKind::NoFly:
        return true;
    case MapToolKind::Select:
    case MapToolKind::Measure:
    case MapToolKind::Pan:
        return false;
    }
    return false;
}

bool isLockedInFlight(MapToolKind kind)
{
    return isEditing(kind) && kind != MapToolKind::Iceberg;
}

void MapTool::documentChanged()
{
    if (!isApplying())
        drop();
    checkPart();
}

void MapTool::documentReplaced()
{
    drop();
    cancelDrawing();
}

std::unique_ptr<EditGesture> makeGesture(const MapToolContext& context, const QString& text)
{
    return std::make_unique<EditGesture>(
        context.document, text,
        [&view = context.view](const Scenario* scenario) { view.setPreview(scenario); });
}

std::unique_ptr<MapTool> makeMapTool(MapToolKind kind, const MapToolContext& context)
{
    switch (kind) {
    case MapToolKind::Select:
        return std::make_unique<SelectTool>(context);
    case MapToolKind::Iceberg:
        return std::make_unique<IcebergTool>(context);
    case MapToolKind::Uav:
        return std::make_unique<UavTool>(context);
    case MapToolKind::Asset:
        return std::make_unique<AssetTool>(context);
    case MapToolKind::Area:
    case MapToolKind::NoFly:
        return std::make_unique<AreaTool>(context, kind);
    case MapToolKind::Measure:
        return std::make_unique<MeasureTool>(context);
    case MapToolKind::Pan:
        return std::make_unique<PanTool>(context);
    }
    return nullptr;
}

QString moveText(const Scenario& scenario, std::span<const std::string> ids)
{
    const auto icebergs = std::count_if(ids.begin(), ids.end(), [&](const std::string& id) {
        return findById(scenario.icebergs, id) != nullptr;
    });
    const auto others = static_cast<std::ptrdiff_t>(ids.size()) - icebergs;
    if (icebergs == 0 && others == 1 && ids.front() == kAssetKey)
        return MapTools::tr("Move asset");
    if (icebergs == 0 && others == 1 && ids.front() == kAreaKey)
        return MapTools::tr("Move area");
    if (icebergs == 0 && others == 1 && noFlyPlace(ids.front()))
        return MapTools::tr("Move no-fly area");
    if (icebergs == 0 && others == 1)
        return MapTools::tr("Move UAV");
    if (others > 0)
        return MapTools::tr("Move %n objects", nullptr, static_cast<int>(ids.size()));
    return MapTools::tr("Move %n icebergs", nullptr, static_cast<int>(icebergs));
}

bool isDragDistance(const QPointF& from, const QPointF& to)
{
    return (to - from).manhattanLength() >= QApplication::startDragDistance();
}

Point placeOf(const MapPointer& pointer)
{
    return clampedPosition(roundedTo(pointer.at_m, kPositionStep_m));
}

MapPointer middleOf(const MapScene& scene)
{
    const QPointF at_px = scene.rect().center();
    return {.at_px = at_px, .at_m = scene.view().toWorld(at_px)};
}

bool isEnter(const QKeyEvent& event)
{
    return event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter;
}

} // namespace berg
