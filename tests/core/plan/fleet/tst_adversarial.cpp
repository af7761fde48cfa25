#include "core/plan/fleet/fleet_bound.h"
#include "core/plan/fleet/fleet_solver.h"
#include "core/plan/policy/tau_curve.h"
#include "core/plan/proof/layered_bound.h"
#include "core/plan/solve/engine.h"
#include "tests/support/approx.h"
#include "tests/support/plan/brute_force.h"
#include "tests/support/plan/fleet_problems.h"
#include "tests/support/plan/nasty_problems.h"
#include "tests/support/plan/reference_optimum.h"

#include <QtTest>

#include <utility>

using namespace berg;

namespace {

constexpr int kUsualCases = 3000;
/** Enough for every proof of so few icebergs; a proof that needs more is a fault. */
constexpr std::int64_t kPlenty = 300'000'000;
/** Rounding of sums of some dozens of numbers, and margin of a proof; relative to the cost. */
constexpr long double kRounding = 1e-14L;
constexpr long double kProof = 2e-9L;

/** F + N sum(sigma), or latency, in 64 bits of mantissa. */
long double costOf(const TvpProblem& problem, const VisitOrder& order)
{
    long double cost = 0;
    long double flown = 0;
    NodeIndex from;
    int position = 0;
    for (const NodeIndex to : order) {
        const long double leg =
            static_cast<long double>(problem.mu) * legBetween(problem.distance_m, from, to);
        flown += leg;
        const long double sigma = problem.sigma_m2[toIndex(to)];
        ++position;
        cost +=
            problem.criterion == Criterion::Latency ? sigma * flown : leg + sigma * (position + 1);
        from = to;
    }
    if (problem.criterion == Criterion::Visitation && problem.route == Route::Closed && from != 0)
        cost += static_cast<long double>(problem.mu) * legBetween(problem.distance_m, from, 0);
    return cost;
}
long double costOf(const FleetProblem& problem, const FleetPlan& plan)
{
    long double cost = 0;
    for (int uav = 0; uav < problem.uavCount(); ++uav)
        cost += costOf(problemOfUav(problem, uav), plan[static_cast<std::size_t>(uav)]);
    return cost;
}

QString figures(long double found, long double optimum)
{
    return QStringLiteral(" %1 against %2 (%3 of it)")
        .arg(static_cast<double>(found), 0, 'g', 17)
        .arg(static_cast<double>(optimum), 0, 'g', 17)
        .arg(static_cast<double>((found - optimum) / optimum), 0, 'g', 3);
}

/**
 * Returns the fault of a bound, an order's cost and the claim that they meet; empty if there is
 * none.
 */
QString faultOf(long double bound, long double cost, bool proven, long double optimum)
{
    if (bound > optimum * (1 + kRounding))
        return QStringLiteral("bound above the optimum:") + figures(bound, optimum);
    if (proven && cost > optimum * (1 + kProof))
        return QStringLiteral("proven, but not optimal:") + figures(cost, optimum);
    return {};
}

/** Returns a size, usually small, now and then larger. */
int sizeOf(std::uint64_t seed, int most)
{
    if (seed % 16 == 0)
        return seed % 64 == 0 ? most : most - 2;
    return 2 + static_cast<int>(seed / 16 % static_cast<std::uint64_t>(most - 5));
}

/** Source of poor orders, limits and the like. */
test::NastyDraw drawBeside(std::uint64_t seed)
{
    return test::NastyDraw(seed + 1'000'000'007);
}

/** Tests the bound alone: no local search, any multipliers, any limit. */
template <class Costs>
QString faultOfBound(const TvpProblem& problem, const VisitOrder& start, test::NastyDraw draw)
{
    const Costs costs(problem);
    const long double optimum = test::referenceOptimum(problem).cost;
    BoundOptions options{.workLimit = draw.oneIn(8) ? draw.below(20'000) : kPlenty};
    const bool plenty = options.workLimit == kPlenty;
    LayeredBoundOptions layered;
    if (draw.oneIn(4))
        layered.manyArcs = 0;
    if (draw.oneIn(8)) {
        layered.lambda = Eigen::VectorXd::Zero(problem.nodeCount());
        for (int i = 1; i < problem.nodeCount(); ++i)
            (*layered.lambda)(i) = (draw.below(3) - 1) * costs.total(start) * draw.magnitude(-3, 3);
    }
    QString fault;
    options.onImproved = [&](const FleetPlan& plan, double bound) {
        if (fault.isEmpty())
            fault = faultOf(bound, costOf(problem, plan.front()), false, optimum);
    };
    const BoundResult result = improveBound(costs, start, options, layered);
    const VisitOrder& order = result.plan.front();
    if (!isVisitOrder(problem, order))
        return QStringLiteral("no order");
    if (fault.isEmpty())
        fault = faultOf(result.bound, costOf(problem, order), result.reached, optimum);
    // With a dozen icebergs, multipliers of another problem may take longer.
    const bool mustProve = plenty && (!layered.lambda || problem.icebergCount() <= 10);
    if (fault.isEmpty() && mustProve && !result.reached)
        fault = QStringLiteral("not proven");
    return fault;
}

/** Checks that no arc of the optimum is ever deleted. */
QString faultOfArcs(const TvpProblem& problem, const VisitOrder& best, const VisitOrder& given,
                    std::int64_t workLimit)
{
    const std::vector<MilpArc> arcs =
        survivingArcs(VisitCosts(problem), given, {.workLimit = workLimit});
    NodeIndex from;
    int position = 0;
    for (const NodeIndex to : best) {
        const MilpArc arc{.from = std::exchange(from, to), .to = to, .position = ++position};
        if (std::find(arcs.begin(), arcs.end(), arc) == arcs.end())
            return QStringLiteral("arc %1 of the optimum lost").arg(position);
    }
    return {};
}
QString faultOfArcs(std::uint64_t seed)
{
    const TvpProblem problem = test::nastyProblem(seed, sizeOf(seed, 11), Criterion::Visitation);
    const VisitOrder best = test::referenceOptimum(problem).order;
    test::NastyDraw draw = drawBeside(seed);
    const VisitOrder given = draw.oneIn(3) ? best : draw.shuffled(problem.icebergCount());
    return faultOfArcs(problem, best, given, draw.oneIn(4) ? 10'000 : kPlenty);
}

QString faultOfVisitation(std::uint64_t seed)
{
    const TvpProblem problem = test::nastyProblem(seed, sizeOf(seed, 12), Criterion::Visitation);
    test::NastyDraw draw = drawBeside(seed);
    const VisitOrder start = draw.shuffled(problem.icebergCount());
    return faultOfBound<VisitCosts>(problem, start, draw);
}
QString faultOfLatency(std::uint64_t seed)
{
    const TvpProblem problem = test::nastyProblem(seed, sizeOf(seed, 10), Criterion::Latency);
    test::NastyDraw draw = drawBeside(seed);
    const VisitOrder start = draw.shuffled(problem.icebergCount());
    return faultOfBound<LatencyCosts>(problem, start, draw);
}

FleetPlan poorPlan(const FleetProblem& problem, test::NastyDraw& draw)
{
    FleetPlan plan(problem.distance_m.size());
    for (const NodeIndex i : draw.shuffled(problem.icebergCount())) {
        int uav = draw.below(problem.uavCount());
        while (!problem.allows(uav, i))
            uav = draw.below(problem.uavCount());
        plan[static_cast<std::size_t>(uav)].push_back(i);
    }
    return plan;
}

QString faultOfFleetBound(const FleetProblem& problem, test::NastyDraw draw)
{
    const FleetCosts costs(problem);
    const long double optimum = test::referenceFleetCost(problem);
    const FleetPlan start = poorPlan(problem, draw);
    QString fault;
    BoundOptions options{.workLimit = draw.oneIn(8) ? draw.below(20'000) : kPlenty,
                         .memoryLimit_bytes = 100'000'000};
    options.onImproved = [&](const FleetPlan& plan, double bound) {
        if (fault.isEmpty())
            fault = faultOf(bound, costOf(problem, plan), false, optimum);
    };
    const BoundResult result = improveFleetBound(costs, start, options);
    if (!isFleetPlan(problem, result.plan))
        return QStringLiteral("no plan");
    if (fault.isEmpty())
        fault = faultOf(result.bound, costOf(problem, result.plan), result.reached, optimum);
    if (fault.isEmpty() && options.workLimit == kPlenty && !result.reached)
        fault = QStringLiteral("not proven");
    return fault;
}

template <int uavs>
QString faultOfFleet(std::uint64_t seed)
{
    return faultOfFleetBound(test::nastyFleet(seed, uavs, sizeOf(seed, 9), Criterion::Visitation),
                             drawBeside(seed));
}

/** Checks the claims of a back end against the cost. */
template <class Problem, class Outcome, class Order>
QString faultOfOutcome(const Problem& problem, const Outcome& outcome, const Order& order,
                       double shift, long double optimum)
{
    const bool proven = outcome.status == SolveStatus::Optimal;
    if (outcome.bound && *outcome.bound > outcome.objective)
        return QStringLiteral("bound above the objective");
    // The objective is a difference of sums as large as the shift, and so is the bound on it.
    const long double bound =
        outcome.bound && !proven ? *outcome.bound + static_cast<long double>(shift) : 0;
    const long double rounding = 100 * kRounding * (optimum + shift);
    return faultOf(bound - rounding, costOf(problem, order), proven, optimum);
}

QString faultOfBackEnds(const TvpProblem& problem, std::uint64_t seed)
{
    const long double optimum = test::referenceOptimum(problem).cost;
    test::NastyDraw draw = drawBeside(seed);
    SolveOptions options{.workLimit = draw.oneIn(4) ? draw.below(20'000) : kPlenty};
    if (draw.oneIn(2))
        options.hint = {draw.shuffled(problem.icebergCount())};
    const auto check = [&](const QString& name, const SolveOutcome& outcome) {
        QString fault;
        if (!isVisitOrder(problem, outcome.order()))
            fault = QStringLiteral("no order");
        else
            fault =
                faultOfOutcome(problem, outcome, outcome.order(), objectiveShift(problem), optimum);
        if (fault.isEmpty() && options.workLimit == kPlenty &&
            outcome.status != SolveStatus::Optimal)
            fault = QStringLiteral("not proven");
        return fault.isEmpty() ? fault : name + ": " + fault;
    };
    SolveOutcome bare = solveByEngine(problem, options, std::nullopt);
    bare.objective = objective(problem, bare.order());
    if (QString fault = check(QStringLiteral("engine"), bare); !fault.isEmpty())
        return fault;
    for (const Backend backend : {Backend::Exact, Backend::Auto, Backend::Heuristic}) {
        const SolveOutcome outcome = makeSolver(backend)->solve(problem, options);
        if (QString fault =
                check(QString::fromStdString(nameOf(kSourceNames, outcome.source)), outcome);
            !fault.isEmpty())
            return fault;
    }
    return {};
}
#if BERG_EXPECT_CBC
/** Checks every MILP; the linear programmes are solved to about 1e-7. */
QString faultOfCbc(std::uint64_t seed)
{
    const TvpProblem problem = test::nastyProblem(seed, sizeOf(seed, 9), Criterion::Visitation);
    const long double optimum = test::referenceOptimum(problem).cost;
    for (const Formulation formulation : {Formulation::Position, Formulation::Reduced}) {
        const SolveOutcome outcome =
            makeSolver(Backend::Cbc, formulation)->solve(problem, {.timeLimit_s = 20});
        if (outcome.status != SolveStatus::Optimal)
            return QStringLiteral("not proven");
        const bool proven = outcome.status == SolveStatus::Optimal;
        if (proven && costOf(problem, outcome.order()) > optimum * (1 + 1e-6L))
            return QStringLiteral("formulation %1 proven, but not optimal:")
                       .arg(static_cast<int>(formulation)) +
                   figures(costOf(problem, outcome.order()), optimum);
    }
    return {};
}
#endif
QString faultOfVisitationBackEnds(std::uint64_t seed)
{
    return faultOfBackEnds(test::nastyProblem(seed, sizeOf(seed, 11), Criterion::Visitation), seed);
}
QString faultOfLatencyBackEnds(std::uint64_t seed)
{
    return faultOfBackEnds(test::nastyProblem(seed, sizeOf(seed, 9), Criterion::Latency), seed);
}

QString faultOfFleetBackEnds(std::uint64_t seed)
{
    const Criterion criterion = seed % 4 == 0 ? Criterion::Latency : Criterion::Visitation;
    const FleetProblem problem =
        test::nastyFleet(seed, 2 + static_cast<int>(seed % 3), sizeOf(seed, 9), criterion);
    const long double optimum = test::referenceFleetCost(problem);
    test::NastyDraw draw = drawBeside(seed);
    SolveOptions options{.workLimit = draw.oneIn(4) ? draw.below(20'000) : 5'000'000};
    if (draw.oneIn(2))
        options.hint = poorPlan(problem, draw);
    for (const Backend backend : {Backend::Exact, Backend::Auto, Backend::Heuristic}) {
        const SolveOutcome outcome = solveFleet(problem, backend, options);
        if (outcome.status == SolveStatus::None)
            return QStringLiteral("no plan");
        const QString fault =
            faultOfOutcome(problem, outcome, outcome.plan, objectiveShift(problem), optimum);
        if (!fault.isEmpty())
            return QString::fromStdString(nameOf(kSourceNames, outcome.source)) + ": " + fault;
    }
    return {};
}

/** One kind of claim, and its share of the cases. */
struct Claim
{
    const char* name;
    int share; ///< per cent
    QString (*fault)(std::uint64_t seed);
};
constexpr std::array kClaims
{
    Claim{"bound from a poor order", 20, faultOfVisitation},
        Claim{"arcs of the optimum", 20, faultOfArcs},
        Claim{"latency bound from a poor order", 16, faultOfLatency},
        Claim{"fleet of 2, bound from a poor plan", 8, faultOfFleet<2>},
        Claim{"fleet of 3, bound from a poor plan", 8, faultOfFleet<3>},
        Claim{"fleet of 4, bound from a poor plan", 8, faultOfFleet<4>},
        Claim{"back ends", 8, faultOfVisitationBackEnds},
        Claim{"latency back ends", 6, faultOfLatencyBackEnds},
        Claim{"fleet back ends", 6, faultOfFleetBackEnds},
#if BERG_EXPECT_CBC
        Claim{"cbc", 1, faultOfCbc},
#endif
};

int cases()
{
    bool ok = false;
    const int asked = qEnvironmentVariableIntValue("BERGWATCH_ADVERSARIAL_CASES", &ok);
    return ok ? asked : kUsualCases;
}

} // namespace

/**
 * Claims of a proof or a bound hold for problems made to break them; a separate dynamic programme
 * decides. 3,000 cases, or the number in BERGWATCH_ADVERSARIAL_CASES.
 */
class TestAdversarial : public QObject
{
    Q_OBJECT

private slots:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    /** Sigmas that agree in all digits but the last few: a line fitted to them is upright. */
    void nearlyEqualSigmas_data()
    {
        QTest::addColumn<double>("spread");
        for (const double spread : {1e-9, 1e-11, 1e-12, 1e-13, 1e-14, 1e-15})
            QTest::addRow("%g", spread) << spread;
    }
    void nearlyEqualSigmas()
    {
        QFETCH(double, spread);
        for (std::uint64_t seed = 0; seed < 10; ++seed) {
            TvpProblem problem = test::randomProblem(seed, 10, 1, Route::Open);
            Random random(seed);
            for (std::size_t i = 1; i < problem.sigma_m2.size(); ++i)
                problem.sigma_m2[i] = 5 * (1 + spread * random.uniform());
            test::NastyDraw draw = drawBeside(seed);
            const VisitOrder start = draw.shuffled(10);
            QCOMPARE(faultOfBound<VisitCosts>(problem, start, draw), QString());
            const VisitOrder best = test::referenceOptimum(problem).order;
            QCOMPARE(faultOfArcs(problem, best, start, kPlenty), QString());
        }
    }

    /** The whole curve of 40 icebergs is that of equal sigmas. */
    void nearlyEqualSigmasHaveTheSameCurve()
    {
        TvpProblem equal = test::randomProblem(3, 40, 1, Route::Open);
        std::fill(equal.sigma_m2.begin() + 1, equal.sigma_m2.end(), 5.0);
        const TauCurve expected = tauCurve(problemOf(equal), {}, {});
        QVERIFY(!expected.intervals.empty());
        for (const double spread : {1e-13, 1e-14, 1e-15}) {
            TvpProblem near = equal;
            Random random(3);
            for (std::size_t i = 1; i < near.sigma_m2.size(); ++i)
                near.sigma_m2[i] *= 1 + spread * random.uniform();
            const TauCurve curve = tauCurve(problemOf(near), {}, {});
            QCOMPARE(curve.intervals.size(), expected.intervals.size());
            for (std::size_t k = 0; k < expected.intervals.size(); ++k) {
                const CurveInterval& a = curve.intervals[k];
                const CurveInterval& b = expected.intervals[k];
                QVERIFY(a.proven && b.proven);
                COMPARE_NEAR(a.tauTo, b.tauTo, 1e-9 * b.tauTo);
                COMPARE_NEAR(a.distance_m, b.distance_m, 1e-9 * b.distance_m);
                COMPARE_NEAR(a.reward_m2, b.reward_m2, 1e-9 * b.reward_m2);
            }
        }
    }

    /** 0 * infinity: a leg with no sigma ahead costs nothing, whatever its length. */
    void latencyWithZeroSigmas()
    {
        Eigen::MatrixX2d points_m(4, 2);
        points_m << 0, 0, 1, 2, 2, 0, 0, 1;
        const TvpProblem problem{.distance_m = euclideanDistances(points_m),
                                 .sigma_m2 = {0, 2, 890, 0},
                                 .mu = 1,
                                 .criterion = Criterion::Latency};
        VisitOrder start{1, 2, 3};
        do
            QCOMPARE(faultOfBound<LatencyCosts>(problem, start, drawBeside(1)), QString());
        while (std::next_permutation(start.begin(), start.end()));
    }

    /** Relaxed paths that form a plan: no step is possible, and the plan must be accepted. */
    void relaxedPathsThatAreAPlan()
    {
        for (const std::uint64_t seed : {79U, 157U, 339U, 868U, 1419U})
            QCOMPARE(
                faultOfFleetBound(test::randomFleet(seed, 3, 4, 0.5, test::FleetKind::Assigned),
                                  test::NastyDraw(seed)),
                QString());
    }

    /**
     * Sums along an order are 3e7 times its cost: rounding must not count as the gain of a move.
     */
    void localSearchEnds()
    {
        Eigen::MatrixX2d points_m(4, 2);
        points_m << 0, 0, 4000, 0, 4000, 6e-4, 0, 1.3e-4;
        const TvpProblem problem{.distance_m = euclideanDistances(points_m),
                                 .sigma_m2 = {0, 0, 0, 7.5e9},
                                 .mu = 2.7e-4,
                                 .criterion = Criterion::Latency};
        QCOMPARE(faultOfBackEnds(problem, 0), QString());
    }

    /** Near the smallest numbers, products have no digits that a margin could allow for. */
    void costsWithoutDigits()
    {
        for (const double unit : {1e-150, 1e-300, 1e300}) {
            TvpProblem problem = test::randomProblem(1, 5, 1, Route::Open);
            problem.criterion = Criterion::Latency;
            problem.distance_m *= unit;
            for (double& sigma_m2 : problem.sigma_m2)
                sigma_m2 *= std::min(unit, 1.0);
            problem.mu = std::min(unit, 1 / unit);
            QVERIFY_THROWS_EXCEPTION(Error, (void)makeSolver(Backend::Exact)->solve(problem, {}));
        }
    }

    void claimsAreTrue_data()
    {
        QTest::addColumn<int>("claim");
        for (std::size_t k = 0; k < kClaims.size(); ++k)
            QTest::newRow(kClaims[k].name) << static_cast<int>(k);
    }
    void claimsAreTrue()
    {
        QFETCH(int, claim);
        const Claim& tried = kClaims[static_cast<std::size_t>(claim)];
        const int count = cases() * tried.share / 100;
        int wrong = 0;
        QString first;
        for (int k = 0; k < count; ++k) {
            const QString fault = tried.fault(static_cast<std::uint64_t>(k));
            if (fault.isEmpty())
                continue;
            ++wrong;
            if (wrong <= 5)
                first += QStringLiteral("\n  seed %1: %2").arg(k).arg(fault);
        }
        QVERIFY2(wrong == 0,
                 qPrintable(QStringLiteral("%1 of %2 wrong:%3").arg(wrong).arg(count).arg(first)));
    }
};

QTEST_APPLESS_MAIN(TestAdversarial)
#include "tst_adversarial.moc"
