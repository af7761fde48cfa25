#pragma once

#include "core/io/formats.h"

namespace berg {

/**
 * The plan as a table, one row per iceberg in visiting order:
 * `sequence,iceberg,name,leg_m,arrival_s,latitude_deg,longitude_deg,east_m,north_m,sigma_now_m2,`
 * `sigma_at_arrival_m2`. Places and times are those of `plannedVisits`; a leg is measured over
 * ground. Icebergs of a cluster share number, place and time. The form is that of
 * core/io/result_csv.h.
 */
[[nodiscard]] std::string planCsv(const Scenario& scenario, const PlanAnswer& plan);

} // namespace berg
