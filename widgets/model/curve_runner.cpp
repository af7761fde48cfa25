#include "widgets/model/curve_runner.h"

#include "core/scenario/validate.h"
#include "core/sim/simulation.h"
#include "widgets/model/compared_run.h"

#include <utility>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr int kPause_ms = 150;

bool same(const VisitationProblem& a, const VisitationProblem& b)
{
    return a.ids == b.ids && a.problem.route == b.problem.route &&
           a.problem.sigma_m2 == b.problem.sigma_m2 &&
           a.problem.distance_m.rows() == b.problem.distance_m.rows() &&
           a.problem.distance_m == b.problem.distance_m;
}

} // namespace

CurveRunner::CurveRunner(QObject* parent)
    : QObject(parent)
    , m_task(u"curve"_s,
             {.work =
                  [](const TvpProblem& problem, const std::stop_token& stop, const auto& tell) {
                      tell(tauCurve(problem, {.stop = stop, .onProgress = tell}));
                  },
              .deliver =
                  [this](TauCurve curve) {
                      m_curve = std::move(curve);
                      emit updated();
                  },
              .end =
                  [this](const std::optional<WorkFailure>& failure) {
                      if (failure) // a problem without a curve
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
    if (const bool isOfFleet = scenario.uavs.size() > 1; isOfFleet != m_isOfFleet) {
        m_isOfFleet = isOfFleet;
        clear();
        emit updated();
    }
    m_scenario = scenario;
    if (m_isOfFleet)
        return;
    ask([this]() -> std::optional<VisitationProblem> {
        if (hasErrors(validate(*m_scenario)))
            return std::nullopt;
        return visitationProblem(Simulation(*m_scenario).clusteredRequest(),
                                 m_scenario->planner.route);
    });
}

void CurveRunner::setRequest(std::shared_ptr<const PlanRequest> request, Route route)
{
    if (m_isOfFleet)
        return;
    m_scenario.reset();
    ask([request = std::move(request), route] { return visitationProblem(*request, route); });
}

/** A problem has a matrix of distances: in a drag only the last one is made. */
void CurveRunner::ask(MakeProblem problem)
{
    if (m_pause.isActive()) { // so there is no curve that could be of another problem
        m_next = std::move(problem);
        m_pause.start();
        return;
    }
    take(problem());
}

void CurveRunner::take(std::optional<VisitationProblem> problem)
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

/** What is known or under way belongs to another problem. */
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
        std::optional<VisitationProblem> problem = std::exchange(m_next, {})();
        if (!problem) {
            clear();
            return;
        }
        m_problem = std::move(*problem);
    }
    m_task.start(m_problem.problem);
}

} // namespace berg
