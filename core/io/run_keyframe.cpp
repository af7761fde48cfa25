#include "core/io/run_keyframe.h"

#include "core/io/json_writer.h"

#include <algorithm>
#include <cmath>

namespace berg {

namespace {

constexpr std::array<Named<FlightMode>, 4> kModeNames{{
    {FlightMode::Idle, "idle"},
    {FlightMode::Leg, "leg"},
    {FlightMode::RunOut, "run-out"},
    {FlightMode::Circle, "circle"},
}};

std::string trackText(const Track& track)
{
    return jsonArrayOf(std::vector<double>{track.anchor_m.x(), track.anchor_m.y(), track.anchor_s,
                                           track.velocity_mps.x(), track.velocity_mps.y(),
                                           track.sigma_m2, track.q_m2ps, track.inView ? 1.0 : 0.0});
}

std::string guidanceText(const LosGuidance& guidance)
{
    return jsonArrayOf(std::vector<double>{guidance.gains.lookahead_m, guidance.gains.integral_mps,
                                           guidance.gains.turn_1ps, guidance.start_m.x(),
                                           guidance.start_m.y(), guidance.integral_s});
}

/** An array of exactly `Count` numbers; zeros and a fault when it is anything else. */
template <std::size_t Count>
std::array<double, Count> readNumbers(const Json& value, const std::string& path, Faults& faults)
{
    std::array<double, Count> numbers{};
    if (!value.is_array() || value.size() != Count) {
        faults.add(path, "must be " + std::to_string(Count) + " numbers");
        return numbers;
    }
    for (std::size_t i = 0; i < Count; ++i)
        if (!value[i].is_number())
            faults.add(entryPath(path, i), "must be a number, not " + typeText(value[i]));
        else
            numbers[i] = value[i].get<double>();
    return numbers;
}

std::vector<Track> readTracks(ObjectReader& object, const RunContext& context)
{
    std::vector<Track> tracks;
    if (object.need("tracks") == nullptr)
        return tracks;
    const Json* list = object.array("tracks");
    if (list == nullptr)
        return tracks;
    if (list->size() < context.icebergsAtStart || list->size() > context.icebergs)
        object.faults().add(object.path("tracks"),
                            "must hold one entry for each iceberg there is, not " +
                                std::to_string(list->size()));
    for (std::size_t i = 0; i < list->size(); ++i) {
        const auto n = readNumbers<8>((*list)[i], entryPath(object.path("tracks"), i), //
                                      object.faults());
        tracks.push_back({.anchor_m = {n[0], n[1]},
                          .anchor_s = n[2],
                          .velocity_mps = {n[3], n[4]},
                          .sigma_m2 = n[5],
                          .q_m2ps = n[6],
                          .inView = n[7] != 0});
    }
    return tracks;
}

/** An index of the run's icebergs; 0 and a fault when it is none. */
int icebergOf(double number, const std::string& path, Faults& faults, const RunContext& context)
{
    if (number >= 0 && number < static_cast<double>(context.icebergs) &&
        number == std::floor(number))
        return static_cast<int>(number);
    faults.add(path, "must be the index of an iceberg");
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

} // namespace

std::string legText(const AimedLeg& leg)
{
    return jsonArrayOf(std::vector<double>{static_cast<double>(leg.iceberg), leg.turn_rad,
                                           leg.from_m.x(), leg.from_m.y(), leg.abeam_m.x(),
                                           leg.abeam_m.y(), leg.sighting_s});
}

AimedLeg readLeg(const Json& value, const std::string& path, Faults& faults,
                 const RunContext& context)
{
    const auto n = readNumbers<7>(value, path, faults);
    return {.iceberg = icebergOf(n[0], entryPath(path, 0), faults, context),
            .turn_rad = n[1],
            .from_m = {n[2], n[3]},
            .abeam_m = {n[4], n[5]},
            .sighting_s = n[6]};
}

std::string keyframeText(const WorldState& state)
{
    std::vector<std::string> tracks;
    tracks.reserve(state.tracks.size());
    std::transform(state.tracks.begin(), state.tracks.end(), std::back_inserter(tracks), trackText);
    JsonObject object;
    object.add("step", state.step);
    object.add("position_m", state.uav.position_m);
    object.add("psi_rad", state.uav.psi_rad);
    object.add("u_radps", state.u_radps);
    object.add("cross_track_m", state.crossTrack_m);
    object.add("sigma_sum_m2", state.sigmaSum_m2);
    object.add("zeta_m2s", state.zeta_m2s);
    object.add("flown_m", state.flown_m);
    object.add("mode", nameOf(kModeNames, state.mode));
    object.add("target", state.target);
    object.add("last_reached", state.lastReached);
    object.addText("guidance", guidanceText(state.guidance));
    object.add("run_out_m", state.runOut_m);
    object.add("misses", state.misses);
    if (state.aim)
        object.addText("aim", legText(*state.aim));
    object.addText("tracks", jsonLines(tracks, 2));
    return object.inLine();
}

WorldState readKeyframe(const Json& value, const std::string& path, Faults& faults,
                        const RunContext& context)
{
    ObjectReader object(value, path, faults);
    WorldState state;
    if (object.need("step") != nullptr)
        state.step = object.whole("step", 0, {.low = 0, .high = context.lastStep});
    state.uav.position_m = object.point("position_m", Point::Zero());
    state.uav.psi_rad = object.number("psi_rad", 0);
    state.u_radps = object.number("u_radps", 0);
    state.crossTrack_m = object.number("cross_track_m", 0);
    state.sigmaSum_m2 = object.number("sigma_sum_m2", 0, kAmount);
    state.zeta_m2s = object.number("zeta_m2s", 0, kAmount);
    state.flown_m = object.number("flown_m", 0, kAmount);
    state.mode = object.choice("mode", FlightMode::Idle, kModeNames);
    state.target = asInt(object.whole("target", -1, context.indices()));
    state.lastReached = asInt(object.whole("last_reached", -1, context.indices()));
    state.guidance = readGuidance(object);
    state.runOut_m = object.number("run_out_m", 0);
    state.misses = asInt(object.whole("misses", 0, {.low = 0, .high = kLargestCount}));
    if (const Json* aim = object.find("aim"))
        state.aim = readLeg(*aim, object.path("aim"), faults, context);
    state.tracks = readTracks(object, context);
    return state;
}

} // namespace berg
