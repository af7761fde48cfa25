#include "core/base/number_text.h"
#include "core/base/version.h"
#include "core/io/export/flight_log.h"
#include "core/io/figure/figure_svg.h"
#include "core/io/figure/report_style.h"
#include "core/io/text/html_text.h"
#include "core/io/words/event_words.h"
#include "core/tracking/position_error.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace berg {

namespace {

/** Time as "1:02:03". */
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

/** Policy and tau, as "visitation, τ = 1.2". */
std::string plannerText(PolicyKind policy, double tau)
{
    const std::string name = nameOf(kPolicyNames, policy);
    return traitsOf(policy).usesTau ? name + ", τ = " + numberText(tau) : name;
}

std::string kilometres(double length_m)
{
    return printedNumber(std::round(length_m / 100) / 10, 1);
}

std::string rowOf(const std::string& term, const std::string& description)
{
    return "<dt>" + term + "</dt>\n<dd>" + description + "</dd>\n";
}

std::string zetaText(const FlightLog& log, const ReportWords& words)
{
    std::string text = rounded(log.metrics.zeta_m2s) + " m²\u00a0s";
    if (log.predicted)
        text += "; " + words.html(QT_TRANSLATE_NOOP("Report", "predicted before take-off %1 m² s, "
                                                              "until the end of the run"),
                                  {rounded(log.predicted->mean_m2s)});
    if (log.wasChanged)
        text += "; " + words.html(QT_TRANSLATE_NOOP("Report", "changed in flight, so that the "
                                                              "prediction was for another flight"));
    return text;
}

std::string factsHtml(const ExportContent& content, const FlightLog& log)
{
    const Scenario& scenario = content.mission->scenario();
    const ReportWords& words = content.words;
    const auto row = [&](std::string_view english, const std::string& description) {
        return rowOf(words.html(english), description);
    };
    return "<section>\n<dl>\n" +
           row(QT_TRANSLATE_NOOP("Report", "Flown"),
               words.html(QT_TRANSLATE_NOOP("Report", "%1 to %2"),
                          {timeOf(content, 0), timeOf(content, log.flown_s)})) +
           rowOf("ζ", zetaText(log, words)) +
           row(QT_TRANSLATE_NOOP("Report", "Visits, plans"),
               std::to_string(log.metrics.visits) + ", " + std::to_string(log.metrics.replans)) +
           row(QT_TRANSLATE_NOOP("Report", "Policy"),
               plannerText(scenario.planner.policy, scenario.planner.tau)) +
           row(QT_TRANSLATE_NOOP("Report", "Seed"), std::to_string(scenario.seed)) +
           row(QT_TRANSLATE_NOOP("Report", "Program"), htmlText(programName())) +
           "</dl>\n</section>\n";
}

std::string uavsHtml(const ExportContent& content, const FlightLog& log)
{
    const ReportWords& words = content.words;
    HtmlTable table(
        words.html(QT_TRANSLATE_NOOP("Report",
                                     "Planned: the first sortie of the plan before take-off, over "
                                     "ground in straight legs. Distances flown are through the "
                                     "air.")),
        words.heads(
            {QT_TRANSLATE_NOOP("Report", "UAV"), QT_TRANSLATE_NOOP("Report", "Visits planned"),
             QT_TRANSLATE_NOOP("Report", "flown"),
             QT_TRANSLATE_NOOP("Report", "Distance planned, km"),
             QT_TRANSLATE_NOOP("Report", "flown, km"), QT_TRANSLATE_NOOP("Report", "Time planned"),
             QT_TRANSLATE_NOOP("Report", "aloft"), QT_TRANSLATE_NOOP("Report", "Took off"),
             QT_TRANSLATE_NOOP("Report", "Landed"),
             QT_TRANSLATE_NOOP("Report", "Outside the flight geography")}));
    const auto time = [&](const std::optional<double>& time_s) {
        return time_s ? timeOf(content, *time_s) : std::string("–");
    };
    std::string hashes;
    for (const LogUav& uav : log.uavs) {
        const std::string name = htmlName(titleOf(content.mission->scenario().uavs[uav.row]));
        table.addRow({name, std::to_string(uav.plannedVisits), std::to_string(uav.visits),
                      kilometres(uav.plannedLength_m), kilometres(uav.flown_m),
                      clockOf(uav.plannedTime_s), clockOf(uav.aloft_s), time(uav.tookOff_s),
                      time(uav.landed_s), content.operation ? clockOf(uav.outside_s) : "–"});
        hashes += rowOf(name, "<code>" + uav.planHash + "</code>");
    }
    return "<section>\n<h2>" + words.html(QT_TRANSLATE_NOOP("Report", "Planned and flown")) +
           "</h2>\n<div class=\"wide\">" + table.html() + "</div>\n<p>" +
           words.html(QT_TRANSLATE_NOOP("Report",
                                        "SHA-256 of the first plan as a file of the format wpl:")) +
           "</p>\n<dl>\n" + hashes + "</dl>\n</section>\n";
}

std::string zetaFigureHtml(const ExportContent& content, const FlightLog& log)
{
    const std::vector<Sample>& samples = content.mission->recorder().samples();
    if (samples.size() < 2)
        return {};
    const ReportWords& words = content.words;
    constexpr std::size_t kMostPoints = 400;
    const std::size_t stride = samples.size() / kMostPoints + 1;
    PlotLine line{.points = {}, .ink = {.of = InkOf::Plan}, .width_px = 2, .key = "mean"};
    for (std::size_t i = 0; i < samples.size(); i += stride)
        line.points.push_back({.x = samples[i].time_s, .y = samples[i].zeta_m2s});
    line.points.push_back({.x = samples.back().time_s, .y = samples.back().zeta_m2s});
    Figure figure{.name = words.text(QT_TRANSLATE_NOOP("Report", "Zeta over time")),
                  .title = {},
                  .emptyText = {},
                  .leftTitles = {"ζ, m² s"},
                  .rightTitles = {},
                  .x = {.ends = AxisEnds::Exact,
                        .least = 0,
                        .largest = samples.back().time_s,
                        .spacing_px = 90,
                        .text = printedNumber,
                        .title = words.text(QT_TRANSLATE_NOOP("Report", "s since the start"))},
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
                  .description = words.text(
                      QT_TRANSLATE_NOOP(
                          "Report", "Zeta over time, in the end %1 square metres times seconds."),
                      {rounded(log.metrics.zeta_m2s)})};
    return "<section>\n<h2>" + words.html(QT_TRANSLATE_NOOP("Report", "ζ over time")) +
           "</h2>\n<figure>\n" + figureSvg(figure, 760, 300) + "</figure>\n</section>\n";
}

std::string sightingsHtml(const ExportContent& content, const FlightLog& log)
{
    const ReportWords& words = content.words;
    HtmlTable table(
        words.html(QT_TRANSLATE_NOOP(
            "Report", "Longest unseen: from when an iceberg was known of, or seen, "
                      "until it was seen again, left, was removed or the record ends.")),
        words.heads(
            {QT_TRANSLATE_NOOP("Report", "Iceberg"), QT_TRANSLATE_NOOP("Report", "First seen"),
             QT_TRANSLATE_NOOP("Report", "Last seen"), QT_TRANSLATE_NOOP("Report", "Visits"),
             QT_TRANSLATE_NOOP("Report", "Longest unseen"),
             QT_TRANSLATE_NOOP("Report", "σ at the end, m²"),
             QT_TRANSLATE_NOOP("Report", "95 % within, m")}));
    const auto time = [&](const std::optional<double>& time_s) {
        return time_s ? timeOf(content, *time_s) : words.html(QT_TRANSLATE_NOOP("Report", "never"));
    };
    for (const LogIceberg& iceberg : log.icebergs)
        table.addRow({htmlName(titleOf(content.mission->icebergs()[iceberg.iceberg])),
                      time(iceberg.first_s), time(iceberg.last_s), std::to_string(iceberg.visits),
                      clockOf(iceberg.longestUnseen_s),
                      printedNumber(std::round(iceberg.sigma_m2 * 10) / 10, 1),
                      printedNumber(std::round(radius95_m(iceberg.sigma_m2) * 10) / 10, 1)});
    return "<section>\n<h2>" + words.html(QT_TRANSLATE_NOOP("Report", "Sightings")) +
           "</h2>\n<div class=\"wide\">" + table.html() + "</div>\n</section>\n";
}

std::string deviationHtml(const ExportContent& content, const MissionEvent& event)
{
    const Mission& mission = *content.mission;
    const auto name = [](const auto& all, const std::optional<int>& index) {
        return index && toIndex(*index) < all.size() ? htmlName(titleOf(all[toIndex(*index)]))
                                                     : std::string();
    };
    const std::vector<Uav>& uavs = mission.scenario().uavs;
    const EventNames names{.iceberg = name(mission.icebergs(), event.iceberg),
                           .uav = uavs.size() > 1 ? name(uavs, event.uav) : std::string(),
                           .otherUav = name(uavs, event.otherUav),
                           .distance = rounded(event.distance_m) + " m",
                           .entry = clockOf(event.entry_s),
                           .planner = plannerText(event.policy, event.tau)};
    std::string text = timeOf(content, event.time_s) + ' ' +
                       eventSentence(event, names, [&content](std::string_view english) {
                           return htmlText(content.words.translated(english));
                       });
    if (!event.failure.empty())
        text += ": " + htmlText(event.failure);
    return "<li>" + text + "</li>\n";
}

std::string deviationsHtml(const ExportContent& content, const FlightLog& log)
{
    constexpr std::size_t kMostListed = 200;
    const ReportWords& words = content.words;
    std::string lines;
    for (std::size_t i = 0; i < std::min(log.deviations.size(), kMostListed); ++i)
        lines += deviationHtml(content, log.deviations[i]);
    if (log.deviations.size() > kMostListed)
        lines += "<li>" +
                 words.html(QT_TRANSLATE_NOOP("Report", "and %1 more"),
                            {std::to_string(log.deviations.size() - kMostListed)}) +
                 "</li>\n";
    return "<section>\n<h2>" + words.html(QT_TRANSLATE_NOOP("Report", "Deviations")) + "</h2>\n" +
           (lines.empty()
                ? "<p>" + words.html(QT_TRANSLATE_NOOP("Report", "None on record.")) + "</p>\n"
                : "<ul class=\"findings\">\n" + lines + "</ul>\n") +
           "</section>\n";
}

} // namespace

std::string flightLogHtml(const ExportContent& content)
{
    const FlightLog log = flightLog(content);
    const std::string title =
        content.words.text(QT_TRANSLATE_NOOP("Report", "Flight log: %1"),
                           {content.name.empty() ? std::string("Bergwatch") : content.name});
    return reportHead({.title = title, .program = programName(), .language = content.words.tag()}) +
           "<body>\n<header>\n<h1>" + htmlName(title) + "</h1>\n<p class=\"lead\">" +
           htmlText(programName()) + "</p>\n</header>\n<main>\n" + factsHtml(content, log) +
           uavsHtml(content, log) + zetaFigureHtml(content, log) + sightingsHtml(content, log) +
           deviationsHtml(content, log) + "</main>\n</body>\n</html>\n";
}

} // namespace berg
