#include "core/io/results/curve_result.h"

#include "core/base/number_text.h"
#include "core/io/results/result_csv.h"
#include "core/io/text/json_writer.h"
#include "core/plan/policy/fleet_task.h"
#include "core/sim/clusters.h"

namespace berg {

namespace {

std::vector<std::string> icebergIds(const CurveReport& report, const VisitOrder& order)
{
    std::vector<std::string> ids;
    for (const int number : icebergNumbers(report, order))
        ids.push_back(report.scenario.icebergs[static_cast<std::size_t>(number - 1)].id);
    return ids;
}

void addOrder(JsonObject& json, const CurveReport& report, const VisitOrder& order)
{
    json.addText("order", jsonArrayOf(icebergNumbers(report, order)));
    json.addText("icebergs", jsonArrayOf(icebergIds(report, order)));
}

} // namespace

std::vector<int> icebergNumbers(const CurveReport& report, const VisitOrder& order)
{
    std::vector<int> numbers;
    for (const NodeIndex node : order) {
        const IcebergIndex first = icebergOf(report.ids, node);
        const std::span<const IcebergIndex> members = clusterWith(report.clusters, first);
        for (const IcebergIndex iceberg : members.empty() ? std::span(&first, 1) : members)
            numbers.push_back(iceberg.number() + 1);
    }
    return numbers;
}

std::string curveJson(const CurveReport& report, double elapsed_s)
{
    std::vector<std::string> intervals;
    for (const CurveInterval& interval : report.curve.intervals) {
        JsonObject entry;
        entry.add("tau_from", interval.tauFrom);
        entry.add("tau_to", interval.tauTo);
        entry.add("distance_m", interval.distance_m);
        entry.add("reward_m2", interval.reward_m2);
        entry.add("proven", interval.proven);
        VisitOrder all;
        std::vector<std::string> uavs;
        for (std::size_t k = 0; k < interval.plan.size(); ++k) {
            const VisitOrder& order = interval.plan[k];
            all.insert(all.end(), order.begin(), order.end());
            const auto place = static_cast<std::size_t>(report.uavs[k]);
            JsonObject uav;
            uav.add("id", report.scenario.uavs[place].id);
            addOrder(uav, report, order);
            uavs.push_back(uav.inLine());
        }
        addOrder(entry, report, all);
        entry.addText("uavs", '[' + joined(uavs, ",") + ']');
        intervals.push_back(entry.inLine());
    }
    JsonObject document;
    document.addText("intervals", jsonLines(intervals, 1));
    document.add("complete", report.curve.complete);
    document.add("seconds", elapsed_s);
    return document.inLines(0) + '\n';
}

std::string curveCsv(const CurveReport& report)
{
    std::string text = "tau_from,tau_to,distance_m,reward_m2,proven,order,icebergs\n";
    for (const CurveInterval& interval : report.curve.intervals) {
        std::vector<std::string> numbers;
        std::vector<std::string> ids;
        for (const VisitOrder& order : interval.plan) {
            numbers.push_back(joined(icebergNumbers(report, order), " ",
                                     [](int number) { return std::to_string(number); }));
            ids.push_back(joined(icebergIds(report, order), ";"));
        }
        text += numberText(interval.tauFrom) + ',' + numberText(interval.tauTo) + ',' +
                numberText(interval.distance_m) + ',' + numberText(interval.reward_m2) + ',' +
                (interval.proven ? "1" : "0") + ',' + joined(numbers, kBetweenOrders) + ',' +
                csvField(joined(ids, kBetweenOrders)) + "\n";
    }
    return text;
}

} // namespace berg
