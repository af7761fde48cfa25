#include "core/io/files/run_keyframe.h"

#include "core/io/text/json_writer.h"
#include "core/scenario/limits.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace berg {

namespace {

constexpr std::array<Named<FlightMode>, 8> kModeNames{{
    {FlightMode::Idle, "idle"},
    {FlightMode::Leg, "leg"},
    {FlightMode::RunOut, "run-out"},
    {FlightMode::Circle, "circle"},
    {FlightMode::Search, "search"},
    {FlightMode::Home, "home"},
    {FlightMode::Ground, "ground"},
    {FlightMode::Hold, "hold"},
}};

/** Filter numbers of a track in the simple observer model, which are then left out. */
const std::vector<double> kPlainFilter{0, 0, 1, 0, 0};
constexpr std::size_t kPlainTrack = 8;
constexpr std::size_t kFilteredTrack = 13;
/**
 * Length with a velocity that is not constant: its mean, spread and time follow, and then the time
 * of the last sighting, because the anchor moves on without one. Older files lack that time.
 */
constexpr std::size_t kOlderFadingTrack = 17;
constexpr std::size_t kFadingTrack = 18;

std::string trackText(const Track& track)
{
    std::vector<double> numbers = trackNumbers(track);
    if (track.velocityTime_s > 0)
        numbers.insert(numbers.end(),
                       {track.mean_mps.x(), track.mean_mps.y(), track.velocitySpread_mps,
                        track.velocityTime_s, track.seen_s});
    else if (std::equal(kPlainFilter.begin(), kPlainFilter.end(), numbers.begin() + kPlainTrack))
        numbers.resize(kPlainTrack);
    return jsonArrayOf(numbers);
}

/** Reads an array of exactly `Count` numbers; anything else is a fault and gives zeros. */
template <std::size_t Count>
std::array<double, Count> readNumbers(const Json& value, const std::string& path, Faults& faults)
{
    std::array<double, Count> numbers{};
    if (!value.is_array() || value.size() != Count) {
        faults.add(path, {IssueId::EntryCount, {countOf(Count), entriesOf(value)}});
        return numbers;
    }
    for (std::size_t i = 0; i < Count; ++i)
        if (!value[i].is_number())
            faults.add(entryPath(path, i),
                       {IssueId::WrongType, {ValueKind::Number, kindOf(value[i])}});
        else
            numbers[i] = value[i].get<double>();
    return numbers;
}

Track readTrack(const Json& value, const std::string& path, Faults& faults)
{
    std::array<double, kFadingTrack> n{};
    const auto take = [&](const auto& numbers) { std::ranges::copy(numbers, n.begin()); };
    const bool isFading = value.is_array() && value.size() == kFadingTrack;
    const bool isOlderFading = value.is_array() && value.size() == kOlderFadingTrack;
    if (isFading) {
        take(readNumbers<kFadingTrack>(value, path, faults));
    } else if (isOlderFading) {
        take(readNumbers<kOlderFadingTrack>(value, path, faults));
    } else if (value.is_array() && value.size() == kFilteredTrack) {
        take(readNumbers<kFilteredTrack>(value, path, faults));
    } else {
        take(readNumbers<kPlainTrack>(value, path, faults));
        std::ranges::copy(kPlainFilter, n.begin() + kPlainTrack);
    }
    TrackStatus status = TrackStatus::Tracked;
    if (n[11] == 1 || n[11] == 2)
        status = n[11] == 1 ? TrackStatus::Lost : TrackStatus::GivenUp;
    else if (n[11] != 0)
        faults.add(entryPath(path, 11), {IssueId::NotOneOf, {"0, 1, 2"}});
    return {.anchor_m = {n[0], n[1]},
            .anchor_s = n[2],
            .seen_s = isOlderFading ? -1 : n[isFading ? kFadingTrack - 1 : 2], // -1: not recorded
            .velocity_mps = {n[3], n[4]},
            .sigma_m2 = n[5],
            .q_m2ps = n[6],
            .inView = n[7] != 0,
            .mixed_m2ps = n[8],
            .velocity_m2ps2 = n[9],
            .presence = n[10],
            .status = status,
            .left = n[12] != 0,
            .mean_mps = {n[13], n[14]},
            .velocitySpread_mps = n[15],
            .velocityTime_s = n[16]};
}

std::vector<Track> readTracks(ObjectReader& object, const RunContext& context)
{
    std::vector<Track> tracks;
    const Json* list = object.neededArray("tracks");
    if (list == nullptr)
        return tracks;
    if (list->size() < context.icebergsAtStart || list->size() > context.icebergs)
        object.faults().add(
            object.path("tracks"),
            {IssueId::EntryRange,
             {countOf(context.icebergsAtStart), countOf(context.icebergs), countOf(list->size())}});
    makeRoom(tracks, list, object.faults());
    for (std::size_t i = 0; i < list->size(); ++i) {
        Track track = readTrack((*list)[i], entryPath(object.path("tracks"), i), object.faults());
        if (!(track.velocityTime_s > 0)) // the file has no mean velocity then
            track.mean_mps = context.current_mps;
        tracks.push_back(track);
    }
    return tracks;
}

/** Reads an iceberg index of the run; anything else is a fault and gives 0. */
int icebergOf(double number, const std::string& path, Faults& faults, const RunContext& context)
{
    if (number >= 0 && number < static_cast<double>(context.icebergs) &&
        number == std::floor(number))
        return static_cast<int>(number);
    if (context.icebergs == 0)
        faults.add(path, {IssueId::NoIcebergInRun});
    else
        faults.add(path, {IssueId::NotWhole, {0, countOf(context.icebergs - 1), number}});
    return 0;
}

LosGuidance readGuidance(ObjectReader& object)
{
    LosGuidance guidance;
    if (const Json* value = object.need("guidance")) {
        const auto n = readNumbers<6>(*value, object.path("guidance"), object.faults());
        guidance.gains = {.lookahead_m = n[0], .integral_mps = n[1], .turn_1ps = n[2]};
        guidance.start_m = {n[3], n[4]};
        guidance.integral_s = n[5];
    }
    return guidance;
}

/** Reads the icebergs of a member that may be missing. */
std::vector<int> readGroup(ObjectReader& object, const char* member, const RunContext& context)
{
    std::vector<bool> seen(context.icebergs, false);
    const Json* list = object.find(member);
    return list == nullptr
               ? std::vector<int>()
               : readIcebergs(*list, object.path(member), object.faults(), context, seen);
}

std::string searchText(const Search& search)
{
    JsonObject object;
    object.add("iceberg", search.iceberg);
    object.addText("corners_m", jsonArrayOf(search.path.corners_m()));
    object.add("next", static_cast<std::int64_t>(search.path.next()));
    object.add("spread_m", search.path.spread_m());
    object.addText("chances", jsonArrayOf(search.path.chances()));
    return object.inLine();
}

std::vector<double> readList(ObjectReader& object, const char* member)
{
    std::vector<double> numbers;
    const Json* list = object.neededArray(member);
    makeRoom(numbers, list, object.faults());
    for (std::size_t i = 0; list != nullptr && i < list->size(); ++i)
        if (const auto number =
                numberOf((*list)[i], entryPath(object.path(member), i), object.faults()))
            numbers.push_back(*number);
    return numbers;
}

Search readSearch(const Json& value, const std::string& path, Faults& faults,
                  const RunContext& context)
{
    ObjectReader object(value, path, faults);
    Search search{.iceberg = asInt(object.whole("iceberg", 0, context.indices()))};
    std::vector<Point> corners_m;
    const Json* list = object.array("corners_m");
    makeRoom(corners_m, list, faults);
    for (std::size_t i = 0; list != nullptr && i < list->size(); ++i)
        if (const auto corner_m =
                pointOf((*list)[i], entryPath(object.path("corners_m"), i), faults))
            corners_m.push_back(*corner_m);
    const auto next = object.whole("next", 0, {.low = 0, .high = kLargestCount});
    const double spread_m = object.number("spread_m", 0);
    search.path = LostSearch::restored(std::move(corners_m), static_cast<std::size_t>(next),
                                       spread_m, readList(object, "chances"));
    return search;
}

/** JSON array of the parts of a return path: turn rate and number of commands, alternating. */
std::string returnPathText(const ReturnPath& path)
{
    std::vector<double> numbers;
    for (const ReturnPath::Part& part : path.parts) {
        numbers.push_back(part.rate_radps);
        numbers.push_back(static_cast<double>(part.commands));
    }
    return jsonArrayOf(numbers);
}

ReturnPath readReturnPath(const Json& value, const std::string& path, Faults& faults)
{
    ReturnPath read;
    if (!value.is_array() || value.size() % 2 != 0) {
        faults.add(path, {IssueId::WrongType, {ValueKind::Pairs, entriesOf(value)}});
        return read;
    }
    faults.take(value.size() / 2 * sizeof(ReturnPath::Part));
    for (std::size_t i = 0; i < value.size(); i += 2) {
        const auto rate_radps = numberOf(value[i], entryPath(path, i), faults);
        const auto commands = wholeOf(value[i + 1], entryPath(path, i + 1), faults,
                                      {.low = 1, .high = kLargestCount});
        if (rate_radps && commands)
            read.parts.push_back({.rate_radps = *rate_radps, .commands = *commands});
    }
    return read;
}

void addUav(JsonObject& object, const UavState& uav)
{
    object.add("position_m", uav.pose.position_m);
    object.add("psi_rad", uav.pose.psi_rad);
    object.add("u_radps", uav.u_radps);
    object.add("cross_track_m", uav.crossTrack_m);
    object.add("flown_m", uav.flown_m);
    object.add("mode", nameOf(kModeNames, uav.mode));
    object.add("target", uav.target.value_or(kNoIcebergInFile));
    object.add("last_reached", uav.lastReached.value_or(kNoIcebergInFile));
    object.addUnless("alone", uav.isAlone, false);
    object.addText("guidance", jsonArrayOf(guidanceNumbers(uav.guidance)));
    object.add("run_out_m", uav.runOut_m);
    object.add("misses", uav.misses);
    if (uav.aim)
        object.addText("aim", legText(*uav.aim));
    if (uav.search)
        object.addText("search", searchText(*uav.search));
    if (!uav.members.empty()) {
        object.addText("members", jsonArrayOf(uav.members));
        object.add("members_by_s", uav.membersBy_s);
    }
    object.addUnless("aloft_s", uav.aloft_s, 0.0);
    object.addUnless("ground_s", uav.ground_s, 0.0);
    object.addUnless("withheld_s", uav.withheld_s, 0.0);
    if (uav.via_m)
        object.add("via_m", *uav.via_m);
    if (uav.returnPath)
        object.addText("return_path", returnPathText(*uav.returnPath));
    if (uav.order != FlightOrder::None)
        object.add("order", nameOf(kFlightOrderNames, uav.order));
    object.addUnless("hold_m", uav.hold_m, Point(Point::Zero()));
}

UavState readUav(ObjectReader& object, const RunContext& context)
{
    UavState uav;
    uav.pose.position_m = object.point("position_m", Point::Zero());
    uav.pose.psi_rad = object.number("psi_rad", 0);
    uav.u_radps = object.number("u_radps", 0);
    uav.crossTrack_m = object.number("cross_track_m", 0);
    uav.flown_m = object.number("flown_m", 0, kAmount);
    uav.mode = object.choice("mode", FlightMode::Idle, kModeNames);
    uav.target = icebergOrNone(object, "target", context);
    uav.lastReached = icebergOrNone(object, "last_reached", context);
    uav.isAlone = object.boolean("alone", false);
    uav.guidance = readGuidance(object);
    uav.runOut_m = object.number("run_out_m", 0);
    uav.misses = asInt(object.whole("misses", 0, {.low = 0, .high = kLargestCount}));
    if (const Json* aim = object.find("aim"))
        uav.aim = readLeg(*aim, object.path("aim"), object.faults(), context);
    if (const Json* search = object.find("search"))
        uav.search = readSearch(*search, object.path("search"), object.faults(), context);
    uav.members = readGroup(object, "members", context);
    uav.membersBy_s = object.number("members_by_s", 0);
    uav.aloft_s = object.number("aloft_s", 0, kAmount);
    uav.ground_s = object.number("ground_s", 0, kAmount);
    uav.withheld_s = object.number("withheld_s", 0, kAmount);
    if (object.find("via_m") != nullptr)
        uav.via_m = object.point("via_m", Point::Zero());
    if (const Json* path = object.find("return_path"))
        uav.returnPath = readReturnPath(*path, object.path("return_path"), object.faults());
    uav.order = object.choice("order", FlightOrder::None, kFlightOrderNames);
    uav.hold_m = object.point("hold_m", Point::Zero());
    return uav;
}

/** Reads the UAVs after the first one, whose members stand in the keyframe itself. */
std::vector<UavState> readOtherUavs(ObjectReader& keyframe, const RunContext& context)
{
    std::vector<UavState> uavs;
    const std::string path = keyframe.path("other_uavs");
    const Json* list = keyframe.find("other_uavs");
    const std::size_t count = list != nullptr && list->is_array() ? list->size() : 0;
    if (count + 1 != context.uavs) {
        keyframe.faults().add(path,
                              {IssueId::EntryCount, {countOf(context.uavs - 1), countOf(count)}});
        return uavs;
    }
    makeRoom(uavs, list, keyframe.faults());
    for (std::size_t i = 0; i < count; ++i) {
        ObjectReader object((*list)[i], entryPath(path, i), keyframe.faults());
        uavs.push_back(readUav(object, context));
    }
    return uavs;
}

} // namespace

std::optional<int> icebergOrNone(ObjectReader& object, const char* member,
                                 const RunContext& context)
{
    const Json* const value = object.find(member);
    if (context.icebergs == 0 && value != nullptr && *value != kNoIcebergInFile) {
        object.faults().add(object.path(member), {IssueId::NoIcebergInRun});
        return std::nullopt;
    }
    const int index = asInt(object.whole(member, kNoIcebergInFile, context.indices()));
    return index == kNoIcebergInFile ? std::nullopt : std::optional(index);
}

std::vector<double> trackNumbers(const Track& track)
{
    return {track.anchor_m.x(),     track.anchor_m.y(),       track.anchor_s,
            track.velocity_mps.x(), track.velocity_mps.y(),   track.sigma_m2,
            track.q_m2ps,           track.inView ? 1.0 : 0.0, track.mixed_m2ps,
            track.velocity_m2ps2,   track.presence,           static_cast<double>(track.status),
            track.left ? 1.0 : 0.0};
}

std::vector<double> guidanceNumbers(const LosGuidance& guidance)
{
    return {guidance.gains.lookahead_m, guidance.gains.integral_mps, guidance.gains.turn_1ps,
            guidance.start_m.x(),       guidance.start_m.y(),        guidance.integral_s};
}

std::vector<double> legNumbers(const AimedLeg& leg)
{
    return {static_cast<double>(leg.iceberg),
            leg.turn_rad,
            leg.from_m.x(),
            leg.from_m.y(),
            leg.abeam_m.x(),
            leg.abeam_m.y(),
            leg.sighting_s};
}

std::string legText(const AimedLeg& leg)
{
    std::vector<double> numbers = legNumbers(leg);
    if (leg.end_s)
        numbers.push_back(*leg.end_s);
    return jsonArrayOf(numbers);
}

AimedLeg readLeg(const Json& value, const std::string& path, Faults& faults,
                 const RunContext& context)
{
    constexpr std::size_t kHoldNumbers = 8;
    const bool isHold = value.is_array() && value.size() == kHoldNumbers;
    std::array<double, kHoldNumbers> n{};
    if (isHold)
        n = readNumbers<kHoldNumbers>(value, path, faults);
    else
        std::ranges::copy(readNumbers<kHoldNumbers - 1>(value, path, faults), n.begin());
    return {.iceberg = icebergOf(n[0], entryPath(path, 0), faults, context),
            .turn_rad = n[1],
            .from_m = {n[2], n[3]},
            .abeam_m = {n[4], n[5]},
            .sighting_s = n[6],
            .end_s = isHold ? std::optional(n[7]) : std::nullopt};
}

std::vector<int> readIcebergs(const Json& value, const std::string& path, Faults& faults,
                              const RunContext& context, std::vector<bool>& seen)
{
    std::vector<int> icebergs;
    if (!value.is_array()) {
        faults.add(path, {IssueId::WrongType, {ValueKind::Array, kindOf(value)}});
        return icebergs;
    }
    makeRoom(icebergs, &value, faults);
    const WholeLimits indices{.low = 0, .high = context.indices().high};
    if (context.icebergs == 0 && !value.empty()) {
        faults.add(path, {IssueId::NoIcebergInRun});
        return icebergs;
    }
    for (std::size_t k = 0; k < value.size(); ++k) {
        const std::string entry = entryPath(path, k);
        const std::optional<std::int64_t> iceberg = wholeOf(value[k], entry, faults, indices);
        if (!iceberg)
            continue;
        const auto i = static_cast<std::size_t>(*iceberg);
        if (seen[i])
            faults.add(entry, {IssueId::IcebergTwice});
        seen[i] = true;
        icebergs.push_back(asInt(*iceberg));
    }
    return icebergs;
}

std::string keyframeText(const WorldState& state)
{
    JsonObject object;
    object.add("step", state.step);
    addUav(object, state.uavs.front());
    object.add("sigma_sum_m2", state.sigmaSum_m2);
    object.add("zeta_m2s", state.zeta_m2s);
    if (!state.unclustered.empty())
        object.addText("apart", jsonArrayOf(state.unclustered));
    if (!state.givenUp.empty())
        object.addText("given_up", jsonLines(textsOf(state.givenUp, searchText), 2));
    if (state.closest_m)
        object.add("closest_m", *state.closest_m);
    std::vector<std::string> others;
    for (std::size_t i = 1; i < state.uavs.size(); ++i) {
        JsonObject other;
        addUav(other, state.uavs[i]);
        others.push_back(other.inLine());
    }
    if (!others.empty())
        object.addText("other_uavs", jsonLines(others, 2));
    object.addText("tracks", jsonLines(textsOf(state.tracks, trackText), 2));
    return object.inLine();
}

WorldState readKeyframe(const Json& value, const std::string& path, Faults& faults,
                        const RunContext& context)
{
    ObjectReader object(value, path, faults);
    WorldState state;
    if (object.need("step") != nullptr)
        state.step = object.whole("step", 0, {.low = 0, .high = context.lastStep});
    faults.take(sizeof(UavState));
    state.uavs.push_back(readUav(object, context));
    std::vector<UavState> others = readOtherUavs(object, context);
    state.uavs.reserve(1 + others.size());
    std::ranges::move(others, std::back_inserter(state.uavs));
    state.sigmaSum_m2 = object.number("sigma_sum_m2", 0, kAmount);
    state.zeta_m2s = object.number("zeta_m2s", 0, kAmount);
    state.unclustered = readGroup(object, "apart", context);
    state.givenUp = readEach(object, "given_up", [&](const Json& search, const std::string& at) {
        return readSearch(search, at, faults, context);
    });
    state.closest_m = object.optionalNumber("closest_m", kAmount);
    state.tracks = readTracks(object, context);
    return state;
}

std::string fixText(const PoseFix& fix)
{
    JsonObject object;
    object.add("time_s", fix.time_s);
    object.addUnless("uav", fix.uav, 0);
    object.add("position_m", fix.pose.position_m);
    object.add("psi_rad", fix.pose.psi_rad);
    object.addUnless("measured", fix.isMeasured, true);
    object.addUnless("first", fix.isFirst, false);
    return object.inLine();
}

std::vector<PoseFix> readFixes(ObjectReader& run, const RunContext& context)
{
    std::vector<double> last_s(std::max<std::size_t>(1, context.uavs), 0);
    return readEach(run, "fixes", [&](const Json& value, const std::string& path) {
        ObjectReader object(value, path, run.faults());
        PoseFix fix;
        fix.uav = asInt(object.whole(
            "uav", 0, {.low = 0, .high = static_cast<std::int64_t>(context.uavs) - 1}));
        double& before_s = last_s[static_cast<std::size_t>(fix.uav)];
        fix.isFirst = object.boolean("first", false);
        fix.time_s = object.number("time_s", before_s, limits::kTime_s);
        if (fix.time_s <= before_s)
            object.faults().add(object.path("time_s"), {IssueId::NotRising});
        if (before_s == 0 && !fix.isFirst)
            object.faults().add(object.path("first"), {IssueId::NotOneOf, {"true"}});
        before_s = std::max(before_s, fix.time_s);
        fix.pose.position_m = object.point("position_m", Point::Zero());
        fix.pose.psi_rad = object.number("psi_rad", 0, Limits{.low = -4, .high = 4});
        fix.isMeasured = object.boolean("measured", true);
        return fix;
    });
}

} // namespace berg
