#pragma once

// Kinds of features of a Bergwatch export, for the writers and the readers of map formats.

#include "core/permit/operation.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>

namespace berg {

/** A colour of 8 bits per channel. */
struct Rgb
{
    std::uint8_t red = 0;
    std::uint8_t green = 0;
    std::uint8_t blue = 0;
};

/** What the name of a kind says as a style, type or id in files without the property `kind`. */
enum class OldUse : std::uint8_t
{
    None,
    Itself,
    NotIceberg ///< a feature that is not read
};

/** A kind of features; its id is the property `kind`. */
struct FeatureKind
{
    std::string_view id;
    Rgb colour = {}; ///< those of a UAV have the colour of `uavColour`
    bool isArea = false;
    bool isFilled = false; ///< polygons are filled and not only outlined
    OldUse inOldFiles = OldUse::None;
};

inline constexpr std::array<FeatureKind, 16> kFeatureKinds{{
    {.id = "iceberg", .colour = {120, 200, 240}},
    {.id = "uav", .inOldFiles = OldUse::NotIceberg}, ///< start of its path
    {.id = "home", .inOldFiles = OldUse::Itself},
    {.id = "visit"},
    {.id = "plan"},
    {.id = "path"},
    {.id = "track"}, ///< the line flown
    {.id = "asset", .colour = {220, 60, 60}, .inOldFiles = OldUse::Itself},
    {.id = "area", .colour = {128, 128, 128}, .isArea = true, .inOldFiles = OldUse::Itself},
    {.id = "airspace", .colour = {48, 120, 200}, .isArea = true, .inOldFiles = OldUse::NotIceberg},
    {.id = "no-fly",
     .colour = {200, 40, 40},
     .isArea = true,
     .isFilled = true,
     .inOldFiles = OldUse::Itself},
    {.id = "stand-off",
     .colour = {200, 40, 40},
     .isArea = true,
     .isFilled = true,
     .inOldFiles = OldUse::Itself},
    {.id = kVolumePartIds[0],
     .colour = {40, 160, 80},
     .isArea = true,
     .inOldFiles = OldUse::NotIceberg},
    {.id = kVolumePartIds[1],
     .colour = {240, 160, 30},
     .isArea = true,
     .inOldFiles = OldUse::NotIceberg},
    {.id = kVolumePartIds[2],
     .colour = {200, 40, 40},
     .isArea = true,
     .inOldFiles = OldUse::NotIceberg},
    {.id = kVolumePartIds[3],
     .colour = {120, 120, 120},
     .isArea = true,
     .inOldFiles = OldUse::NotIceberg},
}};

/** Returns the kind with this id, or null. */
[[nodiscard]] constexpr const FeatureKind* findKind(std::string_view id)
{
    const auto* const kind = std::ranges::find(kFeatureKinds, id, &FeatureKind::id);
    return kind == kFeatureKinds.end() ? nullptr : kind;
}

} // namespace berg
