#include "widgets/map/view/flight_drag.h"

#include "widgets/map/paint/wind_panel.h"
#include "widgets/map/view/drift_arrow.h"
#include "widgets/map/view/map_view.h"
#include "widgets/model/scenario_edits.h"

#include <QCoreApplication>

namespace berg {
namespace {

struct FlightDragText
{
    Q_DECLARE_TR_FUNCTIONS(FlightDrag)
};

class WindDrag final : public HandleDrag
{
public:
    WindDrag(const MapToolContext& context, const MapHandle& handle)
        : HandleDrag(context, handle), m_air(context.scene.picture().air)
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

    [[nodiscard]] QString text() const override { return {}; } // the panel has them

    [[nodiscard]] QString status() const override
    {
        if (isStrong(m_air))
            return FlightDragText::tr("The UAV makes little way against this wind. Esc takes it "
                                      "back.");
        return isInFlight()
                   ? FlightDragText::tr("Let go: this wind blows from now on. Esc takes it back.")
                   : FlightDragText::tr("Let go to keep this wind. Shift keeps to steps of %1°, "
                                        "Esc takes it back.")
                         .arg(kDirectionStep_deg);
    }

private:
    MapAir m_air; ///< with the wind drawn
};

class AssetDrag final : public HandleDrag
{
public:
    AssetDrag(const MapToolContext& context, const MapHandle& handle)
        : HandleDrag(context, handle)
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
        return FlightDragText::tr("Let go: the asset is here from now on. Esc takes it back.");
    }

private:
    Point m_from_m;
    Point m_grip_m; ///< from its centre to where it was taken
    Point m_to_m;
};

} // namespace

std::unique_ptr<HandleDrag> makeWindDrag(const MapToolContext& context, const MapHandle& handle)
{
    return std::make_unique<WindDrag>(context, handle);
}

std::unique_ptr<HandleDrag> makeAssetDrag(const MapToolContext& context, const MapHandle& handle)
{
    return std::make_unique<AssetDrag>(context, handle);
}

} // namespace berg
