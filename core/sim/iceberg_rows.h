#pragma once

#include "core/sim/simulation.h"

#include <span>
#include <vector>

namespace berg {

/** One iceberg at the instant of a sample. */
struct IcebergSample
{
    double sigma_m2 = 0;
    bool inView = false;
    bool active = true; ///< false until it appears
    Point truth_m = Point::Zero();
};

/** All of them now, by index. */
[[nodiscard]] std::vector<IcebergSample> icebergsOf(const Simulation& now);

/**
 * The icebergs at every sample of a flight, bit for bit and in little room: from one row that is
 * whole to the next sigmas grow and places drift, and only what does something else is kept.
 */
class IcebergRows
{
public:
    /** The next row; `whole`: those after it are read from it on. The first one is. */
    void add(const Simulation& now, bool whole);
    [[nodiscard]] std::size_t size() const { return m_rows.size(); }

private:
    friend class IcebergReader;

    /** What becomes of one iceberg while nothing happens to it. */
    struct Course
    {
        DriftVariances variances;
        DriftProcess process;
        bool inView = false;
        bool active = false;
        bool grows = false; ///< known of, and not seen exactly
    };
    struct Change
    {
        int iceberg = 0;
        Course course;
    };
    struct Row
    {
        std::int64_t step = 0;
        std::size_t whole = 0;   ///< which of `m_whole` it is read from
        std::size_t changes = 0; ///< where its own end
    };
    /** All icebergs, from row to row. */
    struct Courses
    {
        std::int64_t step = 0;
        std::vector<Course> icebergs;

        void advanceTo(std::int64_t until, double dt_s);
    };

    [[nodiscard]] static Course courseOf(const Simulation& now, int iceberg);
    [[nodiscard]] std::span<const Change> changesOf(std::size_t row) const;

    std::vector<Row> m_rows;
    std::vector<Change> m_changes;
    std::vector<Courses> m_whole; ///< at the rows that are
    std::vector<World> m_added;   ///< at the first row after icebergs were added in flight
    Courses m_last;               ///< at the last row
};

/**
 * Reads the rows; one after another costs least. Borrows rows and keyframes, of which there may be
 * any, the start among them: places are found from the last one before a row.
 */
class IcebergReader
{
public:
    IcebergReader(const IcebergRows& rows, std::span<const Simulation> keyframes)
        : m_rows(rows), m_keyframes(keyframes)
    {
    }
    /** The icebergs at sample `row`, by index. Throws `std::out_of_range`. */
    [[nodiscard]] std::vector<IcebergSample> at(std::size_t row);

private:
    void goTo(std::size_t row);
    [[nodiscard]] const World& worldBefore(std::int64_t step) const;

    const IcebergRows& m_rows;
    std::span<const Simulation> m_keyframes;
    std::size_t m_next = 0; ///< the row after the one read last; 0: none yet
    IcebergRows::Courses m_courses;
    std::optional<World> m_world;
};

} // namespace berg
