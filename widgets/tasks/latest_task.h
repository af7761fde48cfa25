#pragma once

#include "widgets/tasks/mailbox.h"
#include "widgets/tasks/work_failure.h"

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
    Low ///< yields to the mission and the window
};

/**
 * A thread that runs posted jobs in order. The destructor waits for the current job and discards
 * the rest.
 */
class WorkThread
{
public:
    explicit WorkThread(const QString& name, WorkPriority priority = WorkPriority::Normal);
    WorkThread(const WorkThread&) = delete;
    WorkThread& operator=(const WorkThread&) = delete;
    ~WorkThread();

    /** Runs `job` on the thread after those posted before. It must not throw. */
    template <class Job>
    void post(Job&& job)
    {
        QMetaObject::invokeMethod(m_onThread, std::forward<Job>(job), Qt::QueuedConnection);
    }
    /** Waits until all jobs posted so far are done. */
    void waitForPosted();
    /** Waits until all jobs posted so far are done, then ends the thread. */
    void finish();

private:
    QThread m_thread;
    QObject* m_onThread; ///< receiver of posted jobs; lives on `m_thread`
};

/**
 * Work on its own thread of which only the newest request counts: a new request stops the work
 * in progress, and its later results are discarded. Results and the end are delivered on the
 * owner's thread; of several results that wait only the newest is delivered. Exceptions of the work
 * are reported at the end. The destructor stops the work and waits for the thread.
 */
template <class Request, class Result>
class LatestTask
{
public:
    using Deliver = std::function<void(Result)>;
    struct Parts
    {
        /** Runs on the task's thread and passes on results as they come. */
        std::function<void(Request&, const std::stop_token&, const Deliver&)> work;
        std::function<void(Result)> deliver;
        /** Called after the last result. */
        std::function<void(const std::optional<WorkFailure>&)> end = [](const auto&) {};
    };

    LatestTask(const QString& name, Parts parts, WorkPriority priority = WorkPriority::Normal)
        : m_parts(std::move(parts)), m_thread(name, priority)
    {
    }
    LatestTask(const LatestTask&) = delete;
    LatestTask& operator=(const LatestTask&) = delete;
    ~LatestTask() { m_stop.request_stop(); }

    /** Drops the work in progress and starts work on the request. */
    void start(Request request)
    {
        drop();
        m_stop = std::stop_source();
        m_thread.post([this, generation = m_generation, request = std::move(request),
                       stop = m_stop.get_token()]() mutable { run(generation, request, stop); });
    }
    /** Stops the work; the results so far and the end are still delivered. */
    void stop() { m_stop.request_stop(); }
    /** Stops the work and discards its results and its end. */
    void drop()
    {
        m_stop.request_stop();
        ++m_generation;
    }
    /** Runs a job on the task's thread, after the requests started before. */
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
        // `deliver` may have dropped it.
        if (delivery->ended && delivery->generation == m_generation)
            m_parts.end(delivery->failure);
    }

    Parts m_parts;
    std::uint64_t m_generation = 0;
    std::stop_source m_stop; ///< stops the present generation
    Mailbox<Delivery> m_deliveries;
    QObject m_home;      ///< receiver on the owner's thread
    WorkThread m_thread; ///< last member: its thread ends before the others are destroyed
};

/** Limits the rate of reports: a report costs more than many steps of the work. */
class ReportPace
{
public:
    explicit ReportPace(qint64 between_ms) : m_between_ms(between_ms) { m_sinceLast.start(); }

    /** Returns true if the time between reports has passed since it last returned true. */
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
