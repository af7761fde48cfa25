#pragma once

#include "core/bound/zeta_bound.h"
#include "widgets/model/flight_record.h"
#include "widgets/model/latest_task.h"

#include <QObject>
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

    /** None is known of a scenario with errors. */
    void setScenario(const Scenario& scenario);

    /** Of the present scenario only. */
    [[nodiscard]] const KnownBound& known() const { return m_known; }
    /** Nothing waits or is under way. */
    [[nodiscard]] bool isComplete() const { return m_complete; }

signals:
    /** `known()` is new, also none. */
    void updated();

private:
    void start();

    std::optional<Scenario> m_scenario; ///< without what does not matter
    KnownBound m_known;
    bool m_complete = true;
    QTimer m_pause;                          ///< runs out when changes have come to rest
    LatestTask<Scenario, KnownBound> m_task; ///< last: it ends before the rest
};

} // namespace berg
