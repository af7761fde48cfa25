#include "core/plan/solve/cbc_wire.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <type_traits>

namespace berg {

namespace {

class PayloadWriter
{
public:
    template <typename Number>
    PayloadWriter& add(Number value)
    {
        static_assert(std::is_arithmetic_v<Number> || std::is_enum_v<Number>);
        const std::size_t end = m_bytes.size();
        m_bytes.resize(end + sizeof(Number));
        std::memcpy(m_bytes.data() + end, &value, sizeof(Number));
        return *this;
    }
    template <typename Number>
    PayloadWriter& add(const std::optional<Number>& value)
    {
        return add(value.has_value()).add(value.value_or(Number{}));
    }
    template <typename Item>
    PayloadWriter& add(const std::vector<Item>& items)
    {
        add(static_cast<std::uint64_t>(items.size()));
        for (const Item& item : items)
            add(item);
        return *this;
    }
    PayloadWriter& add(const std::string& text)
    {
        add(static_cast<std::uint64_t>(text.size()));
        m_bytes += text;
        return *this;
    }
    [[nodiscard]] CbcFrame frame(CbcFrameKind kind) { return {kind, std::move(m_bytes)}; }

private:
    std::string m_bytes;
};

class PayloadReader
{
public:
    PayloadReader(const CbcFrame& frame, CbcFrameKind kind) : m_rest(frame.payload)
    {
        if (frame.kind != kind)
            throw CbcWireFault("it sent a message of another kind than expected");
    }
    template <typename Number>
    void read(Number& value)
    {
        // A byte other than 0 and 1 would not be a valid bool.
        if constexpr (std::is_same_v<Number, bool>) {
            std::uint8_t byte = 0;
            read(byte);
            value = byte != 0;
        } else {
            requireBytes(sizeof(Number));
            std::memcpy(&value, m_rest.data(), sizeof(Number));
            m_rest.remove_prefix(sizeof(Number));
        }
    }
    template <typename Number>
    void read(std::optional<Number>& value)
    {
        bool isThere = false;
        Number number{};
        read(isThere);
        read(number);
        value = isThere ? std::optional(number) : std::nullopt;
    }
    template <typename Item>
    void read(std::vector<Item>& items)
    {
        std::uint64_t count = 0;
        read(count);
        constexpr std::size_t kLeast = std::is_arithmetic_v<Item> ? sizeof(Item) : sizeof(count);
        if (count > m_rest.size() / kLeast)
            throw CbcWireFault("it sent a message that is too short");
        items.resize(count);
        for (Item& item : items)
            read(item);
    }
    void read(std::string& text)
    {
        std::uint64_t count = 0;
        read(count);
        requireBytes(count);
        text = m_rest.substr(0, count);
        m_rest.remove_prefix(count);
    }
    /**
     * Reads an enumerator up to `last`, the last one of its enum: update callers when the enum
     * grows.
     */
    template <typename Choice>
    void readEnum(Choice last, Choice& value)
    {
        std::int32_t number = 0;
        read(number);
        if (number < 0 || number > static_cast<std::int32_t>(last))
            throw CbcWireFault("it sent a message with an unknown value");
        value = static_cast<Choice>(number);
    }
    void end() const
    {
        if (!m_rest.empty())
            throw CbcWireFault("it sent a message that is too long");
    }

private:
    void requireBytes(std::uint64_t bytes) const
    {
        if (bytes > m_rest.size())
            throw CbcWireFault("it sent a message that is too short");
    }

    std::string_view m_rest;
};

template <typename Choice>
std::int32_t numberOf(Choice value)
{
    return static_cast<std::int32_t>(value);
}

std::vector<int> onlyOrder(const FleetPlan& plan)
{
    return plan.empty() ? std::vector<int>{} : numbersOf(plan.front());
}

/** Returns the plan of one UAV; empty if the order is empty. */
FleetPlan planOf(const std::vector<int>& numbers, const TvpProblem& problem)
{
    if (numbers.empty())
        return {};
    const VisitOrder order = nodesOf(numbers);
    if (!isVisitOrder(problem, order))
        throw CbcWireFault("it sent an order that does not fit the problem");
    return {order};
}

} // namespace

CbcFrame cbcHello()
{
    return PayloadWriter().add(kCbcWireVersion).frame(CbcFrameKind::Hello);
}

void requireCbcHello(const CbcFrame& frame)
{
    PayloadReader reader(frame, CbcFrameKind::Hello);
    std::int32_t version = 0;
    reader.read(version);
    if (version != kCbcWireVersion)
        throw CbcWireFault("it belongs to another version of Bergwatch");
    reader.end();
}

CbcFrame cbcFrame(const CbcFailure& failure)
{
    PayloadWriter writer;
    return writer.add(failure.words).add(failure.isOutOfMemory).frame(CbcFrameKind::Failure);
}

CbcFailure cbcFailureOf(const CbcFrame& frame)
{
    PayloadReader reader(frame, CbcFrameKind::Failure);
    CbcFailure failure;
    reader.read(failure.words);
    reader.read(failure.isOutOfMemory);
    reader.end();
    return failure;
}

CbcFrame cbcFrame(const CbcProblem& problem)
{
    const TvpProblem& tvp = problem.problem;
    const SolveOptions& options = problem.options;
    PayloadWriter writer;
    writer.add(numberOf(problem.formulation)).add(tvp.sigma_m2).add(tvp.mu);
    writer.add(numberOf(tvp.route)).add(numberOf(tvp.criterion));
    writer.add(
        std::vector<double>(tvp.distance_m.reshaped().begin(), tvp.distance_m.reshaped().end()));
    writer.add(options.timeLimit_s).add(options.workLimit).add(options.memoryLimit_bytes);
    writer.add(options.gap).add(onlyOrder(options.hint));
    return writer.frame(CbcFrameKind::Problem);
}

CbcProblem cbcProblemOf(const CbcFrame& frame)
{
    PayloadReader reader(frame, CbcFrameKind::Problem);
    CbcProblem problem;
    TvpProblem& tvp = problem.problem;
    SolveOptions& options = problem.options;
    reader.readEnum(Formulation::Reduced, problem.formulation);
    reader.read(tvp.sigma_m2);
    reader.read(tvp.mu);
    reader.readEnum(Route::Closed, tvp.route);
    reader.readEnum(Criterion::Latency, tvp.criterion);
    std::vector<double> distance_m;
    reader.read(distance_m);
    const std::size_t nodes = tvp.sigma_m2.size();
    if (distance_m.size() != nodes * nodes)
        throw CbcWireFault("it sent a problem with a wrong number of distances");
    const auto side = static_cast<Eigen::Index>(nodes);
    tvp.distance_m = Eigen::Map<const Eigen::MatrixXd>(distance_m.data(), side, side);
    reader.read(options.timeLimit_s);
    reader.read(options.workLimit);
    reader.read(options.memoryLimit_bytes);
    reader.read(options.gap);
    std::vector<int> hint;
    reader.read(hint);
    reader.end();
    if (tvp.icebergCount() < 1 || !validate(tvp).empty())
        throw CbcWireFault("it sent an invalid problem");
    options.hint = planOf(hint, tvp);
    return problem;
}

CbcFrame cbcFrame(const CbcPartition& partition)
{
    PayloadWriter writer;
    writer.add(static_cast<std::int32_t>(partition.rows)).add(partition.columns);
    writer.add(partition.costs).add(partition.slack);
    return writer.frame(CbcFrameKind::Partition);
}

CbcPartition cbcPartitionOf(const CbcFrame& frame)
{
    PayloadReader reader(frame, CbcFrameKind::Partition);
    CbcPartition partition;
    reader.read(partition.rows);
    reader.read(partition.columns);
    reader.read(partition.costs);
    reader.read(partition.slack);
    reader.end();
    const auto isRow = [&partition](int row) { return row >= 0 && row < partition.rows; };
    const auto areRows = [&isRow](const std::vector<int>& rows) {
        return std::ranges::all_of(rows, isRow);
    };
    const auto isCost = [](double cost) { return std::isfinite(cost); };
    if (partition.costs.size() != partition.columns.size() || !(partition.slack > 0) ||
        !std::ranges::all_of(partition.columns, areRows) ||
        !std::ranges::all_of(partition.costs, isCost))
        throw CbcWireFault("it sent an invalid partition");
    return partition;
}

CbcFrame cbcFrame(const SolveProgress& progress)
{
    PayloadWriter writer;
    writer.add(onlyOrder(progress.plan)).add(progress.objective).add(progress.bound);
    return writer.frame(CbcFrameKind::Progress);
}

SolveProgress cbcProgressOf(const CbcFrame& frame, const TvpProblem& problem)
{
    PayloadReader reader(frame, CbcFrameKind::Progress);
    SolveProgress progress;
    std::vector<int> order;
    reader.read(order);
    reader.read(progress.objective);
    reader.read(progress.bound);
    reader.end();
    progress.plan = planOf(order, problem);
    return progress;
}

CbcFrame cbcFrame(const SolveOutcome& outcome)
{
    PayloadWriter writer;
    writer.add(numberOf(outcome.status)).add(numberOf(outcome.reason));
    writer.add(onlyOrder(outcome.plan)).add(outcome.bound).add(outcome.work);
    writer.add(outcome.hintUsed).add(outcome.detail);
    return writer.frame(CbcFrameKind::Outcome);
}

SolveOutcome cbcOutcomeOf(const CbcFrame& frame, const TvpProblem& problem)
{
    PayloadReader reader(frame, CbcFrameKind::Outcome);
    SolveOutcome outcome;
    std::vector<int> order;
    reader.readEnum(SolveStatus::None, outcome.status);
    reader.readEnum(StopReason::Unable, outcome.reason);
    reader.read(order);
    reader.read(outcome.bound);
    reader.read(outcome.work);
    reader.read(outcome.hintUsed);
    reader.read(outcome.detail);
    reader.end();
    outcome.plan = planOf(order, problem);
    if (outcome.plan.empty() != (outcome.status == SolveStatus::None))
        throw CbcWireFault("it sent a status that does not fit its order");
    return outcome;
}

CbcFrame cbcFrame(const CbcChoice& choice)
{
    return PayloadWriter().add(choice.complete).add(choice.columns).frame(CbcFrameKind::Chosen);
}

CbcChoice cbcChoiceOf(const CbcFrame& frame, const CbcPartition& partition)
{
    PayloadReader reader(frame, CbcFrameKind::Chosen);
    CbcChoice choice;
    reader.read(choice.complete);
    reader.read(choice.columns);
    reader.end();
    const auto isColumn = [&partition](int column) {
        return column >= 0 && static_cast<std::size_t>(column) < partition.columns.size();
    };
    if (!std::ranges::all_of(choice.columns, isColumn))
        throw CbcWireFault("it sent a choice that does not fit the partition");
    return choice;
}

std::string cbcBytes(const CbcFrame& frame)
{
    const CbcFrameHead head{.kind = frame.kind, .length = frame.payload.size()};
    std::string bytes(sizeof head, '\0');
    std::memcpy(bytes.data(), &head, sizeof head);
    return bytes + frame.payload;
}

std::optional<CbcFrame> CbcFrameBuffer::nextFrame()
{
    CbcFrameHead head;
    if (m_bytes.size() < sizeof head)
        return std::nullopt;
    std::memcpy(&head, m_bytes.data(), sizeof head);
    if (head.kind < CbcFrameKind::Hello || head.kind > CbcFrameKind::Failure ||
        head.length > kMostCbcPayload_bytes)
        throw CbcWireFault("it sent something that is not a message");
    const std::size_t length = sizeof head + head.length;
    if (m_bytes.size() < length)
        return std::nullopt;
    CbcFrame frame{.kind = head.kind, .payload = m_bytes.substr(sizeof head, head.length)};
    m_bytes.erase(0, length);
    return frame;
}

} // namespace berg
