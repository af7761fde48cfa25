#include "widgets/panels/plan/planner_text.h"

#include "core/plan/policy/policy.h"
#include "widgets/theme/quantity_text.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

struct PlannerText
{
    Q_DECLARE_TR_FUNCTIONS(PlannerText)
};

/** The names by which the policies that need no solver sign their answers. */
constexpr std::string_view kGreedy = "greedy";
constexpr std::string_view kKeptRoute = "route";
/** Weighs predicted zeta, not an order. */
constexpr std::string_view kCoverage = "coverage";

/** True when a solver has judged the order by Eq. (1). */
bool isSolved(const PlanEvent& plan)
{
    return plan.status != SolveStatus::None && plan.backend != kGreedy &&
           plan.backend != kKeptRoute;
}

/** The back end that signed an answer, in the middle of a sentence. */
QString solverText(const std::string& backend)
{
    if (backend == "exact")
        return PlannerText::tr("exact", "solver");
    if (backend == "heuristic")
        return PlannerText::tr("local search", "solver");
    if (backend == "assignment") // of several UAVs by uncertainty alone
        return PlannerText::tr("by assignment", "solver");
    if (backend.starts_with("cbc"))
        return PlannerText::tr("COIN-OR CBC", "solver");
    return QString::fromStdString(backend);
}

QString detailsOf(const PlanEvent& plan, const QLocale& locale)
{
    const auto number = [&](double value) { return significantText(value, 6, locale); };
    QStringList lines{PlannerText::tr("Solver: %1").arg(QString::fromStdString(plan.backend)),
                      PlannerText::tr("Status: %1")
                          .arg(QString::fromStdString(nameOf(kStatusNames, plan.status))),
                      PlannerText::tr("Time: %1").arg(solveTimeText(plan.elapsed_s, locale))};
    const bool isLatency = plan.criterion == Criterion::Latency;
    if (plan.backend == kCoverage && plan.predictedZeta_m2s)
        lines << PlannerText::tr("Predicted zeta: %1 m² s").arg(number(*plan.predictedZeta_m2s));
    else if (plan.status != SolveStatus::None)
        lines << (isLatency ? PlannerText::tr("Objective: %1 m² s")
                            : PlannerText::tr("Objective: %1 m²"))
                     .arg(number(plan.objective));
    if (plan.bound)
        lines << (isLatency ? PlannerText::tr("Lower bound: %1 m² s")
                            : PlannerText::tr("Lower bound: %1 m²"))
                     .arg(number(*plan.bound));
    if (plan.warmStarted)
        lines << PlannerText::tr("Started from the plan before");
    return lines.join(u'\n');
}

/** Of an answer with an order that is what was asked for. */
PlanState stateOfSolve(const PlanReadout& readout, const QLocale& locale)
{
    const PlanEvent& plan = *readout.plan;
    const QString time = solveTimeText(plan.elapsed_s, locale);
    if (plan.status == SolveStatus::Optimal)
        return {PlanVerdict::Proven,
                PlannerText::tr("Proven optimal, %1 (%2)").arg(time, solverText(plan.backend)),
                {}};
    if (readout.solving)
        return {PlanVerdict::Estimate,
                plan.gap ? PlannerText::tr("Best order so far, within %1 % of optimal")
                               .arg(gapText(*plan.gap, locale))
                         : PlannerText::tr("Best order so far"),
                {}};
    if (plan.gap)
        return {PlanVerdict::Estimate,
                PlannerText::tr("Within %1 % of optimal, %2").arg(gapText(*plan.gap, locale), time),
                {}};
    return {PlanVerdict::Estimate, PlannerText::tr("Best order found, %1").arg(time), {}};
}

/** "2 UAVs, 16 icebergs". */
QString fleetText(const PlanReadout& readout)
{
    return u"%1, %2"_s.arg(
        PlannerText::tr("%n UAVs", nullptr, static_cast<int>(readout.others.size()) + 1),
        PlannerText::tr("%n icebergs", nullptr, static_cast<int>(readout.icebergs())));
}

PlanState stateOf(const PlanReadout& readout, const QLocale& locale)
{
    if (!readout.fault.isEmpty())
        return {PlanVerdict::Fault, readout.fault, {}};
    if (!readout.plan)
        return {PlanVerdict::None,
                readout.solving ? PlannerText::tr("Planning…") : PlannerText::tr("No plan yet"),
                {}};
    const PlanEvent& plan = *readout.plan;
    if (readout.icebergs() == 0)
        return {PlanVerdict::None, PlannerText::tr("Nothing to visit now"), {}};
    if (plan.stop == StopReason::Unable)
        return {PlanVerdict::Warning,
                PlannerText::tr("This solver cannot plan so many icebergs. Choose Automatic."),
                {}};
    if (plan.fellBack)
        return {PlanVerdict::Warning,
                plan.reason == PlanReason::Start
                    ? PlannerText::tr("Limit reached, flying to the nearest iceberg")
                    : PlannerText::tr("Limit reached, flying the previous plan"),
                {}};
    if (plan.backend == kGreedy)
        return {PlanVerdict::None, PlannerText::tr("Chosen one iceberg at a time"), {}};
    if (plan.backend == kKeptRoute)
        return {PlanVerdict::None, PlannerText::tr("Following the route made before"), {}};
    PlanState state = stateOfSolve(readout, locale);
    if (!readout.others.empty())
        state.text += u" · "_s + fleetText(readout);
    return state;
}

} // namespace

std::size_t PlanReadout::icebergs() const
{
    std::size_t count = plan ? plan->order.size() : 0;
    for (const std::vector<int>& order : others)
        count += order.size();
    return count;
}

PlanReadout readoutOf(const FlightRecord& record, const QString& fault)
{
    const MissionSnapshot& shown = record.shown();
    PlanReadout readout{.plan = shown.plan,
                        .solving = record.now.phase == RunPhase::Planning,
                        .fault = fault,
                        .others = {}};
    for (const PlanEvent& plan : shown.plans)
        if (shown.plan && plan.uav != shown.plan->uav && plan.sameSolve &&
            plan.time_s == shown.plan->time_s)
            readout.others.push_back(plan.order);
    return readout;
}

QString policyName(PolicyKind policy)
{
    switch (policy) {
    case PolicyKind::Visitation:
        return PlannerText::tr("Weighted visiting order (as published)");
    case PolicyKind::Path:
        return PlannerText::tr("Shortest path, repeated");
    case PolicyKind::Tour:
        return PlannerText::tr("Shortest round tour, repeated");
    case PolicyKind::Nearest:
        return PlannerText::tr("Nearest iceberg first");
    case PolicyKind::Uncertainty:
        return PlannerText::tr("Most uncertain iceberg first");
    case PolicyKind::Latency:
        return PlannerText::tr("Least waiting time");
    case PolicyKind::Coverage:
        return PlannerText::tr("Best predicted coverage");
    }
    return {};
}

QString policySentence(PolicyKind policy)
{
    switch (policy) {
    case PolicyKind::Visitation:
        return PlannerText::tr(
            "Weighs uncertainty seen early against the length of the way, by τ.");
    case PolicyKind::Path:
        return PlannerText::tr("Flies the shortest path past all icebergs, then the next one.");
    case PolicyKind::Tour:
        return PlannerText::tr("Flies one shortest round tour again and again.");
    case PolicyKind::Nearest:
        return PlannerText::tr("Flies to the nearest iceberg out of view.");
    case PolicyKind::Uncertainty:
        return PlannerText::tr("Flies to the iceberg of the greatest uncertainty.");
    case PolicyKind::Latency:
        return PlannerText::tr(
            "Keeps the waiting time of all icebergs short, weighted by their uncertainty.");
    case PolicyKind::Coverage:
        return PlannerText::tr(
            "Predicts zeta for paths that pass icebergs at an offset and see several at once.");
    }
    return {};
}

QString backendName(Backend backend)
{
    switch (backend) {
    case Backend::Auto:
        return PlannerText::tr("Automatic");
    case Backend::Exact:
        return PlannerText::tr("Exact");
    case Backend::Cbc:
        return PlannerText::tr("COIN-OR CBC");
    case Backend::Heuristic:
        return PlannerText::tr("Local search");
    }
    return {};
}

QString routeName(Route route)
{
    switch (route) {
    case Route::Open:
        return PlannerText::tr("One way", "route");
    case Route::Closed:
        return PlannerText::tr("Round trip", "route");
    }
    return {};
}

PlanState planState(const PlanReadout& readout, const QLocale& locale)
{
    PlanState state = stateOf(readout, locale);
    if (readout.plan && (isSolved(*readout.plan) || readout.plan->fellBack))
        state.details = detailsOf(*readout.plan, locale);
    return state;
}

PlanFigures planFigures(const PlanReadout& readout, PolicyKind policy)
{
    PlanFigures figures;
    if (!readout.plan || readout.icebergs() == 0)
        return figures;
    const PlanEvent& plan = *readout.plan;
    if (plan.status == SolveStatus::None || plan.backend == kKeptRoute)
        return figures;
    figures.distance_m = plan.distance_m;
    // Only Eq. (1) has a reward: the routes are made as if every sigma were 0, the others weigh
    // time.
    if (policy == PolicyKind::Path || policy == PolicyKind::Tour || policy == PolicyKind::Latency ||
        policy == PolicyKind::Coverage)
        return figures;
    figures.reward_m2 = plan.mu * plan.distance_m - plan.objective;
    if (!isSolved(plan))
        return figures;
    figures.objective_m2 = plan.objective;
    figures.mu_m = plan.mu;
    return figures;
}

QString gapText(double gap, const QLocale& locale)
{
    const double percent = 100 * gap;
    constexpr double kRounding = 1e-9; // keeps 0.8 from becoming 0.9
    if (percent > 10)
        return fixedText(std::ceil(percent - kRounding), 0, locale);
    return fixedText(std::max(1.0, std::ceil(10 * percent - kRounding)) / 10, 1, locale);
}

QString solveTimeText(double elapsed_s, const QLocale& locale)
{
    if (elapsed_s < 0.001)
        return PlannerText::tr("under 1 ms");
    if (elapsed_s < 0.9995)
        return PlannerText::tr("%1 ms").arg(fixedText(1000 * elapsed_s, 0, locale));
    return PlannerText::tr("%1 s").arg(significantText(elapsed_s, 2, locale));
}

} // namespace berg
