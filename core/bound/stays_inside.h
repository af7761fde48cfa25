#pragma once

#include "core/scenario/scenario.h"

namespace berg {

/**
 * Whether the estimate of an iceberg surely stays in the area of the scenario until the end of the
 * run, whenever and however often it is seen; so it counts in zeta all the time. True without an
 * area. Never with measurements: their estimates may be anywhere.
 */
[[nodiscard]] bool staysInside(const Scenario& scenario, const Iceberg& iceberg);

} // namespace berg
