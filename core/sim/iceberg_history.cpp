#include "core/sim/iceberg_history.h"

#include <algorithm>
#include <stdexcept>

namespace berg {

std::vector<IcebergSample> icebergsOf(const Simulation& now)
{
    std::vector<IcebergSample> icebergs;
    icebergs.reserve(toIndex(now.icebergCount()));
    for (const IcebergIndex i : now.icebergs())
        icebergs.push_back({.sigma_m2 = now.track(i).sigma_m2,
                            .inView = now.track(i).inView,
                            .active = now.active(i),
                            .truth_m = now.truth_m(i)});
    return icebergs;
}

/** Grows step by step as the simulation does, so that the result agrees to the last bit. */
void IcebergHistory::Snapshot::advanceTo(std::int64_t until, double dt_s)
{
    for (State& state : icebergs)
        for (std::int64_t at = step; state.grows && at < until; ++at)
            state.variances = grown(state.variances, state.process, dt_s);
    step = until;
}

IcebergHistory::State IcebergHistory::stateOf(const Simulation& now, IcebergIndex iceberg)
{
    const Track& track = now.track(iceberg);
    const bool isExact = track.inView && now.world().observer().model == ObserverModel::Simple;
    return {.variances = track.variances(),
            .process = track.process(),
            .inView = track.inView,
            .active = now.active(iceberg),
            .grows = now.world().age(iceberg) >= 0 && !isExact};
}

std::span<const IcebergHistory::Change> IcebergHistory::changesOf(std::size_t row) const
{
    const std::size_t first = row > 0 ? m_rows[row - 1].changes : 0;
    return std::span(m_changes).subspan(first, m_rows[row].changes - first);
}

void IcebergHistory::add(const Simulation& now, bool isComplete)
{
    const auto count = static_cast<std::size_t>(now.icebergCount());
    if (!m_rows.empty() && count > m_last.icebergs.size())
        m_added.push_back(now.world());
    const bool startsSnapshot = isComplete || m_rows.empty();
    if (!startsSnapshot)
        m_last.advanceTo(now.step(), now.world().dt_s());
    m_last.step = now.step();
    m_last.icebergs.resize(count);
    for (const IcebergIndex i : now.icebergs()) {
        State& predicted = m_last.icebergs[toIndex(i)];
        const State is = stateOf(now, i);
        if (!startsSnapshot && is.variances.position_m2 == predicted.variances.position_m2 &&
            is.inView == predicted.inView && is.active == predicted.active &&
            is.process.q_m2ps == predicted.process.q_m2ps)
            continue;
        predicted = is;
        if (!startsSnapshot)
            m_changes.push_back({.iceberg = i, .state = is});
    }
    if (startsSnapshot)
        m_snapshots.push_back(m_last);
    m_rows.push_back(
        {.step = now.step(), .snapshot = m_snapshots.size() - 1, .changes = m_changes.size()});
}

/** Returns the latest world at or before `step` that has all icebergs of the row. */
const World& IcebergReader::worldBefore(std::int64_t step) const
{
    const auto keyframe = std::ranges::upper_bound(m_keyframes, step, {}, &Simulation::step);
    require(keyframe != m_keyframes.begin(), "IcebergReader: no keyframe before the row");
    const World& world = std::prev(keyframe)->world();
    if (toIndex(world.icebergCount()) == m_snapshot.icebergs.size())
        return world;
    const auto added = std::ranges::upper_bound(m_rows.m_added, step, {}, &World::step);
    require(added != m_rows.m_added.begin(), "IcebergReader: icebergs from nowhere");
    return *std::prev(added);
}

/**
 * Continues from the row read last if both rows use one snapshot, else starts from the snapshot.
 */
void IcebergReader::goTo(std::size_t row)
{
    const std::vector<IcebergHistory::Row>& rows = m_rows.m_rows;
    const std::size_t snapshot = rows[row].snapshot;
    const std::int64_t step = rows[row].step;
    if (m_next == 0 || m_next > row || rows[m_next - 1].snapshot != snapshot) {
        m_next = static_cast<std::size_t>(
            std::ranges::lower_bound(rows, snapshot, {}, &IcebergHistory::Row::snapshot) -
            rows.begin());
        m_snapshot = m_rows.m_snapshots[snapshot];
    }
    for (; m_next <= row; ++m_next) {
        m_snapshot.advanceTo(rows[m_next].step, m_keyframes.front().world().dt_s());
        for (const IcebergHistory::Change& change : m_rows.changesOf(m_next)) {
            m_snapshot.icebergs.resize(
                std::max(m_snapshot.icebergs.size(), toIndex(change.iceberg) + 1));
            m_snapshot.icebergs[toIndex(change.iceberg)] = change.state;
        }
    }
    const World& before = worldBefore(step);
    if (!m_world || m_world->step() > step || m_world->step() < before.step() ||
        m_world->icebergCount() != before.icebergCount())
        m_world = before;
    m_world->goTo(step);
}

std::vector<IcebergSample> IcebergReader::at(std::size_t row)
{
    if (row >= m_rows.size())
        throw std::out_of_range("IcebergReader: no such row");
    goTo(row);
    std::vector<IcebergSample> icebergs;
    icebergs.reserve(m_snapshot.icebergs.size());
    for (const IcebergHistory::State& state : m_snapshot.icebergs)
        icebergs.push_back({.sigma_m2 = state.variances.position_m2,
                            .inView = state.inView,
                            .active = state.active,
                            .truth_m = m_world->truth_m(IcebergIndex::of(icebergs.size()))});
    return icebergs;
}

} // namespace berg
