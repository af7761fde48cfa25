#include "core/sim/pose_tracks.h"

#include "core/base/angles.h"
#include "core/scenario/limits.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace berg {

namespace {

/** Times of steps are rounded, so a fix this near to a step counts as at its time. */
constexpr double kSame_s = 1e-6;

DubinsState between(const PoseFix& before, const PoseFix& after, double time_s)
{
    const double share = (time_s - before.time_s) / (after.time_s - before.time_s);
    const Point path_m = after.pose.position_m - before.pose.position_m;
    return {.position_m = before.pose.position_m + share * path_m,
            .psi_rad = wrapPi(before.pose.psi_rad +
                              share * wrapPi(after.pose.psi_rad - before.pose.psi_rad))};
}

std::optional<ExternalPose> poseAt(const std::vector<PoseFix>& track, double time_s)
{
    const auto after = std::ranges::lower_bound(track, time_s - kSame_s, {}, &PoseFix::time_s);
    if (after == track.end())
        return std::nullopt;
    if (after->time_s <= time_s + kSame_s)
        return ExternalPose{.pose = after->pose, .hasView = after->isMeasured};
    if (after->isFirst)
        return std::nullopt;
    const PoseFix& before = *std::prev(after);
    return ExternalPose{.pose = between(before, *after, time_s),
                        .hasView = before.isMeasured && after->isMeasured};
}

bool isStorable(const DubinsState& pose)
{
    const Point& at_m = pose.position_m;
    return std::isfinite(pose.psi_rad) && std::abs(at_m.x()) <= kLargestCoordinate_m &&
           std::abs(at_m.y()) <= kLargestCoordinate_m;
}

} // namespace

void PoseTracks::add(PoseFix fix, double now_s)
{
    std::vector<PoseFix>& track = m_tracks.at(static_cast<std::size_t>(fix.uav));
    if (!isStorable(fix.pose) || fix.time_s <= now_s + kSame_s ||
        (!track.empty() && fix.time_s <= track.back().time_s))
        return;
    fix.isFirst = track.empty() || track.back().time_s < now_s - kSame_s;
    track.push_back(fix);
}

void PoseTracks::restore(std::span<const PoseFix> fixes)
{
    for (std::vector<PoseFix>& track : m_tracks)
        track.clear();
    for (const PoseFix& fix : fixes)
        m_tracks.at(static_cast<std::size_t>(fix.uav)).push_back(fix);
}

std::vector<std::optional<ExternalPose>> PoseTracks::posesAt(double time_s, double step_s) const
{
    std::vector<std::optional<ExternalPose>> poses;
    if (std::ranges::all_of(m_tracks, &std::vector<PoseFix>::empty))
        return poses; // as in most flights, in every step
    for (std::size_t uav = 0; uav < m_tracks.size(); ++uav)
        if (const std::optional<ExternalPose> pose = poseAt(m_tracks[uav], time_s)) {
            poses.resize(m_tracks.size());
            poses[uav] = pose;
            poses[uav]->isJump = !poseAt(m_tracks[uav], time_s - step_s);
        }
    return poses;
}

std::optional<double> PoseTracks::knownUntil_s() const
{
    std::vector<double> ends_s;
    for (const std::vector<PoseFix>& track : m_tracks)
        if (!track.empty())
            ends_s.push_back(track.back().time_s);
    if (ends_s.empty())
        return std::nullopt;
    const double newest_s = std::ranges::max(ends_s);
    std::erase_if(ends_s, [&](double end_s) { return end_s < newest_s - kPatience_s; });
    return std::ranges::min(ends_s);
}

std::vector<PoseFix> PoseTracks::until(double until_s) const
{
    std::vector<PoseFix> fixes;
    for (const std::vector<PoseFix>& track : m_tracks) {
        const auto last = std::ranges::lower_bound(track, until_s - kSame_s, {}, &PoseFix::time_s);
        fixes.insert(fixes.end(), track.begin(), last == track.end() ? last : std::next(last));
    }
    return fixes;
}

} // namespace berg
