#pragma once

#include "core/scenario/scenario.h"

#include <QMimeData>

#include <memory>
#include <span>
#include <vector>

namespace berg {

/** MIME type of icebergs on the clipboard; the same JSON is there as plain text too. */
inline constexpr char kIcebergMimeType[] = "application/x-bergwatch-icebergs+json";

/** Returns clipboard data with the icebergs as JSON and as plain text. */
[[nodiscard]] std::unique_ptr<QMimeData> icebergMimeData(std::span<const Iceberg> icebergs);

/**
 * Returns the icebergs of clipboard data, ours or text in the form of `icebergsToJson`; ids may be
 * any text. Throws `Error` as `icebergsFromJson` for any other text, an empty clipboard and null.
 */
[[nodiscard]] std::vector<Iceberg> icebergsOf(const QMimeData* data);

} // namespace berg
