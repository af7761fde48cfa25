#pragma once

#include "widgets/model/mailbox.h"
#include "widgets/model/work_failure.h"

#include <QElapsedTimer>
#include <QObject>
#include <QThread>

#include <cstdint>
#include <functional>
#include <optional>
#include <stop_token>
#include <utility>

namespace berg {

enum class WorkPriority
{
    Normal,
    Low ///< gives way to the mission and the window
};

/** A thread that does what is posted to it, in turn. Ends with what it is doing then. */
class WorkThread
{
public:
    explicit WorkThread(const QString& name, WorkPriority priority = WorkPriority::Normal);
    WorkThread(const WorkThread&) = delete;
    WorkThread& operator=(const WorkThread&) = delete;
    ~WorkThread();

    /** `job` must not throw. */
    template <class Job>
    void post(Job&& job)
    {
        QMetaObject::invokeMethod(m_onThread, std::forward<Job>(job), Qt::QueuedConnection);
    }
    /** Waits until all that was posted so far is done. */
    void waitForPosted();
    /** Likewise; then it ends. */
    void finish();

private:
    QThread m_thread;
    QObject* m_onThread; ///< what is invoked on it runs on `m_thread`
};

/**
 * Work on a thread of its own, of which only the newest request counts: a new one stops the one
 * under way, and nothing that still comes of that is delivered. What is delivered, and the end,
 * reach the thread of the owner; of results that wait there the newest is kept. Whatever the work
 * throws is told at the end. Destruction stops the work and waits for the thread.
 */
template <class Request, class Result>
class LatestTask
{
public:
    using Tell = std::function<void(Result)>;
    struct Parts
    {
        /** On the thread: tells results as they come. */
        std::function<void(Request&, const std::stop_token&, const Tell&)> work;
        std::function<void(Result)> deliver;
        /** After the last result. */
        std::function<void(const std::optional<WorkFailure>&)> end = [](const auto&) {};
    };

    LatestTask(const QString& name, Parts parts, WorkPriority priority = WorkPriority::Normal)
        : m_parts(std::move(parts)), m_thread(name, priority)
    {
    }
    LatestTask(const LatestTask&) = delete;
    LatestTask& operator=(const LatestTask&) = delete;
    ~LatestTask() { m_stop.request_stop(); }

    void start(Request request)
    {
        drop();
        m_stop = std::stop_source();
        m_thread.post([this, generation = m_generation, request = std::move(request),
                       stop = m_stop.get_token()]() mutable { run(generation, request, stop); });
    }
    /** What it has come to by then is delivered, and its end. */
    void stop() { m_stop.request_stop(); }
    /** Stops it; nothing of it is delivered any more. */
    void drop()
    {
        m_stop.request_stop();
        ++m_generation;
    }
    /** On the thread, after what was started before. */
    template <class Job>
    void post(Job&& job)
    {
        m_thread.post(std::forward<Job>(job));
    }

private:
    struct Delivery
    {
        std::uint64_t generation = 0;
        std::optional<Result> result;
        bool ended = false;
        std::optional<WorkFailure> failure;
    };

    void run(std::uint64_t generation, Request& request, const std::stop_token& stop)
    {
        auto failure = failureOf([&] {
            m_parts.work(request, stop, [this, generation](Result result) {
                send({.generation = generation, .result = std::move(result)});
            });
        });
        send({.generation = generation, .ended = true, .failure = std::move(failure)});
    }

    void send(Delivery delivery)
    {
        const auto join = [](Delivery& waiting, Delivery next) {
            if (!next.result && next.generation == waiting.generation)
                next.result = std::move(waiting.result);
            waiting = std::move(next);
        };
        if (m_deliveries.put(std::move(delivery), join))
            QMetaObject::invokeMethod(
                &m_home, [this] { take(); }, Qt::QueuedConnection);
    }

    void take()
    {
        std::optional<Delivery> delivery = m_deliveries.take();
        if (!delivery || delivery->generation != m_generation)
            return;
        if (delivery->result)
            m_parts.deliver(std::move(*delivery->result));
        if (delivery->ended && delivery->generation == m_generation) // not dropped by whom it told
            m_parts.end(delivery->failure);
    }

    Parts m_parts;
    std::uint64_t m_generation = 0;
    std::stop_source m_stop; ///< of the generation under way
    Mailbox<Delivery> m_deliveries;
    QObject m_home;      ///< of the thread of the owner
    WorkThread m_thread; ///< last: it ends before the rest
};

/** Lets a report through at most every so often: telling costs more than many a step of work. */
class ReportPace
{
public:
    explicit ReportPace(qint64 between_ms) : m_between_ms(between_ms) { m_sinceLast.start(); }

    [[nodiscard]] bool isDue()
    {
        if (m_sinceLast.elapsed() < m_between_ms)
            return false;
        m_sinceLast.restart();
        return true;
    }

private:
    qint64 m_between_ms;
    QElapsedTimer m_sinceLast;
};

} // namespace berg
