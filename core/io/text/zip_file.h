#pragma once

#include <string>
#include <string_view>

namespace berg {

/**
 * A zip archive (PKWARE APPNOTE, version 2.0) with one deflated entry of at most 4 GB. It holds no
 * time, so that equal contents are equal bytes.
 */
[[nodiscard]] std::string zipFile(std::string_view entryName, std::string_view content);

} // namespace berg
