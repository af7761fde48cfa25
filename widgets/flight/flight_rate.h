#pragma once

#include <optional>

namespace berg {

/** Simulated seconds flown in one second, > 0; nullopt flies as fast as possible. */
using FlightRate = std::optional<double>;

inline constexpr FlightRate kFastestRate = std::nullopt;

} // namespace berg
