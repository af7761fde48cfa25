#include "widgets/panels/inspector/field_inputs.h"

#include <cmath>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

std::vector<InspectorRow> pathRows()
{
    const FieldInputs<Asset> asset("asset.");
    const QString change = InspectorRows::tr("Change velocity of the asset");
    return velocityRows(
        {.east = named(asset.inSi("velocity_mps", 0), u"assetVelocityEast"_s, change),
         .north = named(asset.inSi("velocity_mps", 1), u"assetVelocityNorth"_s, change),
         .key = u"assetVelocity"_s,
         .speedLabel = InspectorRows::tr("Speed"),
         .speedToolTip = InspectorRows::tr("Speed of a ship; 0 for a platform."),
         .directionLabel = InspectorRows::tr("Course"),
         .directionToolTip = InspectorRows::tr("Course over ground, clockwise from north."),
         .componentLimit_mps = limits::kAssetVelocity_mps.high,
         .speeds_mps = always({.low = 0, .high = limits::kAssetVelocity_mps.high}),
         .direction = {
             .key = u"assetVelocity"_s,
             .text = [](const Scenario& scenario, const std::string&, const QLocale& locale) {
                 return scenario.asset ? towardsText(scenario.asset->velocity_mps, locale)
                                       : QString();
             }}});
}

QString areaText(const std::vector<Point>& corners_m, const QLocale& locale)
{
    if (corners_m.empty())
        return {};
    const ShownUnit unit = areaUnit();
    const double size = unit.fromSi(std::abs(signedArea(corners_m)));
    return InspectorRows::tr("%n corners, %1", nullptr, static_cast<int>(corners_m.size()))
        .arg(u"%1 %2"_s.arg(significantText(size, 3, locale), unit.name));
}

} // namespace

std::vector<InspectorRow> assetRows()
{
    const FieldInputs<Asset> asset("asset.");
    const FieldInputs<Asset> ring("asset.", [](const Scenario& scenario, const std::string&) {
        return scenario.asset && scenario.asset->standoff_m > 0;
    });
    std::vector<InspectorRow> rows = asset.rows("name");
    beginGroup(rows, u"assetPositionGroup"_s, InspectorRows::tr("Position and course"));
    append(rows, positionRows<Asset>(u"asset"_s, "asset."));
    append(rows, pathRows());
    beginGroup(rows, u"assetProtectionGroup"_s, InspectorRows::tr("Protection"));
    append(rows, asset.rows("range_m"));
    append(rows, asset.rows("alarm_m"));
    append(rows, asset.rows("gain"));
    append(rows, asset.rows("standoff_m"));
    append(rows, ring.rows("standoff_ceiling_m"));
    rows.emplace_back(
        ActionRow{.words = {.key = u"assetRemove"_s,
                            .toolTip = InspectorRows::tr("Removes the asset from the map."),
                            .undoText = InspectorRows::tr("Remove asset")},
                  .act = [](Scenario& scenario) { scenario.asset.reset(); }});
    return rows;
}

std::vector<InspectorRow> areaRows()
{
    return {
        InfoRow{.key = u"areaSize"_s,
                .text = [](const Scenario& scenario, const std::string&,
                           const QLocale& locale) { return areaText(scenario.area_m, locale); }},
        FieldInputs<Scenario>("").flag("geofence"),
        ActionRow{.words = {.key = u"areaRemove"_s,
                            .toolTip = InspectorRows::tr("Removes the area from the map."),
                            .undoText = InspectorRows::tr("Remove area")},
                  .act = [](Scenario& scenario) {
                      scenario.area_m.clear();
                      scenario.geofence = false;
                  }}};
}

std::vector<InspectorRow> noFlyRows()
{
    std::vector<InspectorRow> rows = FieldInputs<NoFlyArea>("no_fly.").rows("name", "ceiling_m");
    rows.emplace_back(
        PartRow{.words = {.key = u"noFlyRemove"_s,
                          .label = InspectorRows::tr("Outline"),
                          .toolTip = InspectorRows::tr("Removes the no-fly area from the map."),
                          .undoText = InspectorRows::tr("Remove no-fly area")},
                .removeText = InspectorRows::tr("Remove"),
                .text =
                    [](const Scenario& scenario, const std::string& id, const QLocale& locale) {
                        const auto* area = objectIn<NoFlyArea>(scenario, id);
                        return area == nullptr ? QString() : areaText(area->corners_m, locale);
                    },
                .remove =
                    [](Scenario& scenario, const std::string& id) {
                        if (const std::optional<std::size_t> place = noFlyPlace(id))
                            scenario.noFly.erase(scenario.noFly.begin() +
                                                 static_cast<std::ptrdiff_t>(*place));
                    }});
    return rows;
}

} // namespace berg
