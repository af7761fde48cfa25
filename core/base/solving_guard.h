#pragma once

namespace berg {

/**
 * While one lives, planning and flying on its thread is a bug: `requireSolvingAllowed` throws
 * there. For threads that must stay responsive. To be destroyed on the thread that made it.
 */
class ForbidSolving
{
public:
    ForbidSolving();
    ~ForbidSolving();
    ForbidSolving(const ForbidSolving&) = delete;
    ForbidSolving& operator=(const ForbidSolving&) = delete;
};

/** At the door of everything that may take long. Throws `std::logic_error` where it is forbidden.
 */
void requireSolvingAllowed();

} // namespace berg
