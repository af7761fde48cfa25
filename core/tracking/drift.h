#pragma once

#include "core/base/geometry.h"
#include "core/base/random.h"

#include <cstdint>
#include <string_view>

namespace berg {

/** How an iceberg moves, Eq. (17). */
struct DriftSpec
{
    Point position_m = Point::Zero();   ///< at `start_s`
    double start_s = 0;                 ///< the noise grid starts here
    Point velocity_mps = Point::Zero(); ///< known part
    double q_m2ps = 0.025;              ///< variance grows by q t along each axis
};

/**
 * True motion of one iceberg, Eq. (17): known velocity plus white-noise velocity. The noise is
 * drawn as increments N(0, q 1 s) per axis on a fixed 1 s grid from the stream (seed, id) and is
 * linear between, so it is the same for every planner and time step. Asked forward in time.
 */
class DriftModel
{
public:
    /** `noise` off: the iceberg moves with its known velocity alone. */
    DriftModel(const DriftSpec& spec, std::uint64_t seed, std::string_view id, bool noise);

    /** True position at `time_s` >= that of the last call. */
    [[nodiscard]] Point position_m(double time_s)
    {
        const double age_s = time_s - m_start_s;
        while (age_s >= static_cast<double>(m_second + 1))
            nextSecond();
        const double inSecond_s = age_s - static_cast<double>(m_second);
        return m_start_m + m_velocity_mps * age_s + m_noise_m + m_step_m * inSecond_s;
    }

private:
    void nextSecond();
    void drawStep();

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
