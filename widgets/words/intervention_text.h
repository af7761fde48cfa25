#pragma once

#include "core/sim/intervention.h"

#include <QString>

namespace berg {

/** Returns the name of a change in the imperative, for Undo: "Change wind". */
[[nodiscard]] QString changeName(const Intervention& change);

/** Returns why nothing can be edited: the scenario is locked in flight. */
[[nodiscard]] QString lockedInFlightText();

} // namespace berg
