#pragma once

#include "core/base/translate_noop.h"
#include "core/plan/solve/names.h"

#include <algorithm>

namespace berg {

/** Rule that chooses the next iceberg. `kPolicyTable` holds its properties. */
enum class PolicyKind
{
    Visitation,
    Path,
    Tour,
    Nearest,
    Uncertainty,
    Latency,
    Coverage
};

/** Method that makes the orders of a policy. */
enum class PolicyMethod
{
    Solver,       ///< a solver back end, whose orders may be proven optimal
    OneByOne,     ///< repeated choice of the best next iceberg
    PredictedZeta ///< a search over flights by their predicted zeta
};

/** When a policy makes new orders. */
enum class ReplanRule
{
    ToNextIceberg, ///< at every iceberg reached
    ToItsEnd,      ///< when every UAV has flown its part
    WholeFlight    ///< never; the orders are repeated
};

/** Properties of a policy. */
struct PolicyTraits
{
    PolicyKind kind = PolicyKind::Visitation;
    std::string_view name; ///< name in files and on the command line
    // English texts, which the window and reports translate (context Report).
    const char* title = nullptr;     ///< name in the lists of the window
    const char* label = nullptr;     ///< short name, with a place for tau if the policy uses it
    const char* about = nullptr;     ///< description in one sentence
    const char* pageTitle = nullptr; ///< title on pages, likewise; nullptr means `title`
    PolicyMethod method = PolicyMethod::Solver;
    Criterion criterion = Criterion::Visitation; ///< criterion of the problem that is solved
    ReplanRule replanRule = ReplanRule::ToNextIceberg;
    bool usesTau = false;     ///< whether tau of Eq. (14) and the route have an effect
    bool weighsSigma = false; ///< whether its orders have a reward in the sense of Eq. (1)
    /**
     * Whether the policy orders the nodes of `PlanRequest::clusters`. Fixed routes visit single
     * icebergs, and coverage itself sees several icebergs at once.
     */
    bool plansClusters = false;

    /** Returns whether a solver back end makes the orders. */
    [[nodiscard]] constexpr bool solves() const { return method == PolicyMethod::Solver; }
    /** Returns whether the orders outlast the next iceberg. */
    [[nodiscard]] constexpr bool keepsRoute() const
    {
        return replanRule != ReplanRule::ToNextIceberg;
    }
};

/** Properties of all policies, in the order of `PolicyKind`. */
inline constexpr std::array kPolicyTable{
    PolicyTraits{.kind = PolicyKind::Visitation,
                 .name = "visitation",
                 .title = QT_TRANSLATE_NOOP("Report", "Weighted visiting order (published method)"),
                 .label = QT_TRANSLATE_NOOP("Report", "τ %1"),
                 .about = QT_TRANSLATE_NOOP(
                     "Report", "Weighs seeing uncertain icebergs early against path length, by τ."),
                 .pageTitle =
                     QT_TRANSLATE_NOOP("Report", "Weighted visiting order, trade-off τ %1"),
                 .usesTau = true,
                 .weighsSigma = true,
                 .plansClusters = true},
    PolicyTraits{.kind = PolicyKind::Path,
                 .name = "path",
                 .title = QT_TRANSLATE_NOOP("Report", "Shortest path, repeated"),
                 .label = QT_TRANSLATE_NOOP("Report", "Shortest path"),
                 .about = QT_TRANSLATE_NOOP(
                     "Report", "Flies the shortest path past all icebergs, then the next one."),
                 .replanRule = ReplanRule::ToItsEnd},
    PolicyTraits{.kind = PolicyKind::Tour,
                 .name = "tour",
                 .title = QT_TRANSLATE_NOOP("Report", "Shortest round tour, repeated"),
                 .label = QT_TRANSLATE_NOOP("Report", "Round tour"),
                 .about =
                     QT_TRANSLATE_NOOP("Report", "Flies one shortest round tour again and again."),
                 .replanRule = ReplanRule::WholeFlight},
    PolicyTraits{.kind = PolicyKind::Nearest,
                 .name = "nearest",
                 .title = QT_TRANSLATE_NOOP("Report", "Nearest iceberg first"),
                 .label = QT_TRANSLATE_NOOP("Report", "Nearest first"),
                 .about = QT_TRANSLATE_NOOP("Report", "Flies to the nearest iceberg out of view."),
                 .method = PolicyMethod::OneByOne,
                 .weighsSigma = true,
                 .plansClusters = true},
    PolicyTraits{.kind = PolicyKind::Uncertainty,
                 .name = "uncertainty",
                 .title = QT_TRANSLATE_NOOP("Report", "Most uncertain iceberg first"),
                 .label = QT_TRANSLATE_NOOP("Report", "Most uncertain first"),
                 .about = QT_TRANSLATE_NOOP("Report", "Flies to the most uncertain iceberg."),
                 .method = PolicyMethod::OneByOne,
                 .weighsSigma = true,
                 .plansClusters = true},
    PolicyTraits{
        .kind = PolicyKind::Latency,
        .name = "latency",
        .title = QT_TRANSLATE_NOOP("Report", "Least waiting time"),
        .label = QT_TRANSLATE_NOOP("Report", "Least waiting"),
        .about = QT_TRANSLATE_NOOP(
            "Report",
            "Keeps the waiting time of all icebergs short, weighted by their uncertainty."),
        .pageTitle = QT_TRANSLATE_NOOP("Report", "Least waiting time, weighted by uncertainty"),
        .criterion = Criterion::Latency,
        .plansClusters = true},
    PolicyTraits{
        .kind = PolicyKind::Coverage,
        .name = "coverage",
        .title = QT_TRANSLATE_NOOP("Report", "Best predicted coverage"),
        .label = QT_TRANSLATE_NOOP("Report", "Best coverage"),
        .about = QT_TRANSLATE_NOOP(
            "Report",
            "Predicts zeta for paths that pass icebergs at an offset and see several at once."),
        .method = PolicyMethod::PredictedZeta},
};

/** All policies in the order in which people choose among them. */
inline constexpr std::array kOfferedPolicies{
    PolicyKind::Visitation, PolicyKind::Latency, PolicyKind::Coverage,   PolicyKind::Path,
    PolicyKind::Tour,       PolicyKind::Nearest, PolicyKind::Uncertainty};
static_assert(kOfferedPolicies.size() == kPolicyTable.size());

/** Returns the properties of a policy. */
[[nodiscard]] constexpr const PolicyTraits& traitsOf(PolicyKind policy)
{
    return kPolicyTable.at(static_cast<std::size_t>(policy));
}
static_assert(std::ranges::all_of(kPolicyTable, [](const PolicyTraits& policy) {
    return &traitsOf(policy.kind) == &policy;
}));

/** Names of the policies in files and on the command line. */
inline constexpr auto kPolicyNames = [] {
    std::array<Named<PolicyKind>, kPolicyTable.size()> names{};
    std::ranges::transform(kPolicyTable, names.begin(), [](const PolicyTraits& policy) {
        return Named<PolicyKind>{policy.kind, policy.name};
    });
    return names;
}();

} // namespace berg
