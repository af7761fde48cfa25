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
    bool active = true; ///< false before it appears and after it has left
    Point truth_m = Point::Zero();
};

/** Returns all icebergs at the present instant, by index. */
[[nodiscard]] std::vector<IcebergSample> icebergsOf(const Simulation& now);

/**
 * Icebergs at every sample of a flight, exact to the last bit in little memory. From one complete
 * snapshot to the next, sigmas are grown and positions drift as the simulation does it; only
 * icebergs that deviate from this prediction are stored.
 */
class IcebergHistory
{
public:
    /**
     * Appends a row. With `isComplete` it starts a new snapshot from which later rows are read; the
     * first row always does.
     */
    void add(const Simulation& now, bool isComplete);
    [[nodiscard]] std::size_t size() const { return m_rows.size(); }

private:
    friend class IcebergReader;

    /** Growth of one iceberg's uncertainty until its next change. */
    struct State
    {
        DriftVariances variances;
        DriftProcess process;
        bool inView = false;
        bool active = false;
        /** True if the uncertainty grows: it has appeared and is not seen exactly. */
        bool grows = false;
    };
    struct Change
    {
        IcebergIndex iceberg;
        State state;
    };
    struct Row
    {
        std::int64_t step = 0;
        std::size_t snapshot = 0; ///< index of the snapshot it is read from
        std::size_t changes = 0;  ///< end of its own changes in `m_changes`
    };
    /** State of all icebergs at one row. */
    struct Snapshot
    {
        std::int64_t step = 0;
        std::vector<State> icebergs;

        void advanceTo(std::int64_t until, double dt_s);
    };

    [[nodiscard]] static State stateOf(const Simulation& now, IcebergIndex iceberg);
    [[nodiscard]] std::span<const Change> changesOf(std::size_t row) const;

    std::vector<Row> m_rows;
    std::vector<Change> m_changes;
    std::vector<Snapshot> m_snapshots; ///< complete snapshots
    std::vector<World> m_added; ///< worlds at the first row after icebergs were added in flight
    Snapshot m_last;            ///< state at the last row
};

/**
 * Reads rows; reading them in sequence is cheapest. Borrows the history and the keyframes.
 * Keyframes must be ascending and include the start; true positions are drawn again from the last
 * one before a row.
 */
class IcebergReader
{
public:
    IcebergReader(const IcebergHistory& rows, std::span<const Simulation> keyframes)
        : m_rows(rows), m_keyframes(keyframes)
    {
    }
    /**
     * Returns the icebergs at sample `row`, by index. Throws `std::out_of_range` if there is no
     * such row.
     */
    [[nodiscard]] std::vector<IcebergSample> at(std::size_t row);

private:
    void goTo(std::size_t row);
    [[nodiscard]] const World& worldBefore(std::int64_t step) const;

    const IcebergHistory& m_rows;
    std::span<const Simulation> m_keyframes;
    std::size_t m_next = 0; ///< row after the one read last; 0 before the first read
    IcebergHistory::Snapshot m_snapshot;
    std::optional<World> m_world;
};

} // namespace berg
