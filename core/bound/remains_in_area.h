#pragma once

#include "core/scenario/scenario.h"

#include <stop_token>

namespace berg {

/**
 * Returns whether the estimate of an iceberg surely stays in the area of the scenario until the end
 * of the run, whenever and however often it is seen, so that the iceberg counts in zeta all the
 * time. Returns true without an area, and false with the Kalman filter, whose estimates may be
 * anywhere. Returns false as well if a stop is requested before the answer is known; the token is
 * checked every 4096 seconds of the run.
 */
[[nodiscard]] bool remainsInArea(const Scenario& scenario, const Iceberg& iceberg,
                                 const std::stop_token& stop = {});

} // namespace berg
