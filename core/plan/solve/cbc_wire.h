#pragma once

#include "core/plan/solve/solver.h"

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

// How other programs ask `bergwatch-cbc`, which solves one request with COIN-OR CBC and ends:
// frames of kind, length and payload over a socket, numbers as this machine has them.

namespace berg {

/** Of all that follows: both sides begin with a `Hello` that holds theirs. */
inline constexpr std::int32_t kCbcWireVersion = 1;
/** Of a payload; the largest problems that CBC is offered have some megabytes. */
inline constexpr std::uint64_t kMostCbcPayload_bytes = 256'000'000;

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

struct CbcFrame
{
    CbcFrameKind kind = CbcFrameKind::Failure;
    std::string payload = {};
};

/** The other side says what it may not. */
class CbcWireFault : public std::runtime_error
{
public:
    using std::runtime_error::runtime_error;
};

/** A problem of one UAV and what is wanted of it; nobody can be called back over the wire. */
struct CbcProblem
{
    Formulation formulation = Formulation::Position;
    TvpProblem problem = {};
    SolveOptions options = {};
};

/** Why there is no answer. */
struct CbcFailure
{
    std::string words = {};
    bool isOutOfMemory = false;
};

/** Binary columns, each in some of the rows, so that each row is in just one chosen column. */
struct CbcPartition
{
    int rows = 0;
    std::vector<std::vector<int>> columns = {}; ///< their rows
    std::vector<double> costs = {};             ///< of each column
    double slack = 0;                           ///< all that is chosen costs less, above 0
};

struct CbcChoice
{
    bool complete = false; ///< there is no better choice, or none at all
    std::vector<int> columns = {};
};

[[nodiscard]] CbcFrame cbcHello();
[[nodiscard]] CbcFrame cbcFrame(const CbcFailure& failure);
[[nodiscard]] CbcFrame cbcFrame(const CbcProblem& problem);
[[nodiscard]] CbcFrame cbcFrame(const CbcPartition& partition);
[[nodiscard]] CbcFrame cbcFrame(const SolveProgress& progress);
[[nodiscard]] CbcFrame cbcFrame(const SolveOutcome& outcome);
[[nodiscard]] CbcFrame cbcFrame(const CbcChoice& choice);

// The way back throws `CbcWireFault` for what is not of that kind, too short, too long or no value.
void requireCbcHello(const CbcFrame& frame);
[[nodiscard]] CbcFailure cbcFailureOf(const CbcFrame& frame);
[[nodiscard]] CbcProblem cbcProblemOf(const CbcFrame& frame);
[[nodiscard]] CbcPartition cbcPartitionOf(const CbcFrame& frame);
/** The plan is an order of the problem. */
[[nodiscard]] SolveProgress cbcProgressOf(const CbcFrame& frame, const TvpProblem& problem);
/** The plan is an order of the problem, or none when the status says so. */
[[nodiscard]] SolveOutcome cbcOutcomeOf(const CbcFrame& frame, const TvpProblem& problem);
/** The columns are some of the partition's. */
[[nodiscard]] CbcChoice cbcChoiceOf(const CbcFrame& frame, const CbcPartition& partition);

/** Before the payload of a frame. */
struct CbcFrameHead
{
    CbcFrameKind kind = CbcFrameKind::Failure;
    std::uint32_t unused = 0;
    std::uint64_t length = 0;
};

/** The frame as it is sent. */
[[nodiscard]] std::string cbcBytes(const CbcFrame& frame);

/** Puts frames together from what comes in, in pieces of any size. */
class CbcFrameBuffer
{
public:
    void add(std::string_view bytes) { m_bytes += bytes; }
    /** The next whole frame, if there is one. Throws `CbcWireFault` for one that is too long. */
    [[nodiscard]] std::optional<CbcFrame> taken();

private:
    std::string m_bytes;
};

} // namespace berg
