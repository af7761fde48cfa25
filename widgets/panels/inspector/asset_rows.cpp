#include "widgets/panels/inspector/inspector_row_makers.h"
#include "widgets/theme/quantity_text.h"

#include <cmath>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr double kSpeedStep_mps = 0.5;

template <class Number>
NumberRow assetRow(const RowWords& words, Number number, const Limits& limits, double step = 1)
{
    NumberRow row = objectRow<Asset>(words, {}, number, limits, step);
    row.decimals = {.least = 0, .most = 2};
    return row;
}

template <class Object, class Height>
NumberRow ceilingRow(const RowWords& words, Height height)
{
    NumberRow row = optionalRow(words, {}, memberOf<Object>(height), limits::kLength_m,
                                InspectorRows::tr("none"));
    row.step = 10;
    return asHeight(row);
}

std::vector<InspectorRow> wayRows()
{
    const auto component = [](const QString& key, const QString& label, const QString& toolTip,
                              int axis) {
        return assetRow(
            {.key = key,
             .label = label,
             .toolTip = toolTip,
             .undoText = InspectorRows::tr("Change velocity of the asset")},
            [axis](auto& asset) -> auto& { return asset.velocity_mps[axis]; },
            limits::kAssetVelocity_mps, kSpeedStep_mps);
    };
    return velocityRows(
        {.east =
             component(u"assetVelocityEast"_s, InspectorRows::tr("Speed east"),
                       InspectorRows::tr("What a ship makes to the east; 0 for a platform."), 0),
         .north =
             component(u"assetVelocityNorth"_s, InspectorRows::tr("Speed north"),
                       InspectorRows::tr("What a ship makes to the north; 0 for a platform."), 1),
         .key = u"assetVelocity"_s,
         .speedLabel = InspectorRows::tr("Speed"),
         .speedToolTip = InspectorRows::tr("What a ship makes; 0 for a platform."),
         .directionLabel = InspectorRows::tr("Course"),
         .directionToolTip = InspectorRows::tr("Where it goes, clockwise from north."),
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
    std::vector<InspectorRow> rows{nameRow<Asset>(u"assetName"_s)};
    rows.emplace_back(GroupRow{.key = u"assetPositionGroup"_s,
                               .title = InspectorRows::tr("Position and course")});
    append(rows, positionRows<Asset>(u"asset"_s));
    append(rows, wayRows());
    rows.emplace_back(
        GroupRow{.key = u"assetProtectionGroup"_s, .title = InspectorRows::tr("Protection")});
    rows.emplace_back(
        asDistance(assetRow({.key = u"assetRange"_s,
                             .label = InspectorRows::tr("Range"),
                             .toolTip = InspectorRows::tr("How near an iceberg matters to it."),
                             .undoText = InspectorRows::tr("Change range of the asset")},
                            &Asset::range_m, limits::kExtent_m, 500)));
    NumberRow alarm = assetRow({.key = u"assetAlarm"_s,
                                .label = InspectorRows::tr("Inner ring"),
                                .toolTip = InspectorRows::tr(
                                    "An iceberg on its way into it within an hour is an alarm; at "
                                    "0 it is half the range."),
                                .undoText = InspectorRows::tr("Change inner ring of the asset")},
                               &Asset::alarm_m, limits::kLength_m, 500);
    alarm.lowestText = InspectorRows::tr("half the range");
    rows.emplace_back(asDistance(alarm));
    rows.emplace_back(
        assetRow({.key = u"assetGain"_s,
                  .label = InspectorRows::tr("Gain"),
                  .toolTip = InspectorRows::tr("How much more an iceberg near it matters."),
                  .undoText = InspectorRows::tr("Change gain of the asset")},
                 &Asset::gain, limits::kGain));
    NumberRow standoff = assetRow(
        {.key = u"assetStandoff"_s,
         .label = InspectorRows::tr("Stand-off ring"),
         .toolTip = InspectorRows::tr("No UAV comes nearer to it; of a ship, to all of its track."),
         .undoText = InspectorRows::tr("Change stand-off ring")},
        &Asset::standoff_m, limits::kLength_m, 100);
    standoff.lowestText = InspectorRows::tr("none");
    rows.emplace_back(asDistance(standoff));
    rows.emplace_back(
        ceilingRow<Asset>({.key = u"assetStandoffCeiling"_s,
                           .label = InspectorRows::tr("Stand-off ceiling"),
                           .toolTip = InspectorRows::tr("Above it UAVs may fly over the ring."),
                           .undoText = InspectorRows::tr("Change stand-off ceiling"),
                           .isShown =
                               [](const Scenario& scenario, const std::string&) {
                                   return scenario.asset && scenario.asset->standoff_m > 0;
                               }},
                          &Asset::standoffCeiling_m));
    rows.emplace_back(
        ActionRow{.words = {.key = u"assetRemove"_s,
                            .toolTip = InspectorRows::tr("Takes the asset off the map."),
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
        flagRow({.key = u"areaFence"_s,
                 .label = InspectorRows::tr("Geofence"),
                 .toolTip = InspectorRows::tr("UAVs that start clear of its edge stay "
                                              "inside the area."),
                 .undoText = InspectorRows::tr("Change geofence")},
                &Scenario::geofence),
        ActionRow{.words = {.key = u"areaRemove"_s,
                            .toolTip = InspectorRows::tr("Takes the area off the map."),
                            .undoText = InspectorRows::tr("Remove area")},
                  .act = [](Scenario& scenario) {
                      scenario.area_m.clear();
                      scenario.geofence = false;
                  }}};
}

std::vector<InspectorRow> noFlyRows()
{
    TextRow name = nameRow<NoFlyArea>(u"noFlyName"_s);
    name.words.toolTip = InspectorRows::tr("Shown on the map.");
    return {
        name,
        asHeight(objectRow<NoFlyArea>(
            {.key = u"noFlyFloor"_s,
             .label = InspectorRows::tr("Floor"),
             .toolTip = InspectorRows::tr("UAVs lower than this fly below it."),
             .undoText = InspectorRows::tr("Change floor of the no-fly area")},
            {}, &NoFlyArea::floor_m, limits::kLength_m, 10)),
        ceilingRow<NoFlyArea>({.key = u"noFlyCeiling"_s,
                               .label = InspectorRows::tr("Ceiling"),
                               .toolTip = InspectorRows::tr("UAVs higher than this fly above it."),
                               .undoText = InspectorRows::tr("Change ceiling of the no-fly area")},
                              &NoFlyArea::ceiling_m),
        PartRow{.words = {.key = u"noFlyRemove"_s,
                          .label = InspectorRows::tr("Outline"),
                          .toolTip = InspectorRows::tr("Takes the no-fly area off the map."),
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
                    }}};
}

} // namespace berg
