#include "widgets/words/plan_text.h"

#include "widgets/theme/quantity_text.h"
#include "widgets/words/issue_text.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

struct PlanText
{
    Q_DECLARE_TR_FUNCTIONS(PlanText)
};

/** Returns whether a solver has evaluated the order by Eq. (1). */
bool isSolved(const Plan& plan)
{
    return plan.outcome.status != SolveStatus::None &&
           plan.outcome.source != AnswerSource::OneByOne &&
           plan.outcome.source != AnswerSource::KeptRoute;
}

/** Returns the name of a solver for the middle of a sentence. */
QString solverText(AnswerSource source)
{
    switch (source) {
    case AnswerSource::Exact:
        return PlanText::tr("exact", "solver");
    case AnswerSource::Heuristic:
        return PlanText::tr("search and bound", "solver");
    case AnswerSource::Assignment:
        return PlanText::tr("by assignment", "solver");
    case AnswerSource::Cbc:
        return PlanText::tr("COIN-OR CBC", "solver");
    case AnswerSource::None:
    case AnswerSource::Auto:
    case AnswerSource::Subsets:
    case AnswerSource::OneByOne:
    case AnswerSource::KeptRoute:
    case AnswerSource::Coverage:
        break;
    }
    return QString::fromStdString(nameOf(kSourceNames, source));
}

/** Returns "under 1 ms", "4 ms" or "1.2 s". */
QString solveTimeText(double elapsed_s, const QLocale& locale)
{
    if (elapsed_s < 0.001)
        return PlanText::tr("under 1 ms");
    if (elapsed_s < 0.9995)
        return PlanText::tr("%1 ms").arg(fixedText(1000 * elapsed_s, 0, locale));
    return PlanText::tr("%1 s").arg(significantText(elapsed_s, 2, locale));
}

QString statusText(SolveStatus status)
{
    switch (status) {
    case SolveStatus::Optimal:
        return PlanText::tr("optimal", "status");
    case SolveStatus::Feasible:
        return PlanText::tr("not proven optimal", "status");
    case SolveStatus::None:
        break;
    }
    return PlanText::tr("no order found", "status");
}

QString detailsOf(const Plan& plan, const QLocale& locale)
{
    const auto number = [&](double value) { return significantText(value, 6, locale); };
    QStringList lines{PlanText::tr("Solver: %1").arg(solverText(plan.outcome.source)),
                      PlanText::tr("Status: %1").arg(statusText(plan.outcome.status)),
                      PlanText::tr("Time: %1").arg(solveTimeText(plan.outcome.elapsed_s, locale))};
    const bool isLatency = plan.problem.criterion == Criterion::Latency;
    if (plan.outcome.source == AnswerSource::Coverage && plan.predictedZeta_m2s)
        lines << PlanText::tr("Predicted zeta: %1 m² s").arg(number(*plan.predictedZeta_m2s));
    else if (plan.outcome.status != SolveStatus::None)
        lines << (isLatency ? PlanText::tr("Objective: %1 m² s") : PlanText::tr("Objective: %1 m²"))
                     .arg(number(plan.outcome.objective));
    if (plan.outcome.bound)
        lines << (isLatency ? PlanText::tr("Lower bound: %1 m² s")
                            : PlanText::tr("Lower bound: %1 m²"))
                     .arg(number(*plan.outcome.bound));
    if (plan.outcome.hintUsed)
        lines << PlanText::tr("Warm start from the previous plan");
    return lines.join(u'\n');
}

/** Returns the state of a plan whose solver returned an order as requested. */
PlanState stateOfSolve(const PlanReadout& readout, const QLocale& locale)
{
    const Plan& plan = *readout.plan;
    // Shorter times vary from run to run and do not matter; the details state them.
    const QString time = plan.outcome.elapsed_s < 0.0995
                             ? PlanText::tr("under 0.1 s")
                             : solveTimeText(plan.outcome.elapsed_s, locale);
    if (plan.outcome.status == SolveStatus::Optimal)
        return {PlanVerdict::Proven,
                PlanText::tr("Proven optimal, %1 (%2)").arg(time, solverText(plan.outcome.source)),
                {}};
    if (readout.solving)
        return {PlanVerdict::Estimate,
                plan.gap ? PlanText::tr("Best order so far, within %1 % of optimal")
                               .arg(gapText(*plan.gap, locale))
                         : PlanText::tr("Best order so far"),
                {}};
    if (plan.gap)
        return {PlanVerdict::Estimate,
                PlanText::tr("Within %1 % of optimal, %2").arg(gapText(*plan.gap, locale), time),
                {}};
    return {PlanVerdict::Estimate, PlanText::tr("Best order found, %1").arg(time), {}};
}

/** Returns "2 UAVs, 16 icebergs". */
QString fleetText(const PlanReadout& readout)
{
    return u"%1, %2"_s.arg(
        PlanText::tr("%n UAVs", nullptr, static_cast<int>(readout.plan->uavs.size())),
        PlanText::tr("%n icebergs", nullptr, static_cast<int>(readout.icebergs())));
}

PlanState stateOf(const PlanReadout& readout, const QLocale& locale)
{
    if (!readout.fault.isEmpty())
        return {PlanVerdict::Fault, readout.fault, {}};
    if (readout.isOver)
        return {PlanVerdict::None, PlanText::tr("Run complete"), {}};
    if (readout.isHeld)
        return {PlanVerdict::None,
                PlanText::tr("No plan while the UAV returns, holds or is on the ground"),
                {}};
    if (!readout.plan)
        return {PlanVerdict::None,
                readout.solving ? PlanText::tr("Planning…") : PlanText::tr("No plan yet"),
                {}};
    const Plan& plan = *readout.plan;
    if (readout.icebergs() == 0)
        return {PlanVerdict::None, PlanText::tr("Nothing to visit now"), {}};
    if (plan.outcome.reason == StopReason::Unable)
        return {PlanVerdict::Warning, issueSentence(IssueId::SolverUnable), {}};
    if (plan.fellBack)
        return {PlanVerdict::Warning,
                plan.uavs.front().reason == PlanReason::Start
                    ? PlanText::tr("Solver limit reached; flying to the nearest iceberg")
                    : PlanText::tr("Solver limit reached; previous plan kept"),
                {}};
    if (plan.outcome.source == AnswerSource::OneByOne)
        return {PlanVerdict::None, PlanText::tr("Chosen one iceberg at a time"), {}};
    if (plan.outcome.source == AnswerSource::KeptRoute)
        return {PlanVerdict::None, PlanText::tr("Following the existing route"), {}};
    PlanState state = stateOfSolve(readout, locale);
    if (plan.uavs.size() > 1)
        state.text += u" · "_s + fleetText(readout);
    return state;
}

} // namespace

std::size_t PlanReadout::icebergs() const
{
    std::size_t count = 0;
    if (plan)
        for (const UavPlan& own : plan->uavs)
            count += own.order.size();
    return count;
}

PlanState planState(const PlanReadout& readout, const QLocale& locale)
{
    PlanState state = stateOf(readout, locale);
    if (readout.plan && !readout.isOver && !readout.isHeld &&
        (isSolved(*readout.plan) || readout.plan->fellBack))
        state.details = detailsOf(*readout.plan, locale);
    return state;
}

PlanFigures planFigures(const PlanReadout& readout, PolicyKind policy)
{
    PlanFigures figures;
    if (!readout.plan || readout.isOver || readout.isHeld || readout.icebergs() == 0)
        return figures;
    const Plan& plan = *readout.plan;
    if (plan.outcome.status == SolveStatus::None || plan.outcome.source == AnswerSource::KeptRoute)
        return figures;
    figures.distance_m = readout.weighed_m.value_or(plan.distance_m);
    // Only Eq. (1) has a reward: kept routes are made as if every sigma were 0, and the other
    // policies weigh time.
    if (!traitsOf(policy).weighsSigma)
        return figures;
    figures.reward_m2 = plan.problem.mu * *figures.distance_m - plan.outcome.objective;
    if (!isSolved(plan))
        return figures;
    figures.objective_m2 = plan.outcome.objective;
    figures.mu_m = plan.problem.mu;
    return figures;
}

QString gapText(double gap, const QLocale& locale)
{
    const double percent = 100 * gap;
    constexpr double kRounding = 1e-9; // rounding errors must not turn 0.8 into 0.9
    if (percent > 10)
        return fixedText(std::ceil(percent - kRounding), 0, locale);
    return fixedText(std::max(1.0, std::ceil(10 * percent - kRounding)) / 10, 1, locale);
}

QStringList marginLines(double margin_s, double low_s)
{
    if (!std::isfinite(margin_s))
        return {PlanText::tr("The wind is too strong to return home")};
    const QString home = margin_s < 0 ? PlanText::tr("Home with %1 of the reserve used")
                                      : PlanText::tr("Home with %1 above the reserve");
    const QString low =
        !std::isfinite(low_s)
            ? PlanText::tr("In 1 flight in 20 the wind is too strong to return home")
        : low_s < 0 ? PlanText::tr("1 flight in 20 uses %1 or more of the reserve")
                    : PlanText::tr("1 flight in 20: %1 or less above the reserve");
    const auto clock = [](double time_s) { return clockText(std::abs(time_s)); };
    return {home.arg(clock(margin_s)), std::isfinite(low_s) ? low.arg(clock(low_s)) : low};
}

QString heldPlanText()
{
    return PlanText::tr("No plan while the UAV returns, is on the ground or holds. A new one is "
                        "made when it resumes.");
}

QStringList boundSourceLines(std::optional<bool> isFromRates)
{
    if (!isFromRates)
        return {};
    return {*isFromRates
                ? PlanText::tr("It follows from visit rates: how often icebergs can be visited.")
                : PlanText::tr("It follows from visit sequences: how soon icebergs can be visited "
                               "one after the other.")};
}

QString chanceText(double chance, const QLocale& locale)
{
    return PlanText::tr("%1 %").arg(fixedText(100 * chance, 0, locale));
}

} // namespace berg
