#pragma once

namespace berg {

class Docks;
class StatusLine;
struct WindowContext;

/** Connects the findings about the scenario with all that leads to them, and them with their
 * fields. */
void connectChecks(WindowContext& context, const Docks& docks, StatusLine& status);
/** Closes the list where it is in front, else opens it. */
void toggleChecks(const WindowContext& context, const Docks& docks);

} // namespace berg
