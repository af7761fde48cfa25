#pragma once

// Private to core/io: applies the scene of a file to a scenario.

#include "core/io/import/scenario/import_scenario.h"

#include <functional>
#include <set>
#include <string>

namespace berg {

/**
 * Applies UAVs, area and asset of a file to a scenario that has no places yet, with its origin and
 * start. UAVs of the file are applied to those of the scenario in turn, by id first; further ones
 * have the settings of the first. `icebergs` are ids that new UAVs must not get. An object that
 * cannot be used becomes a finding and does not affect the others; the scenario stays as valid as
 * before.
 */
void applyScene(const FileScene& scene, const std::set<std::string, std::less<>>& icebergs,
                ImportResult& result);

} // namespace berg
