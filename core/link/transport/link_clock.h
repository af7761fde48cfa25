#pragma once

#include "core/link/message/byte_link.h"

#include <chrono>

namespace berg {

/** Returns the seconds of a clock that never jumps. */
[[nodiscard]] inline double monotonicNow_s()
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

/** Returns the present time, for sessions and vehicles on a real link. */
[[nodiscard]] inline LinkTime linkTimeNow()
{
    return {.monotonic_s = monotonicNow_s(),
            .unix_us = std::chrono::duration_cast<std::chrono::microseconds>(
                           std::chrono::system_clock::now().time_since_epoch())
                           .count()};
}

/** Time between two attempts to open a link. */
inline constexpr double kReopen_s = 2;

} // namespace berg
