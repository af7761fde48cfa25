// Data for an application for a permit: the operation volume and the fields people fill in.

#include "core/permit/airspace.h"
#include "core/permit/operation.h"
#include "widgets/panels/inspector/field_inputs.h"
#include "widgets/theme/quantity_text.h"
#include "widgets/words/issue_text.h"

using namespace Qt::StringLiterals;

namespace berg {
namespace {

bool hasOperation(const Scenario& scenario, const std::string& /*id*/)
{
    return scenario.operation.has_value();
}

/** Converts airspace that the operation may enter into no-fly areas. */
void closeEnteredAirspace(Scenario& scenario)
{
    std::vector<AirspaceArea> left;
    std::vector<bool> isEntered(scenario.airspace.size(), false);
    for (const Issue& issue : airspaceIssues(scenario))
        isEntered[issueIndex(issue, "airspace").value()] = true;
    for (std::size_t i = 0; i < scenario.airspace.size(); ++i) {
        AirspaceArea& area = scenario.airspace[i];
        if (isEntered[i] && scenario.noFly.size() < kMostNoFlyAreas)
            scenario.noFly.push_back({.name = titleOf(area),
                                      .corners_m = std::move(area.corners_m),
                                      .floor_m = area.floor_m,
                                      .ceiling_m = area.ceiling_m});
        else
            left.push_back(std::move(area));
    }
    scenario.airspace = std::move(left);
}

std::vector<InspectorRow> airspaceActions()
{
    const auto hasAirspace = [](const Scenario& scenario, const std::string& /*id*/) {
        return !scenario.airspace.empty();
    };
    return {
        ActionRow{.words = {.key = u"airspaceClose"_s,
                            .toolTip =
                                InspectorRows::tr("Makes airspace that the operation may enter "
                                                  "no-fly areas, so that the UAVs stay out of it."),
                            .undoText = InspectorRows::tr("Make entered airspace no-fly areas"),
                            .isShown =
                                [](const Scenario& scenario, const std::string& /*id*/) {
                                    return !scenario.uavs.empty() &&
                                           !airspaceIssues(scenario).empty();
                                }},
                  .act = &closeEnteredAirspace},
        ActionRow{.words = {.key = u"airspaceRemove"_s,
                            .toolTip = InspectorRows::tr("Removes all airspace. Undo restores it."),
                            .undoText = InspectorRows::tr("Remove airspace"),
                            .isShown = hasAirspace},
                  .act = [](Scenario& scenario) { scenario.airspace.clear(); }}};
}

} // namespace

std::vector<InspectorRow> permitRows()
{
    std::vector<InspectorRow> rows{
        FlagRow{.words = {.key = u"scenarioOperation"_s,
                          .label = InspectorRows::tr("Operation volume"),
                          .toolTip = InspectorRows::tr(
                              "Proposed volume for a permit application; check it with your "
                              "authority. Shown on the map, in KML and GeoJSON, and on a second "
                              "page of the flight brief."),
                          .undoText = InspectorRows::tr("Change operation")},
                .read = hasOperation,
                .write =
                    [](Scenario& scenario, const std::string&, bool on) {
                        scenario.operation = on ? std::optional(Operation()) : std::nullopt;
                    }},
        InfoRow{.key = u"operationWidths"_s,
                .text = [](const Scenario& scenario, const std::string&, const QLocale& locale) {
                    if (!scenario.operation || scenario.uavs.empty())
                        return QString();
                    const OperationVolume volume = operationVolume(scenario, *scenario.operation);
                    const auto metres = [&](double length_m) {
                        return distanceText(length_m, locale, 3, DistanceUnit::Metric);
                    };
                    return InspectorRows::tr("Contingency volume %1 wide, %2 high\nGround-risk "
                                             "buffer %3\nAdjacent area %4")
                        .arg(metres(volume.outside_m), heightText(volume.ceiling_m, locale),
                             metres(volume.buffer_m), metres(volume.adjacent_m));
                }}};
    append(rows, FieldInputs<Operation>("operation.", hasOperation).rows("margin_m", "checklist"));
    rows.emplace_back(
        InfoRow{.key = u"scenarioAirspace"_s,
                .text = [](const Scenario& scenario, const std::string&, const QLocale& locale) {
                    QStringList lines;
                    for (const AirspaceArea& area : scenario.airspace)
                        lines << InspectorRows::tr("Airspace %1: %2")
                                     .arg(QString::fromStdString(titleOf(area)),
                                          heightsText(area.floor_m, area.ceiling_m, locale));
                    constexpr qsizetype kMost = 8;
                    if (lines.size() > kMost) {
                        const qsizetype more = lines.size() - kMost;
                        lines.resize(kMost);
                        lines << InspectorRows::tr("and %1 more").arg(more);
                    }
                    return lines.join(u'\n');
                }});
    append(rows, airspaceActions());
    return rows;
}

} // namespace berg
