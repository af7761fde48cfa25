#pragma once

#include "core/base/error.h"

namespace berg {

/**
 * Forbids planning and flying on its thread while it exists: `requireSolvingAllowed` throws there.
 * For threads that must stay responsive. Must be destroyed on the thread that created it.
 */
class NoBlockingScope
{
public:
    NoBlockingScope() { ++s_guards; }
    ~NoBlockingScope() { --s_guards; }
    NoBlockingScope(const NoBlockingScope&) = delete;
    NoBlockingScope& operator=(const NoBlockingScope&) = delete;

private:
    friend void requireSolvingAllowed();

    inline static thread_local int s_guards = 0; ///< number of scopes on this thread
};

/**
 * Guards every function that may take long. Throws `std::logic_error` inside a `NoBlockingScope`.
 */
inline void requireSolvingAllowed()
{
    require(NoBlockingScope::s_guards == 0,
            "planning or flying on a thread that must stay responsive");
}

} // namespace berg
