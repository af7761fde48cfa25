#pragma once

#include "core/plan/policy/policy.h"
#include "core/sim/simulation.h"

namespace berg {

/**
 * Distances over ground (air distances in wind) and sigmas of the active icebergs, times their
 * priorities, of the UAVs that are planned now; of the first one when none is.
 */
[[nodiscard]] PlanRequest planRequest(const Simulation& simulation);
/**
 * The same with the available icebergs that one view can cover as one node, where the scenario
 * asks for that: `PlanRequest::clusters`. Its `picture` is still that of single icebergs. With
 * several UAVs there are no clusters.
 */
[[nodiscard]] PlanRequest clusteredRequest(const Simulation& simulation);
/** What a policy is asked now: `clusteredRequest` if it plans clusters, else `planRequest`. */
[[nodiscard]] PlanRequest requestFor(const Simulation& simulation, PolicyKind policy);

} // namespace berg
