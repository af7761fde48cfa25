#pragma once

namespace berg {

/** A knot in m/s. */
inline constexpr double kKnot_mps = 1852.0 / 3600;

} // namespace berg
