#include "core/io/plan_csv.h"

#include "core/io/export_numbers.h"
#include "core/io/result_csv.h"
#include "core/io/visits.h"

namespace berg {

std::string planCsv(const Scenario& scenario, const PlanAnswer& plan)
{
    const LocalFrame frame(scenario.origin);
    std::string text = "sequence,iceberg,name,leg_m,arrival_s,latitude_deg,longitude_deg,east_m,"
                       "north_m,sigma_now_m2,sigma_at_arrival_m2\n";
    Point from_m = scenario.uavs.at(0).position_m;
    int sequence = 0;
    for (const Visit& visit : plannedVisits(scenario, plan)) {
        if (visit.iceberg < 0)
            continue; // the way back of a closed route
        const LatLon place = frame.toGeographic(visit.position_m);
        ++sequence;
        for (const int index : icebergsOf(visit)) {
            const Iceberg& iceberg = scenario.icebergs[static_cast<std::size_t>(index)];
            const double now_m2 = initialSigma_m2(iceberg);
            text += std::to_string(sequence) + ',' + csvField(iceberg.id) + ',' +
                    csvField(iceberg.name);
            for (const double value :
                 {(visit.position_m - from_m).norm(), visit.time_s, place.latitude_deg,
                  place.longitude_deg, visit.position_m.x(), visit.position_m.y(), now_m2,
                  now_m2 + iceberg.q_m2ps * visit.time_s}) {
                text += ',';
                appendNumber(text, value);
            }
            text += '\n';
            from_m = visit.position_m;
        }
    }
    return text;
}

} // namespace berg
