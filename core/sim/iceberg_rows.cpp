#include "core/sim/iceberg_rows.h"

#include <algorithm>
#include <stdexcept>

namespace berg {

std::vector<IcebergSample> icebergsOf(const Simulation& now)
{
    std::vector<IcebergSample> icebergs;
    icebergs.reserve(toIndex(now.icebergCount()));
    for (int i = 0; i < now.icebergCount(); ++i)
        icebergs.push_back({.sigma_m2 = now.track(i).sigma_m2,
                            .inView = now.track(i).inView,
                            .active = now.active(i),
                            .truth_m = now.truth_m(i)});
    return icebergs;
}

/** Step by step, as the simulation does, so that the last bit is the same. */
void IcebergRows::Courses::advanceTo(std::int64_t until, double dt_s)
{
    for (Course& course : icebergs)
        for (std::int64_t at = step; course.grows && at < until; ++at)
            course.variances = grown(course.variances, course.process, dt_s);
    step = until;
}

IcebergRows::Course IcebergRows::courseOf(const Simulation& now, int iceberg)
{
    const Track& track = now.track(iceberg);
    const bool isExact = track.inView && now.world().observer().model == ObserverModel::Simple;
    return {.variances = track.variances(),
            .process = track.process(),
            .inView = track.inView,
            .active = now.active(iceberg),
            .grows = now.world().age(iceberg) >= 0 && !isExact};
}

std::span<const IcebergRows::Change> IcebergRows::changesOf(std::size_t row) const
{
    const std::size_t first = row > 0 ? m_rows[row - 1].changes : 0;
    return std::span(m_changes).subspan(first, m_rows[row].changes - first);
}

void IcebergRows::add(const Simulation& now, bool whole)
{
    const auto count = static_cast<std::size_t>(now.icebergCount());
    if (!m_rows.empty() && count > m_last.icebergs.size())
        m_added.push_back(now.world());
    const bool isWhole = whole || m_rows.empty();
    if (!isWhole)
        m_last.advanceTo(now.step(), now.world().dt_s());
    m_last.step = now.step();
    m_last.icebergs.resize(count);
    for (int i = 0; i < now.icebergCount(); ++i) {
        Course& foretold = m_last.icebergs[toIndex(i)];
        const Course is = courseOf(now, i);
        if (!isWhole && is.variances.position_m2 == foretold.variances.position_m2 &&
            is.inView == foretold.inView && is.active == foretold.active &&
            is.process.q_m2ps == foretold.process.q_m2ps)
            continue;
        foretold = is;
        if (!isWhole)
            m_changes.push_back({.iceberg = i, .course = is});
    }
    if (isWhole)
        m_whole.push_back(m_last);
    m_rows.push_back(
        {.step = now.step(), .whole = m_whole.size() - 1, .changes = m_changes.size()});
}

/** As late as there is one until then, with all icebergs of the row. */
const World& IcebergReader::worldBefore(std::int64_t step) const
{
    const auto keyframe = std::ranges::upper_bound(m_keyframes, step, {}, &Simulation::step);
    require(keyframe != m_keyframes.begin(), "IcebergReader: no keyframe before the row");
    const World& world = std::prev(keyframe)->world();
    if (toIndex(world.icebergCount()) == m_courses.icebergs.size())
        return world;
    const auto added = std::ranges::upper_bound(m_rows.m_added, step, {}, &World::step);
    require(added != m_rows.m_added.begin(), "IcebergReader: icebergs from nowhere");
    return *std::prev(added);
}

/** On from the row read last where both are read from one whole row, else from that. */
void IcebergReader::goTo(std::size_t row)
{
    const std::vector<IcebergRows::Row>& rows = m_rows.m_rows;
    const std::size_t whole = rows[row].whole;
    const std::int64_t step = rows[row].step;
    if (m_next == 0 || m_next > row || rows[m_next - 1].whole != whole) {
        m_next = static_cast<std::size_t>(
            std::ranges::lower_bound(rows, whole, {}, &IcebergRows::Row::whole) - rows.begin());
        m_courses = m_rows.m_whole[whole];
    }
    for (; m_next <= row; ++m_next) {
        m_courses.advanceTo(rows[m_next].step, m_keyframes.front().world().dt_s());
        for (const IcebergRows::Change& change : m_rows.changesOf(m_next)) {
            m_courses.icebergs.resize(
                std::max(m_courses.icebergs.size(), toIndex(change.iceberg) + 1));
            m_courses.icebergs[toIndex(change.iceberg)] = change.course;
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
    icebergs.reserve(m_courses.icebergs.size());
    for (const IcebergRows::Course& course : m_courses.icebergs)
        icebergs.push_back({.sigma_m2 = course.variances.position_m2,
                            .inView = course.inView,
                            .active = course.active,
                            .truth_m = m_world->truth_m(static_cast<int>(icebergs.size()))});
    return icebergs;
}

} // namespace berg
