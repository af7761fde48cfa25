#include "core/io/import/scenario/import_scenario.h"

#include "core/base/error.h"
#include "core/base/stopped.h"
#include "core/base/translate_noop.h"
#include "core/checks/validate.h"
#include "core/io/import/scenario/import_icebergs.h"
#include "core/io/import/scenario/import_origin.h"
#include "core/io/import/scenario/import_scene_merge.h"
#include "core/io/import/scenario/import_selection.h"
#include "core/scenario/text_checks.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace berg {

namespace {

bool holdsPlaces(const Scenario& scenario)
{
    return !scenario.icebergs.empty() || scenario.asset || !scenario.area_m.empty() ||
           !scenario.noFly.empty();
}

/**
 * Whether the location of the scenario is fixed, by its objects or by an origin from which the
 * sightings around `centre` are within reach.
 */
bool isPlaced(const Scenario& scenario, const LatLon& centre)
{
    if (holdsPlaces(scenario))
        return true;
    const Point centre_m = LocalFrame(scenario.origin).toPlane(centre);
    return scenario.origin != Scenario().origin &&
           centre_m.cwiseAbs().maxCoeff() <= kLargestCoordinate_m;
}

void checkOptions(const Scenario& base, const ImportOptions& options)
{
    std::vector<Issue> issues;
    const auto check = [&](const char* field, double value, const Limits& limits) {
        if (std::optional<IssueReason> fault = outOfLimits(value, limits))
            issues.push_back({Severity::Error, field, std::move(*fault)});
    };
    check("position error", options.positionSd_m.value_or(0), limits::kLength_m);
    check("drift error", options.statedDriftSd_mps, limits::kSpeed_mps);
    check("drift variation", options.track.drift.velocitySpread_mps, limits::kSpeed_mps);
    check("drift time", options.track.drift.velocityTime_s, limits::kTime_s);
    check("q", options.q_m2ps, limits::kGrowth_m2ps);
    check("window", options.track.window_s, limits::kTime_s);
    check("tolerance", options.tolerance_m, limits::kLength_m);
    if (options.area) {
        check("area: south", options.area->south_deg, limits::kLatitude_deg);
        check("area: north", options.area->north_deg, {.low = options.area->south_deg, .high = 90});
        check("area: west", options.area->west_deg, {.low = -180, .high = 360});
        check("area: east", options.area->east_deg, {.low = -180, .high = 360});
    }
    if (options.since && options.until && *options.since > *options.until)
        issues.push_back({Severity::Error, "until", {IssueId::BeforeOther, {FieldPath{"since"}}}});
    if (options.moveOrigin.value_or(false) && holdsPlaces(base))
        issues.push_back({Severity::Error, "origin", {IssueId::OriginHeld}});
    if (!issues.empty())
        throw Error(ErrorCode::InvalidInput, "import", std::move(issues));
}

void moveBy(Point& position_m, const Point& path_m, const std::string& who)
{
    position_m += path_m;
    if (!onPlane(position_m))
        throw Error(ErrorCode::InvalidInput, "import",
                    {{Severity::Error, "at", {IssueId::OffPlane, {printable(who)}}}});
}

/** Moves the objects of the scenario to a start `later_s` later. */
void moveStart(Scenario& scenario, double later_s)
{
    for (Iceberg& iceberg : scenario.icebergs) {
        // The distance backwards equals that forwards, because the earlier velocity is not known
        // either.
        const double carried_s =
            std::copysign(carriedFor_s(iceberg.velocityTime_s, std::abs(later_s)), later_s);
        moveBy(iceberg.position_m,
               iceberg.velocity_mps * carried_s + scenario.current_mps * later_s, iceberg.id);
        if (iceberg.velocityTime_s > 0)
            iceberg.velocity_mps *= std::exp(-std::max(0.0, later_s) / iceberg.velocityTime_s);
        iceberg.observed_s = std::clamp(iceberg.observed_s + later_s, 0.0, kLargestTime_s);
        iceberg.appears_s = std::clamp(iceberg.appears_s - later_s, 0.0, kLargestTime_s);
        for (double& time_s : iceberg.track.time_s)
            time_s -= later_s;
    }
    if (scenario.asset)
        moveBy(scenario.asset->position_m, scenario.asset->velocity_mps * later_s,
               scenario.asset->name);
}

/** Leaves out new icebergs for which the scenario has no room; those sighted last stay. */
void makeRoom(std::vector<IcebergEntry>& entries, std::size_t there)
{
    std::vector<IcebergEntry*> added;
    for (IcebergEntry& entry : entries)
        if (entry.report.outcome == ImportOutcome::Added)
            added.push_back(&entry);
    const std::size_t room = kMostIcebergs - std::min(there, kMostIcebergs);
    if (added.size() <= room)
        return;
    std::stable_sort(added.begin(), added.end(), [](const IcebergEntry* a, const IcebergEntry* b) {
        return a->report.age_s < b->report.age_s;
    });
    for (std::size_t i = room; i < added.size(); ++i) {
        added[i]->report.outcome = ImportOutcome::LeftOut;
        added[i]->report.notes = {ImportNote::TooMany};
    }
}

std::vector<IcebergEntry> entriesOf(const std::vector<SightedIceberg>& icebergs,
                                    const Scenario& scenario, const ImportOptions& options,
                                    const std::stop_token& stop)
{
    const LocalFrame frame(scenario.origin);
    const IcebergInputs inputs{.options = options,
                               .frame = frame,
                               .current_mps = scenario.current_mps,
                               .hasStart = !scenario.startUtc.empty()};
    std::map<std::string, const Iceberg*, std::less<>> known;
    for (const Iceberg& iceberg : scenario.icebergs)
        known.emplace(iceberg.id, &iceberg);
    std::set<std::string, std::less<>> aircraft;
    for (const Uav& uav : scenario.uavs)
        aircraft.insert(uav.id);
    std::vector<IcebergEntry> entries;
    for (const SightedIceberg& iceberg : icebergs) {
        throwIfStopped(stop);
        const auto it = known.find(iceberg.id);
        entries.push_back(entryOf(iceberg, it == known.end() ? nullptr : it->second, inputs));
        if (aircraft.contains(iceberg.id)) {
            entries.back().report.outcome = ImportOutcome::LeftOut;
            entries.back().report.notes = {ImportNote::IdTaken};
        }
    }
    makeRoom(entries, scenario.icebergs.size());
    return entries;
}

/** Applies the objects of the file other than icebergs. */
void addScene(const FileScene& scene, const std::vector<SightedIceberg>& icebergs, bool inUse,
              ImportResult& result)
{
    if (scene.isEmpty())
        return;
    if (inUse) {
        addFinding(result.scene, SceneNote::InUse);
        return;
    }
    std::set<std::string, std::less<>> ids;
    for (const SightedIceberg& iceberg : icebergs)
        ids.insert(iceberg.id);
    applyScene(scene, ids, result);
}

/** Puts the entries into the scenario and counts them. */
void applyEntries(std::vector<IcebergEntry> entries, ImportResult& result)
{
    std::map<std::string, std::size_t, std::less<>> rows;
    for (std::size_t i = 0; i < result.scenario.icebergs.size(); ++i)
        rows.emplace(result.scenario.icebergs[i].id, i);
    for (IcebergEntry& entry : entries) {
        const bool isTaken = entry.report.outcome == ImportOutcome::Added ||
                             entry.report.outcome == ImportOutcome::Updated;
        const bool isUnsure = entry.iceberg.velocitySd_mps > 0 || entry.iceberg.velocityTime_s > 0;
        if (isTaken && isUnsure && result.scenario.observer.model == ObserverModel::Simple) {
            result.scenario.observer.model = ObserverModel::Kalman;
            result.observerSet = true;
        }
        switch (entry.report.outcome) {
        case ImportOutcome::Added:
            ++result.added;
            result.scenario.icebergs.push_back(std::move(entry.iceberg));
            break;
        case ImportOutcome::Updated:
            ++result.updated;
            result.scenario.icebergs[rows.at(entry.report.id)] = std::move(entry.iceberg);
            break;
        case ImportOutcome::Unchanged:
            ++result.unchanged;
            break;
        case ImportOutcome::LeftOut:
            ++result.leftOut;
            break;
        }
        result.icebergs.push_back(std::move(entry.report));
    }
}

} // namespace

std::string importNoteText(ImportNote note)
{
    static constexpr std::array<Named<ImportNote>, 19> kTexts{{
        {ImportNote::VelocityUnknown, QT_TRANSLATE_NOOP("IssueText", "velocity unknown")},
        {ImportNote::TimeUnknown,
         QT_TRANSLATE_NOOP("IssueText", "no time: counts as seen at the start")},
        {ImportNote::VelocityGiven, QT_TRANSLATE_NOOP("IssueText", "velocity from the file")},
        {ImportNote::VelocityClamped,
         QT_TRANSLATE_NOOP("IssueText", "velocity limited to 5 m/s per axis")},
        {ImportNote::GrowthEstimated, QT_TRANSLATE_NOOP("IssueText", "q estimated")},
        {ImportNote::GrowthClamped, QT_TRANSLATE_NOOP("IssueText", "q limited to 10⁶ m²/s")},
        {ImportNote::Stationary, QT_TRANSLATE_NOOP("IssueText", "stationary")},
        {ImportNote::Repeated, QT_TRANSLATE_NOOP("IssueText", "several sightings at one time")},
        {ImportNote::Jumped,
         QT_TRANSLATE_NOOP("IssueText", "sightings at impossible places not used")},
        {ImportNote::TrackAttached, QT_TRANSLATE_NOOP("IssueText", "recorded track attached")},
        {ImportNote::NoTrack,
         QT_TRANSLATE_NOOP("IssueText", "no track: not sighted after the start")},
        {ImportNote::Older, QT_TRANSLATE_NOOP("IssueText", "older than what the scenario has")},
        {ImportNote::SeenLater, QT_TRANSLATE_NOOP("IssueText", "sighted only after the start")},
        {ImportNote::DriftedAway,
         QT_TRANSLATE_NOOP("IssueText", "more than 1000 km from the origin at the start")},
        {ImportNote::TooMany, QT_TRANSLATE_NOOP("IssueText", "the scenario is full")},
        {ImportNote::IdTaken, QT_TRANSLATE_NOOP("IssueText", "a UAV has this id")},
        {ImportNote::Contradicted,
         QT_TRANSLATE_NOOP("IssueText", "the file's drift contradicts the positions: not used")},
        {ImportNote::TooFast, QT_TRANSLATE_NOOP("IssueText", "faster than 1.5 m/s")},
        {ImportNote::OnLand, QT_TRANSLATE_NOOP("IssueText", "on land")},
    }};
    return nameOf(kTexts, note);
}

bool isDoubtful(const ImportedIceberg& iceberg)
{
    const bool isTaken =
        iceberg.outcome == ImportOutcome::Added || iceberg.outcome == ImportOutcome::Updated;
    return isTaken && std::ranges::any_of(iceberg.notes, [](ImportNote note) {
               return note == ImportNote::TooFast || note == ImportNote::OnLand;
           });
}

bool needsConsent(const ImportResult& result)
{
    return std::ranges::any_of(result.icebergs, isDoubtful);
}

Scenario newScenarioForImport(std::string name)
{
    Scenario scenario;
    scenario.name = std::move(name);
    Uav uav;
    uav.id = "uav-1";
    scenario.uavs.push_back(uav);
    return scenario;
}

ImportResult importSightings(const Scenario& base, const SightingTable& table,
                             const ImportOptions& options, const std::stop_token& stop)
{
    checkOptions(base, options);
    ImportOptions resolved = options;
    resolved.positionSd_m = options.positionSd_m.value_or(table.positionSd_m);
    ImportResult result;
    result.scenario = base;
    result.rejected = table.rejected;
    result.noted = table.noted;
    result.outside.place = table.rejected.place;
    std::vector<const Sighting*> sightings = selected(table, options, result);
    result.at = startOf(base, sightings, options);
    if (result.at) {
        if (const std::optional<UtcTime> before = parseUtc(base.startUtc);
            before && *before != *result.at)
            moveStart(result.scenario, secondsBetween(*before, *result.at));
        result.scenario.startUtc = utcText(*result.at, 0);
        if (!options.withTracks)
            leaveOutLater(sightings, *result.at, result);
    }
    std::vector<SightedIceberg> icebergs = grouped(sightings, table, result.at, stop);
    leaveOutUntimed(icebergs, result.rejected);
    if (options.moveOrigin.value_or(true))
        if (const std::optional<LatLon> centre = originOf(icebergs, stop);
            centre && (options.moveOrigin || !isPlaced(base, *centre)))
            result.scenario.origin = *centre;
    place(icebergs, LocalFrame(result.scenario.origin), result, stop);
    addScene(table.scene, icebergs, holdsPlaces(base), result);
    applyEntries(entriesOf(icebergs, result.scenario, resolved, stop), result);

    std::vector<Issue> issues = validate(result.scenario);
    const std::vector<Issue> before = validate(base); // earlier errors are not the import's
    std::erase_if(issues, [&](const Issue& issue) {
        return issue.severity != Severity::Error ||
               std::ranges::find(before, issue) != before.end();
    });
    if (!issues.empty())
        throw Error(ErrorCode::InvalidInput, "import", std::move(issues));
    return result;
}

} // namespace berg
