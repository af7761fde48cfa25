#pragma once

#include "core/plan/policy/policy.h"
#include "core/sim/simulation.h"

namespace berg {

/**
 * Returns the request for the UAVs that need a plan now, or for the first UAV if no UAV does: leg
 * lengths (`legLengths_m`), scaled for each UAV to flight time times the airspeed of the first UAV
 * of the scenario, and the sigmas of the active icebergs, each times its priority.
 */
[[nodiscard]] PlanRequest planRequest(const Simulation& simulation);
/**
 * Returns `planRequest` with each group of available icebergs that one view can cover made one node
 * (`PlanRequest::clusters`), if the scenario groups icebergs. The `prediction` of each UAV still
 * holds single icebergs.
 */
[[nodiscard]] PlanRequest clusteredRequest(const Simulation& simulation);
/**
 * Returns the request for the policy: `clusteredRequest` if it plans clusters, else `planRequest`.
 */
[[nodiscard]] PlanRequest requestFor(const Simulation& simulation, PolicyKind policy);

} // namespace berg
