#pragma once

#include "widgets/map/land/backdrop.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace berg {

/** Parts of the picture of the map that the user can make faint or hide. */
enum class MapLayer : std::uint8_t
{
    Labels,
    Drift,
    Rings,
    Graticule,
    FormerPlan,
    Swept,
    Permit, ///< airspace and operation volume
    Backdrop,
    Compared, ///< track of the other run
    Places    ///< names of the gazetteer; last: settings keep the layers by number
};
inline constexpr std::size_t kMapLayers = 10;

/** How strongly each layer is painted, a file of the user below all, how far drift arrows look. */
struct MapLayers
{
    /** By `MapLayer`, 0: hidden, to 1; the background does not drown what lies on it. */
    std::array<double, kMapLayers> opacities{1, 1, 1, 1, 1, 1, 1, 0.5, 1, 1};
    BackdropPointer backdrop; ///< null: none
    double horizon_s = 0;     ///< of drift arrows; 0: what makes them of a length to be seen
    bool operator==(const MapLayers&) const = default;

    [[nodiscard]] double opacity(MapLayer layer) const
    {
        return opacities[static_cast<std::size_t>(layer)];
    }
    [[nodiscard]] bool shows(MapLayer layer) const { return opacity(layer) > 0; }
    void set(MapLayer layer, double opacity)
    {
        opacities[static_cast<std::size_t>(layer)] = std::clamp(opacity, 0.0, 1.0);
    }
};

} // namespace berg
