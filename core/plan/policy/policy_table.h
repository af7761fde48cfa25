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
    std::string_view name;    ///< name in files and on the command line
    std::string_view meaning; ///< description after the name in reports
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
                 .meaning = QT_TRANSLATE_NOOP(
                     "Report",
                     "the order of Eq. (1) with the weight τ of Eq. (14), planned again at "
                     "each iceberg"),
                 .usesTau = true,
                 .weighsSigma = true,
                 .plansClusters = true},
    PolicyTraits{.kind = PolicyKind::Path,
                 .name = "path",
                 .meaning = QT_TRANSLATE_NOOP(
                     "Report",
                     "the shortest path through all icebergs, flown to its end, then solved "
                     "again"),
                 .replanRule = ReplanRule::ToItsEnd},
    PolicyTraits{.kind = PolicyKind::Tour,
                 .name = "tour",
                 .meaning =
                     QT_TRANSLATE_NOOP("Report", "the shortest round tour, flown again and again"),
                 .replanRule = ReplanRule::WholeFlight},
    PolicyTraits{.kind = PolicyKind::Nearest,
                 .name = "nearest",
                 .meaning = QT_TRANSLATE_NOOP("Report", "the nearest iceberg next"),
                 .method = PolicyMethod::OneByOne,
                 .weighsSigma = true,
                 .plansClusters = true},
    PolicyTraits{.kind = PolicyKind::Uncertainty,
                 .name = "uncertainty",
                 .meaning = QT_TRANSLATE_NOOP("Report", "the most uncertain iceberg next"),
                 .method = PolicyMethod::OneByOne,
                 .weighsSigma = true,
                 .plansClusters = true},
    PolicyTraits{.kind = PolicyKind::Latency,
                 .name = "latency",
                 .meaning = QT_TRANSLATE_NOOP(
                     "Report", "the order with the least waiting, weighted by uncertainty, planned "
                               "again at each iceberg"),
                 .criterion = Criterion::Latency,
                 .plansClusters = true},
    PolicyTraits{.kind = PolicyKind::Coverage,
                 .name = "coverage",
                 .meaning = QT_TRANSLATE_NOOP(
                     "Report",
                     "legs with aim points that give the lowest predicted ζ, planned again "
                     "at each sighting"),
                 .method = PolicyMethod::PredictedZeta},
};

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
