#pragma once

#include "core/bound/zeta_bound.h"
#include "widgets/flight/flight_record.h"
#include "widgets/tasks/latest_task.h"

#include <QObject>
#include <QTimer>

#include <optional>

namespace berg {

/**
 * Computes the lower bound on zeta of a scenario (`zetaLowerBound`) on its own thread at low
 * priority, a second after the last change. Changes that do not affect the bound (planner, asset,
 * names) are ignored. GUI thread.
 */
class BoundRunner : public QObject
{
    Q_OBJECT

public:
    explicit BoundRunner(QObject* parent = nullptr,
                         std::int64_t workLimit = ZetaBoundOptions().workLimit);

    /**
     * Sets the scenario to bound; one that differs drops the known bound. A scenario with errors
     * has none.
     */
    void setScenario(const Scenario& scenario);

    /** Returns the bound of the present scenario as far as it is known. */
    [[nodiscard]] const KnownBound& known() const { return m_known; }
    /** Returns whether no computation is pending or running. */
    [[nodiscard]] bool isComplete() const { return m_complete; }

signals:
    /** Emitted when `known()` has changed, also when it was cleared. */
    void updated();

private:
    void start();

    std::optional<Scenario> m_scenario; ///< reduced to what the bound depends on
    KnownBound m_known;
    bool m_complete = true;
    QTimer m_pause; ///< restarted by each change
    /** Last member: its thread ends before the others are destroyed. */
    LatestTask<Scenario, KnownBound> m_task;
};

} // namespace berg
