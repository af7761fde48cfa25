#include "core/tracking/iceberg_size.h"

#include <cmath>

namespace berg {

const IcebergSize& sizeOfLength(double length_m)
{
    std::size_t size = 0;
    if (length_m >= 200)
        size = 5;
    else if (length_m > 120)
        size = 4;
    else if (length_m > 60)
        size = 3;
    else if (length_m >= kShortestIceberg_m)
        size = 2;
    else if (length_m >= 5)
        size = 1;
    return kIcebergSizes[size];
}

IcebergDimensions dimensionsOfLength(double length_m)
{
    const double draft_m = 1.78 * std::pow(length_m, 0.71);
    return {.length_m = length_m,
            .draft_m = draft_m,
            .sail_m2 = 0.077 * length_m * length_m,
            .keel_m2 = length_m * draft_m};
}

} // namespace berg
