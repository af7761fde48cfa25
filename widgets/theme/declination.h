#pragma once

#include "core/base/geodesy.h"
#include "core/base/sun.h"

#include <QSettings>

#include <optional>

namespace berg {

/** Setting of the user: the declination typed in, degrees, positive east. */
inline constexpr const char* kDeclinationKey = "units/declination";
/** Largest declination that can be typed, either way, degrees. */
inline constexpr int kMostDeclination_deg = 180;

/** 0 if there is none or no number. */
[[nodiscard]] double readDeclination_deg(const QSettings& settings);

/** The one typed in, of the process as `shownUnits`; any thread may read. */
[[nodiscard]] double typedDeclination_deg();
void setTypedDeclination(double declination_deg);

/**
 * Declination for courses by magnetic north, degrees, positive east, as `shownUnits().north` has
 * it: typed, or of the World Magnetic Model at place and time. Returns nullopt if courses are shown
 * by true north alone, and of the model without a time, outside its years, or where a compass is of
 * no use (`magneticDeclination_deg`).
 */
[[nodiscard]] std::optional<double> shownDeclination_deg(LatLon place,
                                                         const std::optional<SunTime>& time);

} // namespace berg
