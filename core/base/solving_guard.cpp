#include "core/base/solving_guard.h"

#include "core/base/error.h"

namespace berg {

namespace {

thread_local int guards = 0; // of this thread

} // namespace

ForbidSolving::ForbidSolving()
{
    ++guards;
}

ForbidSolving::~ForbidSolving()
{
    --guards;
}

void requireSolvingAllowed()
{
    require(guards == 0, "planning or flying on a thread that must stay responsive");
}

} // namespace berg
