// What an application for a permit is made of: the operation volume and what people fill in.

#include "core/scenario/airspace.h"
#include "core/scenario/operation.h"
#include "widgets/panels/inspector/inspector_row_makers.h"
#include "widgets/theme/quantity_text.h"
#include "widgets/words/issue_text.h"

using namespace Qt::StringLiterals;

namespace berg {
namespace {

bool hasOperation(const Scenario& scenario, const std::string& /*id*/)
{
    return scenario.operation.has_value();
}

struct NumberWords
{
    QString label;
    QString toolTip;
    QString unit;
};

/** By their order in `kOperationNumbers`. */
std::array<NumberWords, kOperationNumbers.size()> numberWords()
{
    return {
        {{InspectorRows::tr("Margin"),
          InspectorRows::tr("Round all places that a plan may lead to, for turns and changes "
                            "of the plan. With a geofence it is not used."),
          u" m"_s},
         {InspectorRows::tr("UAV size"),
          InspectorRows::tr("Largest dimension of a UAV, half of it widens the ground-risk "
                            "buffer."),
          u" m"_s},
         {InspectorRows::tr("Satellite position error"),
          InspectorRows::tr("Part of the width of the contingency volume. Source: Digisky "
                            "3.3.0, after the guide of the Swiss FOCA: 3 m."),
          u" m"_s},
         {InspectorRows::tr("Path-keeping error"),
          InspectorRows::tr("Of the autopilot, likewise. Same source: 3 m."), u" m"_s},
         {InspectorRows::tr("Map error"), InspectorRows::tr("Likewise. Same source: 1 m."),
          u" m"_s},
         {InspectorRows::tr("Reaction time"),
          InspectorRows::tr("At full speed until something is done. Same source: 1 s."), u" s"_s},
         {InspectorRows::tr("Bank of the turn back"),
          InspectorRows::tr("Radius v²/(g tan bank). Same source: 30°."), u"°"_s},
         {InspectorRows::tr("Height error"),
          InspectorRows::tr("Part of the height of the contingency volume. Same source: 4 m."),
          u" m"_s},
         {InspectorRows::tr("Climb part"),
          InspectorRows::tr("Part of the speed that leads upwards during the reaction time. "
                            "Same source: 0.707, a climb of 45°."),
          {}},
         {InspectorRows::tr("Pull-up part"),
          InspectorRows::tr("Part of v²/g that levelling out takes. Same source: 0.3."),
          {}},
         {InspectorRows::tr("Buffer ratio"),
          InspectorRows::tr("Width of the ground-risk buffer by the height of the contingency "
                            "volume. Same source: 1, the rule 1:1."),
          {}},
         {InspectorRows::tr("Adjacent area, time"),
          InspectorRows::tr("Of flight at full speed. Same source: 180 s."), u" s"_s},
         {InspectorRows::tr("Adjacent area, least"), InspectorRows::tr("Same source: 5 km."),
          u" m"_s},
         {InspectorRows::tr("Adjacent area, most"), InspectorRows::tr("Same source: 35 km."),
          u" m"_s}}};
}

struct TextWords
{
    QString label;
    QString toolTip;
    bool isLong = false;
};

/** By their order in `kOperationTexts`. */
std::array<TextWords, kOperationTexts.size()> textWords()
{
    return {
        {{InspectorRows::tr("Crew"),
          InspectorRows::tr("Who flies, printed in the flight brief; empty: a blank line."), true},
         {InspectorRows::tr("Call sign"), InspectorRows::tr("Likewise.")},
         {InspectorRows::tr("Contacts"),
          InspectorRows::tr("Ship, air traffic service, rescue: names, numbers, frequencies."),
          true},
         {InspectorRows::tr("Command link"),
          InspectorRows::tr("How the UAVs are commanded, and what they do without it."), true},
         {InspectorRows::tr("Checklist"),
          InspectorRows::tr("One line for each item, printed with a box to tick."), true}}};
}

RowWords rowWords(std::string_view name, const QString& label, const QString& toolTip)
{
    return {.key = u"operation_"_s + QLatin1StringView(name.data(), qsizetype(name.size())),
            .label = label,
            .toolTip = toolTip,
            .undoText = InspectorRows::tr("Change operation"),
            .isShown = hasOperation};
}

/** What is only told of becomes what is kept out of, as far as the operation enters it. */
void closeEnteredAirspace(Scenario& scenario)
{
    std::vector<AirspaceArea> left;
    std::vector<bool> isEntered(scenario.airspace.size(), false);
    for (const Issue& issue : airspaceIssues(scenario))
        isEntered[static_cast<std::size_t>(issueIndex(issue, "airspace"))] = true;
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
    return {ActionRow{.words = {.key = u"airspaceClose"_s,
                                .toolTip = InspectorRows::tr(
                                    "Airspace that the operation may enter becomes no-fly areas: "
                                    "then the UAVs keep out of it."),
                                .undoText = InspectorRows::tr("Make entered airspace no-fly areas"),
                                .isShown =
                                    [](const Scenario& scenario, const std::string& /*id*/) {
                                        return !scenario.uavs.empty() &&
                                               !airspaceIssues(scenario).empty();
                                    }},
                      .act = &closeEnteredAirspace},
            ActionRow{.words = {.key = u"airspaceRemove"_s,
                                .toolTip = InspectorRows::tr("All of it; undo brings it back."),
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
                              "Proposal for an application for a permit, to be checked with your "
                              "authority: on the map, in KML and GeoJSON, and as a second page of "
                              "the flight brief."),
                          .undoText = InspectorRows::tr("Change operation")},
                .read = [](const Scenario& scenario) { return scenario.operation.has_value(); },
                .write =
                    [](Scenario& scenario, bool on) {
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
    const auto numbers = numberWords();
    for (std::size_t i = 0; i < kOperationNumbers.size(); ++i) {
        const auto& [name, member, limits] = kOperationNumbers[i];
        NumberRow row =
            numberRow(rowWords(name, numbers[i].label, numbers[i].toolTip), numbers[i].unit,
                      ofPart(&Scenario::operation, member), always(limits));
        row.decimals = {.least = 0, .most = 3};
        rows.emplace_back(row);
    }
    const auto texts = textWords();
    for (std::size_t i = 0; i < kOperationTexts.size(); ++i) {
        const auto& [name, member] = kOperationTexts[i];
        TextRow row = textRow(rowWords(name, texts[i].label, texts[i].toolTip),
                              ofPart(&Scenario::operation, member));
        row.multiLine = texts[i].isLong;
        rows.emplace_back(row);
    }
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
