#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace berg {

/** Returns the SHA-256 digest of `bytes` (FIPS 180-4). */
[[nodiscard]] std::array<std::uint8_t, 32> sha256(std::span<const std::uint8_t> bytes);
/** Returns the digest of a text as 64 hexadecimal digits, as `sha256sum` prints it. */
[[nodiscard]] std::string sha256Text(std::string_view text);

} // namespace berg
