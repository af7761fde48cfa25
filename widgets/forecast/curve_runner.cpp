#include "widgets/forecast/curve_runner.h"

#include "core/checks/validate.h"
#include "core/mission/plan_requests.h"
#include "core/sim/simulation.h"
#include "widgets/flight/compared_run.h"

#include <algorithm>
#include <utility>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr int kPause_ms = 150;

bool same(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b)
{
    return a.rows() == b.rows() && a == b;
}

bool same(const FleetTask& a, const FleetTask& b)
{
    return a.ids == b.ids && a.uavs == b.uavs && a.problem.route == b.problem.route &&
           a.problem.sigma_m2 == b.problem.sigma_m2 && a.problem.allowed == b.problem.allowed &&
           same(a.betweenStarts_m, b.betweenStarts_m) &&
           std::ranges::equal(a.problem.distance_m, b.problem.distance_m,
                              [](const auto& x, const auto& y) { return same(x, y); });
}

} // namespace

CurveRunner::CurveRunner(QObject* parent)
    : QObject(parent)
    , m_task(u"curve"_s,
             {.work =
                  [](const FleetTask& task, const std::stop_token& stop, const auto& deliver) {
                      deliver(tauCurve(task.problem, task.betweenStarts_m,
                                       {.stop = stop, .onProgress = deliver}));
                  },
              .deliver =
                  [this](TauCurve curve) {
                      m_curve = std::move(curve);
                      emit updated();
                  },
              .end =
                  [this](const std::optional<WorkFailure>& failure) {
                      if (failure) // the problem has no curve
                          dropCurve(true);
                  }},
             WorkPriority::Low)
{
    m_pause.setSingleShot(true);
    m_pause.setInterval(kPause_ms);
    connect(&m_pause, &QTimer::timeout, this, &CurveRunner::start);
}

void CurveRunner::setScenario(const Scenario& scenario)
{
    if (m_scenario && isSameWorld(*m_scenario, scenario) &&
        m_scenario->planner.route == scenario.planner.route)
        return;
    m_scenario = scenario;
    schedule([this]() -> std::optional<FleetTask> {
        if (hasErrors(validate(*m_scenario)))
            return std::nullopt;
        return visitationTask(clusteredRequest(Simulation(*m_scenario)), m_scenario->planner.route);
    });
}

void CurveRunner::setRequest(std::shared_ptr<const PlanRequest> request, Route route)
{
    m_scenario.reset();
    schedule([request = std::move(request), route] { return visitationTask(*request, route); });
}

/** Making a problem computes a distance matrix: during a drag only the last one is made. */
void CurveRunner::schedule(MakeProblem problem)
{
    if (m_pause.isActive()) { // no curve is known that could belong to another problem
        m_next = std::move(problem);
        m_pause.start();
        return;
    }
    accept(problem());
}

void CurveRunner::accept(std::optional<FleetTask> problem)
{
    if (!problem) {
        clear();
        return;
    }
    if (same(*problem, m_problem))
        return;
    m_problem = std::move(*problem);
    dropCurve(false);
    m_pause.start();
}

void CurveRunner::clear()
{
    m_scenario.reset();
    m_next = {};
    m_problem = {};
    m_pause.stop();
    dropCurve(true);
}

/** Drops the known curve and current work, which belong to another problem. */
void CurveRunner::dropCurve(bool complete)
{
    m_task.drop();
    TauCurve none{.intervals = {}, .complete = complete};
    if (m_curve == none)
        return;
    m_curve = std::move(none);
    emit updated();
}

void CurveRunner::start()
{
    if (m_next) {
        std::optional<FleetTask> problem = std::exchange(m_next, {})();
        if (!problem) {
            clear();
            return;
        }
        m_problem = std::move(*problem);
    }
    m_task.start(m_problem);
}

} // namespace berg
