#include "core/base/number_text.h"
#include "core/io/export/flight_log.h"
#include "core/io/figure/figure_svg.h"
#include "core/io/figure/report_style.h"
#include "core/io/results/result_csv.h"
#include "core/io/text/html_text.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace berg {

namespace {

/** "1:02:03" */
std::string clockOf(double time_s)
{
    const long long whole = std::llround(time_s);
    char text[48];
    std::snprintf(text, sizeof text, "%lld:%02lld:%02lld", whole / 3600, whole / 60 % 60,
                  whole % 60);
    return text;
}

std::string timeOf(const ExportContent& content, double time_s)
{
    return content.start ? utcText(*content.start, time_s) : clockOf(time_s);
}

std::string rounded(double value)
{
    return printedNumber(std::round(value), 0);
}

std::string kilometres(double length_m)
{
    return printedNumber(std::round(length_m / 100) / 10, 1);
}

std::string rowOf(std::string_view term, const std::string& description)
{
    return "<dt>" + std::string(term) + "</dt>\n<dd>" + description + "</dd>\n";
}

std::string zetaText(const FlightLog& log)
{
    std::string text = rounded(log.metrics.zeta_m2s) + " m²\u00a0s";
    if (log.predicted)
        text += "; predicted before take-off " + rounded(log.predicted->zeta_m2s) +
                " m²\u00a0s, until the end of the run";
    if (log.wasChanged)
        text += "; changed in flight, so that the prediction was for another flight";
    return text;
}

std::string factsHtml(const ExportContent& content, const FlightLog& log)
{
    const Scenario& scenario = content.mission->scenario();
    std::string rows = rowOf("Flown", timeOf(content, 0) + " to " + timeOf(content, log.flown_s));
    rows += rowOf("ζ", zetaText(log));
    rows += rowOf("Visits, plans",
                  std::to_string(log.metrics.visits) + ", " + std::to_string(log.metrics.replans));
    rows += rowOf("Policy", nameOf(kPolicyNames, scenario.planner.policy));
    rows += rowOf("Seed", std::to_string(scenario.seed));
    rows += rowOf("Program", htmlText(programName()));
    return "<section>\n<dl>\n" + rows + "</dl>\n</section>\n";
}

std::string uavsHtml(const ExportContent& content, const FlightLog& log)
{
    HtmlTable table(
        "Planned: the first plan, before take-off. Distances flown are through the air.",
        {"UAV", "Visits planned", "flown", "Distance planned, km", "flown, km", "Time planned",
         "aloft", "Outside the flight geography"});
    std::string hashes;
    for (const LogUav& uav : log.uavs) {
        const std::string name = htmlName(titleOf(content.mission->scenario().uavs[uav.row]));
        table.addRow({name, std::to_string(uav.plannedVisits), std::to_string(uav.visits),
                      kilometres(uav.plannedLength_m), kilometres(uav.flown_m),
                      clockOf(uav.plannedTime_s), clockOf(uav.aloft_s),
                      content.operation ? clockOf(uav.outside_s) : "–"});
        hashes += rowOf(name, "<code>" + uav.planHash + "</code>");
    }
    return "<section>\n<h2>Planned and flown</h2>\n<div class=\"wide\">" + table.html() +
           "</div>\n<p>SHA-256 of the first plan as a file of the format wpl:</p>\n<dl>\n" +
           hashes + "</dl>\n</section>\n";
}

std::string zetaFigureHtml(const ExportContent& content, const FlightLog& log)
{
    const std::vector<Sample>& samples = content.mission->recorder().samples();
    if (samples.size() < 2)
        return {};
    constexpr std::size_t kMostPoints = 400;
    const std::size_t stride = samples.size() / kMostPoints + 1;
    PlotLine line{.points = {}, .ink = {.of = InkOf::Plan}, .width_px = 2, .key = "mean"};
    for (std::size_t i = 0; i < samples.size(); i += stride)
        line.points.push_back({.x = samples[i].time_s, .y = samples[i].zeta_m2s});
    line.points.push_back({.x = samples.back().time_s, .y = samples.back().zeta_m2s});
    Figure figure{.name = "Zeta over time",
                  .title = {},
                  .emptyText = {},
                  .leftTitles = {"ζ, m² s"},
                  .rightTitles = {},
                  .x = {.ends = AxisEnds::Exact,
                        .least = 0,
                        .largest = samples.back().time_s,
                        .spacing_px = 90,
                        .text = printedNumber,
                        .title = "s since the start"},
                  .y = {.ends = AxisEnds::Around0,
                        .least = 0,
                        .largest = std::max(1.0, samples.back().zeta_m2s),
                        .spacing_px = 40,
                        .text = printedNumber},
                  .areas = {},
                  .lines = {line},
                  .marks = {},
                  .labels = {},
                  .items = {},
                  .description = "Zeta over time, in the end " + rounded(log.metrics.zeta_m2s) +
                                 " square metres times seconds."};
    return "<section>\n<h2>ζ over time</h2>\n<figure>\n" + figureSvg(figure, 760, 300) +
           "</figure>\n</section>\n";
}

std::string sightingsHtml(const ExportContent& content, const FlightLog& log)
{
    HtmlTable table(
        "Longest unseen: from when an iceberg was known of, or seen, until it was seen "
        "again or the record ends.",
        {"Iceberg", "First seen", "Last seen", "Visits", "Longest unseen", "σ at the end, m²"});
    for (const LogIceberg& iceberg : log.icebergs) {
        const auto time = [&](const std::optional<double>& time_s) {
            return time_s ? timeOf(content, *time_s) : std::string("never");
        };
        table.addRow({htmlName(titleOf(content.mission->icebergs()[iceberg.iceberg])),
                      time(iceberg.first_s), time(iceberg.last_s), std::to_string(iceberg.visits),
                      clockOf(iceberg.longestUnseen_s),
                      printedNumber(std::round(iceberg.sigma_m2 * 10) / 10, 1)});
    }
    return "<section>\n<h2>Sightings</h2>\n<div class=\"wide\">" + table.html() +
           "</div>\n</section>\n";
}

std::string deviationsHtml(const ExportContent& content, const FlightLog& log)
{
    constexpr std::size_t kMostTold = 200;
    const Mission& mission = *content.mission;
    std::string lines;
    for (std::size_t i = 0; i < std::min(log.deviations.size(), kMostTold); ++i) {
        const MissionEvent& event = log.deviations[i];
        std::string line = timeOf(content, event.time_s);
        line.append(" ").append(eventName(event.kind));
        if (event.uav >= 0)
            line.append(" ").append(
                titleOf(mission.scenario().uavs[static_cast<std::size_t>(event.uav)]));
        if (event.iceberg >= 0)
            line.append(" ").append(
                titleOf(mission.icebergs()[static_cast<std::size_t>(event.iceberg)]));
        if (const std::string detail = eventDetail(event, mission); !detail.empty())
            line.append(": ").append(detail);
        lines.append("<li>").append(htmlName(line)).append("</li>\n");
    }
    if (log.deviations.size() > kMostTold)
        lines += "<li>and " + std::to_string(log.deviations.size() - kMostTold) + " more</li>\n";
    return "<section>\n<h2>Deviations</h2>\n" +
           (lines.empty() ? std::string("<p>None on record.</p>\n")
                          : "<ul class=\"findings\">\n" + lines + "</ul>\n") +
           "</section>\n";
}

} // namespace

std::string flightLogHtml(const ExportContent& content)
{
    const FlightLog log = flightLog(content);
    const std::string title =
        "Flight log: " + (content.name.empty() ? std::string("Bergwatch") : content.name);
    return reportHead(title, programName()) + "<body>\n<header>\n<h1>" + htmlName(title) +
           "</h1>\n<p class=\"lead\">" + htmlText(programName()) + "</p>\n</header>\n<main>\n" +
           factsHtml(content, log) + uavsHtml(content, log) + zetaFigureHtml(content, log) +
           sightingsHtml(content, log) + deviationsHtml(content, log) +
           "</main>\n</body>\n</html>\n";
}

} // namespace berg
