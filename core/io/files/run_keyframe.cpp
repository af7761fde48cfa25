#include "core/io/files/run_keyframe.h"

#include "core/io/text/json_writer.h"
#include "core/scenario/limits.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <iterator>

namespace berg {

namespace {

constexpr std::size_t kPlainTrack = 8;
constexpr std::size_t kFilteredTrack = 13;
/**
 * Length with a velocity that is not constant, or a mean that follows wind and current: its mean,
 * spread and time follow, and then the time of the last sighting, because the anchor moves on
 * without one. Older files lack that time.
 */
constexpr std::size_t kOlderFadingTrack = 17;
constexpr std::size_t kFadingTrack = 18;
constexpr std::size_t kLegNumbers = 7;

/** Sets the values that a function names to the numbers of an array, one after the other. */
struct NumberReader
{
    std::vector<double> numbers;
    const std::string& path;
    Faults& faults;
    const RunContext& context;
    std::size_t at = 0;

    void operator()(double& value) { value = numbers[at++]; }
    void operator()(bool& value) { value = numbers[at++] != 0; }
    void operator()(Point& value)
    {
        (*this)(value.x());
        (*this)(value.y());
    }
    void operator()(TrackStatus& value)
    {
        for (const auto status : {TrackStatus::Tracked, TrackStatus::Lost, TrackStatus::GivenUp})
            if (numbers[at] == static_cast<double>(status)) {
                value = status;
                ++at;
                return;
            }
        faults.add(entryPath(path, at++), {IssueId::NotOneOf, {"0, 1, 2"}});
    }
    /** Reads an iceberg index of the run; anything else is a fault. */
    void operator()(IcebergIndex& iceberg)
    {
        const double number = numbers[at];
        const std::string entry = entryPath(path, at++);
        if (number >= 0 && number < static_cast<double>(context.icebergs) &&
            number == std::floor(number))
            iceberg = IcebergIndex::of(static_cast<int>(number));
        else if (context.icebergs == 0)
            faults.add(entry, {IssueId::NoIcebergInRun});
        else
            faults.add(entry, {IssueId::NotWhole, {0, countOf(context.icebergs - 1), number}});
    }
};

/**
 * Reads an array of numbers that has one of the lengths. Another length adds a fault that names the
 * first and gives zeros; an entry that is no number adds one and gives 0.
 */
std::vector<double> readNumbers(const Json& value, const std::string& path, Faults& faults,
                                std::initializer_list<std::size_t> lengths)
{
    std::vector<double> numbers(*lengths.begin());
    if (!value.is_array() || std::ranges::find(lengths, value.size()) == lengths.end()) {
        faults.add(path, {IssueId::EntryCount, {countOf(numbers.size()), entriesOf(value)}});
        return numbers;
    }
    numbers.resize(value.size());
    for (std::size_t i = 0; i < numbers.size(); ++i)
        if (!value[i].is_number())
            faults.add(entryPath(path, i),
                       {IssueId::WrongType, {ValueKind::Number, kindOf(value[i])}});
        else
            numbers[i] = value[i].get<double>();
    return numbers;
}

template <class Io, class T>
void velocityNumbers(Io& io, T& track)
{
    io(track.mean_mps);
    io(track.velocitySpread_mps);
    io(track.velocityTime_s);
}

std::string trackText(const Track& track)
{
    NumberWriter filter;
    filterNumbers(filter, track);
    const Track plain;
    NumberWriter usual;
    filterNumbers(usual, plain);
    const bool isFading = track.velocityTime_s > 0 || track.isForced;
    NumberWriter io;
    trackNumbers(io, track);
    if (isFading || filter.numbers != usual.numbers)
        filterNumbers(io, track);
    if (isFading) {
        velocityNumbers(io, track);
        io(track.seen_s);
    }
    return jsonArrayOf(io.numbers);
}

Track readTrack(const Json& value, const std::string& path, Faults& faults,
                const RunContext& context)
{
    NumberReader io{.numbers =
                        readNumbers(value, path, faults,
                                    {kPlainTrack, kFilteredTrack, kOlderFadingTrack, kFadingTrack}),
                    .path = path,
                    .faults = faults,
                    .context = context};
    const std::size_t length = io.numbers.size();
    Track track;
    trackNumbers(io, track);
    if (length >= kFilteredTrack)
        filterNumbers(io, track);
    if (length >= kOlderFadingTrack)
        velocityNumbers(io, track);
    track.seen_s = length == kOlderFadingTrack ? -1 : track.anchor_s; // -1: not recorded
    if (length == kFadingTrack)
        io(track.seen_s);
    if (length < kOlderFadingTrack) // the file has no mean velocity then
        track.mean_mps = context.current_mps;
    return track;
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
        tracks.push_back(
            readTrack((*list)[i], entryPath(object.path("tracks"), i), object.faults(), context));
        tracks.back().isForced = i < context.forced.size() && context.forced[i];
    }
    return tracks;
}

/** Reads the icebergs of a member that may be missing. */
IcebergList readGroup(ObjectReader& object, const char* member, const RunContext& context)
{
    std::vector<bool> seen(context.icebergs, false);
    const Json* list = object.find(member);
    return list == nullptr
               ? IcebergList()
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
    object.add("presence", search.path.presence());
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
    Search search{.iceberg = IcebergIndex::of(object.whole("iceberg", 0, context.indices()))};
    std::vector<Point> corners_m;
    const Json* list = object.array("corners_m");
    makeRoom(corners_m, list, faults);
    for (std::size_t i = 0; list != nullptr && i < list->size(); ++i)
        if (const auto corner_m =
                pointOf((*list)[i], entryPath(object.path("corners_m"), i), faults))
            corners_m.push_back(*corner_m);
    const auto next = object.whole("next", 0, {.low = 0, .high = kLargestCount});
    const double spread_m = object.number("spread_m", 0);
    const double presence = object.number("presence", 1, Limits{.low = 0, .high = 1});
    std::vector<double> chances = readList(object, "chances");
    if (chances.size() == LostSearch::cellCount())
        search.path = LostSearch::restored(std::move(corners_m), static_cast<std::size_t>(next),
                                           spread_m, std::move(chances), presence);
    else
        faults.add(
            object.path("chances"),
            {IssueId::EntryCount, {countOf(LostSearch::cellCount()), countOf(chances.size())}});
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

/** Writes the members that `uavMembers` names. */
struct UavWriter : MemberWriter
{
    using MemberWriter::operator();
    void operator()(const char* name, const LosGuidance& guidance)
    {
        NumberWriter io;
        guidanceNumbers(io, guidance);
        object.addText(name, jsonArrayOf(io.numbers));
    }
    void operator()(const char* name, const std::optional<AimedLeg>& leg)
    {
        if (leg)
            object.addText(name, legText(*leg));
    }
    void operator()(const char* name, const std::optional<Search>& search)
    {
        if (search)
            object.addText(name, searchText(*search));
    }
    void operator()(const char* name, const std::optional<ReturnPath>& path)
    {
        if (path)
            object.addText(name, returnPathText(*path));
    }
    void operator()(const char* name, const IcebergList& icebergs)
    {
        if (!icebergs.empty())
            object.addText(name, jsonArrayOf(icebergs));
    }
    void operator()(const char* name, const std::optional<IcebergIndex>& iceberg)
    {
        object.add(name, numberInFile(iceberg));
    }
};

/** Reads the members that `uavMembers` names. */
struct UavReader : MemberReader
{
    const RunContext& context;

    using MemberReader::operator();
    void operator()(const char* name, LosGuidance& guidance)
    {
        const Json* const value = object.need(name);
        if (value == nullptr)
            return;
        const std::string path = object.path(name);
        NumberReader io{.numbers = readNumbers(*value, path, object.faults(), {6}),
                        .path = path,
                        .faults = object.faults(),
                        .context = context};
        guidanceNumbers(io, guidance);
    }
    void operator()(const char* name, std::optional<AimedLeg>& leg)
    {
        if (const Json* value = object.find(name))
            leg = readLeg(*value, object.path(name), object.faults(), context);
    }
    void operator()(const char* name, std::optional<Search>& search)
    {
        if (const Json* value = object.find(name))
            search = readSearch(*value, object.path(name), object.faults(), context);
    }
    void operator()(const char* name, std::optional<ReturnPath>& path)
    {
        if (const Json* value = object.find(name))
            path = readReturnPath(*value, object.path(name), object.faults());
    }
    void operator()(const char* name, IcebergList& icebergs)
    {
        icebergs = readGroup(object, name, context);
    }
    void operator()(const char* name, std::optional<IcebergIndex>& iceberg)
    {
        iceberg = icebergOrNone(object, name, context);
    }
};

UavState readUav(ObjectReader& object, const RunContext& context)
{
    UavState uav;
    UavReader io{{object}, context};
    uavMembers(io, uav);
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

std::optional<IcebergIndex> icebergOrNone(ObjectReader& object, const char* member,
                                          const RunContext& context)
{
    const Json* const value = object.find(member);
    if (context.icebergs == 0 && value != nullptr && *value != kNoIcebergInFile) {
        object.faults().add(object.path(member), {IssueId::NoIcebergInRun});
        return std::nullopt;
    }
    const std::int64_t index = object.whole(member, kNoIcebergInFile, context.indices());
    return index == kNoIcebergInFile ? std::nullopt : std::optional(IcebergIndex::of(index));
}

std::string legText(const AimedLeg& leg)
{
    NumberWriter io;
    legNumbers(io, leg);
    if (leg.end_s)
        io(*leg.end_s);
    return jsonArrayOf(io.numbers);
}

AimedLeg readLeg(const Json& value, const std::string& path, Faults& faults,
                 const RunContext& context)
{
    NumberReader io{.numbers = readNumbers(value, path, faults, {kLegNumbers, kLegNumbers + 1}),
                    .path = path,
                    .faults = faults,
                    .context = context};
    AimedLeg leg;
    legNumbers(io, leg);
    if (io.numbers.size() > kLegNumbers)
        io(leg.end_s.emplace());
    return leg;
}

IcebergList readIcebergs(const Json& value, const std::string& path, Faults& faults,
                         const RunContext& context, std::vector<bool>& seen)
{
    IcebergList icebergs;
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
        const std::optional<std::int64_t> number = wholeOf(value[k], entry, faults, indices);
        if (!number)
            continue;
        const IcebergIndex iceberg = IcebergIndex::of(*number);
        if (seen[toIndex(iceberg)])
            faults.add(entry, {IssueId::IcebergTwice});
        seen[toIndex(iceberg)] = true;
        icebergs.push_back(iceberg);
    }
    return icebergs;
}

std::string keyframeText(const WorldState& state)
{
    JsonObject object;
    object.add("step", state.step);
    UavWriter first{{object}};
    uavMembers(first, state.uavs.front());
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
        UavWriter io{{other}};
        uavMembers(io, state.uavs[i]);
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

} // namespace berg
