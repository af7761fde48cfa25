#pragma once

namespace berg {

class Docks;
struct WindowContext;

/** Connects two runs beside each other: their table, their chart, and runs opened for it. */
void connectComparison(WindowContext& context, const Docks& docks);

} // namespace berg
