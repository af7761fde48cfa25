#include "core/tracking/drift_errors.h"

#include "core/base/error.h"
#include "core/base/stopped.h"

#include <algorithm>

namespace berg {

namespace {

/** A fix from which drift is predicted. */
struct Start
{
    const PlacedTrack* track;
    PlacedFix fix;
};

/** Returns the fixes that are at least the given time apart, thinned evenly if there are too many.
 */
std::vector<Start> startsOf(std::span<const PlacedTrack> tracks, const DriftErrorRules& rules)
{
    std::vector<Start> all;
    for (const PlacedTrack& track : tracks) {
        std::optional<double> last_s;
        for (const PlacedFix& fix : track)
            if (!last_s || fix.time_s >= *last_s + rules.startsApart_s) {
                all.push_back({.track = &track, .fix = fix});
                last_s = fix.time_s;
            }
    }
    if (all.size() <= rules.mostStarts)
        return all;
    std::vector<Start> chosen;
    for (std::size_t k = 0; k < rules.mostStarts; ++k)
        chosen.push_back(all[k * all.size() / rules.mostStarts]);
    return chosen;
}

double distance_m(const LatLon& from, const LatLon& to)
{
    return LocalFrame(from).toPlane(to).norm();
}

/** Returns the velocity at the fix from the position some time before it. */
std::optional<Point> lastVelocity(const Start& start, const DriftErrorRules& rules)
{
    const std::optional<LatLon> before =
        placeAt(*start.track, start.fix.time_s - rules.lastVelocityOver_s, rules.longestGap_s);
    if (!before)
        return std::nullopt;
    return -LocalFrame(start.fix.place).toPlane(*before) / rules.lastVelocityOver_s;
}

/** Returns the predicted position after the lead, or nullopt if the forcing is not known so far. */
std::optional<LatLon> predicted(const PlacedFix& from, double lead_s, const DriftLaw& law,
                                const ForcingAt& forcing)
{
    const std::vector<DriftPoint> path = driftPath(
        {.place = from.place, .start_s = from.time_s, .duration_s = lead_s, .every_s = lead_s}, law,
        forcing);
    return path.size() < 2 ? std::nullopt : std::optional(path.back().place);
}

/** Adds the distances of one start to the sums of each lead. */
void addStart(std::vector<DriftLeadError>& sums, const Start& start, const DriftLaw& law,
              const ForcingAt& forcing, const DriftErrorRules& rules)
{
    const std::optional<Point> kept_mps = lastVelocity(start, rules);
    if (!kept_mps)
        return;
    const ForcingAt keeps = [&](double) { return Forcing{.current_mps = *kept_mps}; };
    PlacedFix byLaw = start.fix;
    PlacedFix byVelocity = start.fix;
    for (DriftLeadError& sum : sums) {
        const double time_s = start.fix.time_s + sum.lead_s;
        const std::optional<LatLon> drifted = predicted(byLaw, time_s - byLaw.time_s, law, forcing);
        if (!drifted)
            return;
        byLaw = {.time_s = time_s, .place = *drifted};
        byVelocity = {.time_s = time_s,
                      .place =
                          predicted(byVelocity, time_s - byVelocity.time_s, {}, keeps).value()};
        const std::optional<LatLon> recorded = placeAt(*start.track, time_s, rules.longestGap_s);
        if (!recorded)
            continue;
        ++sum.starts;
        sum.moved_m += distance_m(*recorded, start.fix.place);
        sum.drift_m += distance_m(*recorded, byLaw.place);
        sum.lastVelocity_m += distance_m(*recorded, byVelocity.place);
    }
}

} // namespace

std::optional<LatLon> placeAt(const PlacedTrack& track, double time_s, double longestGap_s)
{
    const auto after = std::ranges::lower_bound(track, time_s, {}, &PlacedFix::time_s);
    if (after == track.end() || (after == track.begin() && after->time_s > time_s))
        return std::nullopt;
    if (after->time_s == time_s)
        return after->place;
    const PlacedFix& before = *(after - 1);
    const double gap_s = after->time_s - before.time_s;
    if (gap_s > longestGap_s)
        return std::nullopt;
    const LocalFrame frame(before.place);
    return frame.toGeographic(frame.toPlane(after->place) * ((time_s - before.time_s) / gap_s));
}

std::vector<DriftLeadError> driftErrors(std::span<const PlacedTrack> tracks, const DriftLaw& law,
                                        const ForcingAt& forcing, const DriftErrorRules& rules,
                                        const std::stop_token& stop)
{
    require(!rules.leads_s.empty() && rules.leads_s.front() > 0 &&
                std::ranges::is_sorted(rules.leads_s, std::ranges::less_equal()),
            "driftErrors: leads must rise");
    std::vector<DriftLeadError> errors;
    for (const double lead_s : rules.leads_s)
        errors.push_back({.lead_s = lead_s});
    for (const Start& start : startsOf(tracks, rules)) {
        throwIfStopped(stop);
        addStart(errors, start, law, forcing, rules);
    }
    for (DriftLeadError& error : errors)
        for (double* const sum : {&error.moved_m, &error.drift_m, &error.lastVelocity_m})
            *sum /= static_cast<double>(std::max<std::size_t>(error.starts, 1));
    return errors;
}

} // namespace berg
