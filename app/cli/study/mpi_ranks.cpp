#include "app/cli/console.h"
#include "app/cli/study/mpi_world.h"
#include "app/cli/study/shard_flight.h"
#include "app/cli/study/sweep_flight.h"
#include "core/base/random.h"
#include "core/io/study/study_json.h"

#include <chrono>
#include <cstdio>
#include <cstring>
#include <utility>

namespace berg::cli {

namespace {

/** Time between two checks of messages and flown missions, which have threads of their own. */
void pause()
{
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
}

std::vector<char> bytesOf(const std::vector<SentOutcome>& outcomes)
{
    std::vector<char> bytes(outcomes.size() * sizeof(SentOutcome));
    std::memcpy(bytes.data(), outcomes.data(), bytes.size());
    return bytes;
}

std::vector<SentOutcome> outcomesOf(const std::vector<char>& bytes)
{
    std::vector<SentOutcome> outcomes(bytes.size() / sizeof(SentOutcome));
    std::memcpy(outcomes.data(), bytes.data(), bytes.size());
    return outcomes;
}

/** Code of an `Error` and its text; the code of a bug is that of no error. */
constexpr char kBug = -1;

std::vector<char> bytesOf(const std::exception_ptr& failure)
{
    std::vector<char> bytes{kBug};
    std::string text = "unknown failure";
    try {
        std::rethrow_exception(failure);
    } catch (const Error& error) {
        bytes.front() = static_cast<char>(error.code());
        text = error.what();
    } catch (const std::exception& error) {
        text = error.what();
    }
    bytes.insert(bytes.end(), text.begin(), text.end());
    return bytes;
}

std::exception_ptr failureOf(const MpiWorld::Message& message)
{
    const std::string subject = "rank " + std::to_string(message.from);
    const std::string text(message.bytes.begin() + 1, message.bytes.end());
    if (message.bytes.front() == kBug)
        return std::make_exception_ptr(std::runtime_error(subject + ": " + text));
    return std::make_exception_ptr(
        Error(static_cast<ErrorCode>(message.bytes.front()), subject, text));
}

/** Runs every rank except the first. */
void follow(const MpiWorld& world, Study study, const StudyOptions& options)
{
    ShardFlight flight(std::move(study), options);
    bool reported = false;
    for (;; pause()) {
        while (const auto message = world.receive()) {
            if (message->tag == Tag::End)
                return;
            flight.stop();
        }
        if (reported)
            continue;
        const bool last = flight.hasEnded();
        if (const std::vector<SentOutcome> news = flight.take(); !news.empty())
            world.send(0, Tag::Outcomes, bytesOf(news));
        if (last && flight.failure())
            world.send(0, Tag::Failure, bytesOf(flight.failure()));
        if (last)
            world.send(0, Tag::Final);
        reported = last;
    }
}

/** Ends all ranks, if this rank cannot report its failure to the first one. */
void followOrAbort(const MpiWorld& world, const StudyOptions& options)
{
    try {
        const std::string text = world.shared({});
        if (!text.empty())
            follow(world, studyFromJson(text, "study"), options);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "rank %d: %s\n", world.rank(), error.what());
        world.abort(kFailure);
    }
}

/** Runs the first rank while the missions are flown. */
class Leader
{
public:
    Leader(const MpiWorld& world, const SweepLead& lead, Study& study, const Shard& shard)
        : m_world(world), m_lead(lead), m_study(study), m_waitingFor(world.size() - 1)
    {
        m_study.outcomes.resize(missionCount(m_study.spec));
        const std::size_t settings = settingsOf(m_study.spec).size();
        const auto parts = static_cast<std::size_t>(shard.count);
        for (std::size_t i = 0; i < m_study.outcomes.size(); ++i)
            if (i / settings % parts == static_cast<std::size_t>(shard.index - 1)) {
                ++m_count;
                m_done += m_study.outcomes[i] ? 1U : 0U;
            }
    }

    /** Whether all missions of the shard are flown; throws the first failure of any rank. */
    bool run(const StudyOptions& options)
    {
        ShardFlight flight(m_study, options);
        for (bool ended = false; m_waitingFor > 0 || !ended; pause()) {
            receive();
            ended = flight.hasEnded();
            for (const SentOutcome& outcome : flight.take())
                add(outcome);
            if (ended && flight.failure())
                fail(flight.failure());
            showProgress();
            if (options.stop.stop_requested() || m_failure)
                stopAll(flight);
        }
        if (m_failure)
            std::rethrow_exception(m_failure);
        return m_done == m_count;
    }

private:
    void receive()
    {
        while (const auto message = m_world.receive()) {
            if (message->tag == Tag::Outcomes)
                for (const SentOutcome& outcome : outcomesOf(message->bytes))
                    add(outcome);
            else if (message->tag == Tag::Failure)
                fail(failureOf(*message));
            else
                --m_waitingFor;
        }
    }

    void add(const SentOutcome& outcome)
    {
        m_study.outcomes.at(outcome.place) = outcome.outcome;
        ++m_done;
    }

    void fail(const std::exception_ptr& failure)
    {
        if (!m_failure)
            m_failure = failure;
    }

    void showProgress()
    {
        if (m_failure)
            return;
        try {
            m_lead.progress(m_study, m_done, m_count);
        } catch (...) {
            fail(std::current_exception());
        }
    }

    void stopAll(ShardFlight& flight)
    {
        if (std::exchange(m_stopped, true))
            return;
        flight.stop();
        m_world.sendToOthers(Tag::Stop);
    }

    const MpiWorld& m_world;
    const SweepLead& m_lead;
    Study& m_study;
    std::size_t m_done = 0;
    std::size_t m_count = 0;
    int m_waitingFor;
    bool m_stopped = false;
    std::exception_ptr m_failure;
};

/** Calls `prepare` in the first rank alone, so that files are read and errors reported once. */
Study prepareForAll(const MpiWorld& world, const SweepLead& lead, bool sameOptions)
{
    try {
        if (!sameOptions)
            throw UsageError(
                QT_TRANSLATE_NOOP("CommandLine", "the MPI processes have different options"));
        Study study = lead.prepare();
        static_cast<void>(world.shared(studyToJson(study)));
        return study;
    } catch (...) {
        static_cast<void>(world.shared({}));
        throw;
    }
}

int leadAll(const MpiWorld& world, const SweepLead& lead, Study study, const StudyOptions& options,
            const Shard& shard)
{
    bool complete = false;
    try {
        complete = Leader(world, lead, study, shard).run(options);
    } catch (...) {
        world.sendToOthers(Tag::End);
        lead.keep(study);
        throw;
    }
    world.sendToOthers(Tag::End);
    lead.keep(study);
    return lead.finish(study, complete);
}

} // namespace

int flyOnRanks(const SweepLead& lead, const StudyOptions& options, const std::string& commandLine)
{
    const MpiWorld world;
    StudyOptions own = options;
    if (const int cores = world.coresEach(); !own.threads)
        own.threads = cores;
    own.shard = {.index = options.shard.index + options.shard.count * world.rank(),
                 .count = options.shard.count * world.size()};
    const bool same = world.isSameInAll(stableHash(commandLine));
    if (world.rank() == 0)
        return leadAll(world, lead, prepareForAll(world, lead, same), own, options.shard);
    followOrAbort(world, own);
    return kDone; // the first one says how it went
}

} // namespace berg::cli
