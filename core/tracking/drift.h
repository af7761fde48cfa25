#pragma once

#include "core/base/random.h"
#include "core/geometry/geometry.h"

#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

namespace berg {

/**
 * True positions of an iceberg, from a beacon on it: as many positions as times. Times rise and are
 * in seconds from the start of the scenario.
 */
struct RecordedTrack
{
    std::vector<double> time_s;
    std::vector<Point> position_m;

    [[nodiscard]] bool empty() const { return time_s.empty(); }
    /**
     * Returns the position at that time: linear between the entries, constant before the first and
     * after the last. Requires at least one entry.
     */
    [[nodiscard]] Point at(double instant_s) const;
    bool operator==(const RecordedTrack&) const = default;
};

/**
 * Random changes of the drift of an iceberg: white-noise velocity, Eq. (17), and a velocity that is
 * not constant. The latter is an Ornstein-Uhlenbeck process along each axis: the difference from
 * the mean fades with exp(-t / velocityTime_s), and noise keeps its standard deviation at
 * `velocitySpread_mps` in the long run.
 */
struct DriftProcess
{
    double q_m2ps = 0;
    double velocitySpread_mps = 0;
    double velocityTime_s = 0; ///< 0 means a constant velocity; its spread has no effect then
    bool operator==(const DriftProcess&) const = default;
};

/**
 * Realistic drift of icebergs: fitted to 639 fixes of a beacon of the Canadian Ice Service
 * (1997_12995), whose displacement per axis is 1.4 km after 2.5 h and 7.8 km after a day.
 */
inline constexpr DriftProcess kFittedDrift{.velocitySpread_mps = 0.15, .velocityTime_s = 36'000};

/** Covariance of position and velocity along one axis. */
struct DriftVariances
{
    double position_m2 = 0;    ///< P, variance of the position
    double mixed_m2ps = 0;     ///< C, covariance of position and velocity
    double velocity_m2ps2 = 0; ///< V, variance of the velocity
    bool operator==(const DriftVariances&) const = default;
};

/**
 * Returns the variances after `dt_s` >= 0 without a measurement. With T the velocity time, S its
 * spread, r = exp(-dt / T) and a = T (1 - r):
 *
 *     P' = P + q dt + 2 C a + V a^2 + S^2 T (2 dt - T (3 - 4 r + r^2))
 *     C' = r (C + V a) + S^2 T (1 - r)^2
 *     V' = r^2 V + S^2 (1 - r^2)
 *
 * For a constant velocity (T = 0) they are P + q dt + 2 C dt + V dt^2, C + V dt and V. The result
 * is exact, also for small steps: where terms cancel (dt << T) their series is summed. (Gillespie
 * 1996, Phys. Rev. E 54, 2084: moments of the process and its integral.)
 */
[[nodiscard]] DriftVariances grown(const DriftVariances& now, const DriftProcess& process,
                                   double dt_s);

/** Returns the integral of P over the next `dt_s`, m^2 s, in closed form: the growth of zeta. */
[[nodiscard]] double positionIntegral_m2s(const DriftVariances& now, const DriftProcess& process,
                                          double dt_s);

/**
 * Transition of the velocity over a time step, along one axis. A velocity u above the mean becomes
 * kept u + velocity_mps n and moves the iceberg by carried_s u + shared_m n + place_m m, with n and
 * m standard normal and independent. Exact for steps of any length.
 */
struct VelocityStep
{
    double kept = 1;
    double carried_s = 0;
    double velocity_mps = 0;
    double shared_m = 0;
    double place_m = 0;
};
/** Returns the transition of the process over `dt_s` >= 0; the white noise of q is not part of it.
 */
[[nodiscard]] VelocityStep velocityStep(const DriftProcess& process, double dt_s);

/**
 * Returns the time, s, in which a constant velocity moves as far as a fading one does in `dt_s`,
 * which must not be negative. Returns `dt_s` if `velocityTime_s` is 0.
 */
[[nodiscard]] double carriedFor_s(double velocityTime_s, double dt_s);

/**
 * Mean velocity of an iceberg that changes with place and time, as wind and current do. Mean
 * velocities are held for `kStep_s` of the run, with the value of the middle of that time at the
 * place where the iceberg is at its beginning. Immutable: several threads may share an object.
 */
class DriftForcing
{
public:
    static constexpr double kStep_s = 60;

    DriftForcing() = default;
    DriftForcing(const DriftForcing&) = delete;
    DriftForcing& operator=(const DriftForcing&) = delete;
    virtual ~DriftForcing() = default;

    /** Returns the number of the step that contains a run time. */
    [[nodiscard]] static std::int64_t stepAt(double time_s)
    {
        constexpr double kRounding = 1e-9;
        return static_cast<std::int64_t>(std::floor(time_s / kStep_s + kRounding));
    }
    /** Returns the mean velocity in a step, or nullopt if the iceberg is aground at the place. */
    [[nodiscard]] std::optional<Point> mean_mps(const Point& place_m, std::int64_t step) const
    {
        return meanAt_mps(place_m, (static_cast<double>(step) + 0.5) * kStep_s);
    }
    /** Returns a speed that no mean velocity exceeds. */
    [[nodiscard]] virtual double fastest_mps() const = 0;

private:
    [[nodiscard]] virtual std::optional<Point> meanAt_mps(const Point& place_m,
                                                          double time_s) const = 0;
};

/** Parameters of the motion of an iceberg, Eq. (17). */
struct DriftSpec
{
    Point position_m = Point::Zero();   ///< position at `start_s`
    double start_s = 0;                 ///< time at which the noise grid starts
    Point velocity_mps = Point::Zero(); ///< velocity at `start_s`
    double q_m2ps = 0.025;              ///< the variance grows by q t along each axis
    Point mean_mps = Point::Zero();     ///< mean to which a variable velocity fades
    double velocitySpread_mps = 0;      ///< see `DriftProcess`
    double velocityTime_s = 0;          ///< see `DriftProcess`
    /**
     * If set, the iceberg follows this track without noise, in place of Eq. (17). Copies share it.
     */
    std::shared_ptr<const RecordedTrack> track;
    /**
     * If set, `mean_mps`, which is part of `velocity_mps`, changes with place and time, and the
     * iceberg stands still from the step on in which it is aground. Copies share it.
     */
    std::shared_ptr<const DriftForcing> forcing = {};
};

/**
 * Random numbers that drive the drift of one iceberg: for each second a standard normal number per
 * axis, from the stream (seed, id). The first `seconds` are drawn in advance and shared by copies,
 * so that many flights of one scenario draw them only once (16 bytes each); later ones are drawn on
 * demand. Different copies may be used by several threads.
 */
class DriftNoise
{
public:
    DriftNoise(std::uint64_t seed, std::string_view id, std::size_t seconds = 0);

    /** Returns an independent stream of the same iceberg. */
    [[nodiscard]] DriftNoise velocityStream() const;

    /** Returns whether this is the stream of the seed `seed` and the iceberg `id`. */
    [[nodiscard]] bool isOf(std::uint64_t seed, std::string_view id) const
    {
        return m_seed == seed && m_stream == stableHash(id);
    }

    /** Returns the numbers of the next second and advances the stream. */
    [[nodiscard]] Point next()
    {
        return m_drawn && m_taken < m_drawn->size() ? (*m_drawn)[m_taken++] : draw();
    }

    /** Upper bound of the absolute value of every number. */
    static constexpr double kLargest = Random::kLargestNormal;

private:
    DriftNoise(std::uint64_t seed, std::uint64_t stream);
    [[nodiscard]] Point draw();

    std::uint64_t m_seed;
    std::uint64_t m_stream;
    /** Numbers drawn in advance; null if there are none. */
    std::shared_ptr<const std::vector<Point>> m_drawn;
    std::size_t m_taken = 0; ///< how many of `m_drawn` have been used
    Random m_random;         ///< continues the stream after them
};

/**
 * True motion of one iceberg: along its recorded track if it has one, otherwise Eq. (17), known
 * velocity plus white-noise velocity. The noise moves it by N(0, q 1 s) per axis in each second of
 * a fixed grid and is linear between, so it is the same for every planner and time step. A variable
 * velocity changes on the same grid, from a stream of its own. Times may only advance.
 */
class DriftModel
{
public:
    /**
     * Makes the motion from the stream (seed, id). Without `noise` the iceberg moves with its known
     * velocity alone.
     */
    DriftModel(const DriftSpec& spec, std::uint64_t seed, std::string_view id, bool noise);
    /** Makes the motion from an existing stream of which no number has been used. */
    DriftModel(const DriftSpec& spec, DriftNoise source, bool noise);

    /** Advances the noise to `time_s`; later calls may only ask for that time or later. */
    void advanceTo(double time_s)
    {
        if (!m_isStepped)
            return;
        while (time_s - m_start_s >= static_cast<double>(m_second + 1))
            nextSecond();
    }

    /**
     * Returns the true position at `time_s`, which must not be before the time of `advanceTo`.
     * Draws as many numbers as there are seconds between the two.
     */
    [[nodiscard]] Point at(double time_s) const
    {
        if (m_track)
            return m_track->at(time_s);
        const double age_s = time_s - m_start_s;
        if (m_isStepped && age_s >= static_cast<double>(m_second + 1))
            return aheadAt(time_s);
        const double inSecond_s = age_s - static_cast<double>(m_second);
        return m_start_m + m_velocity_mps * (age_s - m_base_s) + m_noise_m + m_step_m * inSecond_s;
    }

    /** Advances to `time_s` and returns the position then. */
    [[nodiscard]] Point position_m(double time_s)
    {
        advanceTo(time_s);
        return at(time_s);
    }

    /**
     * Returns the true velocity, without the white noise, at the last whole second of `advanceTo`.
     * For an iceberg with a recorded track it is the velocity of the specification instead.
     */
    [[nodiscard]] Point velocity_mps() const { return m_velocity_mps + m_excess_mps; }

    [[nodiscard]] double start_s() const { return m_start_s; }

    /**
     * Returns a speed that the iceberg never exceeds between any two times; infinity if none is
     * known.
     */
    [[nodiscard]] double speedLimit_mps() const;

private:
    [[nodiscard]] Point aheadAt(double time_s) const;
    void nextSecond();
    void drawStep();
    void followForcing();

    std::shared_ptr<const RecordedTrack> m_track;
    std::shared_ptr<const DriftForcing> m_forcing; ///< null if the mean velocity is constant
    std::int64_t m_forcingStep = 0;                ///< step of `m_mean_mps`
    Point m_mean_mps = Point::Zero();
    Point m_own_mps = Point::Zero(); ///< constant velocity above the mean
    double m_base_s = 0; ///< age at which the constant part of the velocity was last changed
    bool m_isAground = false;
    Point m_start_m; ///< position without the noise at `m_base_s`
    double m_start_s;
    Point m_velocity_mps; ///< the constant part of the velocity
    double m_deviation_m; ///< standard deviation of one increment
    VelocityStep m_fade;  ///< transition of one second
    bool m_isStepped;     ///< whether anything but `m_velocity_mps` moves it
    DriftNoise m_velocitySource;
    DriftNoise m_source;
    Point m_excess_mps = Point::Zero();     ///< velocity above `m_velocity_mps` at `m_second`
    Point m_nextExcess_mps = Point::Zero(); ///< that excess one second later
    std::int64_t m_second = 0;
    Point m_noise_m = Point::Zero(); ///< displacement accumulated until `m_second`
    Point m_step_m = Point::Zero();  ///< increment of the present second
};

} // namespace berg
