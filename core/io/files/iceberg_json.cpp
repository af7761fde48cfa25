#include "core/io/files/iceberg_json.h"

#include "core/checks/validate.h"
#include "core/io/files/scenario_parts.h"

namespace berg {

namespace {

constexpr std::string_view kFormat = "bergwatch-icebergs";

/**
 * Adds the errors that the icebergs would have in a scenario, apart from their ids and assigned
 * UAVs.
 */
void addFindings(std::vector<Iceberg> icebergs, Faults& faults)
{
    Scenario scenario;
    scenario.uavs.push_back({.id = "uav-1"});
    for (std::size_t i = 0; i < icebergs.size(); ++i) {
        icebergs[i].id = "berg-" + std::to_string(i + 1);
        icebergs[i].uav.clear();
    }
    scenario.icebergs = std::move(icebergs);
    for (Issue& issue : validate(scenario))
        if (issue.severity == Severity::Error && !faults.has(issue.field))
            faults.add(std::move(issue));
}

} // namespace

std::string icebergsToJson(std::span<const Iceberg> icebergs)
{
    JsonObject object;
    object.add("format", kFormat);
    object.add("version", 1);
    object.addText("icebergs", jsonLines(textsOf(icebergs, &objectText<Iceberg>), 1));
    return object.inLines(0) + '\n';
}

std::vector<Iceberg> icebergsFromJson(std::string_view text, const std::string& subject,
                                      const std::stop_token& stop)
{
    if (text.size() > kLargestIcebergText)
        throw Error(ErrorCode::FileTooLarge, subject,
                    {IssueId::TextTooLarge, {countOf(kLargestIcebergText >> 20U)}});
    ReadBudget budget(subject, text.size(), stop);
    ParsedJson file = parseJson(text, budget);
    requireFormat(file, kFormat, subject);
    ObjectReader object(file.root, "", file.faults);
    std::vector<Iceberg> icebergs;
    if (const Json* list = object.neededArray("icebergs")) {
        if (list->size() > kMostIcebergs)
            file.faults.add("icebergs", {IssueId::IcebergCount,
                                         {countOf(kMostIcebergs), countOf(list->size())}});
        else
            for (std::size_t i = 0; i < list->size(); ++i)
                icebergs.push_back(
                    readObject<Iceberg>((*list)[i], entryPath("icebergs", i), file.faults));
    }
    addFindings(icebergs, file.faults);
    file.faults.throwIfAny(subject);
    return icebergs;
}

} // namespace berg
