#pragma once

// Private to core/io: UAVs, homes, area and asset in GeoJSON that this program has written.

#include "core/io/import/import_scene.h"
#include "core/io/import/json_members.h"

namespace berg {

/** Whether a feature with these properties (may be null) makes a file one of our own. */
[[nodiscard]] bool isOwnGeoJson(const Json* properties);

/** The `kind` of a feature of ours by its properties (may be null); empty without. */
[[nodiscard]] std::string kindOf(const Json* properties);

/** Adds what a feature of ours says; plans, visits and tracks are passed over. */
void addSceneFeature(FileScene& scene, const Json& feature);

} // namespace berg
