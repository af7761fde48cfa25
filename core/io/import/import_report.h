#pragma once

#include "core/io/import/import_scenario.h"

namespace berg {

/**
 * What an import did, as the JSON document of the command line: format, counts, start, origin, what
 * became of UAVs, area and asset, an entry for each iceberg of the file, and the first thousand
 * rejected rows.
 */
[[nodiscard]] std::string importJson(const SightingTable& table, const ImportResult& result);

} // namespace berg
