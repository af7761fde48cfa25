#include "core/io/results/curve_result.h"

#include "core/io/results/result_csv.h"
#include "core/io/text/json_writer.h"
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

std::string joined(const std::vector<std::string>& parts, char separator)
{
    std::string text;
    for (const std::string& part : parts)
        text += (text.empty() ? "" : std::string(1, separator)) + part;
    return text;
}

} // namespace

std::vector<int> icebergNumbers(const CurveReport& report, const VisitOrder& order)
{
    std::vector<int> numbers;
    for (const int node : order) {
        const int first = report.ids[static_cast<std::size_t>(node - 1)];
        const std::span<const int> members = clusterWith(report.clusters, first);
        for (const int iceberg : members.empty() ? std::span(&first, 1) : members)
            numbers.push_back(iceberg + 1);
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
        entry.addText("order", jsonArrayOf(icebergNumbers(report, interval.order)));
        entry.addText("icebergs", jsonArrayOf(icebergIds(report, interval.order)));
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
        for (const int number : icebergNumbers(report, interval.order))
            numbers.push_back(std::to_string(number));
        text += numberText(interval.tauFrom) + ',' + numberText(interval.tauTo) + ',' +
                numberText(interval.distance_m) + ',' + numberText(interval.reward_m2) + ',' +
                (interval.proven ? "1" : "0") + ',' + joined(numbers, ' ') + ',' +
                csvField(joined(icebergIds(report, interval.order), ';')) + "\n";
    }
    return text;
}

} // namespace berg
