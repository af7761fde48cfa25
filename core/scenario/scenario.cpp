#include "core/scenario/scenario.h"

namespace berg {

double initialSigma_m2(const Iceberg& iceberg)
{
    return iceberg.sigma0_m2 + iceberg.q_m2ps * iceberg.observed_s;
}

} // namespace berg
