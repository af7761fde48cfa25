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

/** Meaning of the name of a kind as a style, type or id in files without the property `kind`. */
enum class OldUse : std::uint8_t
{
    None,
    Itself,
    NotIceberg ///< a feature that is not read
};

/** How a kind is drawn. */
enum class KindDrawing : std::uint8_t
{
    Mark,    ///< places and lines
    Outline, ///< areas
    Filled   ///< areas
};

/** A kind of features; its id is the property `kind`. */
struct FeatureKind
{
    std::string_view id;
    Rgb colour = {}; ///< those of a UAV have the colour of `uavColour`
    KindDrawing drawn = KindDrawing::Mark;
    OldUse inOldFiles = OldUse::None;
};

inline constexpr std::array<FeatureKind, 16> kFeatureKinds{{
    {"iceberg", {120, 200, 240}},
    {"uav", {}, KindDrawing::Mark, OldUse::NotIceberg}, ///< start of its path
    {"home", {}, KindDrawing::Mark, OldUse::Itself},
    {"visit"},
    {"plan"},
    {"path"},
    {"track"}, ///< the line flown
    {"asset", {220, 60, 60}, KindDrawing::Mark, OldUse::Itself},
    {"area", {128, 128, 128}, KindDrawing::Outline, OldUse::Itself},
    {"airspace", {48, 120, 200}, KindDrawing::Outline, OldUse::NotIceberg},
    {"no-fly", {200, 40, 40}, KindDrawing::Filled, OldUse::Itself},
    {"stand-off", {200, 40, 40}, KindDrawing::Filled, OldUse::Itself},
    {kVolumePartIds[0], {40, 160, 80}, KindDrawing::Outline, OldUse::NotIceberg},
    {kVolumePartIds[1], {240, 160, 30}, KindDrawing::Outline, OldUse::NotIceberg},
    {kVolumePartIds[2], {200, 40, 40}, KindDrawing::Outline, OldUse::NotIceberg},
    {kVolumePartIds[3], {120, 120, 120}, KindDrawing::Outline, OldUse::NotIceberg},
}};

/** Returns the kind with this id, or null. */
[[nodiscard]] constexpr const FeatureKind* findKind(std::string_view id)
{
    const auto* const kind = std::ranges::find(kFeatureKinds, id, &FeatureKind::id);
    return kind == kFeatureKinds.end() ? nullptr : kind;
}

} // namespace berg
