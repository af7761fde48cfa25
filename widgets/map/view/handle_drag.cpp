// Drags of the map's handles, which change the scenario, or in flight request a change of the
// flight.

#include "widgets/document/scenario_edits.h"
#include "widgets/map/paint/wind_panel.h"
#include "widgets/map/view/drift_arrow.h"
#include "widgets/map/view/map_handles.h"
#include "widgets/map/view/map_view.h"

#include <QCoreApplication>

#include <algorithm>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

struct HandleText
{
    Q_DECLARE_TR_FUNCTIONS(HandleDrag)
};

struct FlightDragText
{
    Q_DECLARE_TR_FUNCTIONS(FlightDrag)
};

constexpr std::size_t kFewestCorners = 3;

/** Ids of the selected icebergs. */
std::vector<std::string> selectedIcebergs(const MapToolContext& context)
{
    std::vector<std::string> ids;
    for (const Iceberg& iceberg : icebergsOf(context.document.scenario(), context.selection.ids()))
        ids.push_back(iceberg.id);
    return ids;
}

class DriftDrag final : public HandleDrag
{
public:
    DriftDrag(const MapToolContext& context, const MapHandle& handle)
        : HandleDrag(context)
        , m_ids(selectedIcebergs(context))
        , m_iceberg(*findById(context.document.scenario().icebergs, handle.id))
        , m_arrow(context.scene, handle.id)
    {
        begin(
            HandleText::tr("Change drift of %n icebergs", nullptr, static_cast<int>(m_ids.size())));
    }

    void move(const MapPointer& pointer) override
    {
        m_iceberg.velocity_mps = m_arrow.velocity_mps(m_iceberg, pointer, current_mps());
        gesture().apply([this](Scenario& scenario) {
            for (const std::string& id : m_ids)
                findById(scenario.icebergs, id)->velocity_mps = m_iceberg.velocity_mps;
        });
    }
    [[nodiscard]] QString text() const override
    {
        return driftText(m_iceberg.velocity_mps + current_mps(), context().scene.locale());
    }
    [[nodiscard]] QString status() const override { return m_arrow.status(); }

private:
    [[nodiscard]] Point current_mps() const { return context().document.scenario().current_mps; }

    std::vector<std::string> m_ids;
    Iceberg m_iceberg; ///< iceberg of the handle, with the drift drawn
    DriftArrow m_arrow;
};

class HeadingDrag final : public HandleDrag
{
public:
    HeadingDrag(const MapToolContext& context, const MapHandle& handle)
        : HandleDrag(context), m_uav(*findById(context.document.scenario().uavs, handle.id))
    {
        begin(HandleText::tr("Turn UAV"));
    }

    void move(const MapPointer& pointer) override
    {
        m_uav.heading_deg =
            headingTowards_deg(m_uav.position_m, pointer).value_or(m_uav.heading_deg);
        gesture().apply([this](Scenario& scenario) {
            findById(scenario.uavs, m_uav.id)->heading_deg = m_uav.heading_deg;
        });
    }
    [[nodiscard]] QString text() const override { return headingText(m_uav.heading_deg); }
    [[nodiscard]] QString status() const override
    {
        return HandleText::tr("Release to keep this heading. Shift snaps to steps of %1°; Esc "
                              "cancels.")
            .arg(kDirectionStep_deg);
    }

private:
    Uav m_uav;
};

/** Drag of a corner, possibly a new one in the middle of an edge. */
class CornerDrag final : public HandleDrag
{
public:
    CornerDrag(const MapToolContext& context, const MapHandle& handle)
        : HandleDrag(context)
        , m_area_m(*outlineIn(context.document.scenario(), handle.id))
        , m_index(handle.kind == HandleKind::Edge ? handle.index + 1 : handle.index)
        , m_from_m(context.scene.view().toWorld(handle.at_px))
        , m_id(handle.id)
    {
        if (handle.kind == HandleKind::Edge)
            m_area_m.insert(m_area_m.begin() + static_cast<std::ptrdiff_t>(m_index), m_from_m);
        begin(handle.kind == HandleKind::Edge ? HandleText::tr("Add corner")
                                              : HandleText::tr("Move corner"));
    }

    void move(const MapPointer& pointer) override
    {
        std::vector<Point> area_m = m_area_m;
        area_m[m_index] = placeOf(pointer);
        m_isRefused = !isSimplePolygon(area_m);
        if (m_isRefused)
            return; // keeps the last valid place
        m_area_m = area_m;
        gesture().apply([&](Scenario& scenario) { *outlineIn(scenario, m_id) = area_m; });
    }
    [[nodiscard]] QString text() const override
    {
        return m_isRefused ? crossingText()
                           : pathText(m_area_m[m_index] - m_from_m, context().scene.locale());
    }
    [[nodiscard]] QString status() const override
    {
        return m_isRefused ? crossingText()
                           : HandleText::tr("Release to place the corner here. Esc cancels.");
    }

private:
    std::vector<Point> m_area_m; ///< with the drag so far
    std::size_t m_index;
    Point m_from_m;
    std::string m_id;
    bool m_isRefused = false;
};

// Drags that are also possible in flight. There the end of a drag requests a change of the flight,
// and until then it is only drawn.

/** Drag of the wind arrow's tip, which changes direction and speed. */
class WindDrag final : public HandleDrag
{
public:
    explicit WindDrag(const MapToolContext& context)
        : HandleDrag(context), m_air(context.scene.picture().air)
    {
        if (!context.view.isLocked())
            begin(FlightDragText::tr("Change wind"));
    }

    void move(const MapPointer& pointer) override
    {
        m_air.wind_mps = windAtTip(context().scene.layout().wind, m_air, pointer.at_px,
                                   pointer.modifiers.testFlag(Qt::ShiftModifier));
        const Point wind_mps = m_air.wind_mps;
        if (isInFlight())
            context().view.setDraft([wind_mps](MapPicture& p) { p.air.wind_mps = wind_mps; });
        else
            gesture().apply([&](Scenario& scenario) { scenario.wind_mps = wind_mps; });
    }

    void end(bool keep) override
    {
        if (!isInFlight())
            HandleDrag::end(keep);
        else if (keep)
            emit context().view.windEdited(m_air.wind_mps);
    }

    [[nodiscard]] QString text() const override { return {}; } // the panel shows the values

    [[nodiscard]] QString status() const override
    {
        if (isStrong(m_air))
            return FlightDragText::tr("The UAV makes little headway in this wind. Esc cancels.");
        return isInFlight()
                   ? FlightDragText::tr("Release to apply this wind from now on. Esc cancels.")
                   : FlightDragText::tr("Release to keep this wind. Shift snaps to steps of %1°; "
                                        "Esc cancels.")
                         .arg(kDirectionStep_deg);
    }

private:
    MapAir m_air; ///< with the wind of the drag
};

/** Drag of the asset's present position, in flight only. */
class AssetDrag final : public HandleDrag
{
public:
    AssetDrag(const MapToolContext& context, const MapHandle& handle)
        : HandleDrag(context)
        , m_from_m(context.scene.picture().asset->position_m)
        , m_grip_m(context.scene.view().toWorld(handle.at_px) - m_from_m)
        , m_to_m(m_from_m)
    {
    }

    void move(const MapPointer& pointer) override
    {
        MapPointer centre = pointer;
        centre.at_m -= m_grip_m;
        m_to_m = placeOf(centre);
        context().view.setDraft([to_m = m_to_m](MapPicture& p) {
            if (p.asset)
                p.asset->position_m = to_m;
        });
    }

    void end(bool keep) override
    {
        if (keep)
            emit context().view.assetMoved(m_to_m);
    }

    [[nodiscard]] QString text() const override
    {
        return pathText(m_to_m - m_from_m, context().scene.locale());
    }

    [[nodiscard]] QString status() const override
    {
        return FlightDragText::tr("Release to move the asset here now. Esc cancels.");
    }

private:
    Point m_from_m;
    Point m_grip_m; ///< from the asset's centre to the grabbed point
    Point m_to_m;
};

} // namespace

void HandleDrag::end(bool keep)
{
    if (keep)
        m_gesture->finish();
    else
        m_gesture->cancel();
}

std::unique_ptr<HandleDrag> makeHandleDrag(const MapToolContext& context, const MapHandle& handle)
{
    switch (handle.kind) {
    case HandleKind::Drift:
        return std::make_unique<DriftDrag>(context, handle);
    case HandleKind::Heading:
        return std::make_unique<HeadingDrag>(context, handle);
    case HandleKind::Corner:
    case HandleKind::Edge:
        return std::make_unique<CornerDrag>(context, handle);
    case HandleKind::Wind:
        return std::make_unique<WindDrag>(context);
    case HandleKind::Asset:
        return std::make_unique<AssetDrag>(context, handle);
    }
    return nullptr;
}

QString handleText(const MapToolContext& context, const MapHandle& handle)
{
    switch (handle.kind) {
    case HandleKind::Drift: {
        const auto count = static_cast<int>(selectedIcebergs(context).size());
        return count > 1 ? HandleText::tr("Drag to give all %n selected icebergs the same drift.",
                                          nullptr, count)
                         : HandleText::tr("Drag to set the drift of the iceberg.");
    }
    case HandleKind::Heading:
        return HandleText::tr("Drag to turn the UAV.");
    case HandleKind::Corner:
        return HandleText::tr("Drag to move the corner. To remove it, click it and press Del.");
    case HandleKind::Edge:
        return HandleText::tr("Drag to add a corner here.");
    case HandleKind::Wind:
        return context.view.isLocked()
                   ? HandleText::tr("Drag to change the wind from now on. In flight this cannot be "
                                    "undone.")
                   : HandleText::tr("Drag to set the wind. The arrow points downwind.");
    case HandleKind::Asset:
        break; // has no visible handle
    }
    return {};
}

bool hasCorner(const MapToolContext& context, const MapHandle& corner)
{
    const std::vector<Point>* outline_m = outlineIn(context.document.scenario(), corner.id);
    return outline_m != nullptr && corner.index < outline_m->size();
}

void removeCorner(const MapToolContext& context, const MapHandle& corner)
{
    std::vector<Point> area_m = *outlineIn(context.document.scenario(), corner.id);
    if (area_m.size() <= kFewestCorners) {
        emit context.view.refused(
            HandleText::tr("An area needs at least three corners. Delete the whole area instead."));
        return;
    }
    area_m.erase(area_m.begin() + static_cast<std::ptrdiff_t>(corner.index));
    if (!isSimplePolygon(area_m)) {
        emit context.view.refused(
            HandleText::tr("Without this corner the outline would cross itself."));
        return;
    }
    context.document.edit(HandleText::tr("Remove corner"),
                          [&](Scenario& scenario) { *outlineIn(scenario, corner.id) = area_m; });
}

QString crossingText()
{
    return HandleText::tr("The outline would cross itself here.");
}

} // namespace berg
