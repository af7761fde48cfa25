#pragma once

#include "core/plan/policy/fleet_task.h"
#include "core/plan/policy/tau_curve.h"
#include "core/scenario/scenario.h"
#include "widgets/model/latest_task.h"

#include <QObject>
#include <QTimer>

#include <functional>
#include <memory>
#include <optional>

namespace berg {

/**
 * Computes trade-off curves on a thread of its own, at low priority and a moment after the last
 * change, so that it never delays a plan. The newest request wins; a request for the problem
 * there is (a change of tau, say, which the curve does not depend on) changes nothing. GUI
 * thread.
 */
class CurveRunner : public QObject
{
    Q_OBJECT

public:
    explicit CurveRunner(QObject* parent = nullptr);

    /** The curve of the plan from the scenario's start; none when the scenario has errors. */
    void setScenario(const Scenario& scenario);
    /** The curve of any other instant, `ids` being icebergs of the caller. */
    void setRequest(std::shared_ptr<const PlanRequest> request, Route route);
    /** No curve wanted. */
    void clear();

    /** Newest known, of the present problem only; grows until it is `complete`. */
    [[nodiscard]] const TauCurve& curve() const { return m_curve; }
    /** What its orders are about. */
    [[nodiscard]] const FleetTask& problem() const { return m_problem; }

signals:
    /** The curve has changed, also to none. */
    void updated();

private:
    /** None: there is no curve. */
    using MakeProblem = std::function<std::optional<FleetTask>()>;

    void ask(MakeProblem problem);
    void take(std::optional<FleetTask> problem);
    void dropCurve(bool complete);
    void start();

    std::optional<Scenario> m_scenario; ///< what was asked for last; none: a request
    MakeProblem m_next; ///< asked for since the last change came: made when they are at rest
    FleetTask m_problem;
    TauCurve m_curve{.intervals = {}, .complete = true};
    QTimer m_pause;                         ///< runs out when changes have come to rest
    LatestTask<FleetTask, TauCurve> m_task; ///< last: it ends before the rest
};

} // namespace berg
