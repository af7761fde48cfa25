#pragma once

// Private to core/io: scene of a GeoJSON file exported by Bergwatch.

#include "core/io/import/fields/import_scene.h"
#include "core/io/import/fields/json_members.h"

namespace berg {

/**
 * Adds a feature of a Bergwatch export to the scene: a UAV, home, area, no-fly area or asset. Other
 * kinds are ignored, and so is a home without a place or before its UAV. An area or asset that
 * cannot be read becomes a finding; a UAV without a place is added without a start.
 */
void addSceneFeature(FileScene& scene, const Json& feature);

} // namespace berg
