#pragma once

#include "core/earth/geodesy.h"
#include "core/earth/sun.h"

#include <QSettings>

#include <optional>

namespace berg {

/** Key of the user's setting: the typed declination, degrees, positive east. */
inline constexpr const char* kDeclinationKey = "units/declination";
/** Largest absolute declination that can be typed, degrees. */
inline constexpr int kMostDeclination_deg = 180;

/** Reads the typed declination, clamped to the limit; zero if it is missing or not a number. */
[[nodiscard]] double readDeclination_deg(const QSettings& settings);

/** Typed declination of this process, degrees, positive east; any thread may read it. */
[[nodiscard]] double typedDeclination_deg();
/** Sets the typed declination of this process. */
void setTypedDeclination(double declination_deg);

/**
 * Declination for courses by magnetic north, degrees, positive east, as `shownUnits().north`
 * selects: typed, or from the World Magnetic Model at place and time. Returns nullopt if courses
 * are shown by true north only; with the model also without a time, outside the model's years, or
 * where a compass is useless (`magneticDeclination_deg`).
 */
[[nodiscard]] std::optional<double> shownDeclination_deg(LatLon place,
                                                         const std::optional<SunTime>& time);

} // namespace berg
