#pragma once

#include "core/bound/zeta_bound.h"
#include "widgets/model/flight_record.h"
#include "widgets/model/mailbox.h"

#include <QObject>
#include <QThread>
#include <QTimer>

#include <optional>

namespace berg {

/**
 * Finds what zeta of no flight of the scenario is below (`zetaLowerBound`), on a thread of its own
 * at low priority, a second after the last change. A change of what the bound does not depend on
 * (planner, asset, names) changes nothing. GUI thread.
 */
class BoundRunner : public QObject
{
    Q_OBJECT

public:
    explicit BoundRunner(QObject* parent = nullptr,
                         std::int64_t workLimit = BoundOptions().workLimit);
    /** Stops a search under way and waits for the thread: some milliseconds. */
    ~BoundRunner() override;

    /** None is known of a scenario with errors, or with several UAVs. */
    void setScenario(const Scenario& scenario);

    /** Of the present scenario only. */
    [[nodiscard]] const KnownBound& known() const { return m_known; }
    /** Nothing waits or is under way. */
    [[nodiscard]] bool isComplete() const { return m_complete; }

signals:
    /** `known()` is new, also none. */
    void updated();

private:
    struct Request
    {
        std::uint64_t generation = 0;
        Scenario scenario;
        std::stop_token stop;
    };
    struct Result
    {
        std::uint64_t generation = 0;
        bool complete = false;
        KnownBound known;
    };

    void start();
    void takeResult();
    // On the thread of the runner:
    void compute(const Request& request);
    void publish(Result result);

    std::int64_t m_workLimit;
    std::optional<Scenario> m_scenario; ///< without what does not matter
    KnownBound m_known;
    bool m_complete = true;
    std::uint64_t m_generation = 0;
    std::stop_source m_stop; ///< of the generation under way
    QTimer m_pause;          ///< runs out when changes have come to rest
    Mailbox<Result> m_results;
    QThread m_thread;
    QObject* m_onThread; ///< what is invoked on it runs on `m_thread`
};

} // namespace berg
