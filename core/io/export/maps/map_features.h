#pragma once

#include "core/io/export/content/export_content.h"
#include "core/io/export/content/feature_kinds.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace berg {

// Objects of an export for map formats. Every format writes the same list, each in its own syntax.

/** Value of a property; a point is a vector to true east and north. */
using MapValue =
    std::variant<std::string, double, std::int64_t, bool, Point, std::vector<std::string>>;

/** A value that programs read; imports find it by its name. */
struct MapProperty
{
    std::string name;
    MapValue value;
};

/** A polygon in the plane and its heights. */
struct MapOutline
{
    std::vector<Point> corners_m;
    double floor_m = 0;
    std::optional<double> ceiling_m = {}; ///< nullopt if it is unlimited or not known
};

/** An object of a map. */
struct MapFeature
{
    std::string kind;        ///< id of one of `kFeatureKinds`
    std::string key = {};    ///< distinguishes it from others of its kind; empty if there are none
    std::string title = {};  ///< for people
    std::string about = {};  ///< a line for people; may be empty
    std::string folder = {}; ///< title of the group of the feature; empty if it has none
    /** Place, outline, or the path of a UAV. */
    std::variant<Point, MapOutline, const ExportUav*> geometry = Point(0, 0);
    double altitude_m = 0;                 ///< of a place
    std::optional<double> time_s = {};     ///< of a place
    std::optional<std::size_t> uav = {};   ///< row of the UAV that it belongs to
    std::vector<MapProperty> properties{}; ///< without `kind`
    bool isAtStart = false;                ///< a home at the place of the feature before it
};

/**
 * Returns the objects of the content, those in the background first. Properties that are fields of
 * a scenario have the names and units of its files. `velocity_mps` is an iceberg's own velocity,
 * `drift_mps` includes the current. The list borrows the content.
 */
[[nodiscard]] std::vector<MapFeature> mapFeatures(const ExportContent& content);

/**
 * Returns the kind and the properties of a feature for formats without vectors and lists: a vector
 * `drift_mps` becomes `drift_east_mps` and `drift_north_mps`, a list becomes one text.
 */
[[nodiscard]] std::vector<MapProperty> flatProperties(const MapFeature& feature);

/**
 * Returns the colour of UAV `row` in files: the palette of Okabe and Ito, distinguishable with
 * colour blindness, used cyclically.
 */
[[nodiscard]] Rgb uavColour(std::size_t row);
/** Returns the appearance of a feature. */
[[nodiscard]] FeatureKind styleOf(const MapFeature& feature);

} // namespace berg
