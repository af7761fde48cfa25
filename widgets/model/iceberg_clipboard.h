#pragma once

#include "core/scenario/scenario.h"

#include <QMimeData>

#include <memory>
#include <span>
#include <vector>

namespace berg {

/** Type of icebergs on the clipboard; the same JSON text is there as plain text too. */
inline constexpr char kIcebergMimeType[] = "application/x-bergwatch-icebergs+json";

[[nodiscard]] std::unique_ptr<QMimeData> icebergMimeData(std::span<const Iceberg> icebergs);

/**
 * The icebergs of a clipboard, ours or text that somebody made; their ids may be anything. Null is
 * an empty one. Throws `Error` of `icebergsFromJson` when it holds something else.
 */
[[nodiscard]] std::vector<Iceberg> icebergsOf(const QMimeData* data);

} // namespace berg
