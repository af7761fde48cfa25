#pragma once

#include "core/base/translate_noop.h"
#include "core/plan/solve/names.h"

#include <algorithm>

namespace berg {

/** How the next iceberg is chosen. All that is asked of one is in `kPolicyTable`. */
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

/** What makes the orders of a policy. */
enum class PolicyMethod
{
    Solver,       ///< a back end, whose orders may be proven
    OneByOne,     ///< the best next iceberg, again and again
    PredictedZeta ///< a search over flights, each with the zeta that it is predicted to come to
};

/** How long the orders of a policy are flown. */
enum class PlanLife
{
    ToNextIceberg, ///< planned again at every iceberg reached
    ToItsEnd,      ///< planned again when every UAV has flown its part
    WholeFlight    ///< flown again and again
};

/** One policy. */
struct PolicyTraits
{
    PolicyKind kind = PolicyKind::Visitation;
    std::string_view name;    ///< in files and on the command line
    std::string_view meaning; ///< for reports, after the name
    PolicyMethod method = PolicyMethod::Solver;
    Criterion criterion = Criterion::Visitation; ///< of the problem that is solved
    PlanLife life = PlanLife::ToNextIceberg;
    bool usesTau = false;     ///< tau of Eq. (14), and the route, matter
    bool weighsSigma = false; ///< its orders have a reward in the sense of Eq. (1)
    bool plansClusters =
        false; ///< orders the nodes of `PlanRequest::clusters`; fixed routes are over
               ///< single icebergs, and coverage sees several at once by itself

    [[nodiscard]] constexpr bool solves() const { return method == PolicyMethod::Solver; }
    [[nodiscard]] constexpr bool keepsRoute() const { return life != PlanLife::ToNextIceberg; }
};

/** In the order of `PolicyKind`. */
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
                 .life = PlanLife::ToItsEnd},
    PolicyTraits{.kind = PolicyKind::Tour,
                 .name = "tour",
                 .meaning =
                     QT_TRANSLATE_NOOP("Report", "the shortest round tour, flown again and again"),
                 .life = PlanLife::WholeFlight},
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

[[nodiscard]] constexpr const PolicyTraits& traitsOf(PolicyKind policy)
{
    return kPolicyTable.at(static_cast<std::size_t>(policy));
}
static_assert(std::ranges::all_of(kPolicyTable, [](const PolicyTraits& policy) {
    return &traitsOf(policy.kind) == &policy;
}));

inline constexpr auto kPolicyNames = [] {
    std::array<Named<PolicyKind>, kPolicyTable.size()> names{};
    std::ranges::transform(kPolicyTable, names.begin(), [](const PolicyTraits& policy) {
        return Named<PolicyKind>{policy.kind, policy.name};
    });
    return names;
}();

} // namespace berg
