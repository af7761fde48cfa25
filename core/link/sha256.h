#pragma once

#include <array>
#include <cstdint>
#include <span>

namespace berg {

/** Returns the SHA-256 digest of `bytes` (FIPS 180-4), used by signed MAVLink frames. */
[[nodiscard]] std::array<std::uint8_t, 32> sha256(std::span<const std::uint8_t> bytes);

} // namespace berg
