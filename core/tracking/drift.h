#pragma once

#include "core/base/geometry.h"
#include "core/base/random.h"

#include <cstdint>
#include <memory>
#include <string_view>
#include <vector>

namespace berg {

/**
 * Where an iceberg truly was, from a beacon on it: as many positions as times, times rising, in
 * seconds from the start of the scenario.
 */
struct RecordedTrack
{
    std::vector<double> time_s;
    std::vector<Point> position_m;

    [[nodiscard]] bool empty() const { return time_s.empty(); }
    /** Linear between the entries, held at the first and the last. Needs an entry. */
    [[nodiscard]] Point at(double instant_s) const;
    bool operator==(const RecordedTrack&) const = default;
};

/** How an iceberg moves, Eq. (17). */
struct DriftSpec
{
    Point position_m = Point::Zero();   ///< at `start_s`
    double start_s = 0;                 ///< the noise grid starts here
    Point velocity_mps = Point::Zero(); ///< known part
    double q_m2ps = 0.025;              ///< variance grows by q t along each axis
    /** Null: Eq. (17); otherwise the iceberg follows it, without noise. Shared by copies. */
    std::shared_ptr<const RecordedTrack> track;
};

/**
 * True motion of one iceberg: along its recorded track where it has one, otherwise Eq. (17), known
 * velocity plus white-noise velocity. The noise is drawn as increments N(0, q 1 s) per axis on a
 * fixed 1 s grid from the stream (seed, id) and is linear between, so it is the same for every
 * planner and time step. Asked forward in time.
 */
class DriftModel
{
public:
    /** `noise` off: the iceberg moves with its known velocity alone. */
    DriftModel(const DriftSpec& spec, std::uint64_t seed, std::string_view id, bool noise);

    /** True position at `time_s` >= that of the last call. */
    [[nodiscard]] Point position_m(double time_s)
    {
        if (m_track)
            return m_track->at(time_s);
        const double age_s = time_s - m_start_s;
        while (age_s >= static_cast<double>(m_second + 1))
            nextSecond();
        const double inSecond_s = age_s - static_cast<double>(m_second);
        return m_start_m + m_velocity_mps * age_s + m_noise_m + m_step_m * inSecond_s;
    }

private:
    void nextSecond();
    void drawStep();

    std::shared_ptr<const RecordedTrack> m_track;
    Point m_start_m;
    double m_start_s;
    Point m_velocity_mps;
    double m_deviation_m; ///< of one increment
    Random m_random;
    std::int64_t m_second = 0;
    Point m_noise_m = Point::Zero(); ///< accumulated until m_second
    Point m_step_m = Point::Zero();  ///< increment of the second under way
};

} // namespace berg
