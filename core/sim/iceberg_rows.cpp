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

void IcebergRows::Courses::startAt(const Simulation& keyframe)
{
    step = keyframe.step();
    icebergs.clear();
    for (int i = 0; i < keyframe.icebergCount(); ++i)
        icebergs.push_back(courseOf(keyframe, i));
}

/** Step by step, as the simulation does, so that the last bit is the same. */
void IcebergRows::Courses::advanceTo(std::int64_t until, double dt_s)
{
    for (Course& course : icebergs) {
        if (!course.grows)
            continue;
        Track track{.sigma_m2 = course.sigma_m2,
                    .q_m2ps = course.q_m2ps,
                    .mixed_m2ps = course.mixed_m2ps,
                    .velocity_m2ps2 = course.velocity_m2ps2,
                    .velocitySpread_mps = course.velocitySpread_mps,
                    .velocityTime_s = course.velocityTime_s};
        for (std::int64_t at = step; at < until; ++at)
            track.grow(dt_s);
        course.sigma_m2 = track.sigma_m2;
        course.mixed_m2ps = track.mixed_m2ps;
        course.velocity_m2ps2 = track.velocity_m2ps2;
    }
    step = until;
}

IcebergRows::Course IcebergRows::courseOf(const Simulation& now, int iceberg)
{
    const Track& track = now.track(iceberg);
    const bool isExact = track.inView && now.world().observer().model == ObserverModel::Simple;
    return {.sigma_m2 = track.sigma_m2,
            .mixed_m2ps = track.mixed_m2ps,
            .velocity_m2ps2 = track.velocity_m2ps2,
            .velocitySpread_mps = track.velocitySpread_mps,
            .velocityTime_s = track.velocityTime_s,
            .q_m2ps = track.q_m2ps,
            .inView = track.inView,
            .active = now.active(iceberg),
            .grows = now.world().age(iceberg) >= 0 && !isExact};
}

std::span<const IcebergRows::Change> IcebergRows::changesOf(std::size_t row) const
{
    const std::size_t first = row > 0 ? m_rows[row - 1].changes : 0;
    return std::span(m_changes).subspan(first, m_rows[row].changes - first);
}

void IcebergRows::add(const Simulation& now, std::span<const Simulation> keyframes)
{
    require(!keyframes.empty(), "IcebergRows: no keyframe yet");
    Row row{.step = now.step(), .keyframe = keyframes.size() - 1};
    const bool isFirst = m_rows.empty() || m_rows.back().keyframe != row.keyframe;
    if (isFirst)
        m_last.startAt(keyframes.back());
    m_last.advanceTo(row.step, now.world().dt_s());
    if (now.icebergCount() > keyframes.back().icebergCount()) {
        if (isFirst || static_cast<std::size_t>(now.icebergCount()) > m_last.icebergs.size())
            m_added.push_back(now.world());
        row.added = static_cast<int>(m_added.size()) - 1;
    }
    m_last.icebergs.resize(static_cast<std::size_t>(now.icebergCount()));
    for (int i = 0; i < now.icebergCount(); ++i) {
        Course& foretold = m_last.icebergs[toIndex(i)];
        const Course is = courseOf(now, i);
        if (is.sigma_m2 == foretold.sigma_m2 && is.inView == foretold.inView &&
            is.active == foretold.active && is.q_m2ps == foretold.q_m2ps)
            continue;
        foretold = is;
        m_changes.push_back({.iceberg = i, .course = is});
    }
    row.changes = m_changes.size();
    m_rows.push_back(row);
}

/** On from the row read last where that is before it and of the same keyframe, else from the
 * keyframe. */
void IcebergReader::goTo(std::size_t row)
{
    const std::vector<IcebergRows::Row>& rows = m_rows.m_rows;
    const std::size_t keyframe = rows[row].keyframe;
    const bool continues = m_next > 0 && m_next <= row && rows[m_next - 1].keyframe == keyframe;
    if (!continues) {
        m_next = static_cast<std::size_t>(
            std::ranges::lower_bound(rows, keyframe, {}, &IcebergRows::Row::keyframe) -
            rows.begin());
        m_courses.startAt(m_keyframes[keyframe]);
        m_world.reset();
    }
    for (; m_next <= row; ++m_next) {
        m_courses.advanceTo(rows[m_next].step, m_keyframes[keyframe].world().dt_s());
        for (const IcebergRows::Change& change : m_rows.changesOf(m_next)) {
            m_courses.icebergs.resize(
                std::max(m_courses.icebergs.size(), toIndex(change.iceberg) + 1));
            m_courses.icebergs[toIndex(change.iceberg)] = change.course;
        }
    }
    const int added = rows[row].added;
    if (!m_world || added != m_added)
        m_world = added < 0 ? m_keyframes[keyframe].world() : m_rows.m_added[toIndex(added)];
    m_added = added;
    m_world->goTo(rows[row].step);
}

std::vector<IcebergSample> IcebergReader::at(std::size_t row)
{
    if (row >= m_rows.size())
        throw std::out_of_range("IcebergReader: no such row");
    goTo(row);
    std::vector<IcebergSample> icebergs;
    icebergs.reserve(m_courses.icebergs.size());
    for (const IcebergRows::Course& course : m_courses.icebergs)
        icebergs.push_back({.sigma_m2 = course.sigma_m2,
                            .inView = course.inView,
                            .active = course.active,
                            .truth_m = m_world->truth_m(static_cast<int>(icebergs.size()))});
    return icebergs;
}

} // namespace berg
