#pragma once

#include <QString>

namespace berg {

class Workspace;

/** Why nothing can be planned, in one sentence; empty: nothing stands in the way. */
[[nodiscard]] QString planFault(Workspace& workspace);

} // namespace berg
