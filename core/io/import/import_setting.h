#pragma once

// Private to core/io: what a file says beside its icebergs, put into a scenario.

#include "core/io/import/import_scenario.h"

#include <functional>
#include <set>
#include <string>

namespace berg {

/**
 * Takes UAVs, area and asset over into a scenario that holds no places yet, on its origin and for
 * its start. UAVs of the file take those of the scenario in turn, by id first; further ones have
 * the settings of the first. `icebergs`: ids that new UAVs must not get. What cannot be taken is a
 * finding and leaves the rest; the scenario is as valid as before.
 */
void takeScene(const FileScene& scene, const std::set<std::string, std::less<>>& icebergs,
               ImportResult& result);

} // namespace berg
