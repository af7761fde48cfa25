#pragma once

#include <stop_token>

namespace berg {

/** Thrown when work is cancelled; there is no result. Not derived from `std::exception`. */
struct Stopped
{
};

/** Throws `Stopped` if a stop was requested. */
inline void throwIfStopped(const std::stop_token& stop)
{
    if (stop.stop_requested())
        throw Stopped{};
}

} // namespace berg
