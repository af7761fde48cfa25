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
 * The noise of one iceberg: for each second a standard normal number per axis, from the stream
 * (seed, id). The first `seconds` are drawn at once and shared by copies, so that many flights of
 * one scenario draw them only once (16 bytes each); what comes after is drawn as it is asked for.
 * Copies may be used by several threads.
 */
class DriftNoise
{
public:
    DriftNoise(std::uint64_t seed, std::string_view id, std::size_t seconds = 0);

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
 * a fixed grid and is linear between, so it is the same for every planner and time step. Asked
 * forward in time.
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
        if (m_deviation_m == 0)
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
        if (m_deviation_m != 0 && age_s >= static_cast<double>(m_second + 1))
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
    Point m_velocity_mps;
    double m_deviation_m; ///< of one increment
    DriftNoise m_source;
    std::int64_t m_second = 0;
    Point m_noise_m = Point::Zero(); ///< accumulated until m_second
    Point m_step_m = Point::Zero();  ///< increment of the second under way
};

} // namespace berg
