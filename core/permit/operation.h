#pragma once

#include "core/scenario/limits.h"
#include "core/scenario/scenario.h"

#include <array>
#include <string_view>

namespace berg {

/** Parts of an operation volume, from the inside out; each contains the ones before. */
enum class VolumePart
{
    Geography,   ///< area of the planned flights
    Contingency, ///< room to return after leaving the flight geography
    Buffer,      ///< ground area where a UAV may come down
    Adjacent     ///< area that a UAV might reach if nobody stopped it
};
inline constexpr std::size_t kVolumeParts = 4;
/** Names of the parts in exported files. */
inline constexpr std::array<std::string_view, kVolumeParts> kVolumePartIds{
    "flight-geography", "contingency-volume", "ground-risk-buffer", "adjacent-area"};

/** Dimensions and outlines of an operation volume, computed by `operationVolume`. */
struct OperationVolume
{
    double speed_mps = 0;  ///< speed v
    double height_m = 0;   ///< height H_FG of the flight geography
    double ceiling_m = 0;  ///< height H_CV of the contingency volume
    double outside_m = 0;  ///< width S_CV of the contingency volume
    double buffer_m = 0;   ///< width S_GRB of the ground-risk buffer
    double adjacent_m = 0; ///< width S_AA of the adjacent area
    std::array<std::vector<Point>, kVolumeParts> outlines_m; ///< by part, counter-clockwise

    [[nodiscard]] const std::vector<Point>& outline_m(VolumePart part) const
    {
        return outlines_m[static_cast<std::size_t>(part)];
    }
    /**
     * Returns the top of the part above sea level, or nullopt for the parts on the ground, which
     * cover all heights.
     */
    [[nodiscard]] std::optional<double> top_m(VolumePart part) const
    {
        if (part == VolumePart::Geography)
            return height_m;
        return part == VolumePart::Contingency ? std::optional(ceiling_m) : std::nullopt;
    }
};

/**
 * Proposes the volume of an operation, to be checked with the authority that issues the permit.
 *
 * The flight geography is the inside of the geofence, or without one the hull of all places to
 * which a plan may lead (start and landing places of UAVs; expected positions of icebergs when they
 * appear and at the end of the run, if inside the area) with the margin. H_FG is the altitude of
 * the highest UAV, v the largest speed over ground.
 *
 * S_CV = position + path + map error + v t + v^2 / (g tan bank)
 * H_CV = H_FG + height error + climb part v t + pull-up part v^2 / g
 * S_GRB = ratio H_CV + span / 2
 * S_AA = v adjacent time, within its minimum and maximum
 *
 * t is the reaction time; S_AA counts from the contingency volume. Formulas and defaults are those
 * of the calculator of Digisky (version 3.3.0), which follows the guide of the Swiss FOCA; they are
 * not an authority's own text. At 22 m/s and 120 m S_CV is 114 m and H_CV 154 m. The scenario must
 * have a UAV. Cost: quadratic in the corners of the geofence.
 */
[[nodiscard]] OperationVolume operationVolume(const Scenario& scenario, const Operation& operation);

} // namespace berg
