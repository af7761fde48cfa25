#pragma once

#include "core/plan/policy/fleet_task.h"
#include "core/plan/policy/tau_curve.h"
#include "core/scenario/scenario.h"
#include "widgets/tasks/latest_task.h"

#include <QObject>
#include <QTimer>

#include <functional>
#include <memory>
#include <optional>

namespace berg {

/**
 * Computes trade-off curves on its own thread at low priority, a moment after the last change, so
 * that a curve never delays a plan. The newest request wins; a request for the present problem is
 * ignored (a change of tau, for example, does not affect the curve). GUI thread.
 */
class CurveRunner : public QObject
{
    Q_OBJECT

public:
    explicit CurveRunner(QObject* parent = nullptr);

    /**
     * Requests the curve of the plan from the scenario's start; a scenario with errors has none.
     */
    void setScenario(const Scenario& scenario);
    /**
     * Requests the curve of another instant; `ids` of the request are iceberg indices of the
     * caller.
     */
    void setRequest(std::shared_ptr<const PlanRequest> request, Route route);
    /** Drops the curve and what is being computed. */
    void clear();

    /** Returns the newest curve of the present problem; it grows until it is `complete`. */
    [[nodiscard]] const TauCurve& curve() const { return m_curve; }
    /** Returns the problem of the curve, whose orders refer to the nodes of this problem. */
    [[nodiscard]] const FleetTask& problem() const { return m_problem; }

signals:
    /** Emitted when the curve has changed, also when it was dropped. */
    void updated();

private:
    /** Makes the problem of a curve, or returns nullopt if there is no curve. */
    using MakeProblem = std::function<std::optional<FleetTask>()>;

    void schedule(MakeProblem problem);
    void accept(std::optional<FleetTask> problem);
    void dropCurve(bool complete);
    void start();

    std::optional<Scenario> m_scenario; ///< scenario requested last; nullopt after `setRequest`
    MakeProblem m_next; ///< request since the last change; the problem is made when changes stop
    FleetTask m_problem;
    TauCurve m_curve{.intervals = {}, .complete = true};
    QTimer m_pause; ///< restarted by each change
    /** Last member: its thread ends before the others are destroyed. */
    LatestTask<FleetTask, TauCurve> m_task;
};

} // namespace berg
