#pragma once

#include <stop_token>

namespace berg {

/** Thrown out of work that was to be stopped: nothing has come of it. No `std::exception`. */
struct Stopped
{
};

inline void throwIfStopped(const std::stop_token& stop)
{
    if (stop.stop_requested())
        throw Stopped{};
}

} // namespace berg
