#include "core/tracking/iceberg_size.h"

#include <cmath>

namespace berg {

IcebergDimensions dimensionsOfLength(double length_m)
{
    const double draft_m = 1.78 * std::pow(length_m, 0.71);
    return {.length_m = length_m,
            .draft_m = draft_m,
            .sail_m2 = 0.077 * length_m * length_m,
            .keel_m2 = length_m * draft_m};
}

} // namespace berg
