#pragma once

#include "core/scenario/scenario.h"

#include <stop_token>

namespace berg {

/**
 * Whether the estimate of an iceberg surely stays in the area of the scenario until the end of the
 * run, whenever and however often it is seen; so it counts in zeta all the time. True without an
 * area. Never with measurements: their estimates may be anywhere. False as well when the stop is
 * requested before it is known; asked every few thousand seconds of the run.
 */
[[nodiscard]] bool staysInside(const Scenario& scenario, const Iceberg& iceberg,
                               const std::stop_token& stop = {});

} // namespace berg
