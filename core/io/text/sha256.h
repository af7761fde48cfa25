#pragma once

#include <string>
#include <string_view>

namespace berg {

/** Returns the SHA-256 (FIPS 180-4) of the bytes as 64 hexadecimal digits, as `sha256sum` prints
 * it. */
[[nodiscard]] std::string sha256(std::string_view bytes);

} // namespace berg
