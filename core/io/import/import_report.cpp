#include "core/io/import/airspace/import_airspace.h"
#include "core/io/import/scenario/import_scenario.h"
#include "core/io/text/json_writer.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace berg {

namespace {

constexpr std::array<Named<ImportOutcome>, 4> kOutcomeNames{{
    {ImportOutcome::Added, "added"},
    {ImportOutcome::Updated, "updated"},
    {ImportOutcome::Unchanged, "unchanged"},
    {ImportOutcome::LeftOut, "left-out"},
}};

std::string icebergText(const ImportedIceberg& imported, const Iceberg* iceberg)
{
    JsonObject object;
    object.add("id", imported.id);
    object.add("outcome", nameOf(kOutcomeNames, imported.outcome));
    object.add("sightings", imported.sightings);
    object.add("used", imported.used);
    object.add("age_s", imported.age_s);
    if (iceberg != nullptr) {
        object.add("velocity_mps", iceberg->velocity_mps);
        object.add("velocity_sd_mps", iceberg->velocitySd_mps);
        object.add("velocity_from", nameOf(kVelocitySourceNames, imported.velocityFrom));
        if (imported.velocityFrom != VelocitySource::Nothing)
            object.add("velocity_age_s", imported.velocityAge_s);
        object.add("sd_m", std::sqrt(initialSigma_m2(*iceberg)));
        object.add("q_m2ps", iceberg->q_m2ps);
    }
    object.addText("notes", jsonArrayOf(textsOf(imported.notes, importNoteText)));
    return object.inLine();
}

std::string findingText(const SceneFinding& finding)
{
    JsonObject object;
    object.add("note", sceneFindingText(finding));
    object.add("count", finding.count);
    return object.inLine();
}

std::string rowText(const RejectedRow& row)
{
    JsonObject object;
    object.add("line", row.line); // or feature, packet: `Rejections::place`
    object.add("reason", englishText(reasonOf(row)));
    return object.inLine();
}

std::string originText(const LatLon& origin)
{
    JsonObject object;
    object.add("latitude_deg", origin.latitude_deg);
    object.add("longitude_deg", origin.longitude_deg);
    return object.inLine();
}

} // namespace

std::string rowsJson(const Rejections& rows)
{
    return jsonLines(textsOf(rows.first, rowText), 1);
}

std::string importJson(const SightingTable& table, const ImportResult& result,
                       const std::string& photographs)
{
    std::map<std::string, const Iceberg*> byId;
    for (const Iceberg& iceberg : result.scenario.icebergs)
        byId.emplace(iceberg.id, &iceberg);
    std::vector<std::string> icebergs;
    for (const ImportedIceberg& imported : result.icebergs) {
        const auto it = byId.find(imported.id);
        const bool taken = imported.outcome != ImportOutcome::LeftOut && it != byId.end();
        icebergs.push_back(icebergText(imported, taken ? it->second : nullptr));
    }

    JsonObject object;
    object.add("format", table.format);
    object.add("sightings", table.sightings.size());
    if (!photographs.empty())
        object.addText("photographs", photographs);
    object.add("rejected", result.rejected.count);
    object.add("noted", result.noted.count);
    object.add("outside_area", result.outsideArea);
    object.add("outside_time", result.outsideTime);
    object.add("added", result.added);
    object.add("updated", result.updated);
    object.add("unchanged", result.unchanged);
    object.add("left_out", result.leftOut);
    object.add("needs_consent", needsConsent(result));
    if (result.at)
        object.add("start_utc", result.scenario.startUtc);
    else
        object.addText("start_utc", "null");
    object.addText("origin", originText(result.scenario.origin));
    object.addText("unused_columns", jsonArrayOf(table.unused));
    object.addText("scene", jsonLines(textsOf(result.scene, findingText), 1));
    object.addText("icebergs", jsonLines(icebergs, 1));
    object.addText("rejected_rows", rowsJson(result.rejected));
    object.addText("noted_rows", rowsJson(result.noted));
    object.addText("outside_rows", rowsJson(result.outside));
    return object.inLines(0) + '\n';
}

std::string airspaceJson(const AirspaceResult& result)
{
    JsonObject object;
    object.add("added", result.added);
    object.add("known", result.known);
    object.add("far", result.far);
    object.add("too_many", result.tooMany);
    object.add("rejected", result.rejected.count);
    object.add("noted", result.noted.count);
    object.addText("not_needed_areas", rowsJson(result.notNeeded));
    object.addText("rejected_rows", rowsJson(result.rejected));
    object.addText("noted_rows", rowsJson(result.noted));
    return object.inLines(0) + '\n';
}

} // namespace berg
