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

/**
 * What changes about the drift of an iceberg: white-noise velocity, Eq. (17), and a velocity that
 * is not the same for ever. The latter is an Ornstein-Uhlenbeck process along each axis: what
 * differs from the mean fades with exp(-t / velocityTime_s), and as much is added as keeps its
 * standard deviation at `velocitySpread_mps` in the long run.
 */
struct DriftProcess
{
    double q_m2ps = 0;
    double velocitySpread_mps = 0;
    double velocityTime_s = 0; ///< 0: the velocity is constant, its spread does not count
    bool operator==(const DriftProcess&) const = default;
};

/**
 * As icebergs drift: fitted to 639 fixes of a beacon of the Canadian Ice Service (1997_12995),
 * whose displacement per axis is 1.4 km after 2.5 h and 7.8 km after a day.
 */
inline constexpr DriftProcess kFittedDrift{.velocitySpread_mps = 0.15, .velocityTime_s = 36'000};

/** Of what is not known of position and velocity, along one axis. */
struct DriftVariances
{
    double position_m2 = 0;    ///< P, variance of the position
    double mixed_m2ps = 0;     ///< C, covariance of position and velocity
    double velocity_m2ps2 = 0; ///< V, variance of the velocity
    bool operator==(const DriftVariances&) const = default;
};

/**
 * The variances `dt_s` >= 0 later, nothing being seen. With T the velocity time, S its spread,
 * r = exp(-dt / T) and a = T (1 - r):
 *
 *     P' = P + q dt + 2 C a + V a^2 + S^2 T (2 dt - T (3 - 4 r + r^2))
 *     C' = r (C + V a) + S^2 T (1 - r)^2
 *     V' = r^2 V + S^2 (1 - r^2)
 *
 * and P + q dt + 2 C dt + V dt^2, C + V dt, V where the velocity is constant (T = 0). Exact, also
 * in small steps: where terms cancel (dt << T) their series is summed. (Gillespie 1996, Phys. Rev.
 * E 54, 2084: moments of the process and its integral.)
 */
[[nodiscard]] DriftVariances grown(const DriftVariances& now, const DriftProcess& process,
                                   double dt_s);

/** The integral of P over the next `dt_s`, in closed form as well: what zeta grows by. m^2 s */
[[nodiscard]] double positionIntegral_m2s(const DriftVariances& now, const DriftProcess& process,
                                          double dt_s);

/**
 * What becomes within a time of a velocity u above the mean: it changes to kept u + velocity_mps n
 * and moves the iceberg by carried_s u + shared_m n + place_m m, with n and m standard normal and
 * independent. One axis; exact for times of any length.
 */
struct VelocityStep
{
    double kept = 1;
    double carried_s = 0;
    double velocity_mps = 0;
    double shared_m = 0;
    double place_m = 0;
};
[[nodiscard]] VelocityStep velocityStep(const DriftProcess& process, double dt_s);

/** In how many seconds a constant velocity moves as far as one that fades does in `dt_s` >= 0. */
[[nodiscard]] double carriedFor_s(double velocityTime_s, double dt_s);

/** How an iceberg moves, Eq. (17). */
struct DriftSpec
{
    Point position_m = Point::Zero();   ///< at `start_s`
    double start_s = 0;                 ///< the noise grid starts here
    Point velocity_mps = Point::Zero(); ///< at `start_s`
    double q_m2ps = 0.025;              ///< variance grows by q t along each axis
    Point mean_mps = Point::Zero();     ///< what the velocity fades to, where it is not constant
    double velocitySpread_mps = 0;      ///< see `DriftProcess`
    double velocityTime_s = 0;          ///< likewise
    /** Null: Eq. (17); otherwise the iceberg follows it, without noise. Shared by copies. */
    std::shared_ptr<const RecordedTrack> track;
};

/**
 * The noise of one iceberg: for each second a standard normal number per axis, from the stream
 * (seed, id). The first `seconds` are drawn at once and shared by copies, so that many flights of
 * one scenario draw them only once (16 bytes each); what comes after is drawn as it is asked for.
 * Copies may be used by several threads.
 */
class DriftNoise
{
public:
    DriftNoise(std::uint64_t seed, std::string_view id, std::size_t seconds = 0);

    /** Numbers of the same iceberg that have nothing to do with these. */
    [[nodiscard]] DriftNoise ofVelocity() const;

    /** Whether it is the stream of that name. */
    [[nodiscard]] bool isOf(std::uint64_t seed, std::string_view id) const
    {
        return m_seed == seed && m_stream == stableHash(id);
    }

    /** The numbers of the next second. */
    [[nodiscard]] Point next()
    {
        return m_drawn && m_taken < m_drawn->size() ? (*m_drawn)[m_taken++] : draw();
    }

    /** Neither of the numbers is ever larger. */
    static constexpr double kLargest = Random::kLargestNormal;

private:
    DriftNoise(std::uint64_t seed, std::uint64_t stream);
    [[nodiscard]] Point draw();

    std::uint64_t m_seed;
    std::uint64_t m_stream;
    std::shared_ptr<const std::vector<Point>> m_drawn; ///< null: none
    std::size_t m_taken = 0;                           ///< of `m_drawn`
    Random m_random;                                   ///< where the stream goes on after them
};

/**
 * True motion of one iceberg: along its recorded track where it has one, otherwise Eq. (17), known
 * velocity plus white-noise velocity. The noise moves it by N(0, q 1 s) per axis in each second of
 * a fixed grid and is linear between, so it is the same for every planner and time step. A velocity
 * that changes does so on the same grid, from a stream of its own. Asked forward in time.
 */
class DriftModel
{
public:
    /** `noise` off: the iceberg moves with its known velocity alone. */
    DriftModel(const DriftSpec& spec, std::uint64_t seed, std::string_view id, bool noise);
    /** The same with a source of noise at hand, of which nothing has been taken. */
    DriftModel(const DriftSpec& spec, DriftNoise source, bool noise);

    /** Takes the noise until `time_s`: from now on positions are asked for that time or later. */
    void advanceTo(double time_s)
    {
        if (!m_isStepped)
            return;
        while (time_s - m_start_s >= static_cast<double>(m_second + 1))
            nextSecond();
    }

    /**
     * True position at `time_s`, not before that of `advanceTo`. Costs as many draws as there are
     * seconds between the two.
     */
    [[nodiscard]] Point at(double time_s) const
    {
        if (m_track)
            return m_track->at(time_s);
        const double age_s = time_s - m_start_s;
        if (m_isStepped && age_s >= static_cast<double>(m_second + 1))
            return aheadAt(time_s);
        const double inSecond_s = age_s - static_cast<double>(m_second);
        return m_start_m + m_velocity_mps * age_s + m_noise_m + m_step_m * inSecond_s;
    }

    /** `advanceTo` and `at` in one. */
    [[nodiscard]] Point position_m(double time_s)
    {
        advanceTo(time_s);
        return at(time_s);
    }

    /** True velocity at the whole second that `advanceTo` came to, without the white noise. */
    [[nodiscard]] Point velocity_mps() const { return m_velocity_mps + m_own_mps; }

    [[nodiscard]] double start_s() const { return m_start_s; }
    /** No two positions are farther apart than the time between them allows at this speed;
     * infinite where no such speed is known. */
    [[nodiscard]] double speedLimit_mps() const;

private:
    [[nodiscard]] Point aheadAt(double time_s) const;
    void nextSecond();
    void drawStep();

    std::shared_ptr<const RecordedTrack> m_track;
    Point m_start_m;
    double m_start_s;
    Point m_velocity_mps; ///< the part that never changes
    double m_deviation_m; ///< of one increment
    VelocityStep m_fade;  ///< of one second
    bool m_isStepped;     ///< not all that moves it is `m_velocity_mps`
    DriftNoise m_velocitySource;
    DriftNoise m_source;
    Point m_own_mps = Point::Zero();  ///< above `m_velocity_mps`, at m_second
    Point m_next_mps = Point::Zero(); ///< a second later
    std::int64_t m_second = 0;
    Point m_noise_m = Point::Zero(); ///< accumulated until m_second
    Point m_step_m = Point::Zero();  ///< increment of the second under way
};

} // namespace berg
