#pragma once

#include "core/study/drift_tracks.h"
#include "widgets/map/land/backdrop.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace berg {

/** Layers of the map that the user can fade or hide. */
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
    Compared, ///< track of the compared run
    Places,   ///< names of the gazetteer
    IceChart,
    Wind,    ///< barbs of the forecast
    Current, ///< arrows of the forecast
    Tracks   ///< predicted drift; new layers are last: settings store them by number
};
inline constexpr std::size_t kMapLayers = 14;

/** Predicted drift of the icebergs; null if it is not known. */
using DriftTracksPointer = std::shared_ptr<const std::vector<DriftTrack>>;

/** Opacity of each layer, the user's backdrop, and the horizon of drift arrows. */
struct MapLayers
{
    /**
     * By `MapLayer`, from 0 (hidden) to 1; the backdrop and the ice chart are faint by default,
     * and tracks are hidden.
     */
    std::array<double, kMapLayers> opacities{1, 1, 1, 1, 1, 1, 1, 0.5, 1, 1, 0.4, 1, 1, 0};
    BackdropPointer backdrop; ///< null if there is none
    /** Horizon of drift arrows; nullopt chooses one that gives them a readable length. */
    std::optional<double> horizon_s;
    DriftTracksPointer tracks;
    double trackMark_s = 6 * 3600.0; ///< time between two marks of `tracks`
    bool operator==(const MapLayers&) const = default;

    /** Returns the opacity of a layer in [0, 1]. */
    [[nodiscard]] double opacity(MapLayer layer) const
    {
        return opacities[static_cast<std::size_t>(layer)];
    }
    [[nodiscard]] bool shows(MapLayer layer) const { return opacity(layer) > 0; }
    /** Sets the opacity of a layer, clamped to [0, 1]. */
    void set(MapLayer layer, double opacity)
    {
        opacities[static_cast<std::size_t>(layer)] = std::clamp(opacity, 0.0, 1.0);
    }
};

} // namespace berg
