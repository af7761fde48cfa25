#pragma once

#include "core/plan/solve/solver.h"

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

// Protocol of `bergwatch-cbc`, which solves one request with COIN-OR CBC and ends: frames of kind,
// length and payload over a socket, numbers in the format of this machine.

namespace berg {

/** Version of the protocol; both sides begin with a `Hello` that holds theirs. */
inline constexpr std::int32_t kCbcWireVersion = 1;
/** Largest payload; the largest problems for CBC need some megabytes. */
inline constexpr std::uint64_t kMostCbcPayload_bytes = 256'000'000;

/** Kind of a frame. */
enum class CbcFrameKind : std::uint32_t
{
    Hello = 0x42574342, ///< the version
    Problem,            ///< `CbcProblem`, answered by any number of `Progress`, then `Outcome`
    Partition,          ///< `CbcPartition`, answered by `Chosen`
    Progress,
    Outcome,
    Chosen,
    Failure ///< `CbcFailure`, in place of an answer
};

/** One message. */
struct CbcFrame
{
    CbcFrameKind kind = CbcFrameKind::Failure;
    std::string payload = {};
};

/** Thrown when the other side violates the protocol. */
class CbcWireFault : public std::runtime_error
{
public:
    using std::runtime_error::runtime_error;
};

/**
 * A problem of one UAV and its options. Only the limits, the gap and the hint of the options are
 * transmitted.
 */
struct CbcProblem
{
    Formulation formulation = Formulation::Position;
    TvpProblem problem = {};
    SolveOptions options = {};
};

/** Reason for a missing answer. */
struct CbcFailure
{
    std::string words = {};
    bool isOutOfMemory = false;
};

/**
 * A set partitioning: binary columns, each in some of the rows, so that each row is in exactly one
 * chosen column.
 */
struct CbcPartition
{
    int rows = 0;
    std::vector<std::vector<int>> columns = {}; ///< rows of each column
    std::vector<double> costs = {};             ///< cost of each column
    double slack = 0; ///< upper limit of the total cost of the chosen columns, > 0
};

/** Solution of a set partitioning. */
struct CbcChoice
{
    bool complete = false; ///< whether no better choice exists, or none at all
    std::vector<int> columns = {};
};

/** Returns the frame that opens a conversation. */
[[nodiscard]] CbcFrame cbcHello();

// The functions below return the frame that holds the value.
[[nodiscard]] CbcFrame cbcFrame(const CbcFailure& failure);
[[nodiscard]] CbcFrame cbcFrame(const CbcProblem& problem);
[[nodiscard]] CbcFrame cbcFrame(const CbcPartition& partition);
[[nodiscard]] CbcFrame cbcFrame(const SolveProgress& progress);
[[nodiscard]] CbcFrame cbcFrame(const SolveOutcome& outcome);
[[nodiscard]] CbcFrame cbcFrame(const CbcChoice& choice);

// The functions below read a frame; they throw `CbcWireFault` if it is of another kind, too short,
// too long or holds an invalid value.
void requireCbcHello(const CbcFrame& frame);
[[nodiscard]] CbcFailure cbcFailureOf(const CbcFrame& frame);
[[nodiscard]] CbcProblem cbcProblemOf(const CbcFrame& frame);
[[nodiscard]] CbcPartition cbcPartitionOf(const CbcFrame& frame);
/**
 * Reads progress; its plan is an order of the problem, or empty. Only plan, objective and bound are
 * transmitted.
 */
[[nodiscard]] SolveProgress cbcProgressOf(const CbcFrame& frame, const TvpProblem& problem);
/**
 * Reads an outcome; its plan is an order of the problem, or empty with status None. Only status,
 * reason, plan, bound, work, `hintUsed` and detail are transmitted; the other members keep their
 * defaults.
 */
[[nodiscard]] SolveOutcome cbcOutcomeOf(const CbcFrame& frame, const TvpProblem& problem);
/** Reads a choice; its columns are columns of the partition. */
[[nodiscard]] CbcChoice cbcChoiceOf(const CbcFrame& frame, const CbcPartition& partition);

/** Header before the payload of a frame. */
struct CbcFrameHead
{
    CbcFrameKind kind = CbcFrameKind::Failure;
    std::uint32_t unused = 0;
    std::uint64_t length = 0;
};

/** Returns the bytes of the frame as sent. */
[[nodiscard]] std::string cbcBytes(const CbcFrame& frame);

/** Assembles frames from bytes that arrive in pieces of any size. */
class CbcFrameBuffer
{
public:
    void add(std::string_view bytes) { m_bytes += bytes; }
    /**
     * Removes and returns the next complete frame, or returns nullopt if there is none. Throws
     * `CbcWireFault` if a frame is too long or of an unknown kind.
     */
    [[nodiscard]] std::optional<CbcFrame> nextFrame();

private:
    std::string m_bytes;
};

} // namespace berg
