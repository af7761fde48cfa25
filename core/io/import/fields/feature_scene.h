#pragma once

// Private to core/io: objects of a Bergwatch export other than icebergs, from any map format.

#include "core/io/import/fields/file_feature.h"
#include "core/io/import/fields/import_scene.h"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace berg {

/**
 * Properties of a feature by their names, as `flatProperties` gives them: those of vectors are
 * apart.
 */
using FeatureData = std::map<std::string, std::string, std::less<>>;

/** Returns the text of a property; empty if there is none. */
[[nodiscard]] const std::string& valueOf(const FeatureData& data, std::string_view name);
/** Returns a property as a number, or nullopt if it is not one. */
[[nodiscard]] std::optional<double> numberOf(const FeatureData& data, std::string_view name);
/** Returns true if a property of this name is a component of a vector to true east and north. */
[[nodiscard]] bool isVectorPart(std::string_view name);

/**
 * Returns true if the text of a map file is a Bergwatch export, whose features have a `featureKind`
 * and are not icebergs unless it says so.
 */
[[nodiscard]] bool isOwnExport(std::string_view text);

/** A feature of a Bergwatch export other than an iceberg. */
struct SceneFeature
{
    const FileFeature& feature;
    const FeatureData& data;
    std::optional<UtcTime> time = {};
};
/**
 * Adds a UAV, home, area, no-fly area or asset to the scene; other kinds are ignored. An area or
 * asset that cannot be read becomes a finding; a UAV without a place is added without a start.
 */
void addSceneFeature(FileScene& scene, const SceneFeature& added);

} // namespace berg
