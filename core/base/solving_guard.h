#pragma once

#include "core/base/error.h"

namespace berg {

/**
 * While one lives, planning and flying on its thread is a bug: `requireSolvingAllowed` throws
 * there. For threads that must stay responsive. To be destroyed on the thread that made it.
 */
class ForbidSolving
{
public:
    ForbidSolving() { ++s_guards; }
    ~ForbidSolving() { --s_guards; }
    ForbidSolving(const ForbidSolving&) = delete;
    ForbidSolving& operator=(const ForbidSolving&) = delete;

private:
    friend void requireSolvingAllowed();

    inline static thread_local int s_guards = 0; ///< of this thread
};

/** At the door of everything that may take long. Throws `std::logic_error` where it is forbidden.
 */
inline void requireSolvingAllowed()
{
    require(ForbidSolving::s_guards == 0,
            "planning or flying on a thread that must stay responsive");
}

} // namespace berg
